#include "taut/checks/mast/machine_masts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "taut/base/suggest.hpp"
#include "taut/calc/shown.hpp"
#include "taut/catalogue/section_search.hpp"
#include "taut/checks/guy/guy_checks.hpp"
#include "taut/checks/parts.hpp"
#include "taut/structure/column.hpp"

namespace taut::checks {
namespace {

using machine::description::Beam;

std::size_t index_in(const machine::Model& model, const std::string& name) {
  const auto found =
      std::find_if(model.beams.begin(), model.beams.end(), [&](const machine::Beam& b) { return b.name == name; });
  return static_cast<std::size_t>(found - model.beams.begin());
}

bool is_own(const MastCheckRequest& request, const CheckedDeck& deck) {
  return request.beams.empty() && beam_named(deck, request.name) == nullptr;
}

std::string steel_of(const MastCheckRequest& request, const Beam& beam) {
  return request.steel ? *request.steel : beam.steel.value_or("");
}

/// Whether the machine is shown to the checks while it is put up.
bool is_put_up(const machine::Machine& machine) {
  const auto has_install = [](const auto& rope) { return rope.install.has_value(); };
  return std::any_of(machine.guys.begin(), machine.guys.end(), has_install) ||
         std::any_of(machine.reevings.begin(), machine.reevings.end(), has_install) ||
         std::any_of(machine.take_up.begin(), machine.take_up.end(),
                     [](const auto& one) { return one.screw.has_value(); });
}

/// Names that a combination may use: of all analyses that show states; beams don't move.
std::vector<std::string> analyses_of(const CheckedDeck& deck, bool with_motions) {
  std::vector<std::string> names;
  if (is_put_up(deck.machine)) names.emplace_back(put_up_analysis);
  const auto add = [&](const auto& analysis, const char* kind) {
    if (analysis) names.push_back(analysis->name.value_or(kind));
  };
  for (const study::AnalysisRequest& a : deck.analyses) {
    add(a.equilibrium, "equilibrium");
    add(a.load_path, "load_path");
    add(a.envelope, "envelope");
    add(a.cycle, "cycle");
    add(a.sweep, "sweep");
    add(a.payload, "payload");
    add(a.installation, "installation");
    add(a.pretension, "pretension");
    add(a.modes, "modes");
    if (with_motions) add(a.transient, "transient");
  }
  if (deck.analyses.empty()) names.emplace_back("equilibrium");
  return names;
}

void complain_of_terms(const MastCheckRequest& request, const std::string& path, const CheckedDeck& deck,
                       std::vector<Complaint>& complaints) {
  const std::vector<std::string> known = analyses_of(deck, false);
  for (const MastCombinationRequest& c : request.combinations) {
    const std::string at = fmt::format("{}.combinations.{}", path, c.name);
    if (c.terms.size() != 1) {
      complaints.push_back({at,
                            "of a machine takes one analysis: bent shapes can't be added; put the loads that come "
                            "together into one analysis"});
    }
    for (const MastTerm& t : c.terms) {
      if (std::find(known.begin(), known.end(), t.name) != known.end()) continue;
      complaints.push_back(
          {fmt::format("{}.{}", at, t.name),
           fmt::format("no analysis with states at rest has the name '{}'{}", t.name, did_you_mean(t.name, known))});
    }
  }
}

void complain_of_beam(const MastCheckRequest& request, const std::string& name, const std::string& path,
                      const CheckedDeck& deck, std::vector<Complaint>& complaints) {
  const Beam* beam = beam_named(deck, name);
  if (beam == nullptr) {
    std::vector<std::string> known;
    known.reserve(deck.machine.beams.size());
    for (const Beam& b : deck.machine.beams) known.push_back(b.name);
    complaints.push_back({path + ".beams", fmt::format("there is no beam '{}'{}", name, did_you_mean(name, known))});
    return;
  }
  if (!beam->section) {
    complaints.push_back({path, fmt::format("beam '{}' has its section by figures, which say nothing of its walls: "
                                            "EN 1993-1-1 needs a 'section' of the catalogue",
                                            name)});
    return;
  }
  if (steel_of(request, *beam).empty()) {
    complaints.push_back({path, fmt::format("beam '{}' has no 'steel': give it here or there", name)});
    return;
  }
  const auto material = mast_material(request, *beam->section, steel_of(request, *beam), path);
  if (!material) complaints.push_back(material.error());
}

/// The forces of a beam's section; N of the engine is tension, of the checks compression.
structure::CrossForces forces_of(const solve::BeamPoint& p) {
  return {
      .N = -p.N, .V_y = p.shear_y, .V_z = p.shear_x, .M_y = p.bends_to_x, .M_z = p.bends_to_y, .torsion = p.torsion};
}

/// The deflection farthest from the line between those of the ends.
Vector3 farthest_from_chord(const solve::BeamResult& b) {
  const solve::BeamPoint &first = b.points.front(), &last = b.points.back();
  Vector3 farthest = Vector3::Zero();
  for (const solve::BeamPoint& p : b.points) {
    const double share = (p.s - first.s) / (last.s - first.s);
    const Vector3 off = p.deflection - (1 - share) * first.deflection - share * last.deflection;
    if (off.norm() > farthest.norm()) farthest = off;
  }
  return farthest;
}

/// A beam that no factor within the range of the analysis makes buckle presses nothing.
bool presses(const solve::BeamResult& beam) { return std::isfinite(beam.critical_factor); }

/// What may hold sections of beams sideways: ropes that run over or end at them, what touches or pushes them.
bool holds(const machine::Model& model, int body) {
  for (const machine::Reeving& rope : model.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (node.at.body == body) return true;
    }
    for (const machine::Guides& guides : rope.guides) {
      for (const machine::Node& node : guides.all) {
        if (node.at.body == body) return true;
      }
    }
  }
  return std::any_of(model.contacts.begin(), model.contacts.end(), [&](const auto& c) { return c.body == body; }) ||
         std::any_of(model.faces.begin(), model.faces.end(), [&](const auto& f) { return f.body == body; }) ||
         std::any_of(model.actuators.begin(), model.actuators.end(),
                     [&](const auto& a) { return a.from_body == body || a.to_body == body; });
}

/// Whether another beam begins or ends at a section.
bool meets_another(const machine::Model& model, const machine::Beam& own, int body) {
  return std::any_of(model.beams.begin(), model.beams.end(), [&](const machine::Beam& other) {
    return &other != &own && (other.pieces.front().start.body == body || other.pieces.back().end.body == body);
  });
}

/// Whether the mast goes on from this end of a beam as another beam.
bool goes_on(const machine::Model& model, const machine::Beam& beam, int body) {
  if (body == machine::ground || !model.bodies[body].beam) return false;
  return &model.beams[*model.bodies[body].beam] != &beam || meets_another(model, beam, body);
}

/// Whether the bow of a beam is that of the member that buckles, EN 1993-1-1, 5.3.2 (3) b, one half wave from where the
/// mast is held to where it is held next. `inverse`: 1/alpha_cr of the mast, not too small. Where the mast goes on as
/// another beam, its buckling length pi sqrt(EI/(alpha N)) must not be longer than this beam; where something may hold
/// the beam between its ends, not shorter. There alpha is that of the beam's own forces, which is not below the mast's.
bool bow_spans_member(const machine::Model& model, const machine::Beam& built, const solve::BeamResult& b,
                      double inverse) {
  if (b.compression <= 0) return true;
  const auto& pieces = built.pieces;
  const structure::BeamSection& section = pieces.front().rod.section;
  const double weak = std::min(section.EI_x, section.EI_y), strong = std::max(section.EI_x, section.EI_y);
  if (goes_on(model, built, pieces.front().start.body) || goes_on(model, built, pieces.back().end.body)) {
    if (inverse <= 0) return false;
    if (structure::buckling_length(strong, 1 / inverse, b.compression) > built.length / as_rounded) return false;
  }
  bool held = false;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    const int body = pieces[i].start.body;
    held = held || holds(model, body) || meets_another(model, built, body);
  }
  if (!held) return true;
  return presses(b) && structure::buckling_length(weak, b.critical_factor, b.compression) >= as_rounded * built.length;
}

