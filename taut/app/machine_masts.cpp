#include "taut/app/machine_masts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/base/suggest.hpp"
#include "taut/catalogue/section_search.hpp"
#include "taut/rope/guy.hpp"

namespace taut::app {
namespace {

using model::description::Beam;

std::vector<std::string> beams_of(const MastCheckRequest& request) {
  return request.beams.empty() ? std::vector<std::string>{request.name} : request.beams;
}

const Beam* beam_named(const MachineDeck& deck, const std::string& name) {
  const auto& all = deck.machine.beams;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Beam& b) { return b.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::size_t index_in(const model::Model& model, const std::string& name) {
  const auto found =
      std::find_if(model.beams.begin(), model.beams.end(), [&](const model::Beam& b) { return b.name == name; });
  return static_cast<std::size_t>(found - model.beams.begin());
}

bool is_own(const MastCheckRequest& request, const MachineDeck& deck) {
  return request.beams.empty() && beam_named(deck, request.name) == nullptr;
}

std::string steel_of(const MastCheckRequest& request, const Beam& beam) {
  return request.steel ? *request.steel : beam.steel.value_or("");
}

/// Names that a combination may use.
std::vector<std::string> analyses_of(const MachineDeck& deck) {
  std::vector<std::string> names;
  for (const AnalysisRequest& a : deck.analyses) {
    if (a.equilibrium) names.push_back(a.equilibrium->name.value_or("equilibrium"));
    if (a.load_path) names.push_back(a.load_path->name.value_or("load_path"));
  }
  if (deck.analyses.empty()) names.emplace_back("equilibrium");
  return names;
}

void complain_of_terms(const MastCheckRequest& request, const std::string& path, const MachineDeck& deck,
                       std::vector<Complaint>& complaints) {
  const std::vector<std::string> known = analyses_of(deck);
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
           fmt::format("no equilibrium or load_path has the name '{}'{}", t.name, did_you_mean(t.name, known))});
    }
  }
}

void complain_of_beam(const MastCheckRequest& request, const std::string& name, const std::string& path,
                      const MachineDeck& deck, std::vector<Complaint>& complaints) {
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
  mast_material(request, *beam->section, steel_of(request, *beam), path, complaints);
}

/// The forces of a beam's section; N of the engine is tension, of the checks compression.
structure::CrossForces forces_of(const analysis::BeamPoint& p) {
  return {-p.N, p.shear_y, p.shear_x, p.bends_to_x, p.bends_to_y, p.torsion};
}

/// Whether the state contains the imperfections that make (6.61) needless, EN 1993-1-1, 5.2.2 (7) a.
bool built_crooked(const Beam& beam, const MastMaterial& material, double length) {
  if (beam.order != model::description::Order::second || !beam.imperfection) return false;
  const auto curve = structure::curve_of(material.section, material.yield);
  const bool bowed = std::abs(beam.imperfection->bow.value_or(0)) >= 0.98 * structure::bow_share(curve, true);
  const bool leans = std::abs(beam.imperfection->sway.value_or(0)) >= 0.98 * structure::sway_of(length);
  return bowed && leans;
}

/// One mast of the machine's beams.
class MachineMast {
 public:
  MachineMast(const MastCheckRequest& request, const MachineDeck& deck, const MachineRun& run)
      : request_(request), deck_(deck), run_(run) {
    report_.name = request.name;
    for (const std::string& name : beams_of(request)) {
      const Beam& beam = *beam_named(deck, name);
      beams_.push_back(index_in(run.model, name));
      lengths_.push_back(run.model.beams[beams_.back()].length);
      std::vector<Complaint> told_before;
      report_.materials.push_back(*mast_material(request, *beam.section, steel_of(request, beam), {}, told_before));
    }
  }

  MastReport report() {
    bool crooked = true;
    for (std::size_t i = 0; i < beams_.size(); ++i) {
      const Beam& beam = *beam_named(deck_, beams_of(request_)[i]);
      report_.loaded.mast.parts.push_back(part(report_.materials[i], beam.E));
      crooked = crooked && built_crooked(beam, report_.materials[i], lengths_[i]);
    }
    report_.loaded.mast.members = !crooked;
    add_cases();
    if (report_.loaded.cases.empty()) report_.refused = "no analysis found an equilibrium";
    tell(crooked);
    if (beams_.size() == 1) report_.in_section = other_section();
    return std::move(report_);
  }

 private:
  structure::MastPart part(const MastMaterial& material, double E) const {
    structure::MastPart p;
    p.member.steel = {material.section, material.yield, E, {request_.gamma_M0, request_.gamma_M1}};
    p.member.curve = curve_of(request_);
    p.member.y = {request_.buckling_length, {}, request_.C_m};
    p.member.z = p.member.y;
    p.allowable_stress = material.allowable_stress;
    return p;
  }

