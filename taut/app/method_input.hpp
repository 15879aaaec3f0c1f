#pragma once
#include <any>
#include <functional>
#include <utility>

namespace taut::app {

/// The input of one method, whichever: all that is not known of it by its type. A value: a copy is another input.
class MethodInput {
 public:
  /// One with its defaults.
  template <class Input>
  static MethodInput of() {
    MethodInput in;
    in.value_ = Input{};
    in.place_ = [](std::any& value) -> void* { return std::any_cast<Input>(&value); };
    return in;
  }

  /// The struct itself, for its Description.
  void* place() { return place_(value_); }

  /// The struct by its type, which has to be the right one.
  template <class Input>
  const Input& as() const {
    return std::any_cast<const Input&>(value_);
  }
  template <class Input>
  Input& as() {
    return std::any_cast<Input&>(value_);
  }

 private:
  std::any value_;
  void* (*place_)(std::any&) = nullptr;
};

/// A function of a method's own input as one of any method's.
template <class Answer, class Input, class... More>
std::function<Answer(const MethodInput&, More...)> on(Answer (*own)(const Input&, More...)) {
  return [own](const MethodInput& in, More... more) { return own(in.as<Input>(), std::forward<More>(more)...); };
}
template <class Input, class... More>
std::function<void(MethodInput&, More...)> on(void (*own)(Input&, More...)) {
  return [own](MethodInput& in, More... more) { own(in.as<Input>(), std::forward<More>(more)...); };
}

}  // namespace taut::app