/// Whether the state contains the imperfections that make (6.61) needless, EN 1993-1-1, 5.2.2 (7) a: sway and bow of
/// 5.3.2 in the direction in which the beam bends (5.3.1 (2)). What of them lies along the deflection counts.
bool built_crooked(const Beam& beam, const machine::Beam& built, const MastMaterial& material,
                   std::optional<structure::Curve> curve, const solve::BeamResult& b) {
  if (beam.order != machine::description::Order::second || !beam.imperfection) return false;
  const auto along = [&](const Vector3& moved) {
    const double size = moved.norm();
    return size > 0 ? imperfection_sense(beam, built).dot(moved) / size : 0;
  };
  const double bow = beam.imperfection->bow.value_or(0) * along(farthest_from_chord(b));
  const double sway = beam.imperfection->sway.value_or(0) * along(b.points.back().deflection);
  const auto of = curve.value_or(structure::curve_of(material.section, material.yield));
  return bow >= as_rounded * structure::bow_share(of, true) && sway >= as_rounded * structure::sway_of(built.length);
}

/// 1/alpha_cr of a mast: not less, not more than.
struct Inverse {
  double least = 0, most = 0;
};

/// One mast of the machine's beams.
class MachineMast {
 public:
  MachineMast(const MastStates& mast, const CheckedDeck& deck, const machine::Model& model)
      : request_(*mast.request), deck_(deck), model_(model), mast_(mast) {
    const MastCheckRequest& request = request_;
    report_.name = request.name;
    report_.display = deck.display;
    for (std::size_t i = 0; i < mast.beams.size(); ++i) {
      const Beam& beam = *beam_named(deck, beams_of(request)[i]);
      lengths_.push_back(model.beams[mast.beams[i]].length);
      // complain_of_beam has seen it
      report_.materials.push_back(mast_material(request, *beam.section, steel_of(request, beam), {}).value());
      const double nominal = catalogue::find_section(*beam.section).value().I_z;
      softer_ = std::max(softer_, nominal / report_.materials.back().section.I_z);
    }
  }

