#include "taut/app/design/design_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "taut/base/number.hpp"
#include "taut/base/suggest.hpp"
#include "taut/catalogue/rope_search.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/io/file.hpp"
#include "taut/units/any_quantity.hpp"
#include "taut/units/display.hpp"

namespace taut::app {
namespace {

using catalogue::RopeRow;

constexpr double most_places = 20000;  // of a grid

double cost_of(design::Seek seek, const RopeRow& row) {
  switch (seek) {
    case design::Seek::smallest:
      return row.diameter;
    case design::Seek::cheapest:
      return row.price.value_or(0);
    case design::Seek::lightest:
    case design::Seek::least_tension:
    case design::Seek::most_reserve:
      return row.mass_per_length;
  }
  return 0;
}

std::vector<RopeRow> catalogue_of(const io::Node& input, const design::DesignRequest& design, Diagnostics& mistakes) {
  if (!design.catalogue) return catalogue::ropes();
  const io::Node& node = *io::follow(input, "design.catalogue").node;
  const auto file = io::read_named(node, *design.catalogue, mistakes);
  if (!file) return {};
  if (file->text.size() > io::largest_deck) {
    io::add(mistakes, node.spot,
            fmt::format("'{}' has more than {} MB: keep the ropes that may be chosen", file->path,
                        io::largest_deck >> 20U));
    return {};
  }
  auto rows = catalogue::read_ropes(file->text, file->path);
  if (rows) return std::move(*rows);
  for (Diagnostic& d : rows.error()) io::add(mistakes, io::without_text(std::move(d), file->text));
  return {};
}

catalogue::RopeFilter filter_of(const design::DesignRopeRequest& one) {
  catalogue::RopeFilter filter;
  filter.construction = one.construction.value_or("");
  filter.core = one.core.value_or("");
  filter.standard = one.standard.value_or("");
  filter.grade = one.grade;
  filter.min_diameter = one.least_diameter;
  filter.max_diameter = one.most_diameter;
  filter.min_trust = one.trust;
  return filter;
}

/// The numbers that unknowns are free by, each once, in whatever spelling of its path.
class FreeNumbers {
 public:
  explicit FreeNumbers(const FindParameter& find) : find_(find) {}

  /// Complains at `key` where the number is one of those before.
  void take(const std::string& path, const std::string& unknown, const std::string& key,
            std::vector<Complaint>& complaints) {
    const auto found = find_(path);
    if (!found) return;
    if (const Free* same = at(found->place)) {
      complaints.push_back({key, fmt::format("'{}' is the same number as '{}', which is free by the unknown '{}': give "
                                             "it once",
                                             path, same->path, same->unknown)});
    } else {
      all_.push_back({.place = found->place, .path = path, .unknown = unknown});
    }
  }

  /// The unknown by which a number of that place is free; null: none.
  const std::string* unknown_of(const std::string& place) const {
    const Free* found = at(place);
    return found == nullptr ? nullptr : &found->unknown;
  }

 private:
  struct Free {
    std::string place, path, unknown;
  };

  const Free* at(const std::string& place) const {
    const auto found = std::find_if(all_.begin(), all_.end(), [&](const Free& one) { return one.place == place; });
    return found == all_.end() ? nullptr : &*found;
  }

