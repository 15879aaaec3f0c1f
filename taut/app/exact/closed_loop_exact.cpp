#include "taut/app/exact/closed_loop_exact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "taut/app/exact/rope_doubts.hpp"
#include "taut/calc/answers.hpp"

namespace taut::app {
namespace {

/// Misfits below this are rounding, which differs from machine to machine.
constexpr double rounding = 1e-12;

solve::SecondSection second_section(const closed_loop::Input& in) {
  return {.distance = *in.section_distance,
          .along_rope = in.distance_kind == closed_loop::DistanceKind::rope,
          .sag_is_of_second = in.sag_of == closed_loop::Section::second,
          .place_is_of_second = in.position_of == closed_loop::Section::second};
}

Outcome exact_sag(const closed_loop::Input& in, const closed_loop::Case<double>& c, closed_loop::ExactSag& found) {
  using solve::LoopGiven;
  solve::LoopSag at;
  const solve::RunningLoop loop = running_loop(in, c);
  const auto find = [&](solve::LoopGiven given, double value) {
    return solve::find_loop_sag(loop, c.x, given, value, at);
  };
  Outcome o;
  switch (in.mode) {
    case closed_loop::Mode::winch_pull:
      o = find(solve::LoopGiven::tension_at_A, closed_loop::pull_at_A(in));
      break;
    case closed_loop::Mode::loop_length:
      o = find(solve::LoopGiven::length, *in.loop_length);
      break;
    case closed_loop::Mode::free_running:
      o = find(solve::LoopGiven::tension_at_carriage, c.S);
      break;
    case closed_loop::Mode::sag:
      at.sag = *in.sag;
      break;
  }
  found = {.sag = at.sag, .second = at.second};
  return o;
}

void keep(const solve::RunningLoop& loop, const solve::LoopState& s, closed_loop::Output& out) {
  out.P_v_exact = s.R_z;
  out.P_b_exact = s.R_z - loop.rise / loop.span * s.R_x;
  out.N_exact = s.roller_force();
  out.phi_exact = s.lean;
  out.T_uA_exact = s.upper_A.T_start;
  out.T_uB_exact = s.upper_B.T_end;
  out.T_lA_exact = s.lower_A.T_start;
  out.T_lB_exact = s.lower_B.T_end;
  out.T_U_exact = std::max(s.upper_A.T_end, s.upper_B.T_start);
  out.T_lLA_exact = s.lower_A.T_end;
  out.T_lLB_exact = s.lower_B.T_start;
  if (loop.second) {
    out.delta_f_exact = s.delta_sag;
    out.T_12_exact = std::max(s.between.T_start, s.between.T_end);
  }
  out.upper_sag_exact = s.upper_sag;
  out.loop_length_exact = s.loop_length();
  out.traction_length_exact = s.traction_length;
  out.return_length_exact = s.return_length;
  const double largest = std::max({out.T_uA_exact, out.T_uB_exact, out.T_lA_exact, out.T_lB_exact});
  out.residual_exact = std::max(s.residual / largest, rounding);
  out.closure_exact = std::max(s.closure / loop.span, rounding);
}

Outcome exact_values(const closed_loop::Input& in, const closed_loop::Case<double>& c, closed_loop::Output& out) {
  const solve::RunningLoop loop = running_loop(in, c);
  solve::LoopState s;
  Outcome o = solve::solve_loop(loop, {.x = c.x, .sag = c.f}, s);
  if (o.ok()) keep(loop, s, out);
  return o;
}

}  // namespace

solve::RunningLoop running_loop(const closed_loop::Input& in, const closed_loop::Case<double>& c) {
  solve::RunningLoop loop;
  loop.span = c.l;
  loop.rise = c.l * c.m;
  loop.branch_distance = in.branch_distance;
  loop.offset_is_vertical = in.branch_offset == closed_loop::BranchOffset::vertical;
  loop.traction_rope = {.weight = c.q_T, .stiffness = c.EA_T};
  loop.return_rope = {.weight = c.q_b, .stiffness = c.EA_b};
  loop.efficiency = c.eta;
  loop.pull_x = c.S * c.sin_g;
  loop.pull_z = -c.S * c.cos_g;
  loop.carriage_weight = c.W_c;
  loop.roller = in.roller == closed_loop::Roller::free ? solve::RollerLaw::free : solve::RollerLaw::vertical;
  if (in.carriage == closed_loop::Carriage::two_section) loop.second = second_section(in);
  return loop;
}

const closed_loop::Engine& loop_engine() {
  static const closed_loop::Engine engine{.sag = exact_sag, .solve = exact_values};
  return engine;
}

Result run_closed_loop(const closed_loop::Input& in, const Display& display) {
  Result r = closed_loop::run(in, loop_engine(), display);
  const Table* ropes = r.find_table("ropes");
  for (std::size_t k = 0; ropes != nullptr && k < ropes->rows.size(); ++k) {
    const std::string role = text_in(*ropes, k, "role"), row = text_in(*ropes, k, "designation");
    MethodRope rope{.name = role,
                    .rope = {},
                    .own = {},
                    .tension = number_in(*ropes, k, "largest_tension"),
                    .stiffness_key = role + "_stiffness"};
    if (!row.empty()) rope.rope = row;
    const double stiffness = role == "return" ? in.return_stiffness : in.traction_stiffness;
    if (std::isfinite(stiffness)) rope.own.stiffness = stiffness;
    warn_of_rope(rope, display, r);
  }
  return r;
}

}  // namespace taut::app