  MastReport report() {
    for (std::size_t i = 0; i < mast_.beams.size(); ++i) {
      const Beam& beam = *beam_named(deck_, beams_of(request_)[i]);
      report_.loaded.mast.parts.push_back(part(report_.materials[i], beam.E));
    }
    add_cases();
    const auto& cases = report_.loaded.cases;
    report_.unseen = cases.empty() && report_.refused.empty();
    if (report_.unseen) {
      report_.refused = report_.left_out.empty()
                            ? "it is not checked: no analysis found an equilibrium"
                            : "it is not checked: its combinations name no analysis with an answer";
    }
    tell(std::none_of(cases.begin(), cases.end(), [](const structure::MastCase& c) { return c.members; }));
    if (mast_.beams.size() == 1) report_.in_section = other_section();
    return std::move(report_);
  }

 private:
  structure::MastPart part(const MastMaterial& material, double E) const {
    structure::MastPart p;
    p.member.steel = {.section = material.section,
                      .yield = material.yield,
                      .E = E,
                      .gamma = {.M0 = request_.gamma_M0, .M1 = request_.gamma_M1}};
    p.member.curve = curve_of(request_);
    p.member.y = {.length = request_.buckling_length, .critical_force = {}, .C_m = request_.C_m};
    p.member.z = p.member.y;
    p.allowable_stress = material.allowable_stress;
    return p;
  }

