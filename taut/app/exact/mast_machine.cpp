#include "taut/app/exact/mast_machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "taut/base/gravity.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/machine/compile/beam_build.hpp"

namespace taut::app {
namespace {

using mast_section::Input;

constexpr int mast_elements = 48;    ///< sections with results: the largest moment lies at one of them to 1e-4
constexpr double share_step = 1e-3;  ///< to which the share of the loads that is held is found

double mast_height(const Input& in) { return std::max(in.skyline_block_height, in.mainline_block_height.value_or(0)); }

MastGuy bare_guy(const Input& in, std::size_t i) {
  const mast_section::Guy& g = in.guys[i];
  MastGuy out;
  out.name = std::to_string(i + 1);
  out.height = g.attachment_height.value_or(mast_height(in));
  out.anchor = {g.anchor_distance * std::cos(g.plan_angle), g.anchor_distance * std::sin(g.plan_angle),
                g.anchor_height};
  if (g.rope) {
    const auto rope = catalogue::find_rope_in_words(*g.rope);
    out.stiffness = g.modulus * rope->area;
    out.weight = rope->mass_per_length * standard_gravity;
    out.breaking_force = rope->breaking_force;
  }
  out.stiffness = g.stiffness.value_or(out.stiffness);
  out.weight = g.weight.value_or(out.weight);
  out.breaking_force = g.breaking_force.value_or(out.breaking_force);
  return out;
}

/// The rope of a guy between its anchor and a place.
machine::Reeving rope_of(const MastGuy& guy, const machine::Place& top) {
  machine::Reeving rope;
  rope.name = guy.name;
  rope.nodes.resize(2);
  rope.nodes[0].name = "anchor";
  rope.nodes[0].at.at = guy.anchor;
  rope.nodes[1].name = "mast";
  rope.nodes[1].at = top;
  rope.value = guy.length;
  rope.weight = guy.weight;
  rope.stiffness = guy.stiffness;
  rope.breaking_force = guy.breaking_force;
  return rope;
}

/// Between its anchor and the plumb mast the rope stands by itself.
Outcome put_up(const mast_section::Guy& given, MastGuy& guy) {
  machine::Model alone;
  alone.reevings.push_back(rope_of(guy, {.body = machine::ground, .at = Vector3(0, 0, guy.height)}));
  machine::Reeving& rope = alone.reevings.front();
  if (given.length) {
    rope.value = *given.length;
  } else {
    rope.given = given.install->at == mast_section::GuyEnd::top ? machine::Given::tension_at_end
                                                                : machine::Given::tension_at_start;
    rope.value = given.install->tension;
  }
  const solve::EquilibriumResult found = solve::equilibrium(alone);
  if (found.outcome.ok()) {
    guy.length = found.branches[0].unstretched;
    guy.installed = found.branches[0].T_to;
    guy.installed_most = rope::largest_tension(found.branches[0].shape);
    return {};
  }
  if (given.length) return infeasible(fmt::format("guy {}: {}", guy.name, found.outcome.message));
  return infeasible(fmt::format("guy {}: no length gives {:.4g} N when it is put up: {}", guy.name,
                                given.install->tension, found.outcome.message));
}

Vector3 block_force(const mast_section::BlockForce& f) { return {f.across, 0, -f.down}; }

struct MastLoad {
  double height = 0;
  Vector3 force = Vector3::Zero();
};

std::vector<MastLoad> loads_of(const Input& in, const mast_section::ClampForces& forces) {
  const double lower = in.mainline_block_height.value_or(in.skyline_block_height);
  std::vector<MastLoad> loads = {{.height = in.skyline_block_height, .force = block_force(forces.skyline)},
                                 {.height = lower, .force = block_force(forces.mainline)}};
  if (forces.lateral != 0) loads.push_back({.height = in.skyline_block_height, .force = {0, forces.lateral, 0}});
  return loads;
}

/// A place on the mast's axis, on the section nearest to it.
machine::Place place_at(const machine::Model& model, double height) {
  machine::Place place;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < model.bodies.size(); ++k) {
    const double above = height - model.bodies[k].position.z();
    if (std::abs(above) >= std::abs(nearest)) continue;
    nearest = above;
    place = {.body = static_cast<int>(k), .at = Vector3(0, 0, above)};
  }
  return place;
}

}  // namespace

