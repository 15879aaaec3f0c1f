#include "taut/app/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include "taut/analysis/sizing.hpp"
#include "taut/app/rope_uses.hpp"
#include "taut/base/suggest.hpp"
#include "taut/catalogue/rope_search.hpp"
#include "taut/io/include.hpp"
#include "taut/io/read.hpp"
#include "taut/model/compile.hpp"

namespace taut::app {
namespace {

using analysis::SizingCandidate;
using analysis::SizingTrial;
using catalogue::RopeRow;

constexpr double nearly_active = 0.9;  // utilisation of checks that are told as active

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

std::string names_of(const DesignSpace& space, const std::vector<std::size_t>& choice) {
  std::string all;
  for (std::size_t k = 0; k < choice.size(); ++k) {
    all += fmt::format("{}{}: {}", k == 0 ? "" : "; ", space.ropes[k].name, space.ropes[k].rows[choice[k]].id);
  }
  return all;
}

/// The check that decides: of those that fail the worst, else the one nearest to its limit.
SizingTrial trial_of(const Result& r) {
  if (r.status != Status::ok) return {false, std::nan(""), r.message};
  SizingTrial trial{true, 0, "no check"};
  for (const Check& c : r.checks) {
    const double u = std::isnan(c.utilisation) ? HUGE_VAL : c.utilisation;
    if (!c.passes) trial.passes = false;
    if (u < trial.utilisation) continue;
    trial.utilisation = u;
    trial.governs = c.name;
  }
  return trial;
}

/// A deck that looks at one place of each load path only, where the rope was worst before. What fails there fails in
/// the whole: every check takes the worst of all states.
MachineDeck at_places(const MachineDeck& deck, const std::map<std::size_t, double>& places) {
  MachineDeck probe = deck;
  for (const auto& [i, x] : places) {
    LoadPathRequest& one = *probe.analyses[i].load_path;
    one.from = one.to = x;
    one.steps = 1;
  }
  std::erase_if(probe.analyses, [](const AnalysisRequest& a) { return !a.load_path && !a.equilibrium; });
  return probe;
}

/// Where each load path has its largest tension by its table; empty where there is none.
std::map<std::size_t, double> worst_places(const MachineDeck& deck, const Result& r) {
  std::map<std::size_t, double> places;
  std::size_t number = 0;
  for (std::size_t i = 0; i < deck.analyses.size(); ++i) {
    if (!deck.analyses[i].load_path) continue;
    ++number;
    const auto& name = deck.analyses[i].load_path->name;
    const std::string table = "load_path" + (name          ? "_" + *name
                                             : number == 1 ? std::string{}
                                                           : fmt::format("_{}", number));
    const Table* t = r.find_table(table);
    if (t == nullptr) continue;
    double most = 0;
    for (const auto& row : t->rows) {
      for (std::size_t c = 0; c < t->columns.size(); ++c) {
        const auto* T = std::get_if<double>(&row[c]);
        if (T == nullptr || !t->columns[c].name.ends_with(".T_max") || !(*T > most)) continue;
        most = *T;
        places[i] = std::get<double>(row.front());
      }
    }
  }
  return places;
}

class Design {
 public:
  Design(const MachineDeck& deck, const DesignSpace& space, const RunDeck& run)
      : deck_(deck), space_(space), run_(run) {}

  SizingTrial try_one(const std::vector<std::size_t>& choice) {
    const MachineDeck whole = with_choice(deck_, space_, choice);
    if (!places_.empty()) {
      const Result r = run_(at_places(whole, places_), true);
      const SizingTrial probe = trial_of(r);
      if (!probe.passes) return probe;
    }
    const Result r = run_(whole, true);
    const SizingTrial trial = trial_of(r);
    if (!trial.passes) places_ = worst_places(deck_, r);
    return trial;
  }