  void add_cases() {
    const bool in_all = counts_put_up_in_all(request_);
    for (const BeamState& one : mast_.states) {
      if (request_.combinations.empty()) add_case(one, one.words, request_.load_factor);
      bool named = request_.combinations.empty();
      for (const MastCombinationRequest& c : request_.combinations) {
        for (const MastTerm& t : c.terms) {
          if (t.name != one.analysis && !(in_all && one.analysis == put_up_analysis)) continue;
          add_case(one, fmt::format("{}: {}", c.name, one.words), t.factor);
          named = true;
        }
      }
      if (!named) report_.left_out.insert(one.analysis);
    }
  }

  bool built_crooked(const BeamState& state) const {
    const double inverse = inverse_critical(state).most;
    for (std::size_t i = 0; i < state.beams.size(); ++i) {
      const Beam& beam = *beam_named(deck_, beams_of(request_)[i]);
      const machine::Beam& built = model_.beams[mast_.beams[i]];
      if (!checks::built_crooked(beam, built, report_.materials[i], curve_of(request_), state.beams[i])) return false;
      if (!bow_spans_member(model_, built, state.beams[i], inverse)) return false;
    }
    return true;
  }

  /// By the wall that counts: a thinner one takes from the stiffness at most in proportion. The factor of one beam is
  /// for its own forces alone, those of the others as they are: that of the mast is at most the least of them, and at
  /// least 1/sum(1/alpha) (Dunkerley). Where no other beam presses, it is that of all together, as found.
  Inverse inverse_critical(const BeamState& state) const {
    double sum = 0, largest = 1 / state.together;
    for (const solve::BeamResult& beam : state.beams) {
      const double alpha = beam.critical_factor;
      if (!std::isfinite(alpha) || alpha <= 0) continue;
      sum += 1 / alpha;
      largest = std::max(largest, 1 / alpha);
    }
    return {.least = softer_ * largest, .most = softer_ * (state.alone ? largest : std::max(sum, largest))};
  }

  std::string buckles(double factor, const Inverse& inverse, const std::string& words) const {
    const bool surely = factor * inverse.least >= 1;
    return fmt::format(
        "{}: under {:.4g} times its forces the mast {}, its critical factor is {}{:.4g}{}; "
        "choose a stiffer section, shorten it, or guy it",
        words, factor, surely ? "buckles" : "may buckle",
        inverse.least == inverse.most ? ""
        : surely                      ? "at most "
                                      : "at least ",
        1 / (surely ? inverse.least : inverse.most),
        surely ? "" : " (a lower bound, from those of its beams by Dunkerley, because other beams press as well)");
  }

  void tell_of_swing(double factor, double swings, const std::string& words) {
    if (swings > factor || swings >= swings_) return;
    swings_ = swings;
    report_.swings = fmt::format(
        "{}: from {:.4g} times the forces on its beams the machine swings away if the tensions of its ropes stay as "
        "they are, and {:.4g} times are asked for; tensions that carry the same load grow with it, those of ropes put "
        "up tight do not",
        words, swings, factor);
  }

  /// The engine has bent the mast under its forces as they are, of second order by 1/(1 - 1/alpha) more than of first,
  /// alpha the critical factor; under `factor` times them it is 1/(1 - factor/alpha), EN 1993-1-1, (5.4). First order
  /// does where alpha/factor is 10 at least, 5.2.1 (3).
  double magnified(const BeamState& state, double factor, const Inverse& bounds, const std::string& words) {
    const double inverse = bounds.most;
    for (const solve::BeamResult& b : state.beams) tell_of_swing(factor, b.swing_factor, words);
    bool second = true;
    for (const std::string& name : beams_of(request_)) {
      second = second && beam_named(deck_, name)->order == machine::description::Order::second;
    }
    if (factor * inverse >= 1) {
      report_.refused = buckles(factor, bounds, words);
      return 1;
    }
    const double all = 1 / (1 - factor * inverse);
    if (!second) return factor * inverse > 1 / first_order_factor ? all : 1;
    return std::max(1.0, (1 - inverse / softer_) * all);
  }

