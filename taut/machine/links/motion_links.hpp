#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/base/suggest.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/links/links.hpp"
#include "taut/machine/motion.hpp"

namespace taut::machine {

using Complaints = std::vector<Complaint>;

/// Index of the first of that name.
template <class All>
std::optional<int> index_of(const All& all, const std::string& name) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  return at == all.end() ? std::nullopt : std::optional(static_cast<int>(at - all.begin()));
}

/// Index of the thing of that name; a complaint when there is none.
template <class All>
std::optional<int> named(const All& all, const std::string& name, const char* what, const std::string& path,
                         Complaints& complaints) {
  if (const auto i = index_of(all, name)) return i;
  std::vector<std::string> names;
  for (const auto& one : all) names.push_back(one.name);
  complaints.push_back({path, fmt::format("there is no {} '{}'{}", what, name, did_you_mean(name, names))});
  return std::nullopt;
}

/// What drives something, from the three keys of which it has one; none: empty.
std::optional<Drive> drive_of(const std::optional<std::string>& speed, const std::optional<std::string>& torque,
                              const std::optional<std::string>& pull, const Array<Signal>& signals,
                              const std::string& path, Complaints& complaints);

/// What happens, and when. `model`: everything but its events.
Event event_of(const description::Event& given, const Model& model, const std::string& path, Complaints& complaints);

}  // namespace taut::machine
