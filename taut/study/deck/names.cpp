#include "taut/study/deck/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/base/suggest.hpp"
#include "taut/study/line/carriage_way.hpp"

namespace taut::study {
namespace {

template <class Things>
std::optional<int> index_named(const Things& things, std::string_view kind, const std::string& name,
                               const DeckPlace& path, std::vector<Complaint>& complaints) {
  std::vector<std::string> known;
  for (const auto& one : things) {
    if (one.name == name) return static_cast<int>(known.size());
    known.push_back(one.name);
  }
  complaints.push_back({path.text(), fmt::format("there is no {} '{}'{}", kind, name, did_you_mean(name, known))});
  return std::nullopt;
}

}  // namespace

std::optional<int> carriage_of(Names& names, const std::string& name, const DeckPlace& path) {
  return index_named(names.model.carriages, "carriage", name, path, names.complaints);
}

std::optional<int> reeving_of(Names& names, const std::string& name, const DeckPlace& path) {
  return index_named(names.model.reevings, "reeving or guy", name, path, names.complaints);
}

std::string ending_of(Names& names, const std::string& kind, const std::optional<std::string>& name,
                      const DeckPlace& path) {
  const auto before =
      std::count_if(names.endings.begin(), names.endings.end(), [&](const auto& e) { return e.first == kind; });
  const std::string text = name ? "_" + *name : before == 0 ? std::string{} : fmt::format("_{}", before + 1);
  if (std::find(names.endings.begin(), names.endings.end(), std::pair(kind, text)) != names.endings.end()) {
    names.complaints.push_back({DeckPlace(path, "name").text(), "another analysis of this kind has the same name"});
  }
  // it becomes part of files' names
  const bool plain = std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  if (!plain || (name && name->empty())) {
    names.complaints.push_back({DeckPlace(path, "name").text(), "a name of letters, digits, _ and - is expected"});
  }
  names.endings.emplace_back(kind, text);
  return text;
}

std::optional<machine::Prescribed> prescribed_of(const std::optional<std::string>& carriage,
                                                 const std::optional<double>& x, const std::vector<double>& along,
                                                 const DeckPlace& path, Names& names) {
  const Vector3 way = direction_of(along, {path, "along"}, names.complaints);
  if (carriage.has_value() != x.has_value()) {
    names.complaints.push_back({path.text(), "'carriage' and 'x' belong together"});
    return std::nullopt;
  }
  if (!carriage) return std::nullopt;
  const auto car = carriage_of(names, *carriage, {path, "carriage"});
  if (!car) return std::nullopt;
  if (const machine::Node* support = support_at(names.model, *car, *x, way)) {
    names.complaints.push_back(
        {DeckPlace(path, "x").text(), fmt::format("the carriage would be on '{}', in no span", support->name)});
  }
  check_hold(names.model, car, names.complaints);
  return machine::Prescribed{.carriage = *car, .x = *x, .along = way, .z = {}};
}

}  // namespace taut::study