  void add_case(const BeamState& state, const std::string& words, double factor) {
    structure::MastCase c;
    c.words = words;
    c.members = !built_crooked(state);
    const double all = factor * request_.dynamic_factor;
    const Inverse inverse = inverse_critical(state);
    const double bends = magnified(state, all, inverse, words);
    double height = 0;
    for (std::size_t i = 0; i < state.beams.size(); ++i) {
      const solve::BeamResult& b = state.beams[i];
      for (const solve::BeamPoint& p : b.points) {
        const structure::CrossForces f = forces_of(p);
        structure::CrossForces design = all * f;
        for (double* one : {&design.M_y, &design.M_z, &design.V_y, &design.V_z}) *one *= bends;
        c.stations.push_back({height + p.s, i, f, design, all * f});
      }
      height += lengths_[i];
    }
    if (!request_.buckling_length && inverse.most > 0) {
      for (const solve::BeamResult& b : state.beams) {
        const double N_cr = b.compression / inverse.most;
        c.critical_force.push_back({.y = N_cr, .z = N_cr});
      }
    }
    if (request_.buckling_length) compare_length(state);
    report_.loaded.cases.push_back(std::move(c));
  }

  /// By the forces of each beam alone, which gives the shorter length.
  void compare_length(const BeamState& state) {
    for (std::size_t i = 0; i < state.beams.size(); ++i) {
      const solve::BeamResult& b = state.beams[i];
      if (b.compression <= 0 || !presses(b) || b.critical_factor <= 0) continue;
      const structure::BeamSection& section = model_.beams[mast_.beams[i]].pieces.front().rod.section;
      const double length =
          structure::buckling_length(std::min(section.EI_x, section.EI_y), b.critical_factor, b.compression);
      if (as_rounded * length <= std::max(longest_, *request_.buckling_length)) continue;
      longest_ = length;
      const auto [given, own] = brief_apart(*request_.buckling_length, length, si::m, deck_.display);
      report_.short_length = fmt::format(
          "'buckling_length' of {} is shorter than that of the machine, {}: the beam buckles at {:.4g} times its "
          "forces ({}); leave 'buckling_length' out, or put what holds the mast into the machine",
          given, own, b.critical_factor, state.words);
    }
  }

  void tell(bool crooked) {
    report_.words.push_back(fmt::format(
        "{}: forces of the machine's states at rest times their factors, moments of second order by (1 - "
        "1/alpha_cr)/(1 - factor/alpha_cr) more; {}; N_cr {}.",
        request_.name,
        crooked ? "sections are checked in the bent shape with sway and bow as built of EN 1993-1-1, 5.3.2, so that "
                  "(6.61) is not asked for (5.2.2 (7) a)"
                : "(6.61) is asked for beside the sections in states without bow and sway as built of EN 1993-1-1, "
                  "5.3.2, in the direction of the bending, the bow from hold to hold of the mast; of second-order "
                  "moments that is on the safe side",
        request_.buckling_length ? "from 'buckling_length', " + deck_.display.brief(*request_.buckling_length, si::m)
                                 : "from the critical load of the whole machine"));
  }

  /// The same forces in another section.
  structure::MastOf other_section() const {
    const Beam& beam = *beam_named(deck_, beams_of(request_)[0]);
    const structure::LoadedMast loaded = report_.loaded;
    const MastCheckRequest request = request_;
    const std::string steel = steel_of(request, beam);
    const double I = report_.materials[0].section.I_z;
    return [request, steel, loaded, I](const catalogue::SectionRow& row) -> std::optional<structure::LoadedMast> {
      const auto m = mast_material(request, row, steel);
      if (!m) return std::nullopt;
      structure::LoadedMast other = loaded;
      auto& one = other.mast.parts[0];
      one.member.steel.section = m->section;
      one.member.steel.yield = m->yield;
      one.allowable_stress = m->allowable_stress;
      // a weaker mast holds less, at most in proportion; a stiffer one is not believed to hold more
      for (auto& c : other.cases) {
        for (structure::CriticalForces& N : c.critical_force) {
          N.y *= std::min(1.0, m->section.I_z / I);
          N.z *= std::min(1.0, m->section.I_z / I);
        }
      }
      return other;
    };
  }

