#include "taut/study/modes.hpp"

#include <fmt/format.h>

#include <cmath>

#include "taut/calc/none.hpp"
#include "taut/machine/compile/guides.hpp"
#include "taut/study/deck/motion_checks.hpp"

namespace taut::study {
namespace {

std::string mode_kind_words(solve::ModeKind kind) {
  switch (kind) {
    case solve::ModeKind::swings:
      return "swings";
    case solve::ModeKind::creeps:
      return "creeps back";
    case solve::ModeKind::free:
      return "nothing brings it back";
    case solve::ModeKind::unstable:
      return "unstable";
  }
  return {};
}

constexpr double mode_rounding = 1e-10;  ///< beside the largest shift, which is 1

const solve::Mode& mode_of(const ModeRow& r) { return r.set.modes[r.mode]; }
double mode_number(const ModeRow& r) { return static_cast<double>(r.mode + 1); }

double rounded(double x) { return std::abs(x) < mode_rounding ? 0 : x; }
double shift_along(const ModeShapeRow& r, int axis) { return rounded(mode_of(r.of).bodies[r.body].shift[axis]); }
double turn_about(const ModeShapeRow& r, int axis) { return rounded(mode_of(r.of).bodies[r.body].turn[axis]); }

}  // namespace

const Description& ModesRequest::describe() {
  using Start = TransientRequest::Start;
  using Branches = TransientRequest::Branches;
  static const Description d =
      Describe<ModesRequest>()
          .field(&ModesRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&ModesRequest::judge, "judge", "false: its states do not count for the verdict")
          .field(&ModesRequest::count, "count", "n", si::one, "number of modes, lowest first")
          .at_least(1)
          .at_most(400)
          .choice(&ModesRequest::start, "start", {{"settled", Start::settled}, {"assembled", Start::assembled}},
                  "settled: about the equilibrium at rest; assembled: places and lengths as described")
          .field(&ModesRequest::damping_ratio, "damping_ratio", "zeta", si::one,
                 "damping ratio of ropes without their own, in the lowest mode that stretches the rope")
          .at_least(0)
          .at_most(10)
          .field(&ModesRequest::rope_mass, "rope_mass", "false: ropes without weight and inertia")
          .choice(
              &ModesRequest::branches, "branches",
              {{"straight", Branches::straight}, {"catenary", Branches::catenary}, {"by_weight", Branches::by_weight}},
              "branches, as in a transient");
  return d;
}

std::string sheaves_words(const ModesRun& run, const solve::ModeSet& set) {
  if (run.result.sets.size() == 1) return "no loss";
  return set.sheaves == solve::Sheaves::stuck ? "stuck" : "released";
}

ModesRun resolve(const ModesRequest& request, const std::string& path, Names& names) {
  ModesRun run;
  run.ending = ending_of(names, "modes", request.name, path);
  if (request.name) run.words = fmt::format("modes, {}", *request.name);
  const bool settled = request.start == TransientRequest::Start::settled;
  run.options.start = settled ? solve::Start::settled : solve::Start::assembled;
  run.options.most = request.count;
  run.options.damping_ratio = request.damping_ratio;
  run.options.rope_mass = request.rope_mass;
  run.options.branches = branches_of(request.branches);
  check_inertia(names.machine, names.model, names.complaints);
  check_masses(names.machine, names.model, {.rope_mass = request.rope_mass}, names.complaints);
  return run;
}

void solve(const machine::Model& model, ModesRun& run) {
  run.model = machine::with_guides_at_start(model);
  run.result = solve::modes(run.model, run.options);
}

const Quantities<ModeRow>& mode_quantities() {
  using Row = ModeRow;
  static const Quantities<Row> all = {
      {"sheaves", "", si::one, "those with a loss: stuck or released; no loss: there are none",
       [](const Row& r) { return sheaves_words(r.run, r.set); }},
      {"mode", "", si::one, "its number, from 1", mode_number},
      {"frequency", "f", si::per_s.in("Hz"), "undamped frequency", [](const Row& r) { return mode_of(r).frequency; }},
      {"period", "T", si::s, "its inverse",
       [](const Row& r) { return mode_of(r).frequency > 0 ? 1 / mode_of(r).frequency : none; }},
      {"damped", "f_d", si::per_s.in("Hz"), "damped frequency", [](const Row& r) { return mode_of(r).damped; }},
      {"damping_ratio", "zeta", si::one, "damping as a share of the critical one",
       [](const Row& r) { return mode_of(r).kind == solve::ModeKind::free ? none : mode_of(r).damping; }},
      {"kind", "", si::one, "swings, creeps back, nothing brings it back, or unstable",
       [](const Row& r) { return mode_kind_words(mode_of(r).kind); }},
      {"moves_most", "", si::one, "body with most of the kinetic energy, or the ropes", [](const Row& r) {
         return mode_of(r).largest ? r.run.model.bodies[*mode_of(r).largest].name : std::string("ropes");
       }}};
  return all;
}

const Quantities<ModeShapeRow>& mode_shape_quantities() {
  using Row = ModeShapeRow;
  static const Quantities<Row> all = {
      {"sheaves", "", si::one, "as in modes", [](const Row& r) { return sheaves_words(r.of.run, r.of.set); }},
      {"mode", "", si::one, "its number, from 1", [](const Row& r) { return mode_number(r.of); }},
      {"body", "", si::one, "the body", [](const Row& r) { return r.of.run.model.bodies[r.body].name; }},
      {"x", "", si::one, "shift of its origin; 1 is the largest of all",
       [](const Row& r) { return shift_along(r, 0); }},
      {"y", "", si::one, "shift along y", [](const Row& r) { return shift_along(r, 1); }},
      {"z", "", si::one, "shift along z", [](const Row& r) { return shift_along(r, 2); }},
      {"rx", "", si::one, "turn about x, rad per metre of the largest shift",
       [](const Row& r) { return turn_about(r, 0); }},
      {"ry", "", si::one, "turn about y", [](const Row& r) { return turn_about(r, 1); }},
      {"rz", "", si::one, "turn about z", [](const Row& r) { return turn_about(r, 2); }}};
  return all;
}

}  // namespace taut::study