  void add_cases() {
    for (const NamedAnswer& one : named_answers(run_)) {
      if (request_.combinations.empty()) add_case(one.answer, one.answer.words, request_.load_factor);
      for (const MastCombinationRequest& c : request_.combinations) {
        for (const MastTerm& t : c.terms) {
          if (t.name == one.analysis) add_case(one.answer, fmt::format("{}: {}", c.name, one.answer.words), t.factor);
        }
      }
    }
  }

  double inverse_critical(const Answer& answer) const {
    double sum = 0;
    for (const std::size_t i : beams_) {
      const double alpha = answer.result->beams[i].critical_factor;
      if (std::isfinite(alpha) && alpha > 0) sum += 1 / alpha;
    }
    return sum;
  }

  /// The engine has bent the mast under its forces as they are. Under `factor` times them second order bends it more
  /// than in proportion: (1 - 1/alpha)/(1 - factor/alpha), alpha the critical factor, EN 1993-1-1, (5.4).
  double magnified(double factor, double inverse, const std::string& words) {
    bool second = true;
    for (const std::string& name : beams_of(request_)) {
      second = second && beam_named(deck_, name)->order == model::description::Order::second;
    }
    if (factor * inverse >= 1) {
      report_.refused = fmt::format(
          "{}: under {:.4g} times its forces the mast buckles, its critical factor is {:.4g}; "
          "choose a stiffer section, shorten it, or guy it",
          words, factor, 1 / inverse);
      return 1;
    }
    return second && factor > 1 ? (1 - inverse) / (1 - factor * inverse) : 1;
  }

  void add_case(const Answer& answer, const std::string& words, double factor) {
    structure::MastCase c;
    c.words = words;
    const double all = factor * request_.dynamic_factor;
    // each beam's factor is for its own forces alone: together they buckle not before 1/sum(1/alpha) (Dunkerley)
    const double together = inverse_critical(answer);
    const double bends = magnified(all, together, words);
    double height = 0;
    for (std::size_t i = 0; i < beams_.size(); ++i) {
      const analysis::BeamResult& b = answer.result->beams[beams_[i]];
      for (const analysis::BeamPoint& p : b.points) {
        const structure::CrossForces f = forces_of(p);
        structure::CrossForces design = all * f;
        for (double* one : {&design.M_y, &design.M_z, &design.V_y, &design.V_z}) *one *= bends;
        c.stations.push_back({height + p.s, i, f, design, all * f});
      }
      height += lengths_[i];
    }
    if (!request_.buckling_length && together > 0) {
      for (const std::size_t i : beams_) c.critical_force.push_back(answer.result->beams[i].compression / together);
    }
    report_.loaded.cases.push_back(std::move(c));
  }

  void tell(bool crooked) {
    report_.words.push_back(fmt::format(
        "{}: forces of the machine's equilibria and load paths times their factors, moments of second order by (1 - "
        "1/alpha_cr)/(1 - factor/alpha_cr) more; {}; N_cr {}.",
        request_.name,
        crooked ? "sections are checked in the bent shape with sway and bow as built of EN 1993-1-1, 5.3.2, so that "
                  "(6.61) is not asked for (5.2.2 (7) a)"
                : "(6.61) is asked for beside the sections, as the beam has no bow and sway as built of EN 1993-1-1, "
                  "5.3.2; of second-order moments that is on the safe side",
        request_.buckling_length ? "from 'buckling_length'" : "from the critical load of the whole machine"));
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
        for (double& N : c.critical_force) N *= std::min(1.0, m->section.I_z / I);
      }
      return other;
    };
  }

  const MastCheckRequest& request_;
  const MachineDeck& deck_;
  const MachineRun& run_;
  MastReport report_;
  std::vector<std::size_t> beams_;
  std::vector<double> lengths_;
};

/// The least horizontal stiffness of all guys at the top of a beam, in a state, N/m.
std::optional<double> guy_stiffness(const MachineDeck& deck, const Answer& answer, const std::string& top) {
  rope::RingStiffness ring;
  bool any = false;
  for (const auto& guy : deck.machine.guys) {
    if (guy.from != top && guy.to != top) continue;
    for (const analysis::SpanResult& span : answer.result->spans) {
      const model::Reeving& rope = answer.model->reevings[static_cast<std::size_t>(span.reeving)];
      if (rope.name != guy.name || span.unstretched >= span.chord) continue;  // slack ones give nothing
      const Vector3 d = span.end - span.start;
      rope::GuyLine line;
      line.length = span.chord;
      line.slope = std::atan2(d.z(), std::hypot(d.x(), d.y()));
      line.weight = rope.weight;
      line.stiffness = rope.stiffness;
      line.tension = (span.T_from + span.T_to) / 2;
      rope::RingStiffness one = rope::in_ring(rope::horizontal_stiffness(line), std::atan2(d.y(), d.x()));
      for (int copy = 0; copy < rope.copies; ++copy) ring = ring + one;
      any = true;
    }
  }
  if (!any) return std::nullopt;
  const double mean = (ring.xx + ring.yy) / 2;
  return mean - std::hypot((ring.xx - ring.yy) / 2, ring.xy);
}

