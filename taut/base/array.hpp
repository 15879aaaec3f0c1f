#pragma once
#include <concepts>
#include <cstddef>
#include <utility>
#include <vector>

namespace taut {

/// A std::vector that takes an index of any integer type. The indices of a model are int, so no cast is needed where
/// they are used. An index outside the array is a bug; only a checked standard library detects it.
template <class T>
class Array : public std::vector<T> {
  using Base = std::vector<T>;

 public:
  using Base::Base;
  Array() = default;
  Array(Base all) : Base(std::move(all)) {}

  decltype(auto) operator[](std::integral auto i) { return Base::operator[](static_cast<std::size_t>(i)); }
  decltype(auto) operator[](std::integral auto i) const { return Base::operator[](static_cast<std::size_t>(i)); }
};

}  // namespace taut