  const MastCheckRequest& request_;
  const CheckedDeck& deck_;
  const machine::Model& model_;
  const MastStates& mast_;
  MastReport report_;
  std::vector<double> lengths_;
  double longest_ = 0;  ///< of the buckling lengths that are longer than that of the deck, m
  double swings_ = std::numeric_limits<double>::infinity();  ///< the least that is told
  double softer_ = 1;  ///< stiffness of the nominal wall over that of the wall that counts, the largest of the beams
};

}  // namespace

Vector3 imperfection_sense(const Beam& given, const machine::Beam& built) {
  const Matrix3& axes = built.pieces.front().reference_axes;
  Vector3 sense = axes.col(0);
  if (given.imperfection && given.imperfection->towards) {
    const auto& t = *given.imperfection->towards;
    sense = {t[0], t[1], t[2]};
  }
  return (sense - axes.col(2) * axes.col(2).dot(sense)).normalized();
}

std::vector<std::string> beams_of(const MastCheckRequest& request) {
  return request.beams.empty() ? std::vector<std::string>{request.name} : request.beams;
}

const Beam* beam_named(const CheckedDeck& deck, const std::string& name) {
  const auto& all = deck.machine.beams;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Beam& b) { return b.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::vector<MastStates> mast_states(const std::vector<MastCheckRequest>& masts, const CheckedDeck& deck,
                                    const machine::Model& model) {
  std::vector<MastStates> all;
  for (const MastCheckRequest& one : masts) {
    MastStates& mast = all.emplace_back();
    mast.request = &one;
    if (is_own(one, deck)) continue;
    for (const std::string& name : beams_of(one)) mast.beams.push_back(index_in(model, name));
  }
  return all;
}

namespace {

/// See BeamState::alone.
bool is_alone(const MastStates& mast, const solve::EquilibriumResult& state) {
  for (std::size_t i = 0; i < state.beams.size(); ++i) {
    const bool own = std::find(mast.beams.begin(), mast.beams.end(), i) != mast.beams.end();
    if (!own && presses(state.beams[i])) return false;
  }
  return true;
}

/// See BeamState::together.
double together_in(const solve::EquilibriumResult& state, bool alone) {
  constexpr double apart = 0.99;  // of the weakest beam's own factor: from there on it buckles by itself
  double least = std::numeric_limits<double>::infinity();
  for (const solve::BeamResult& beam : state.beams) least = std::min(least, beam.critical_factor);
  const double all = state.beams.empty() ? least : state.beams.front().critical_together;
  return all > 0 && (alone || all < apart * least) ? all : std::numeric_limits<double>::infinity();
}

}  // namespace

void take(const CheckState& state, const CheckedDeck& deck, MastStates& mast) {
  if (!mast.request->carries.empty()) mast.carried.push_back(carried_by(*mast.request, state));
  // guys are put up without the beams
  if (mast.beams.empty() || state.rest == nullptr || state.rest->beams.empty()) return;
  const bool alone = is_alone(mast, *state.rest);
  BeamState& one = mast.states.emplace_back(BeamState{.words = state.words,
                                                      .analysis = state.analysis,
                                                      .beams = {},
                                                      .together = together_in(*state.rest, alone),
                                                      .alone = alone});
  for (const std::size_t beam : mast.beams) one.beams.push_back(state.rest->beams[beam]);
  if (!mast.request->top_criterion) return;
  const auto k = guy_stiffness(deck, state, mast.beams.back());
  if (!k || *k >= mast.guy_stiffness) return;
  mast.guy_stiffness = *k;
  mast.where_stiffness = state.words;
}

/// A beam has one steel.
void complain_of_steel(const MastCheckRequest& request, const std::string& path, const CheckedDeck& deck,
                       std::vector<Complaint>& complaints) {
  if (!request.steel) return;
  for (const std::string& name : beams_of(request)) {
    const Beam* beam = beam_named(deck, name);
    if (beam == nullptr || !beam->steel || *beam->steel == *request.steel) continue;
    complaints.push_back(
        {path + ".steel", fmt::format("beam '{}' is of {}: say its steel there alone", name, *beam->steel)});
    return;
  }
}

void complain_of_masts(const std::vector<MastCheckRequest>& masts, const CheckedDeck& deck, const machine::Model& model,
                       std::vector<Complaint>& complaints) {
  for (const MastCheckRequest& one : masts) {
    const std::string path = fmt::format("checks.masts.{}", one.name);
    if (is_own(one, deck)) {
      if (one.carries.empty()) {
        complain_of_own_mast(one, path, LoadsOf::deck, {}, complaints);
      } else {
        complain_of_carried(one, path, model, analyses_of(deck, true), complaints);
      }
      if (one.top_criterion) complaints.push_back({path + ".top_criterion", "is of the guys of a beam of the machine"});
      if (one.plate) complaints.push_back({path + ".plate", "is of the guys of a beam of the machine"});
      continue;
    }
    const auto refuse = [&](bool given, const char* key, const char* advice = "say it of the beam there") {
      if (given) complaints.push_back({path + "." + key, fmt::format("is the machine's: {}", advice)});
    };
    refuse(!one.loads.empty(), "loads", "put them into 'machine.loads', at a place of the beam");
    refuse(!one.carries.empty(), "carries");
    refuse(one.section.has_value(), "section");
    refuse(!one.pieces.empty(), "pieces");
    refuse(one.height.has_value(), "height");
    refuse(one.own_weight, "own_weight", "the beam weighs what its section or its 'mass' says");
    refuse(one.top_stiffness != 0, "top_stiffness", "guys hold its top as stiffly as they are");
    complain_of_steel(one, path, deck, complaints);
    refuse(one.base.has_value(), "base");
    refuse(!one.foot.empty(), "foot");
    refuse(!one.towards.empty(), "towards");
    refuse(one.sway.has_value(), "sway");
    refuse(one.bow.has_value(), "bow");
    if (one.allowable_stress && one.safety) {
      complaints.push_back({path + ".safety", "either 'allowable_stress' or 'safety'"});
    }
    refuse_both_factors(one, path, complaints);
    for (const std::string& name : beams_of(one)) complain_of_beam(one, name, path, deck, complaints);
    complain_of_terms(one, path, deck, complaints);
  }
}

void add_machine_masts(const std::vector<MastStates>& masts, const CheckedDeck& deck, const machine::Model& model,
                       Result& r) {
  for (const MastStates& mast : masts) {
    const MastCheckRequest& one = *mast.request;
    const AboutPart about(r, part_of_mast(model, one.name));
    if (mast.beams.empty()) {
      add_mast_report(one,
                      one.carries.empty() ? own_mast(one, one.loads, model.gravity, deck.display)
                                          : carrying_mast(one, mast.carried, model.gravity, deck.display),
                      r);
      continue;
    }
    MastReport report = MachineMast(mast, deck, model).report();
    report.covers = beams_of(one);
    add_mast_report(one, report, r);
    double bending = HUGE_VAL;
    for (std::size_t i = 0; i < report.materials.size(); ++i) {
      bending = std::min(bending, beam_named(deck, beams_of(one)[i])->E * report.materials[i].section.I_z);
    }
    add_top_check(mast, bending, model, r);
    add_plate_checks(mast, deck, model, r);
  }
}

}  // namespace taut::checks