void add_top_check(const MastCheckRequest& request, const MachineDeck& deck, const MachineRun& run,
                   const MastReport& report, Result& r) {
  if (!request.top_criterion) return;
  const std::string top = beams_of(request).back() + ".top";
  double height = 0, EI = HUGE_VAL;
  for (std::size_t i = 0; i < report.materials.size(); ++i) {
    height += run.model.beams[index_in(run.model, beams_of(request)[i])].length;
    EI = std::min(EI, beam_named(deck, beams_of(request)[i])->E * report.materials[i].section.I_z);
  }
  const double wanted = *request.top_criterion * structure::euler_load(1, EI, height) / height;
  double least = HUGE_VAL;
  std::string when;
  for (const Answer& a : answers_of(run)) {
    const auto k = guy_stiffness(deck, a, top);
    if (!k || *k >= least) continue;
    least = *k;
    when = a.words;
  }
  Check c = make_check(
      request.name + ".top_stiffness", std::isfinite(least) ? least : 0, Sense::at_least, wanted,
      si::N_per_m.in("kN/m"),
      fmt::format("horizontal stiffness of the guys at its top in their weakest direction against {:.3g} N_cr/L of the "
                  "mast hinged at both ends; {}",
                  *request.top_criterion, when.empty() ? "no guy holds it" : when),
      "UNVERIFIED: 3 to 4 recalled practice");
  c.part = request.name;
  r.checks.push_back(std::move(c));
}

}  // namespace

std::vector<NamedAnswer> named_answers(const MachineRun& run) {
  std::vector<NamedAnswer> all;
  const auto name = [](const std::string& ending, const char* kind) {  // "_2": the second without a name
    const bool numbered = ending.find_first_not_of("0123456789", 1) == std::string::npos;
    return ending.size() < 2 || numbered ? std::string(kind) : ending.substr(1);
  };
  std::vector<std::string> names;
  for (const EquilibriumRun& one : run.equilibria) {
    if (one.result.outcome.ok()) names.push_back(name(one.ending, "equilibrium"));
  }
  for (const LoadPathRun& one : run.paths) {
    for (const LoadPathPart& part : one.parts) {
      for (const auto& point : part.result.points) {
        if (point.at.outcome.ok()) names.push_back(name(one.ending, "load_path"));
      }
    }
  }
  for (const Answer& a : answers_of(run)) {  // in the same order, then others
    all.push_back({a, all.size() < names.size() ? names[all.size()] : std::string{}});
  }
  return all;
}

void complain_of_masts(const std::vector<MastCheckRequest>& masts, const MachineDeck& deck, const model::Model&,
                       std::vector<Complaint>& complaints) {
  for (const MastCheckRequest& one : masts) {
    const std::string path = fmt::format("checks.masts.{}", one.name);
    if (is_own(one, deck)) {
      complain_of_own_mast(one, path, false, complaints);
      if (one.top_criterion) complaints.push_back({path + ".top_criterion", "is of the guys of a beam of the machine"});
      continue;
    }
    const auto refuse = [&](bool given, const char* key) {
      if (given) complaints.push_back({path + "." + key, "is the machine's: say it of the beam there"});
    };
    refuse(!one.loads.empty(), "loads");
    refuse(one.section.has_value(), "section");
    refuse(!one.pieces.empty(), "pieces");
    refuse(one.height.has_value(), "height");
    refuse(one.own_weight, "own_weight");
    refuse(one.top_stiffness != 0, "top_stiffness");
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

void add_machine_masts(const std::vector<MastCheckRequest>& masts, const MachineDeck& deck, const MachineRun& run,
                       Result& r) {
  for (const MastCheckRequest& one : masts) {
    if (is_own(one, deck)) {
      add_mast_report(one, own_mast(one, one.loads), r);
      continue;
    }
    const MastReport report = MachineMast(one, deck, run).report();
    add_mast_report(one, report, r);
    add_top_check(one, deck, run, report, r);
  }
}

}  // namespace taut::app