  const FindParameter& find_;
  std::vector<Free> all_;
};

/// Where a number is while another one goes from where it is to `value`: as far from it as in the deck.
double along(const study::Parameter& own, const study::Parameter& with, double value) {
  const double moved = own.value + (value - with.value);
  return std::isfinite(moved) ? moved : value;
}

void complain_of_company(const design::DesignUnknownRequest& one, const study::Parameter& first,
                         const FindParameter& find, const std::string& path, const design::UnknownValues& range,
                         std::vector<Complaint>& complaints) {
  for (std::size_t i = 0; i < one.along_with.size(); ++i) {
    const std::string own = fmt::format("{}.along_with[{}]", path, i);
    const auto other = find(one.along_with[i]);
    if (!other) {
      complaints.push_back({own, other.error()});
      continue;
    }
    if (!same_kind(other->unit, first.unit)) {
      complaints.push_back(
          {own, fmt::format("'{}' is no quantity of the same kind as '{}'", one.along_with[i], one.parameter)});
      continue;
    }
    for (const double end : {range.low, range.high}) {
      const double moved = along(*other, first, end);
      if (other->range().contains(moved)) continue;
      complaints.push_back(
          {own, fmt::format("'{}' would go with it to {}, and must be {}: choose 'from' and 'to' so "
                            "that it stays there",
                            one.along_with[i], Display().quantity(moved, other->unit), range_text(*other->field))});
      break;
    }
  }
}

/// Where an unknown may be and is tried; empty with complaints.
design::UnknownValues values_of_unknown(const design::DesignUnknownRequest& one, const FindParameter& find,
                                        std::vector<Complaint>& complaints) {
  const std::string path = fmt::format("design.unknowns.{}", one.name);
  design::UnknownValues own;
  own.name = one.name;
  own.parameter = one.parameter;
  own.along_with = one.along_with;
  own.price = one.price.value_or(0);
  if (one.name == "cost" || one.name == "trials") {
    complaints.push_back({path, fmt::format("design_{} is a value of every design: give it another name", one.name)});
  }
  const auto parameter = find(one.parameter);
  if (!parameter) {
    complaints.push_back({path + ".parameter", parameter.error()});
    return own;
  }
  own.unit = parameter->unit;
  const auto from = study::value_of(one.from, *parameter, path + ".from", complaints);
  const auto to = study::value_of(one.to, *parameter, path + ".to", complaints);
  if (!from || !to) return own;
  if (*from == *to) complaints.push_back({path + ".to", "is the same as 'from'"});
  std::tie(own.low, own.high) = std::minmax(*from, *to);
  complain_of_company(one, *parameter, find, path, own, complaints);
  const int steps = one.steps.value_or(one.start ? 0 : 4);
  for (int i = 0; i <= steps && steps > 0; ++i) own.values.push_back(step_between(*from, *to, i, steps));
  if (!one.start) return own;
  const auto start = study::value_of(*one.start, *parameter, path + ".start", complaints);
  if (!start) return own;
  if (*start < own.low || *start > own.high) {
    complaints.push_back({path + ".start", fmt::format("{} is not between {} and {}", *one.start, one.from, one.to)});
  }
  if (std::find(own.values.begin(), own.values.end(), *start) == own.values.end()) own.values.push_back(*start);
  std::sort(own.values.begin(), own.values.end());
  if (*from > *to) std::reverse(own.values.begin(), own.values.end());
  return own;
}

/// The candidates of one rope, in the order of their cost per metre.
design::RopeCandidates candidates_of_rope(const design::DesignRopeRequest& one, design::Seek seek,
                                          const std::vector<RopeRow>& rows, const DesignParts& parts,
                                          std::vector<Complaint>& complaints) {
  const std::string path = fmt::format("design.ropes.{}", one.name);
  design::RopeCandidates own;
  own.name = one.name;
  own.rows = catalogue::select_ropes(filter_of(one), rows);
  if (own.rows.empty()) complaints.push_back({path, "no rope of the catalogue is so: drop a condition"});
  const bool priced =
      std::all_of(own.rows.begin(), own.rows.end(), [](const RopeRow& r) { return r.price.has_value(); });
  if (seek == design::Seek::cheapest && !priced) {
    complaints.push_back({"design.seek", "'cheapest' needs a catalogue with 'price_per_m' in every row"});
  }
  using Key = std::tuple<double, double, const std::string&>;
  std::stable_sort(own.rows.begin(), own.rows.end(), [&](const RopeRow& a, const RopeRow& b) {
    return Key(cost_of(seek, a), a.breaking_force, a.id) < Key(cost_of(seek, b), b.breaking_force, b.id);
  });
  own.costs.reserve(own.rows.size());
  own.moduli.reserve(own.rows.size());
  for (const RopeRow& row : own.rows) {
    own.costs.push_back(cost_of(seek, row));
    const std::optional<double> modulus = one.modulus ? one.modulus : parts.modulus(one.name, row);
    own.moduli.push_back(modulus.value_or(0));
    if (modulus) continue;
    complaints.push_back({path, fmt::format("no modulus is known for the construction of '{}': give 'modulus', or "
                                            "conditions that leave it out",
                                            row.id)});
    break;
  }
  return own;
}

design::DesignCase case_of(const design::DesignCaseRequest& one, const FreeNumbers& free, const FindParameter& find,
                           std::vector<Complaint>& complaints) {
  design::DesignCase own{.name = one.name, .settings = {}};
  std::map<std::string, std::string> set;  // by place the path
  for (const design::DesignSettingRequest& setting : one.settings) {
    const std::string path = fmt::format("design.cases.{}.{}", one.name, setting.name);
    const auto parameter = find(setting.name);
    if (!parameter) {
      complaints.push_back({path, parameter.error()});
      continue;
    }
    if (const std::string* unknown = free.unknown_of(parameter->place)) {
      complaints.push_back({path, fmt::format("'{}' is free by the unknown '{}'", setting.name, *unknown)});
    }
    const auto [before, is_new] = set.emplace(parameter->place, setting.name);
    if (!is_new) {
      complaints.push_back(
          {path, fmt::format("'{}' is the same number as '{}': give it once", setting.name, before->second)});
    }
    if (const auto value = study::value_of(setting.value, *parameter, path, complaints)) {
      own.settings.emplace_back(setting.name, *value);
    }
  }
  return own;
}

void complain_of_seek(const design::DesignRequest& design, const DesignParts& parts,
                      std::vector<Complaint>& complaints) {
  if (design.ropes.empty() && design.sections.empty() && design.unknowns.empty()) {
    complaints.push_back({"design", "says nothing that is free: name 'ropes', 'sections' or 'unknowns'"});
  }
  if (design.of && design.seek != design::Seek::least_tension) {
    complaints.push_back({"design.of", "belongs to 'seek: least_tension'"});
  }
  if (design.seek == design::Seek::least_tension && parts.tensions.empty()) {
    complaints.push_back({"design.seek", fmt::format("{} has no rope whose tension could be least", parts.owner)});
  } else if (design.of && std::find(parts.tensions.begin(), parts.tensions.end(), *design.of) == parts.tensions.end()) {
    complaints.push_back({"design.of", fmt::format("{} has no rope '{}'{}", parts.owner, *design.of,
                                                   did_you_mean(*design.of, parts.tensions))});
  }
  const bool priced = !design.ropes.empty() || !design.sections.empty() ||
                      std::any_of(design.unknowns.begin(), design.unknowns.end(),
                                  [](const design::DesignUnknownRequest& u) { return u.price.has_value(); });
  if (design.seek == design::Seek::cheapest && !priced) {
    complaints.push_back({"design.seek", "nothing that is free has a price: give an unknown its 'price'"});
  }
}

}  // namespace

design::DesignSpace design_space(const io::Node& input, const design::DesignRequest& design, const DesignParts& parts,
                                 Diagnostics& mistakes) {
  design::DesignSpace space;
  std::vector<Complaint> complaints;
  Diagnostics unreadable;
  const std::vector<RopeRow> rows = catalogue_of(input, design, unreadable);
  complain_of_seek(design, parts, complaints);
  for (const design::DesignRopeRequest& one : design.ropes) {
    if (std::find(parts.ropes.begin(), parts.ropes.end(), one.name) == parts.ropes.end()) {
      complaints.push_back({fmt::format("design.ropes.{}", one.name),
                            parts.ropes.empty() ? fmt::format("{} has no rope that can be chosen", parts.owner)
                                                : fmt::format("{} has no rope '{}'{}", parts.owner, one.name,
                                                              did_you_mean(one.name, parts.ropes))});
    } else if (unreadable.empty()) {
      space.ropes.push_back(candidates_of_rope(one, design.seek, rows, parts, complaints));
    }
  }
  for (const design::DesignSectionRequest& one : design.sections) {
    space.sections.push_back(candidates_of_section(one, design.seek, parts.sections, parts.owner, complaints));
  }
  double places = 1;
  FreeNumbers free(parts.parameter);
  for (const design::DesignUnknownRequest& one : design.unknowns) {
    const std::string path = fmt::format("design.unknowns.{}", one.name);
    free.take(one.parameter, one.name, path + ".parameter", complaints);
    for (std::size_t i = 0; i < one.along_with.size(); ++i) {
      free.take(one.along_with[i], one.name, fmt::format("{}.along_with[{}]", path, i), complaints);
    }
    space.unknowns.push_back(values_of_unknown(one, parts.parameter, complaints));
    places *= static_cast<double>(space.unknowns.back().values.size());
  }
  if (places > most_places) {
    complaints.push_back(
        {"design.unknowns", fmt::format("their grid has {:.3g} places, more than {:.0f}: fewer 'steps', "
                                        "or a 'start' without steps",
                                        places, most_places)});
  }
  for (const design::DesignCaseRequest& one : design.cases) {
    space.cases.push_back(case_of(one, free, parts.parameter, complaints));
  }
  for (Diagnostic& d : unreadable) io::add(mistakes, std::move(d));
  io::place(input, complaints, mistakes);
  return space;
}

void put_values(const design::DesignSpace& space, const std::vector<double>& values, const FindParameter& parameter) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    const design::UnknownValues& one = space.unknowns[k];
    const auto first = parameter(one.parameter);
    if (!first) continue;
    for (const std::string& path : one.along_with) {
      const auto other = parameter(path);
      if (other) other->set(along(*other, *first, values[k]));
    }
    first->set(values[k]);
  }
}

void put_case(const design::DesignCase& one, const FindParameter& parameter) {
  for (const auto& [path, value] : one.settings) {
    if (const auto found = parameter(path)) found->set(value);
  }
}

design::DesignLengths by_the_metre(const design::DesignRequest& request, const design::DesignSpace& space,
                                   const std::vector<double>& values) {
  design::DesignLengths lengths{.ropes = std::vector<double>(space.ropes.size(), 1),
                                .sections = std::vector<double>(space.sections.size(), 1),
                                .rest = 0};
  if (request.seek != design::Seek::cheapest) return lengths;
  for (std::size_t k = 0; k < values.size(); ++k) lengths.rest += space.unknowns[k].price * values[k];
  return lengths;
}

}  // namespace taut::app
