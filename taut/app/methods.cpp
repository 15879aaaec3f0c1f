#include "taut/app/methods.hpp"

#include <algorithm>
#include <memory>

#include "taut/app/embedded/examples.hpp"
#include "taut/app/exact/closed_loop_exact.hpp"
#include "taut/app/exact/friction_drive_exact.hpp"
#include "taut/app/exact/mast_section_exact.hpp"
#include "taut/app/method_checks.hpp"
#include "taut/base/expects.hpp"
#include "taut/io/read.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/closed_loop/closed_loop.hpp"
#include "taut/methods/friction_drive/friction_drive.hpp"
#include "taut/methods/mast_section/mast_section.hpp"

namespace taut::app {
namespace {

std::string_view example_of(const std::string& method) {
  for (const auto& [file, text] : embedded::examples) {
    if (file == method + ".yaml") return text;
  }
  expects(false, "no example for " + method);
  return {};
}

/// What the engine adds to a method's result, and the description of its values.
template <class Input>
struct Exact {
  const Description* values = nullptr;
  void (*complete)(const Input&, Result&) = nullptr;
};

/// The block `checks:` of a deck, and with it what it needs of the method.
struct ChecksBlock {
  std::optional<ChecksRequest> checks;
  static const Description& describe() {
    static const Description d =
        Describe<ChecksBlock>().record(&ChecksBlock::checks, "checks", "which parts are checked by which rules");
    return d;
  }
};

template <class Input, class Output>
MethodEntry entry(const Method& about, std::vector<Complaint> (*complaints)(const Input&), Result (*run)(const Input&),
                  const Exact<Input>& exact = {}, const MethodChecks<Input>& offered = {}) {
  MethodEntry e;
  e.about = &about;
  e.input = &Input::describe();
  e.output = &Output::describe();
  e.exact = exact.values;
  e.example = example_of(about.name);
  const std::string what = "the input of " + about.name;
  e.prepare = [complaints, run, what, name = about.name, offered, complete = exact.complete](
                  const io::Node& node, const io::Node* checks, Diagnostics& mistakes) -> std::function<Result()> {
    const auto in = std::make_shared<Input>();
    const auto asked = std::make_shared<ChecksBlock>();
    bool readable = io::read(node, Input::describe(), in.get(), what, mistakes);
    if (checks != nullptr) readable &= io::read(*checks, ChecksBlock::describe(), asked.get(), "the deck", mistakes);
    if (!readable) return {};
    std::vector<Complaint> broken = complaints(*in);
    io::place(node, broken, mistakes);
    const auto ropes = [offered](const Input& i, const Result* r) {
      return offered.ropes != nullptr ? offered.ropes(i, r) : std::vector<rope::RopeUse>{};
    };
    if (broken.empty() && asked->checks) {
      broken = method_check_complaints(*asked->checks, ropes(*in, nullptr), name);
      io::place(*checks, broken, mistakes);
    }
    if (!broken.empty()) return {};
    return [in, asked, run, ropes, complete] {
      Result r = run(*in);
      if (complete != nullptr) complete(*in, r);
      if (asked->checks) add_method_checks(*asked->checks, ropes(*in, &r), r);
      return r;
    };
  };
  return e;
}

}  // namespace

const std::vector<MethodEntry>& methods() {
  static const std::vector<MethodEntry> all = {
      entry<mast_section::Input, mast_section::Output>(
          mast_section::about(), mast_section::complaints, mast_section::run,
          {&MastSectionExact::describe(), complete_mast_section}, {ropes_of_mast}),
      entry<closed_loop::Input, closed_loop::Output>(closed_loop::about(), closed_loop::complaints, run_closed_loop, {},
                                                     {ropes_of_loop}),
      entry<friction_drive::Input, friction_drive::Output>(
          friction_drive::about(), friction_drive::complaints, friction_drive::run,
          {&FrictionDriveExact::describe(), complete_friction_drive}, {ropes_of_drive}),
      entry<boom_ropes::Input, boom_ropes::Output>(boom_ropes::about(), boom_ropes::complaints, boom_ropes::run, {},
                                                   {ropes_of_boom}),
  };
  return all;
}

const MethodEntry* find_method(std::string_view name) {
  const auto& all = methods();
  const auto at = std::find_if(all.begin(), all.end(), [&](const MethodEntry& e) { return e.about->name == name; });
  return at == all.end() ? nullptr : &*at;
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const MethodEntry& e : methods()) names.push_back(e.about->name);
  return names;
}

}  // namespace taut::app
