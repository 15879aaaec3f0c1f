#include "taut/solve/quantities.hpp"

#include <algorithm>
#include <cmath>

#include "taut/calc/none.hpp"
#include "taut/math/fixed_angles.hpp"

namespace taut::solve {
namespace {

const machine::Node& node(const machine::Model& m, int reeving, int n) { return m.reevings[reeving].nodes[n]; }

/// Horizontal direction from the branch's start to its end; 0 where it hangs plumb.
Vector3 plan_direction(const BranchResult& branch) {
  Vector3 along = branch.end - branch.start;
  along.z() = 0;
  if (along.norm() > 0) along.normalize();
  return along;
}

Vector3 pull(const RopeEndRow& r) { return r.last ? pull_on_end(r.branch) : pull_on_start(r.branch); }

const machine::Node& own_node(const DriveRow& r) { return node(r.model, r.part.reeving, r.part.node); }

/// Arcs and limits of a drive are known where its friction is given.
double with_friction(const DriveRow& r, double value) { return std::isfinite(own_node(r).law.friction) ? value : none; }

double power_of(const DrumRow& r) {
  return r.part.speed ? r.model.reevings[r.part.reeving].copies * r.part.pull * *r.part.speed : none;
}

}  // namespace

const BranchResult& first_branch(const EquilibriumResult& at, int reeving) {
  return *std::find_if(at.branches.begin(), at.branches.end(), [&](const auto& s) { return s.reeving == reeving; });
}

const BranchResult& last_branch(const EquilibriumResult& at, int reeving) {
  return *std::find_if(at.branches.rbegin(), at.branches.rend(), [&](const auto& s) { return s.reeving == reeving; });
}

Vector3 pull_on_start(const BranchResult& branch) { return branch.H * plan_direction(branch) + branch.V_from * up(); }

Vector3 pull_on_end(const BranchResult& branch) { return -branch.H * plan_direction(branch) - branch.V_to * up(); }

std::string_view to_text(ContactState state) {
  switch (state) {
    case ContactState::turning:
      return "turning";
    case ContactState::slipping:
      return "slipping";
    case ContactState::stuck:
      return "stuck";
    case ContactState::held:
      return "held";
    case ContactState::pulled:
      return "pulled";
    case ContactState::lifted:
      return "lifted";
  }
  return "";
}

const Quantities<BranchRow>& branch_quantities() {
  using Row = BranchRow;
  static const Quantities<Row> all = {
      {"rope", "", si::one, "the rope", [](const Row& r) { return r.model.reevings[r.part.reeving].name; }},
      {"from", "", si::one, "node where the branch begins",
       [](const Row& r) { return node(r.model, r.part.reeving, r.part.from).name; }},
      {"to", "", si::one, "node where it ends",
       [](const Row& r) { return node(r.model, r.part.reeving, r.part.to).name; }},
      {"T_from", "T_0", si::N, "tension where it begins", [](const Row& r) { return r.part.T_from; }},
      {"T_to", "T_1", si::N, "tension where it ends", [](const Row& r) { return r.part.T_to; }},
      {"H", "H", si::N, "horizontal part of its tension", [](const Row& r) { return r.part.H; }},
      {"V_from", "V_0", si::N, "vertical part where it begins; positive where it rises along the path",
       [](const Row& r) { return r.part.V_from; }},
      {"V_to", "V_1", si::N, "vertical part where it ends", [](const Row& r) { return r.part.V_to; }},
      {"chord", "c", si::m, "straight distance between its ends", [](const Row& r) { return r.part.chord; }},
      {"unstretched", "L", si::m, "length without tension, at the temperature of the state",
       [](const Row& r) { return r.part.unstretched * (1 + r.model.reevings[r.part.reeving].thermal_strain); }},
      {"stretched", "l", si::m, "length under its tension", [](const Row& r) { return r.part.stretched; }},
      {"sag", "f", si::m, "largest distance below its chord", [](const Row& r) { return r.part.sag; }}};
  return all;
}

const Quantities<BranchRow>& branch_band_quantities() {
  using Row = BranchRow;
  static const Quantities<Row> all = {
      {"T_from_min", "", si::N, "least T_from that friction allows at rest",
       [](const Row& r) { return r.part.T_from_min; }},
      {"T_from_max", "", si::N, "largest T_from that friction allows", [](const Row& r) { return r.part.T_from_max; }},
      {"T_to_min", "", si::N, "least T_to", [](const Row& r) { return r.part.T_to_min; }},
      {"T_to_max", "", si::N, "largest T_to", [](const Row& r) { return r.part.T_to_max; }}};
  return all;
}

const Quantities<ContactRow>& contact_quantities() {
  using Row = ContactRow;
  static const Quantities<Row> all = {
      {"name", "", si::one, "the sheave, support or carriage",
       [](const Row& r) { return node(r.model, r.part.reeving, r.part.node).name; }},
      {"T_in", "T_in", si::N, "tension before it along the path", [](const Row& r) { return r.part.T_in; }},
      {"T_out", "T_out", si::N, "tension behind it", [](const Row& r) { return r.part.T_out; }},
      {"wrap", "theta", si::rad, "angle by which the rope bends over it",
       [](const Row& r) { return r.part.wrap < 0 ? r.part.wrap : r.part.turning; }},
      {"Fx", "F_x", si::N, "force of the rope (one copy) on it", [](const Row& r) { return r.part.force.x(); }},
      {"Fy", "F_y", si::N, "the same along y", [](const Row& r) { return r.part.force.y(); }},
      {"Fz", "F_z", si::N, "the same along z", [](const Row& r) { return r.part.force.z(); }},
      {"resultant", "F", si::N, "size of that force", [](const Row& r) { return r.part.force.norm(); }},
      {"state", "", si::one, "turning, slipping, stuck, held, pulled (upwards) or lifted",
       [](const Row& r) { return std::string(to_text(r.part.state)); }},
      {"rope", "", si::one, "the rope", [](const Row& r) { return r.model.reevings[r.part.reeving].name; }}};
  return all;
}

const Quantities<ContactRow>& contact_band_quantities() {
  using Row = ContactRow;
  static const Quantities<Row> all = {
      {"T_in_min", "", si::N, "least T_in that friction allows at rest", [](const Row& r) { return r.part.T_in_min; }},
      {"T_in_max", "", si::N, "largest T_in that friction allows", [](const Row& r) { return r.part.T_in_max; }},
      {"T_out_min", "", si::N, "least T_out", [](const Row& r) { return r.part.T_out_min; }},
      {"T_out_max", "", si::N, "largest T_out", [](const Row& r) { return r.part.T_out_max; }}};
  return all;
}

const Quantities<RopeLoadRow>& rope_load_quantities() {
  using Row = RopeLoadRow;
  static const Quantities<Row> all = {
      {"name", "", si::one, "the load", [](const Row& r) { return node(r.model, r.part.reeving, r.part.node).name; }},
      {"rope", "", si::one, "the rope", [](const Row& r) { return r.model.reevings[r.part.reeving].name; }},
      {"F", "F", si::N, "force on one copy, positive along the path", [](const Row& r) { return r.part.along_path; }},
      {"T_in", "T_in", si::N, "tension before it along the path", [](const Row& r) { return r.part.T_in; }},
      {"T_out", "T_out", si::N, "tension behind it", [](const Row& r) { return r.part.T_out; }},
      {"x", "x", si::m, "where it acts", [](const Row& r) { return r.part.at.x(); }},
      {"y", "y", si::m, "where it acts", [](const Row& r) { return r.part.at.y(); }},
      {"z", "z", si::m, "where it acts", [](const Row& r) { return r.part.at.z(); }}};
  return all;
}

const Quantities<RopeEndRow>& rope_end_quantities() {
  using Row = RopeEndRow;
  static const Quantities<Row> all = {
      {"name", "", si::one, "anchor or drum at the rope's end",
       [](const Row& r) { return node(r.model, r.branch.reeving, r.last ? r.branch.to : r.branch.from).name; }},
      {"rope", "", si::one, "the rope", [](const Row& r) { return r.model.reevings[r.branch.reeving].name; }},
      {"T", "T", si::N, "tension there", [](const Row& r) { return r.last ? r.branch.T_to : r.branch.T_from; }},
      {"Fx", "F_x", si::N, "force of the rope (one copy) on it", [](const Row& r) { return pull(r).x(); }},
      {"Fy", "F_y", si::N, "the same along y", [](const Row& r) { return pull(r).y(); }},
      {"Fz", "F_z", si::N, "the same along z", [](const Row& r) { return pull(r).z(); }}};
  return all;
}

const Quantities<RopeRow>& rope_quantities() {
  using Row = RopeRow;
  static const Quantities<Row> all = {
      {"name", "", si::one, "the rope", [](const Row& r) { return r.model.reevings[r.reeving].name; }},
      {"unstretched", "L", si::m, "unstretched length", [](const Row& r) { return r.at.ropes[r.reeving].unstretched; }},
      {"T_max", "T_max", si::N, "largest tension anywhere in it",
       [](const Row& r) { return r.at.ropes[r.reeving].T_max; }},
      {"where", "", si::one, "node where that is",
       [](const Row& r) {
         const RopeResult& rope = r.at.ropes[r.reeving];
         const BranchResult& s = r.at.branches[rope.branch];
         return node(r.model, s.reeving, rope.at_end ? s.to : s.from).name;
       }},
      {"safety_factor", "S", si::one, "minimum breaking force over T_max, where that force is known", [](const Row& r) {
         const double factor = r.at.ropes[r.reeving].safety_factor;
         return factor > 0 ? factor : none;
       }}};
  return all;
}

const Quantities<RopeRow>& rope_end_tensions() {
  using Row = RopeRow;
  static const Quantities<Row> all = {{"T_start", "T_start", si::N, "tension at the start of its path",
                                       [](const Row& r) { return first_branch(r.at, r.reeving).T_from; }},
                                      {"T_end", "T_end", si::N, "tension at the end of its path",
                                       [](const Row& r) { return last_branch(r.at, r.reeving).T_to; }}};
  return all;
}

const Quantities<BodyRow>& body_quantities() {
  using Row = BodyRow;
  const auto place = [](const Row& r) -> const Vector3& { return r.at.state.bodies[r.body].position; };
  const auto turn = [](const Row& r) { return fixed_angles(r.at.state.bodies[r.body].orientation); };
  const auto hold = [](const Row& r) -> const Vector3& { return r.at.reactions[r.body]; };
  static const Quantities<Row> all = {
      {"name", "", si::one, "the body", [](const Row& r) { return r.model.bodies[r.body].name; }},
      {"x", "x", si::m, "place", [=](const Row& r) { return place(r).x(); }},
      {"y", "y", si::m, "place", [=](const Row& r) { return place(r).y(); }},
      {"z", "z", si::m, "place", [=](const Row& r) { return place(r).z(); }},
      {"rx", "r_x", si::rad, "rotation about x, first", [=](const Row& r) { return turn(r).x(); }},
      {"ry", "r_y", si::rad, "then about y", [=](const Row& r) { return turn(r).y(); }},
      {"rz", "r_z", si::rad, "then about z", [=](const Row& r) { return turn(r).z(); }},
      {"Rx", "R_x", si::N, "force on it of what holds it", [=](const Row& r) { return hold(r).x(); }},
      {"Ry", "R_y", si::N, "the same along y", [=](const Row& r) { return hold(r).y(); }},
      {"Rz", "R_z", si::N, "the same along z", [=](const Row& r) { return hold(r).z(); }}};
  return all;
}

const Quantities<DriveRow>& drive_quantities() {
  using Row = DriveRow;
  static const Quantities<Row> all = {
      {"name", "", si::one, "the driven sheave", [](const Row& r) { return own_node(r).name; }},
      {"rope", "", si::one, "the rope", [](const Row& r) { return r.model.reevings[r.part.reeving].name; }},
      {"T_in", "T_in", si::N, "tension before it along the path", [](const Row& r) { return r.part.T_in; }},
      {"T_out", "T_out", si::N, "tension behind it", [](const Row& r) { return r.part.T_out; }},
      {"centrifugal", "c", si::N, "m v^2, contained in both tensions", [](const Row& r) { return r.part.centrifugal; }},
      {"torque", "M", si::N_m, "torque", [](const Row& r) { return r.part.torque; }},
      {"wrap", "theta", si::rad, "angle by which the rope bends over it", [](const Row& r) { return r.part.wrap; }},
      {"slip_arc", "theta_s", si::rad, "arc on which the rope creeps",
       [](const Row& r) { return with_friction(r, r.part.slip_arc); }},
      {"rest_arc", "theta_r", si::rad, "arc left in reserve",
       [](const Row& r) { return with_friction(r, r.part.rest_arc); }},
      {"ratio", "", si::one, "larger over smaller tension, both less m v^2", [](const Row& r) { return r.part.ratio; }},
      {"limit", "", si::one, "exp(mu theta), beyond which the rope slips",
       [](const Row& r) { return with_friction(r, r.part.limit); }},
      {"creep", "", si::one, "share of its way that the rope creeps", [](const Row& r) { return r.part.creep; }},
      {"speed", "v", si::m_per_s, "speed of the rope where it arrives",
       [](const Row& r) { return r.part.speed.value_or(none); }},
      {"power", "P", si::W, "power", [](const Row& r) { return r.part.speed ? r.part.power : none; }},
      {"power_loads", "", si::W, "part of it that the loads take",
       [](const Row& r) { return r.part.power_loads.value_or(none); }},
      {"power_losses", "", si::W, "part lost at sheaves and supports, the driven ones' bearings too",
       [](const Row& r) { return r.part.power_losses.value_or(none); }},
      {"power_carriages", "", si::W, "part that the carriages take",
       [](const Row& r) { return r.part.power_carriages.value_or(none); }},
      {"power_creep", "", si::W, "part lost by creep", [](const Row& r) { return r.part.power_creep.value_or(none); }}};
  return all;
}

const Quantities<DrumRow>& drum_quantities() {
  using Row = DrumRow;
  static const Quantities<Row> all = {
      {"name", "", si::one, "the drum", [](const Row& r) { return r.model.drums[r.part.drum].name; }},
      {"rope", "", si::one, "the rope", [](const Row& r) { return r.model.reevings[r.part.reeving].name; }},
      {"layer", "", si::one, "layer from which the rope leaves",
       [](const Row& r) { return static_cast<double>(r.part.layer); }},
      {"radius", "R", si::m.in("mm"), "of that layer, to the rope's centre",
       [](const Row& r) { return r.part.radius; }},
      {"wraps", "n", si::one, "wraps on it, all layers", [](const Row& r) { return r.part.wraps.value_or(none); }},
      {"length", "L", si::m, "unstretched rope on it", [](const Row& r) { return r.part.length.value_or(none); }},
      {"capacity", "", si::m, "unstretched rope that fits within its flanges",
       [](const Row& r) { return r.part.capacity.value_or(none); }},
      {"pull", "T", si::N, "tension of one copy where it leaves", [](const Row& r) { return r.part.pull; }},
      {"torque", "M", si::N_m, "torque of all copies", [](const Row& r) { return r.part.torque; }},
      {"pull_last_layer", "", si::N, "pull of the same torque in the last layer",
       [](const Row& r) { return r.part.pull_last_layer.value_or(none); }},
      {"speed", "v", si::m_per_s, "speed of the rope, positive when it is taken in",
       [](const Row& r) { return r.part.speed.value_or(none); }},
      {"power", "P", si::W, "power, all copies", power_of}};
  return all;
}

const Quantities<BeamPointRow>& beam_point_quantities() {
  using Row = BeamPointRow;
  static const Quantities<Row> all = {
      {"name", "", si::one, "the beam", [](const Row& r) { return r.model.beams[r.beam.beam].name; }},
      {"s", "s", si::m, "distance from its base along the axis as built", [](const Row& r) { return r.point.s; }},
      {"x", "x", si::m, "place", [](const Row& r) { return r.point.place.x(); }},
      {"y", "y", si::m, "place", [](const Row& r) { return r.point.place.y(); }},
      {"z", "z", si::m, "place", [](const Row& r) { return r.point.place.z(); }},
      {"N", "N", si::N, "axial force, tension positive", [](const Row& r) { return r.point.N; }},
      {"V", "V", si::N, "shear", [](const Row& r) { return r.point.V; }},
      {"M", "M", si::N_m, "bending moment", [](const Row& r) { return r.point.M; }},
      {"torsion", "M_t", si::N_m, "torsional moment", [](const Row& r) { return r.point.torsion; }},
      {"stress", "sigma", si::Pa, "|N|/A + M/W with torsion and shear by von Mises",
       [](const Row& r) { return r.point.stress; }},
      {"w", "w", si::m.in("mm"), "deflection across the chord, from as built", [](const Row& r) { return r.point.w; }}};
  return all;
}

const Quantities<BeamRow>& beam_quantities() {
  using Row = BeamRow;
  const auto most_bent = [](const Row& r) -> const BeamPoint& { return r.part.points[r.part.most_bent]; };
  static const Quantities<Row> all = {
      {"name", "", si::one, "the beam", [](const Row& r) { return r.model.beams[r.part.beam].name; }},
      {"M_max", "M_max", si::N_m, "largest bending moment", [=](const Row& r) { return most_bent(r).M; }},
      {"at", "s", si::m, "where that is, from the base", [=](const Row& r) { return most_bent(r).s; }},
      {"N_base", "N", si::N, "axial force at the base, tension positive,",
       [](const Row& r) { return r.part.points.front().N; }},
      {"N_max", "N_max", si::N, "largest axial force, pulled or pressed,",
       [](const Row& r) { return std::abs(r.part.points[r.part.most_pressed].N); }},
      {"stress_max", "sigma_max", si::Pa, "largest |N|/A + M/W with torsion and shear by von Mises",
       [](const Row& r) { return r.part.points[r.part.most_stressed].stress; }},
      {"top_displacement", "", si::m.in("mm"), "displacement of the far end",
       [](const Row& r) { return r.part.top_displacement; }},
      {"N_cr", "N_cr", si::N, "least critical axial force",
       [](const Row& r) {
         const double factor = r.part.least_factor();
         return std::isfinite(factor) && r.part.compression > 0 ? factor * r.part.compression : none;
       }},
      {"alpha_cr", "alpha_cr", si::one, "critical over present axial force",
       [](const Row& r) { return std::isfinite(r.part.least_factor()) ? r.part.least_factor() : none; }},
      {"Rx", "R_x", si::N, "force on the base", [](const Row& r) { return r.part.base_force.x(); }},
      {"Ry", "R_y", si::N, "force on the base", [](const Row& r) { return r.part.base_force.y(); }},
      {"Rz", "R_z", si::N, "force on the base", [](const Row& r) { return r.part.base_force.z(); }},
      {"Mx", "M_x", si::N_m, "moment on the base", [](const Row& r) { return r.part.base_moment.x(); }},
      {"My", "M_y", si::N_m, "moment on the base", [](const Row& r) { return r.part.base_moment.y(); }},
      {"Mz", "M_z", si::N_m, "moment on the base", [](const Row& r) { return r.part.base_moment.z(); }}};
  return all;
}

const Quantities<Closure>& closure_quantities() {
  static const Quantities<Closure> all = {
      {"rope_closure", "", si::m.in("mm"), "ends of branches and lengths of ropes", &Closure::rope},
      {"force_residual", "", si::N.in("N"), "balance of every freedom, law of every contact", &Closure::force},
      {"balance", "", si::N.in("N"), "weights, loads and forces of the ground together", &Closure::balance},
      {"iterations", "", si::one, "steps of Newton's method",
       [](const Closure& c) { return static_cast<double>(c.iterations); }}};
  return all;
}

}  // namespace taut::solve
