#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <tuple>
#include <utility>

#include "taut/app/design.hpp"
#include "taut/app/parameter.hpp"
#include "taut/app/rope_uses.hpp"
#include "taut/base/suggest.hpp"
#include "taut/catalogue/rope_search.hpp"
#include "taut/io/include.hpp"
#include "taut/io/read.hpp"
#include "taut/model/compile.hpp"
#include "taut/units/parse.hpp"

namespace taut::app {
namespace {

using catalogue::RopeRow;

double cost_of(Seek seek, const RopeRow& row) {
  switch (seek) {
    case Seek::lightest:
      return row.mass_per_length;
    case Seek::smallest:
      return row.diameter;
    case Seek::cheapest:
      return row.price.value_or(0);
  }
  return 0;
}

std::vector<RopeRow> catalogue_of(const io::Node& input, const DesignRequest& design, Diagnostics& mistakes) {
  if (!design.catalogue) return catalogue::ropes();
  namespace fs = std::filesystem;
  const io::Node& node = *io::follow(input, "design.catalogue").node;
  const fs::path deck = node.spot.source ? fs::path(node.spot.source->name) : fs::path();
  const fs::path path = deck.parent_path() / *design.catalogue;
  const auto text = io::read_file(path.string());
  if (!text) {
    io::add(mistakes, node.spot, fmt::format("can't read '{}': {}", path.string(), text.error()));
    return {};
  }
  if (text->size() > io::largest_deck) {
    io::add(mistakes, node.spot,
            fmt::format("'{}' has more than {} MB: keep the ropes that may be chosen", path.string(),
                        io::largest_deck >> 20U));
    return {};
  }
  auto rows = catalogue::read_ropes(*text, path.string());
  if (rows) return std::move(*rows);
  for (Diagnostic& d : rows.error()) io::add(mistakes, std::move(d));
  return {};
}

catalogue::RopeFilter filter_of(const DesignRopeRequest& one) {
  catalogue::RopeFilter filter;
  filter.construction = one.construction.value_or("");
  filter.core = one.core.value_or("");
  filter.standard = one.standard.value_or("");
  filter.grade = one.grade;
  filter.min_diameter = one.least_diameter;
  filter.max_diameter = one.most_diameter;
  filter.min_trust = one.trust == LeastTrust::verified  ? catalogue::Trust::verified
                     : one.trust == LeastTrust::derived ? catalogue::Trust::derived
                                                        : catalogue::Trust::unverified;
  return filter;
}

/// Straight length of all that is reeved of a rope, m.
double length_of(const std::string& rope, const MachineDeck& deck) {
  const auto model = model::compile(deck.machine);
  if (!model) return 1;
  const model::State state = model::initial_state(*model);
  double length = 0;
  for (std::size_t i = 0; i < model->reevings.size(); ++i) {
    if (rope_name_of(deck.machine, i) != rope) continue;
    const model::Reeving& own = model->reevings[i];
    for (int k = 0; k < model::branch_count(own); ++k) {
      const auto at = static_cast<std::size_t>(k);
      length += own.copies * model::straight_length(state, own.nodes[at], own.nodes[(at + 1) % own.nodes.size()]);
    }
  }
  return length > 0 ? length : 1;
}

/// Ropes whose figures say nothing yet are compiled with those of their first candidate.
void put(const RopeRow& row, double modulus, model::description::Rope& rope) {
  rope.rope.reset();
  rope.mass = row.mass_per_length;
  rope.breaking_force = row.breaking_force;
  rope.diameter = row.diameter;
  rope.stiffness = modulus * row.area;
}

/// The values at which an unknown is tried; empty with complaints.
UnknownValues values_of_unknown(const DesignUnknownRequest& one, const MachineDeck& deck,
                                std::vector<Complaint>& complaints) {
  const std::string path = fmt::format("design.unknowns.{}", one.name);
  UnknownValues own;
  own.name = one.name;
  own.parameter = one.parameter;
  model::Machine machine = deck.machine;
  const auto parameter = find_parameter(model::Machine::describe(), &machine, one.parameter);
  if (!parameter) {
    complaints.push_back({path + ".parameter", parameter.error()});
    return own;
  }
  own.unit = parameter->unit;
  std::vector<double> ends;
  for (const auto& [text, key] : {std::pair(one.from, "from"), std::pair(one.to, "to")}) {
    const auto number = parse_quantity(text, parameter->unit);
    if (!number) {
      complaints.push_back({fmt::format("{}.{}", path, key), number.error().message});
    } else if (parameter->unit.is_angle == parameter->field->unit.is_angle &&
               !parameter->field->range.contains(*number)) {
      complaints.push_back({fmt::format("{}.{}", path, key),
                            fmt::format("must be {}, not {}", io::range_text(*parameter->field), text)});
    } else {
      ends.push_back(*number);
    }
  }
  if (ends.size() < 2) return own;
  for (int i = 0; i <= one.steps; ++i) own.values.push_back(ends[0] + (ends[1] - ends[0]) * i / one.steps);
  return own;
}

/// The candidates of one rope, in the order of their cost per metre.
RopeCandidates candidates_of_rope(const DesignRopeRequest& one, Seek seek, const std::vector<RopeRow>& rows,
                                  std::vector<Complaint>& complaints) {
  const std::string path = fmt::format("design.ropes.{}", one.name);
  RopeCandidates own;
  own.name = one.name;
  own.modulus = one.modulus;
  own.rows = catalogue::select_ropes(filter_of(one), rows);
  if (own.rows.empty()) complaints.push_back({path, "no rope of the catalogue is so: drop a condition"});
  const bool priced =
      std::all_of(own.rows.begin(), own.rows.end(), [](const RopeRow& r) { return r.price.has_value(); });
  if (seek == Seek::cheapest && !priced) {
    complaints.push_back({"design.seek", "'cheapest' needs a catalogue with 'price_per_m' in every row"});
  }
  using Key = std::tuple<double, double, const std::string&>;
  std::stable_sort(own.rows.begin(), own.rows.end(), [&](const RopeRow& a, const RopeRow& b) {
    return Key(cost_of(seek, a), a.breaking_force, a.id) < Key(cost_of(seek, b), b.breaking_force, b.id);
  });
  return own;
}

}  // namespace

DesignSpace design_space(const io::Node& input, const MachineDeck& deck, Diagnostics& mistakes) {
  DesignSpace space;
  const DesignRequest& design = *deck.design;
  std::vector<Complaint> complaints;
  const std::vector<RopeRow> rows = catalogue_of(input, design, mistakes);
  if (!mistakes.empty()) return space;
  if (design.ropes.empty() && design.sections.empty() && design.unknowns.empty()) {
    complaints.push_back({"design", "says nothing that is free: name 'ropes', 'sections' or 'unknowns'"});
  }
  if (!deck.checks) complaints.push_back({"design", "needs 'checks': a design is what passes them"});
  std::vector<std::string> known;
  known.reserve(deck.machine.ropes.size());
  for (const auto& rope : deck.machine.ropes) known.push_back(rope.name);
  for (const DesignRopeRequest& one : design.ropes) {
    if (std::find(known.begin(), known.end(), one.name) != known.end()) {
      space.ropes.push_back(candidates_of_rope(one, design.seek, rows, complaints));
      continue;
    }
    complaints.push_back({fmt::format("design.ropes.{}", one.name),
                          fmt::format("the machine has no rope '{}'{}", one.name, did_you_mean(one.name, known))});
  }
  for (const DesignSectionRequest& one : design.sections) {
    space.sections.push_back(candidates_of_beam(one, deck, complaints));
  }
  for (const DesignUnknownRequest& one : design.unknowns) {
    space.unknowns.push_back(values_of_unknown(one, deck, complaints));
  }
  io::place(input, complaints, mistakes);
  if (!mistakes.empty()) return space;
  const MachineDeck first =
      with_choice(deck, space, std::vector<std::size_t>(space.ropes.size() + space.sections.size(), 0));
  weigh_sections(first, space);
  for (RopeCandidates& own : space.ropes) {
    own.length = design.seek == Seek::smallest ? 1 : length_of(own.name, first);
    own.costs.reserve(own.rows.size());
    for (const RopeRow& row : own.rows) own.costs.push_back(cost_of(design.seek, row) * own.length);
  }
  return space;
}

MachineDeck with_choice(const MachineDeck& deck, const DesignSpace& space, const std::vector<std::size_t>& choice) {
  MachineDeck own = deck;
  for (std::size_t k = 0; k < space.sections.size(); ++k) {
    const std::size_t row = choice[space.ropes.size() + k];
    for (auto& beam : own.machine.beams) {
      if (beam.name == space.sections[k].name) beam.section = space.sections[k].rows[row].name;
    }
  }
  for (std::size_t k = 0; k < space.ropes.size(); ++k) {
    const RopeCandidates& free = space.ropes[k];
    for (auto& rope : own.machine.ropes) {
      if (rope.name == free.name) put(free.rows[choice[k]], free.modulus, rope);
    }
    own.chosen[free.name] = free.rows[choice[k]];
  }
  return own;
}

MachineDeck with_values(const MachineDeck& deck, const DesignSpace& space, const std::vector<double>& values) {
  MachineDeck own = deck;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto parameter = find_parameter(model::Machine::describe(), &own.machine, space.unknowns[k].parameter);
    if (parameter) parameter->set(values[k]);
  }
  return own;
}

}  // namespace taut::app
