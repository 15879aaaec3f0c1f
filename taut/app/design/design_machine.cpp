#include "taut/app/design/design_machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "taut/app/design/design_space.hpp"
#include "taut/catalogue/modulus.hpp"
#include "taut/catalogue/section_search.hpp"
#include "taut/checks/parts.hpp"
#include "taut/checks/rope/rope_uses.hpp"
#include "taut/design/design_checks.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/machine/compile.hpp"
#include "taut/study/deck/temperature.hpp"
#include "taut/study/sweep.hpp"

namespace taut::app {
namespace {

using catalogue::RopeRow;

constexpr double steel_density = 7850;  // kg/m3

FindParameter parameters_of(MachineDeck& deck) {
  return [&deck](const std::string& path) {
    return path.starts_with("analyses") ? study::find_parameter(MachineDeck::describe(), &deck, path)
                                        : study::find_parameter(machine::Machine::describe(), &deck.machine, path);
  };
}

DesignParts parts_of(MachineDeck& deck) {
  DesignParts parts;
  parts.owner = "the machine";
  for (const auto& rope : deck.machine.ropes) parts.ropes.push_back(rope.name);
  parts.tensions = parts.ropes;
  for (const auto& reeving : deck.machine.reevings) parts.tensions.push_back(name_of(reeving));
  for (const auto& guy : deck.machine.guys) parts.tensions.push_back(guy.name);
  for (const auto& beam : deck.machine.beams) {
    const std::string refused =
        beam.section ? std::string{}
                     : fmt::format(
                           "beam '{}' has its section by figures: give it a 'section' of the catalogue to begin "
                           "with",
                           beam.name);
    parts.sections.push_back({beam.name, beam.steel, refused});
  }
  if (deck.checks) add_masts(deck.checks->masts, parts.sections);
  parts.parameter = parameters_of(deck);
  parts.modulus = [&deck](const std::string& name, const RopeRow& row) -> std::optional<double> {
    for (const auto& rope : deck.machine.ropes) {
      if (rope.name == name && rope.stiffness) return *rope.stiffness / row.area;
    }
    const auto stiffness = catalogue::stiffness_of(row);
    return stiffness ? std::optional(stiffness->modulus) : std::nullopt;
  };
  return parts;
}

/// A number that an unknown or a load case changes.
struct Change {
  std::string at;    ///< where the deck says so: "design.cases.full.loads.car.mass"
  std::string path;  ///< of the number
};

std::vector<Change> changes_of(const design::DesignSpace& space) {
  std::vector<Change> all;
  for (const design::UnknownValues& one : space.unknowns) {
    all.push_back({fmt::format("design.unknowns.{}.parameter", one.name), one.parameter});
    for (std::size_t i = 0; i < one.along_with.size(); ++i) {
      all.push_back({fmt::format("design.unknowns.{}.along_with[{}]", one.name, i), one.along_with[i]});
    }
  }
  for (const design::DesignCase& one : space.cases) {
    for (const auto& [path, value] : one.settings) {
      all.push_back({fmt::format("design.cases.{}.{}", one.name, path), path});
    }
  }
  return all;
}

/// Where in the deck the temperature of the machine is free, or another one in a load case.
std::vector<std::string> temperatures_of(const design::DesignSpace& space, const FindParameter& find) {
  std::vector<std::string> places;
  for (const Change& one : changes_of(space)) {
    const auto found = find(one.path);
    if (found && found->place == "temperature") places.push_back(one.at);
  }
  return places;
}

/// Ropes whose figures say nothing yet are compiled with those of their first candidate. A mass or stiffness of the
/// deck goes before that of the row, as it does beside a `rope` of the deck.
void put_rope(const RopeRow& row, double modulus, machine::description::Rope& rope) {
  rope.rope.reset();
  rope.mass = rope.mass.value_or(row.mass_per_length);
  rope.breaking_force = row.breaking_force;
  rope.diameter = row.diameter;
  rope.stiffness = rope.stiffness.value_or(modulus * row.area);
}

/// What the deck says of a rope that is chosen and no candidate could have.
void complain_of_ropes(const design::DesignRequest& design, const machine::Machine& machine,
                       std::vector<Complaint>& complaints) {
  for (const design::DesignRopeRequest& one : design.ropes) {
    const auto rope =
        std::find_if(machine.ropes.begin(), machine.ropes.end(), [&](const auto& own) { return own.name == one.name; });
    if (rope == machine.ropes.end()) continue;
    const auto fixed = [&](const std::optional<double>& value, const char* key) {
      if (!value) return;
      complaints.push_back({fmt::format("machine.ropes.{}.{}", one.name, key),
                            fmt::format("'design' chooses this rope, and each candidate has its own {}: leave it out, "
                                        "or give the rope by figures and leave 'design.ropes.{}' out",
                                        key, one.name)});
    };
    fixed(rope->breaking_force, "breaking_force");
    fixed(rope->diameter, "diameter");
    if (!rope->stiffness || !one.modulus) continue;
    complaints.push_back({fmt::format("design.ropes.{}.modulus", one.name),
                          "is given beside the 'stiffness' of the rope: give one of the two"});
  }
}

/// Length of a reeving, all copies, m: what the deck gives it, unless every analysis has another one; else the straight
/// one.
double length_of(const MachineDeck& deck, const machine::Reeving& reeving, std::size_t i, const machine::State& state) {
  if (reeving.described_length &&
      !study::is_set_anew(deck.machine, deck.analyses, fmt::format("machine.reevings[{}].length", i))) {
    return reeving.copies * *reeving.described_length;
  }
  double length = 0;
  for (int k = 0; k < machine::branch_count(reeving); ++k) {
    const auto at = static_cast<std::size_t>(k);
    length += reeving.copies *
              machine::straight_length(state, reeving.nodes[at], reeving.nodes[(at + 1) % reeving.nodes.size()]);
  }
  return length;
}

double mass_per_metre(const machine::description::Beam& beam) {
  if (beam.mass) return *beam.mass;
  if (beam.section) {
    if (const auto row = catalogue::find_section(*beam.section)) return row->mass_per_length;
  }
  return beam.A.value_or(0) * steel_density;
}

template <class Candidates>
std::optional<std::size_t> free_one(const Candidates& free, const std::string& name) {
  const auto found = std::find_if(free.begin(), free.end(), [&](const auto& one) { return one.name == name; });
  if (found == free.end()) return std::nullopt;
  return static_cast<std::size_t>(found - free.begin());
}

/// Of the ropes that are free; in `rest` the mass of the others, where that counts.
void set_rope_lengths(const MachineDeck& deck, const machine::Model& model, const design::DesignSpace& space,
                      bool by_mass, design::DesignLengths& lengths) {
  std::map<std::string, double> of_rope;
  const machine::State state = machine::initial_state(model);
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    const std::string& rope = checks::rope_name_of(deck.machine, i);
    const double length = length_of(deck, model.reevings[i], i, state);
    of_rope[rope] += length;
    if (by_mass && !free_one(space.ropes, rope)) lengths.rest += model.reevings[i].mass * length;
  }
  for (std::size_t k = 0; k < space.ropes.size(); ++k) {
    const double length = of_rope[space.ropes[k].name];
    if (length > 0) lengths.ropes[k] = length;
  }
}

/// Of the sections that are free, beams' and masts'; in `rest` the mass of the other beams, where that counts.
void set_section_lengths(const MachineDeck& deck, const machine::Model& model, const design::DesignSpace& space,
                         bool by_mass, design::DesignLengths& lengths) {
  for (const machine::Beam& beam : model.beams) {
    if (const auto free = free_one(space.sections, beam.name)) {
      lengths.sections[*free] = beam.length;
    } else if (const auto own = free_one(deck.machine.beams, beam.name); own && by_mass) {
      lengths.rest += mass_per_metre(deck.machine.beams[*own]) * beam.length;
    }
  }
  for (std::size_t k = 0; k < space.sections.size() && deck.checks; ++k) {
    if (const auto height = mast_height(deck.checks->masts, space.sections[k].name)) lengths.sections[k] = *height;
  }
}

/// Lengths of what is free; in `rest` the mass of the ropes, beams and take-ups that are not.
design::DesignLengths lengths_of(const MachineDeck& deck, const design::DesignSpace& space,
                                 const std::vector<double>& values) {
  design::DesignLengths lengths = by_the_metre(*deck.design, space, values);
  if (deck.design->seek == design::Seek::smallest) return lengths;
  design::DesignPlace place = design::first_place(space);
  place.values = values;
  const MachineDeck own = with_design(deck, space, place);
  const auto model = machine::compile(own.machine, machine::ModelFor::rest);
  if (!model) return lengths;
  const bool by_mass = deck.design->seek == design::Seek::lightest;
  set_rope_lengths(own, *model, space, by_mass, lengths);
  set_section_lengths(own, *model, space, by_mass, lengths);
  for (const auto& one : own.machine.take_up) {
    if (by_mass) lengths.rest += one.weight.value_or(0);
  }
  return lengths;
}

/// The largest tension by a result's values and checks, of a rope or reeving, or of all.
double tension_in(const Result& r, const MachineDeck& deck) {
  double most = std::nan("");
  const auto take = [&](const std::string& name, double value) {
    const std::size_t at = name.find("T_max");
    if (at == std::string::npos || (at > 0 && name[at - 1] != '.')) return;
    if (deck.design->of) {
      const std::string reeving = name.substr(0, at == 0 ? 0 : at - 1);
      bool own = reeving == *deck.design->of;
      for (const auto& one : deck.machine.reevings) {
        own = own || (one.rope == *deck.design->of && name_of(one) == reeving);
      }
      for (const auto& one : deck.machine.guys) own = own || (one.rope == *deck.design->of && one.name == reeving);
      if (!own) return;
    }
    most = std::fmax(most, value);
  };
  for (const Value& v : r.values) take(v.name, v.value);
  for (const Check& c : r.checks) take(c.name, c.value);
  return most;
}

/// Whether a mast combines analyses by their names: without one of them there is no such deck.
bool combines_analyses(const MachineDeck& deck) {
  if (!deck.checks) return false;
  const auto& masts = deck.checks->masts;
  return std::any_of(masts.begin(), masts.end(),
                     [](const checks::MastCheckRequest& mast) { return !mast.combinations.empty(); });
}

/// A deck that looks at one place of each load path only, where the rope was worst before. What fails there fails in
/// the whole: every check takes the worst of all states.
MachineDeck at_places(const MachineDeck& deck, const std::map<std::size_t, double>& places) {
  MachineDeck probe = deck;
  for (const auto& [i, x] : places) {
    study::LoadPathRequest& one = *probe.analyses[i].load_path;
    one.from = one.to = x;
    one.steps = 1;
    one.one_place = true;
  }
  if (!combines_analyses(deck)) {
    std::erase_if(probe.analyses, [](const study::AnalysisRequest& a) { return !a.load_path && !a.equilibrium; });
  }
  return probe;
}

/// Whether a check fails, which is so in the whole deck too. What a probe does not make or judge says nothing.
bool any_fails(const Result& probe) {
  return std::any_of(probe.checks.begin(), probe.checks.end(), [](const Check& c) { return !c.passes; });
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

/// The inputs name the rows of the catalogue that were put in, each before the values that it brings.
void add_rows(const MachineDeck& deck, Result& r) {
  for (const auto& [name, row] : deck.chosen) {
    const std::string prefix = fmt::format("machine.ropes.{}.", name);
    const auto first =
        std::find_if(r.given.begin(), r.given.end(), [&](const Given& g) { return g.key.starts_with(prefix); });
    Given one;
    one.key = prefix + "rope";
    one.words = "the rope of the catalogue that is chosen";
    one.text = row.id;
    one.chosen = true;
    r.given.insert(first, std::move(one));
  }
}

/// What a load case changes before lines and guys are put up.
design::DesignCase built_by(const design::DesignCase& load_case, const FindParameter& find) {
  design::DesignCase built = load_case;
  std::erase_if(built.settings, [&](const auto& setting) {
    const auto found = find(setting.first);
    return found && !study::puts_up_anew(*found);
  });
  return built;
}

/// Numbers that all analyses set anew.
void complain_of_set_anew(const design::DesignSpace& space, MachineDeck& deck, std::vector<Complaint>& complaints) {
  for (const Change& one : changes_of(space)) {
    const auto found = parameters_of(deck)(one.path);
    if (!found || !study::is_set_anew(deck.machine, deck.analyses, found->place)) continue;
    complaints.push_back({one.at, "every analysis sets this number anew: it would change nothing"});
  }
}

/// Load cases of another temperature, where analyses find the length of a rope anew, which is cut once.
void complain_of_cases(const design::DesignSpace& space, MachineDeck& deck, std::vector<Complaint>& complaints) {
  const auto given = std::find_if(deck.analyses.begin(), deck.analyses.end(), [](const study::AnalysisRequest& one) {
    return (one.equilibrium && one.equilibrium->given) || (one.load_path && one.load_path->given);
  });
  for (const design::DesignCase& one : space.cases) {
    for (const auto& [path, value] : one.settings) {
      const auto found = parameters_of(deck)(path);
      const std::string place = fmt::format("design.cases.{}.{}", one.name, path);
      if (!found) continue;
      if (found->place == "temperature" && found->value != value && given != deck.analyses.end()) {
        complaints.push_back(
            {place,
             "at each temperature 'given' would find another length of its rope, which is cut once: give "
             "the rope its 'length' or 'install'"});
      }
    }
  }
}

/// The checks take the strength and the diameter of a chosen rope from its row: another one would count in part.
void complain_of_strength(const design::DesignSpace& space, MachineDeck& deck, std::vector<Complaint>& complaints) {
  std::vector<std::string> of_row;  // places of numbers
  for (const design::RopeCandidates& rope : space.ropes) {
    for (const char* key : {"breaking_force", "diameter"}) of_row.push_back(fmt::format("ropes.{}.{}", rope.name, key));
  }
  for (const Change& one : changes_of(space)) {
    const auto found = parameters_of(deck)(one.path);
    if (!found || std::find(of_row.begin(), of_row.end(), study::below_machine(found->place)) == of_row.end()) continue;
    complaints.push_back({one.at,
                          "'design' chooses this rope, and each candidate has its own: ask a larger 'safety_factor' "
                          "of a worn rope"});
  }
}

/// A rope or section all of whose parts the deck exempts has no limit: the first candidate would do.
void complain_of_exempt(const design::DesignSpace& space, const MachineDeck& deck, std::vector<Complaint>& complaints) {
  if (!deck.checks) return;
  const std::vector<Part> exempt = checks::exempt_parts(*deck.checks, deck.machine);
  const auto is_exempt = [&](const Part& part) {
    return std::find(exempt.begin(), exempt.end(), part) != exempt.end();
  };
  const auto complain = [&](const char* kind, const std::string& name) {
    complaints.push_back({fmt::format("design.{}.{}", kind, name),
                          "'checks.exempt' takes it out of the verdict, so that nothing limits the choice: leave it "
                          "out there or here"});
  };
  for (const design::RopeCandidates& rope : space.ropes) {
    std::vector<Part> parts;
    const auto add = [&](const std::string& name) { parts.push_back({.kind = PartKind::rope, .name = name}); };
    for (const auto& one : deck.machine.reevings) {
      if (one.rope == rope.name) add(name_of(one));
    }
    for (const auto& one : deck.machine.guys) {
      if (one.rope == rope.name) add(one.name);
    }
    if (!parts.empty() && std::all_of(parts.begin(), parts.end(), is_exempt)) complain("ropes", rope.name);
  }
  for (const design::SectionCandidates& one : space.sections) {
    const auto is_of = [&](PartKind kind) { return is_exempt({.kind = kind, .name = one.name}); };
    if (is_of(PartKind::beam) || is_of(PartKind::mast)) complain("sections", one.name);
  }
}

/// What a search keeps from one calculation to the next.
struct Memory {
  std::map<const design::DesignCase*, std::map<std::size_t, double>>
      places;                                          ///< where the last choice that failed was worst
  std::map<const design::DesignCase*, States> states;  ///< of the last choice that had an answer
  std::size_t first_case = 0;
};

}  // namespace

design::DesignSpace machine_space(const io::Node& input, const MachineDeck& deck, Diagnostics& mistakes) {
  MachineDeck own = deck;
  if (!deck.checks) {
    io::place(input, {{.path = "design", .message = "needs 'checks': a design is what passes them"}}, mistakes);
  }
  design::DesignSpace space = design_space(input, *deck.design, parts_of(own), mistakes);
  std::vector<Complaint> complaints;
  for (const std::string& place : temperatures_of(space, parameters_of(own))) {
    study::require_references(own.machine, place, complaints);
  }
  complain_of_ropes(*deck.design, own.machine, complaints);
  complain_of_strength(space, own, complaints);
  complain_of_exempt(space, own, complaints);
  complain_of_set_anew(space, own, complaints);
  complain_of_cases(space, own, complaints);
  io::place(input, complaints, mistakes);
  return space;
}

MachineDeck with_design(const MachineDeck& deck, const design::DesignSpace& space, const design::DesignPlace& place,
                        const design::DesignCase* load_case) {
  MachineDeck own = deck;
  for (std::size_t k = 0; k < space.sections.size(); ++k) {
    const std::size_t row = place.choice[space.ropes.size() + k];
    for (auto& beam : own.machine.beams) {
      if (beam.name == space.sections[k].name) beam.section = space.sections[k].rows[row].name;
    }
  }
  if (own.checks) put_masts(space, place.choice, own.checks->masts);
  for (std::size_t k = 0; k < space.ropes.size(); ++k) {
    const design::RopeCandidates& free = space.ropes[k];
    for (auto& rope : own.machine.ropes) {
      if (rope.name == free.name) put_rope(free.rows[place.choice[k]], free.moduli[place.choice[k]], rope);
    }
    own.chosen[free.name] = free.rows[place.choice[k]];
  }
  // after the rows, which set the same numbers; what moves along does so from where it is in the deck
  MachineDeck moved = deck;
  put_values(space, place.values, parameters_of(moved));
  for (const design::UnknownValues& one : space.unknowns) {
    std::vector<std::string> paths = one.along_with;
    paths.push_back(one.parameter);
    for (const std::string& path : paths) {
      const auto from = parameters_of(moved)(path), to = parameters_of(own)(path);
      if (from && to) to->set(from->value);
    }
  }
  if (load_case != nullptr) {
    put_case(built_by(*load_case, parameters_of(own)), parameters_of(own));
    own.put_up_on = std::make_shared<const machine::Machine>(own.machine);
    put_case(*load_case, parameters_of(own));
  }
  if (own.machine.temperature != deck.machine.temperature) {
    study::keep_references(own.machine, deck.machine.temperature);
  }
  return own;
}

namespace {

/// The list of candidates by each name that a check may have: of a rope, of what it is rove as, of a beam.
std::map<std::string, std::size_t> lists_by_name(const machine::Machine& machine, const design::DesignSpace& space) {
  std::map<std::string, std::size_t> lists;
  for (std::size_t k = 0; k < space.ropes.size(); ++k) {
    const std::string& rope = space.ropes[k].name;
    lists[rope] = k;
    for (const auto& one : machine.reevings) {
      if (one.rope == rope) lists[name_of(one)] = k;
    }
    for (const auto& one : machine.guys) {
      if (one.rope == rope) lists[one.name] = k;
    }
  }
  for (std::size_t k = 0; k < space.sections.size(); ++k) lists[space.sections[k].name] = space.ropes.size() + k;
  return lists;
}

}  // namespace

design::DesignTask machine_task(std::shared_ptr<const MachineDeck> deck, design::DesignSpace space, DeckDoors doors,
                                std::function<bool(const Progress&)> progress) {
  design::DesignTask task;
  task.request = *deck->design;
  task.space = std::move(space);
  task.progress = std::move(progress);
  task.method_title = "Machine";
  task.given = given_of(MachineDeck::describe(), deck.get());
  task.display = deck->display;
  const auto own = std::make_shared<const design::DesignSpace>(task.space);
  task.lengths = [deck, own](const std::vector<double>& values) { return lengths_of(*deck, *own, values); };
  task.given_with = [deck, own](const design::DesignPlace& place) {
    const MachineDeck chosen = with_design(*deck, *own, place);
    return given_of(MachineDeck::describe(), &chosen);
  };
  task.picture = [deck, own, picture = std::move(doors.picture)](const design::DesignPlace& place, Result& r) {
    picture(with_design(*deck, *own, place), r);
  };
  task.list_of = lists_by_name(deck->machine, task.space);
  const auto memory = std::make_shared<Memory>();
  task.run = [deck, own, memory, run = std::move(doors.run)](const design::DesignPlace& place, design::Depth depth,
                                                             const std::function<bool(const Progress&)>& ask) {
    const auto one = [&](const design::DesignCase* load_case, design::Depth how) -> design::DesignRun {
      const MachineDeck whole = with_design(*deck, *own, place, load_case);
      auto& places = memory->places[load_case];
      States alone;
      if (how == design::Depth::quick && !places.empty()) {
        Result probe = run(at_places(whole, places), RunDepth::checks, ask, alone);
        design::disregard(deck->design->disregard, probe);
        if (any_fails(probe) || probe.interrupted) return {.result = std::move(probe), .tension = std::nan("")};
      }
      const RunDepth wanted = how == design::Depth::report ? RunDepth::report : RunDepth::checks;
      // what is shown does not go by how it was found
      alone.clear();
      States& near = depth == design::Depth::report ? alone : memory->states[load_case];
      design::DesignRun done{.result = run(whole, wanted, ask, near), .tension = 0};
      if (how == design::Depth::report) add_rows(whole, done.result);
      if (depth != design::Depth::report) design::disregard(deck->design->disregard, done.result);
      if (how == design::Depth::quick && !design::trial_of(done.result).passes)
        places = worst_places(*deck, done.result);
      done.tension = tension_in(done.result, *deck);
      return done;
    };
    return run_cases(own->cases, depth, memory->first_case, one);
  };
  return task;
}

}  // namespace taut::app
