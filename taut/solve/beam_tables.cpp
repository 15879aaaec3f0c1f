#include "taut/solve/beam_tables.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/mechanics/beam_piece.hpp"
#include "taut/solve/beam_stability.hpp"

namespace taut::solve {
namespace {

using structure::RodState;

double angle_between(const Vector3& a, const Vector3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

BeamPoint point_of(const structure::RodPiece& rod, const RodState& state, const RodState& built, double s) {
  const structure::SectionForces f = section_forces(state);
  BeamPoint p;
  p.s = s;
  p.place = state.place;
  p.N = f.axial;
  p.V = std::hypot(f.shear_x, f.shear_y);
  p.M = std::hypot(f.bends_to_x, f.bends_to_y);
  p.torsion = f.torsion;
  p.shear_x = f.shear_x;
  p.shear_y = f.shear_y;
  p.bends_to_x = f.bends_to_x;
  p.bends_to_y = f.bends_to_y;
  if (rod.section.W_x > 0) p.stress = largest_stress(rod.section, f);
  p.deflection = state.place - built.place;
  return p;
}

/// The direction of a section's axis as it stands: first order tells its small turn apart.
Vector3 direction(const structure::RodPiece& rod, const RodState& state) {
  const Vector3 d = state.axes.col(2);
  return rod.order == structure::BeamOrder::second ? d : Vector3((d + state.turn.cross(d)).normalized());
}

/// Fills points and the largest values of one beam.
void fill_points(const mechanics::System& s, const mechanics::Configuration& c, int beam, BeamResult& r) {
  RodState built;  // as built, on what the beam begins on as that stands
  Vector3 first = Vector3::UnitZ(), first_built = first;
  for (std::size_t k = 0; k < s.layout.pieces.size(); ++k) {
    if (s.layout.pieces[k].beam != beam) continue;
    const machine::BeamPiece& piece = mechanics::piece_of(s, s.layout.pieces[k]);
    const RodState start = mechanics::piece_start(s, c, k);
    structure::RodPiece bare = piece.rod;
    bare.section.weight = 0;
    bare.thermal_strain = 0;
    bare.order = structure::BeamOrder::second;
    if (piece.rod.from == 0) {
      const bool moves = piece.reference != machine::ground;
      built.place = start.place;
      built.axes = moves ? Matrix3(c.bodies[piece.reference].orientation * piece.reference_axes) : piece.reference_axes;
      first = direction(piece.rod, start);
      first_built = built.axes.col(2);
      r.base_force = -start.force;
      r.base_moment = -start.moment;
    }
    Array<RodState> all = {start}, all_built = {built};
    along(piece.rod, start, &all);
    along(bare, built, &all_built);
    const double step = (piece.rod.to - piece.rod.from) / piece.rod.steps;
    for (std::size_t i = 0; i < all.size(); ++i) {
      BeamPoint& p = r.points.emplace_back(
          point_of(piece.rod, all[i], all_built[i], piece.rod.from + static_cast<double>(i) * step));
      p.listed = i % as_size(piece.section_every) == 0;
      if (piece.rod.section.W_x > 0) {
        const structure::SectionForces f = section_forces(all[i]);
        r.stress_in_corner = std::max(r.stress_in_corner, largest_stress_in_corner(piece.rod.section, f));
        if (leaves_out_torsion(piece.rod.section, f)) {
          r.torsion_left_out = std::max(r.torsion_left_out, std::abs(p.torsion));
        }
      }
      const double turn =
          angle_between(first, direction(piece.rod, all[i])) - angle_between(first_built, all_built[i].axes.col(2));
      r.bend = std::max(r.bend, std::abs(turn));
    }
    built = all_built.back();
  }
}

void fill_worst(const Vector3& chord, BeamResult& r) {
  for (std::size_t i = 0; i < r.points.size(); ++i) {
    BeamPoint& p = r.points[i];
    p.w = (p.deflection - chord * chord.dot(p.deflection)).norm();
    if (p.M > r.points[r.most_bent].M) r.most_bent = i;
    if (std::abs(p.N) > std::abs(r.points[r.most_pressed].N)) r.most_pressed = i;
    if (p.stress > r.points[r.most_stressed].stress) r.most_stressed = i;
    r.compression = std::max(r.compression, -p.N);
  }
  r.top_displacement = r.points.back().deflection.norm();
}

}  // namespace

Array<BeamResult> beam_results(const mechanics::System& s, const mechanics::Configuration& c) {
  Array<BeamResult> all;
  for (int b = 0; b < static_cast<int>(s.model.beams.size()); ++b) {
    BeamResult& r = all.emplace_back();
    r.beam = b;
    fill_points(s, c, b, r);
    const Vector3 start = r.points.front().place, end = r.points.back().place;
    const Vector3 built = end - r.points.back().deflection - start;
    fill_worst(built.normalized(), r);
    const int top = s.model.beams[b].pieces.back().end.body;
    if (top != machine::ground && s.model.bodies[top].beam == b) r.lean = angle_between(built, end - start);
  }
  return all;
}

void act_beams(const mechanics::System& s, const mechanics::Configuration& c,
               const std::function<void(int, const Vector3&)>& act, Vector3& outside) {
  for (std::size_t k = 0; k < s.layout.pieces.size(); ++k) {
    const machine::BeamPiece& piece = mechanics::piece_of(s, s.layout.pieces[k]);
    const RodState start = mechanics::piece_start(s, c, k);
    act(piece.start.body, start.force);
    act(piece.end.body, -along(piece.rod, start).force);
    outside -= piece.rod.section.weight * (piece.rod.to - piece.rod.from) * up();
  }
}

namespace {

Outcome judge(const mechanics::System& s, const mechanics::Configuration& c, bool factors, Array<BeamResult>& results) {
  if (results.empty()) return {};
  const auto name = [&](const BeamResult& r) { return s.model.beams[r.beam].name; };
  for (const BeamResult& r : results) {
    if (r.bend <= most_bend) continue;
    return infeasible(
        fmt::format("beam '{}' gives way: it is bent by {:.3g} rad, more than a beam lives to see ({} rad); choose a "
                    "stiffer section, guy it, or take load off",
                    name(r), r.bend, most_bend));
  }
  for (const BeamResult& r : results) {
    if (r.lean <= most_lean) continue;
    return infeasible(fmt::format(
        "beam '{}' falls over: where it comes to rest it leans {:.3g} rad from where the deck has it (at most "
        "{} rad); hold its top by guys, clamp its base, or put 'to' where it is meant to stand",
        name(r), r.lean, most_lean));
  }
  const std::optional<BeamStability> stability = beam_stability(s, c, factors);
  if (!stability && factors) {
    return not_converged(fmt::format(
        "whether beam '{}' stands, or buckles, was not found: the stiffness of the ropes that hold it has no number "
        "here; give the ropes the stiffness that they have, or leave out what carries nothing",
        name(results.front())));
  }
  if (!stability || (stability->stable && !factors)) return {};
  if (!factors) {
    return infeasible("the equilibrium found is not one to stay in: a beam buckles, or falls over");
  }
  for (BeamResult& r : results) {
    r.critical_factor = stability->factors[r.beam];
    r.critical_together = stability->together;
    r.swing_factor = stability->swings;
  }
  if (stability->stable) return {};
  if (stability->swings < 1) {
    return infeasible(fmt::format(
        "the equilibrium found is not one to stay in: under {:.4g} of its forces the machine with beam '{}' "
        "swings away, which its ropes hold by their tension alone; hold it by a rope across, or move "
        "the place about which it turns",
        stability->swings, name(results.front())));
  }
  const auto worst = std::min_element(results.begin(), results.end(), [](const BeamResult& a, const BeamResult& b) {
    return a.critical_factor < b.critical_factor;
  });
  if (worst->critical_factor < 1 && worst->critical_factor > 0) {
    return infeasible(fmt::format(
        "beam '{}' buckles: its compression of {:.6g} kN is {:.4g} times what it holds in this state; choose "
        "a stiffer section, shorten it, guy it, or take load off",
        name(*worst), worst->compression / 1e3, 1 / worst->critical_factor));
  }
  return infeasible(
      fmt::format("the equilibrium found is not one to stay in: the machine with beam '{}' falls over at "
                  "the least push; clamp its base, or hold its top by guys",
                  name(*worst)));
}

}  // namespace

Outcome check_beams(const mechanics::System& s, const mechanics::Configuration& c, Array<BeamResult>& results) {
  return judge(s, c, true, results);
}

Outcome beams_stay(const mechanics::System& s, const mechanics::Configuration& c) {
  Array<BeamResult> results = beam_results(s, c);
  return judge(s, c, false, results);
}

}  // namespace taut::solve