 private:
  const MachineDeck& deck_;
  const DesignSpace& space_;
  const RunDeck& run_;
  std::map<std::size_t, double> places_;
};

Table chosen_table(const DesignSpace& space, const SizingCandidate& best) {
  Table t{"design", "The ropes chosen", {}, {}};
  t.columns = {{"rope", si::one},
               {"designation", si::one},
               {"diameter", si::m.in("mm")},
               {"area", si::m2},
               {"mass_per_metre", si::kg_per_m},
               {"grade", si::Pa},
               {"breaking_force", si::N},
               {"stiffness", si::N},
               {"trust", si::one}};
  for (std::size_t k = 0; k < space.ropes.size(); ++k) {
    const RopeRow& row = space.ropes[k].rows[best.choice[k]];
    t.rows.push_back({space.ropes[k].name, row.id, row.diameter, row.area, row.mass_per_length,
                      row.grade.value_or(std::nan("")), row.breaking_force, space.ropes[k].modulus * row.area,
                      std::string(catalogue::to_text(row.trust))});
  }
  return t;
}

Unit cost_unit(Seek seek) {
  return seek == Seek::lightest ? si::kg : seek == Seek::smallest ? si::m.in("mm") : si::one;
}

Table runner_ups(const DesignSpace& space, Seek seek, const analysis::SizingAnswer& answer) {
  Table t{"design_runner_ups", "The choice between its neighbours, and what governs each", {}, {}};
  t.columns = {{"choice", si::one},
               {"cost", cost_unit(seek)},
               {"outcome", si::one},
               {"governs", si::one},
               {"utilisation", si::one}};
  const auto add = [&](const SizingCandidate& c, const char* outcome) {
    t.rows.push_back({names_of(space, c.choice), c.cost, std::string(outcome), c.trial.governs, c.trial.utilisation});
  };
  for (const SizingCandidate& c : answer.below) add(c, "fails");
  if (answer.outcome.ok()) add(answer.best, "chosen");
  for (const SizingCandidate& c : answer.above) add(c, "passes");
  return t;
}

Table active_checks(const Result& r) {
  Table t{"design_active", "Checks near their limits: what holds the design", {}, {}};
  t.columns = {{"check", si::one}, {"utilisation", si::one}, {"rule", si::one}, {"trust", si::one}};
  std::vector<Check> all = r.checks;
  std::stable_sort(all.begin(), all.end(),
                   [](const Check& a, const Check& b) { return a.utilisation > b.utilisation; });
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i > 0 && all[i].utilisation < nearly_active) break;
    t.rows.push_back({all[i].name, all[i].utilisation, all[i].rule, all[i].trust});
  }
  return t;
}

void add_design(const MachineDeck& deck, const DesignSpace& space, const analysis::SizingAnswer& answer, Result& r) {
  const Seek seek = deck.design->seek;
  static constexpr const char* what[] = {"mass of the ropes chosen, by their straight lengths",
                                         "sum of the diameters chosen",
                                         "price of the ropes chosen, by their straight lengths"};
  r.values.insert(r.values.begin(),
                  {"design_cost", answer.best.cost, cost_unit(seek), "cost", what[static_cast<int>(seek)], {}});
  r.values.push_back({"design_trials",
                      static_cast<double>(answer.trials),
                      si::one,
                      "trials",
                      "choices tried up to the one that passes",
                      {}});
  std::vector<Table> tables = {chosen_table(space, answer.best), active_checks(r), runner_ups(space, seek, answer)};
  r.tables.insert(r.tables.begin(), std::make_move_iterator(tables.begin()), std::make_move_iterator(tables.end()));
}

}  // namespace