MastGuys put_up_guys(const Input& in) {
  MastGuys guys;
  for (std::size_t i = 0; i < in.guys.size(); ++i) {
    MastGuy guy = bare_guy(in, i);
    guys.outcome = put_up(in.guys[i], guy);
    if (!guys.outcome.ok()) return guys;
    guys.all.push_back(std::move(guy));
  }
  return guys;
}

machine::Model mast_machine(const Input& in, const std::vector<MastGuy>& guys, const mast_section::ClampForces& forces,
                            const structure::BeamSection& section) {
  const std::vector<MastLoad> loads = loads_of(in, forces);
  machine::StraightBeam mast;
  mast.name = "mast";
  mast.to.at = {0, 0, mast_height(in)};
  mast.section = section;
  mast.section.shear_x = mast.section.shear_y = {};  // the paper's condition, N/A + M/W, has no shear
  mast.base = in.base == mast_section::Base::hinged ? machine::BeamHold::hinged : machine::BeamHold::clamped;
  mast.elements = mast_elements;
  for (const MastGuy& guy : guys) mast.stations.push_back(guy.height / mast_height(in));
  for (const MastLoad& load : loads) mast.stations.push_back(load.height / mast_height(in));
  mast.stations = machine::cuts_of(mast, mast_height(in));
  machine::Model model;
  machine::add_beam(model, mast);
  for (const MastLoad& load : loads) model.loads.push_back({place_at(model, load.height), load.force});
  for (const MastGuy& guy : guys) model.reevings.push_back(rope_of(guy, place_at(model, guy.height)));
  return model;
}

Outcome with_share_held(const machine::Model& model, const Outcome& outcome) {
  if (outcome.status != Status::infeasible || model.beams.empty()) return outcome;
  const auto stands = [&](double share) {
    machine::Model part = model;
    for (machine::Load& load : part.loads) load.force *= share;
    return solve::equilibrium(part).outcome.ok();
  };
  const bool guyed = !model.reevings.empty();
  if (!stands(0)) {
    return infeasible(guyed ? "the mast buckles under the tension of its guys alone: install them with less tension, "
                              "balance them around the mast, or give it a stiffer section"
                            : "the mast does not stand up by itself: clamp its foot, or give it guys");
  }
  double held = 0;
  for (double step = 0.5; step > share_step; step /= 2) {
    if (stands(held + step)) held += step;
  }
  return infeasible(fmt::format(
      "the mast finds no stable equilibrium above {:.3g} % of its loads: {}", 100 * held,
      guyed
          ? "it buckles, or falls aside where guys go slack; give it a stiffer section, stiffer or tighter guys, those "
            "towards the load too, or lower rope forces"
          : "it buckles; give it a stiffer section, or guys"));
}

double moment_balance(const machine::Model& model, const solve::EquilibriumResult& found) {
  const auto place = [&](const machine::Place& at) {
    const machine::Pose& body = found.state.bodies[static_cast<std::size_t>(at.body)];
    return Vector3(body.position + body.orientation * at.at);
  };
  const solve::BeamResult& mast = found.beams[0];
  Vector3 moment = mast.base_moment;
  for (const machine::Load& load : model.loads) moment += place(load.at).cross(load.force);
  for (const solve::BranchResult& guy : found.branches) moment += guy.end.cross(rope::force_on_end(guy.shape));
  const double weight = model.beams[0].pieces[0].rod.section.weight;
  for (std::size_t i = 1; i < mast.points.size(); ++i) {
    const solve::BeamPoint &low = mast.points[i - 1], &high = mast.points[i];
    moment += (low.place + high.place).cross(-weight * (high.s - low.s) / 2 * up());
  }
  return moment.norm();
}

bool hangs(const solve::BranchResult& guy) { return guy.unstretched >= guy.chord; }

}  // namespace taut::app
