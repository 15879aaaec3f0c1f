#include "taut/app/design/design_method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "taut/app/design/method_parts.hpp"
#include "taut/calc/answers.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/design/design_checks.hpp"
#include "taut/io/deck/read.hpp"

namespace taut::app {
namespace {

constexpr const char* the_mast = "mast";  // of a method that has one section

FindParameter parameters_of(MethodDeck& deck) {
  return [&deck](const std::string& path) { return deck.parameter(path); };
}

double tension_of(const MethodDeck& deck, const Result& r) {
  double most = std::nan("");
  if (r.status != Status::ok) return most;
  const auto& of = deck.blocks.design->of;
  for (const rope::RopeUse& use : deck.ropes(&r)) {
    if (!of || *of == use.name) most = std::fmax(most, use.tension);
  }
  return most;
}

/// The result of a deck that a design has changed: what was put in may not fit the method.
Result calculate_changed(const MethodDeck& deck) {
  const std::vector<Complaint> broken = deck.method->complaints(deck.input);
  if (broken.empty()) return deck.calculate();
  Result r;
  r.status = Status::infeasible;
  r.message = fmt::format("{}: {}", broken.front().path, broken.front().message);
  return r;
}

/// Whether the method has one mast and its section is chosen.
bool chooses_mast(const MethodDeck& deck, const design::DesignSpace& space) {
  return deck.method->design.put_section &&
         std::any_of(space.sections.begin(), space.sections.end(), [](const auto& s) { return s.name == the_mast; });
}

/// Whether what the method's answer names as given is all chosen: each of its ropes, or its mast.
bool chooses_all(const MethodDeck& deck, const design::DesignSpace& space) {
  return chooses_mast(deck, space) ||
         (!deck.method->design.put_section && !space.ropes.empty() && space.ropes.size() == deck.ropes(nullptr).size());
}

/// Whether a line of the answer names all ropes that are chosen, or the mast. The pretension of a boom is given too,
/// and a line that has it stays as it is.
bool names_chosen(const Answer& line, const design::DesignSpace& space, const design::DesignPlace& place) {
  for (std::size_t k = 0; k < space.sections.size(); ++k) {
    if (space.sections[k].name != the_mast) continue;
    return line.text.find(space.sections[k].rows[place.choice[space.ropes.size() + k]].name) != std::string::npos;
  }
  for (std::size_t k = 0; k < space.ropes.size(); ++k) {
    const std::string rope = catalogue::words_of_rope(space.ropes[k].rows[place.choice[k]]);
    if (line.text.find(rope) == std::string::npos) return false;
  }
  return true;
}

/// Lengths of ropes and masts with these values of the unknowns, and what else costs.
design::DesignLengths lengths_of(const MethodDeck& deck, const design::DesignSpace& space,
                                 const std::vector<double>& values) {
  const design::DesignRequest& request = *deck.blocks.design;
  design::DesignLengths lengths = by_the_metre(request, space, values);
  if (request.seek == design::Seek::smallest) return lengths;
  design::DesignPlace place = design::first_place(space);
  place.values = values;
  const MethodDeck own = with_design(deck, space, place);
  const MethodDesign& method = own.method->design;
  for (std::size_t k = 0; k < space.ropes.size(); ++k) {
    if (method.rope_length) lengths.ropes[k] = method.rope_length(own.input, space.ropes[k].name);
  }
  for (std::size_t k = 0; k < space.sections.size(); ++k) {
    const std::string& name = space.sections[k].name;
    if (method.height && name == the_mast) lengths.sections[k] = method.height(own.input);
    if (!own.blocks.checks) continue;
    if (const auto height = mast_height(own.blocks.checks->masts, name)) lengths.sections[k] = *height;
  }
  if (request.seek == design::Seek::lightest && method.mass) lengths.rest += method.mass(own.input);
  return lengths;
}

}  // namespace

design::DesignSpace method_space(const io::Node& block, const MethodDeck& deck, Diagnostics& mistakes) {
  const MethodDesign& method = deck.method->design;
  const design::DesignRequest& design = *deck.blocks.design;
  const std::string refused = method.refuse ? method.refuse(deck.input) : std::string();
  MethodDeck own = deck;
  DesignParts parts;
  parts.owner = "the method";
  for (const rope::RopeUse& use : deck.ropes(nullptr)) parts.tensions.push_back(use.name);
  if (method.put_rope) parts.ropes = parts.tensions;
  if (method.put_section) parts.sections.push_back({the_mast, {}, refused});
  if (deck.blocks.checks) add_masts(deck.blocks.checks->masts, parts.sections);
  parts.parameter = parameters_of(own);
  parts.modulus = [&deck](const std::string& name, const catalogue::RopeRow& row) -> std::optional<double> {
    const auto& own = deck.method->design.modulus;
    return own ? own(deck.input, name, row) : method_modulus;
  };
  if (!design.ropes.empty() && !refused.empty())
    io::place(block, {{.path = "design.ropes", .message = refused}}, mistakes);
  return design_space(block, design, parts, mistakes);
}

MethodDeck with_design(MethodDeck deck, const design::DesignSpace& space, const design::DesignPlace& place,
                       const design::DesignCase* load_case) {
  const MethodDesign& method = deck.method->design;
  for (std::size_t k = 0; k < space.ropes.size(); ++k) {
    const design::RopeCandidates& free = space.ropes[k];
    const catalogue::RopeRow& row = free.rows[place.choice[k]];
    method.put_rope(deck.input, free.name, row, free.moduli[place.choice[k]]);
    deck.chosen[free.name] = row;
  }
  for (std::size_t k = 0; k < space.sections.size(); ++k) {
    const catalogue::SectionRow& row = space.sections[k].rows[place.choice[space.ropes.size() + k]];
    if (method.put_section && space.sections[k].name == the_mast) method.put_section(deck.input, row.name);
  }
  if (deck.blocks.checks) put_masts(space, place.choice, deck.blocks.checks->masts);
  // behind the ropes: a weight or stiffness that is free goes before that of the rope
  put_values(space, place.values, parameters_of(deck));
  if (load_case != nullptr) put_case(*load_case, parameters_of(deck));
  return deck;
}

design::DesignTask method_task(MethodDeck deck, design::DesignSpace space,
                               std::function<bool(const Progress&)> progress) {
  design::DesignTask task;
  task.request = *deck.blocks.design;
  task.space = std::move(space);
  task.progress = std::move(progress);
  task.display = deck.display;
  task.given = given_of(*deck.method->input, deck.input.place());
  for (std::size_t k = 0; k < task.space.ropes.size(); ++k) task.list_of[task.space.ropes[k].name] = k;
  for (std::size_t k = 0; k < task.space.sections.size(); ++k) {
    const std::string& name = task.space.sections[k].name;
    // a method with one section checks it without naming a part
    const bool only = name == the_mast && deck.method->design.put_section;
    task.list_of[only ? std::string{} : name] = task.space.ropes.size() + k;
  }
  struct Shared {
    MethodDeck deck;
    design::DesignSpace space;
    std::size_t first_case = 0;
  };
  const auto own = std::make_shared<Shared>(Shared{.deck = std::move(deck), .space = task.space});
  task.lengths = [own](const std::vector<double>& values) { return lengths_of(own->deck, own->space, values); };
  task.given_with = [own](const design::DesignPlace& place) {
    MethodDeck chosen = with_design(own->deck, own->space, place);
    return given_of(*chosen.method->input, chosen.input.place());
  };
  task.run = [own](const design::DesignPlace& place, design::Depth depth, const std::function<bool(const Progress&)>&) {
    const auto one = [&](const design::DesignCase* load_case, design::Depth) -> design::DesignRun {
      const MethodDeck changed = with_design(own->deck, own->space, place, load_case);
      design::DesignRun done{.result = calculate_changed(changed), .tension = 0};
      if (changed.method->design.check_choice && chooses_mast(changed, own->space))
        changed.method->design.check_choice(done.result);
      if (depth == design::Depth::report && chooses_all(own->deck, own->space)) {
        for (Answer& a : done.result.answers) {
          if (a.label == given_label && names_chosen(a, own->space, place)) a.label = build_label;
        }
      }
      if (depth != design::Depth::report) design::disregard(changed.blocks.design->disregard, done.result);
      done.tension = tension_of(changed, done.result);
      return done;
    };
    return run_cases(own->space.cases, depth, own->first_case, one);
  };
  return task;
}

}  // namespace taut::app