DesignSpace design_space(const io::Node& input, const MachineDeck& deck, Diagnostics& mistakes) {
  DesignSpace space;
  const DesignRequest& design = *deck.design;
  std::vector<Complaint> complaints;
  const std::vector<RopeRow> rows = catalogue_of(input, design, mistakes);
  if (!mistakes.empty()) return space;
  if (design.ropes.empty()) complaints.push_back({"design", "says nothing that is free: name 'ropes' to choose"});
  if (!deck.checks) complaints.push_back({"design", "needs 'checks': a design is what passes them"});
  for (const DesignRopeRequest& one : design.ropes) {
    const std::string path = fmt::format("design.ropes.{}", one.name);
    std::vector<std::string> known;
    known.reserve(deck.machine.ropes.size());
    for (const auto& rope : deck.machine.ropes) known.push_back(rope.name);
    if (std::find(known.begin(), known.end(), one.name) == known.end()) {
      complaints.push_back(
          {path, fmt::format("the machine has no rope '{}'{}", one.name, did_you_mean(one.name, known))});
      continue;
    }
    RopeCandidates own;
    own.name = one.name;
    own.modulus = one.modulus;
    own.rows = catalogue::select_ropes(filter_of(one), rows);
    if (own.rows.empty()) complaints.push_back({path, "no rope of the catalogue is so: drop a condition"});
    const bool priced =
        std::all_of(own.rows.begin(), own.rows.end(), [](const RopeRow& r) { return r.price.has_value(); });
    if (design.seek == Seek::cheapest && !priced) {
      complaints.push_back({"design.seek", "'cheapest' needs a catalogue with 'price_per_m' in every row"});
    }
    std::stable_sort(own.rows.begin(), own.rows.end(), [&](const RopeRow& a, const RopeRow& b) {
      return std::tuple(cost_of(design.seek, a), a.breaking_force, a.id) <
             std::tuple(cost_of(design.seek, b), b.breaking_force, b.id);
    });
    space.ropes.push_back(std::move(own));
  }
  io::place(input, complaints, mistakes);
  if (!mistakes.empty()) return space;
  const MachineDeck first = with_choice(deck, space, std::vector<std::size_t>(space.ropes.size(), 0));
  for (RopeCandidates& own : space.ropes) {
    own.length = design.seek == Seek::smallest ? 1 : length_of(own.name, first);
    for (const RopeRow& row : own.rows) own.costs.push_back(cost_of(design.seek, row) * own.length);
  }
  return space;
}

MachineDeck with_choice(const MachineDeck& deck, const DesignSpace& space, const std::vector<std::size_t>& choice) {
  MachineDeck own = deck;
  for (std::size_t k = 0; k < choice.size(); ++k) {
    const RopeCandidates& free = space.ropes[k];
    for (auto& rope : own.machine.ropes) {
      if (rope.name == free.name) put(free.rows[choice[k]], free.modulus, rope);
    }
    own.chosen[free.name] = free.rows[choice[k]];
  }
  return own;
}

Result run_design(const MachineDeck& deck, const DesignSpace& space, const RunDeck& run) {
  analysis::SizingOptions options;
  options.most_trials = static_cast<std::size_t>(deck.design->most_trials);
  options.neighbours = static_cast<std::size_t>(deck.design->runner_ups);
  std::vector<std::vector<double>> costs;
  costs.reserve(space.ropes.size());
  for (const RopeCandidates& one : space.ropes) costs.push_back(one.costs);
  Design design(deck, space, run);
  const auto answer = analysis::cheapest(
      costs, [&](const std::vector<std::size_t>& c) { return design.try_one(c); }, options);
  if (!answer.outcome.ok()) {
    Result r;
    r.method_title = "Machine";
    r.given = given_of(MachineDeck::describe(), &deck);
    r.status = answer.outcome.status;
    r.message = fmt::format("design: {}", answer.outcome.message);
    if (!answer.below.empty()) {
      const SizingCandidate& last = answer.below.back();
      r.message += fmt::format(
          "; the last one tried, {}, fails by {}{}", names_of(space, last.choice), last.trial.governs,
          std::isfinite(last.trial.utilisation) ? fmt::format(" (utilisation {:.3g})", last.trial.utilisation)
                                                : std::string{});
    }
    r.tables.push_back(runner_ups(space, deck.design->seek, answer));
    return r;
  }
  Result r = run(with_choice(deck, space, answer.best.choice), false);
  add_design(deck, space, answer, r);
  return r;
}

}  // namespace taut::app
