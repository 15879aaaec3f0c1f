#include "taut/methods/friction_drive/friction_drive.hpp"

#include <fmt/format.h>

#include <cmath>

#include "taut/methods/friction_drive/grip.hpp"

namespace taut::friction_drive {
namespace {

// For double; Num brings its own along.
using std::exp;
using std::max;
using std::sqrt;

/// What every later line needs.
template <class T>
struct Drive {
  T P_p, m, r, e, c;
};

/// Euler, Andreev and the centrifugal tension.
template <class T>
Drive<T> drive_of(const Input& in, Sheet<T>& s, Output& out) {
  s.section("Grip");
  const T mu = s.given(in.friction);
  const T alpha = s.given(in.wrap);
  const T k = s.given(in.section_factor);
  const T fill = s.given(in.fill_ratio);
  const T rest = s.given(in.rest_arc);
  const T euler = s.eq("", "euler_ratio", si::one, exp(mu * alpha), "Euler");
  const T andreev =
      s.eq("", "andreev_ratio", si::one, exp(mu * (alpha - rest) * (1 - k) / (k * mu + 1) * fill), "Andreev");
  const T phi = s.eq("", "phi", si::rad, (alpha - rest) * (1 - k) / (mu * k + 1) * fill);
  const T e = s.eq("", "e", si::one, exp(mu * phi));
  const T q = s.given(in.rope_mass);
  const T U = s.given(in.speed);
  const T c = s.eq("", "c", si::N, q * square(U), "centrifugal tension");
  out.euler_ratio = value(euler);
  out.andreev_ratio = value(andreev);
  out.phi = value(phi);
  out.e = value(e);
  out.c = value(c);
  return {s.given(in.cutting_force), s.given(in.grip_reserve), s.given(in.idler_loss), e, c};
}

/// (13) to (18): the paper's chain, each misprint beside its correction.
template <class T>
T initial_tension(const Drive<T>& d, Sheet<T>& s, Output& out) {
  const auto& [P_p, m, r, e, c] = d;
  s.section("Branches at the limit of slip and initial tension, as the paper has it");
  const T P_slack = s.eq("15", "P_slack", si::N, m * (P_p + c * (e - 1)) / (e - r));
  const T printed_13 = s.eq("13", "P_tight_printed", si::N, c + P_slack * e);
  const T P_tight = s.eq("16", "P_tight", si::N, c + (P_slack - c) * e);
  const T P_T = s.eq("17", "P_T", si::N, P_tight - P_slack);
  const T printed_3 = s.eq("3", "P_M_3_printed", si::N, (P_T + P_p) * (e + 1) / (e - 1));
  const T printed_18 = s.eq("18", "P_M_printed", si::N,
                            P_p * (e + 1) * (m / (e - r) - 1 / (e - 1)) + c * (e + 1) * ((e - 1) / (e - r) - 1));
  const T P_M = s.eq("18*", "P_M", si::N,
                     P_p * (e + 1) * (m / (e - r) - 1 / (e - 1)) + c * (e + 1) * (m * (e - 1) / (e - r) - 1));
  out.P_slack = value(P_slack);
  out.P_tight = value(P_tight);
  out.P_tight_printed = value(printed_13);
  out.P_T = value(P_T);
  out.P_M_3_printed = value(printed_3);
  out.P_M_printed = value(printed_18);
  out.P_M = value(P_M);
  out.takeup_15_16 = value(s.eq("", "W_15_16", si::N, P_tight + P_slack - 2 * c, "pull on the idler by (15), (16)"));
  return P_M;
}

/// The branches of the paper under P_M, and whether a take-up that holds P_M keeps the rope from slipping. The paper
/// puts the cutting force on top of a drive at its limit, so that its branches never meet its condition. The pull may
/// hold all the same: it then leaves other branches, which are judged.
template <class T>
void slip_under_P_M(const Input& in, const Drive<T>& d, const T& P_M, Sheet<T>& s, Output& out) {
  const auto& [P_p, m, r, e, c] = d;
  s.section("Does the drive hold with P_M?");
  const T T_1 = s.eq("", "T_1", si::N, P_M / (1 + 1 / e) + c + P_p);
  const T T_2 = s.eq("", "T_2", si::N, P_M / e / (1 + 1 / e) + c);
  const T ratio = s.eq("", "slip_ratio", si::one, (T_1 - c) / (T_2 - c), "no-slip condition, from (13)");
  const T passed =
      s.eq("", "P_p_at_P_M", si::N, P_M * (e - 1) / (e + 1), "take-up that holds P_M, at the limit of slip");
  const T slack = s.eq("", "T_2_P_M", si::N, slack_branch_under(P_M, P_p, r, c), "take-up that holds P_M, with (14)");
  const T tight = s.eq("", "T_1_P_M", si::N, r * slack + P_p, "(14)");
  const T reserve =
      s.eq("", "m_P_M", si::one, reserve_of(tight, slack, e, c), "reserve of the grip; below 1 the rope slips");
  const bool held = holds(value(reserve));
  if (in.take_up) {
    s.note("P_M is not the deck's pull: the grip is checked with its take-up, by the exact solution.");
  } else if (!held) {
    s.check("no slip", ratio, si::one,
            {Sense::at_most, e, "(T_1 - c)/(T_2 - c) <= exp(mu phi), Ryabukhin et al. 2022, (12), (13)", "derived"});
  } else {
    s.check("no slip", (tight - c) / (slack - c), si::one,
            {Sense::at_most, e, "(T_1 - c)/(T_2 - c) <= exp(mu phi) with the branches that P_M leaves, (13), (14)",
             "derived"});
    s.check("grip reserve", reserve, si::one,
            {Sense::at_least, m, "(e - 1)(T_2 - c)/(T_1 - T_2) >= m with the branches that P_M leaves", "derived"});
  }
  out.T_1 = value(T_1);
  out.T_2 = value(T_2);
  out.slip_ratio = value(ratio);
  out.cutting_force_at_P_M = value(passed);
}

/// The drive that does not slip: the branches differ by the cutting force and keep the reserve m against e.
template <class T>
void drive_without_slip(const Input& in, const Drive<T>& d, Sheet<T>& s, Output& out) {
  const auto& [P_p, m, r, e, c] = d;
  s.section("The drive that does not slip");
  const T T_2 = s.eq("", "T_2_no_slip", si::N, c + m * P_p / (e - 1), "no-slip condition with the reserve m");
  const T T_1 = s.eq("", "T_1_no_slip", si::N, T_2 + P_p, "balance of the driving sheave");
  const T takeup = s.eq("", "W_no_slip", si::N, T_1 + T_2 - 2 * c, "pull on the idler");
  out.T_2_no_slip = value(T_2);
  out.T_1_no_slip = value(T_1);
  out.takeup_no_slip = value(takeup);
  // The loss at the idler makes the driving sheave pull (r - 1) T_2 more, (14); with m = 1 this is (15), (16).
  if (value(e) - 1 > value(m) * (value(r) - 1)) {
    const T slack = s.eq("", "T_2_idler", si::N, (m * P_p + c * (e - 1)) / (e - 1 - m * (r - 1)), "the same with (14)");
    out.takeup_with_idler_loss =
        value(s.eq("", "W_idler_loss", si::N, (r + 1) * slack + P_p - 2 * c, "pull on the idler with (14)"));
  } else {
    s.note("The loss at the idler, with this reserve, takes more than the grip can give: no take-up is enough.");
  }
  if (in.rope_mass > 0) {
    const T q = s.given(in.rope_mass);
    out.speed_of_lost_grip = value(s.eq("", "U_lost", si::m_per_s, sqrt(takeup / (2 * q)),
                                        "screw take-up set to takeup_no_slip at rest: T_1 + T_2 = 2 c"));
  }
}

/// (1), (2), F_0 = A sigma_0 where area and radius are known.
template <class T>
void machine(const Input& in, const Drive<T>& d, Sheet<T>& s, Output& out) {
  const T U = s.given(in.speed);
  const T P_T = s.named("P_T", si::N, out.P_T);
  s.section("Drive and rope");
  const T takeup = s.named("W_no_slip", si::N, out.takeup_no_slip);
  const T F_0 = s.eq("", "F_0", si::N, takeup / 2, "each branch at rest, idler pulled by takeup_no_slip");
  out.F_0 = value(F_0);
  out.power = value(s.eq("", "power", si::W, P_T * U, "at the limit of slip, (17)"));
  out.power_working = value(s.eq("", "power_working", si::W, d.P_p * U, "into the cut"));
  if (in.sheave_radius) {
    const T R = s.given(*in.sheave_radius);
    out.torque = value(s.eq("2", "torque", si::N_m, R * P_T));
    out.torque_working = value(s.eq("2", "torque_working", si::N_m, R * d.P_p));
  }
  if (in.rope_area) {
    const T A = s.given(*in.rope_area);
    const T P_tight = s.named("P_tight", si::N, out.P_tight);
    const T T_1 = s.named("T_1_no_slip", si::N, out.T_1_no_slip);
    out.sigma_0 = value(s.eq("", "sigma_0", si::Pa, F_0 / A, "Ryabukhin et al. 2022, F_0 = A sigma_0"));
    out.sigma_tight =
        value(s.eq("", "sigma_tight", si::Pa, max(P_tight, T_1) / A, "the larger of both tight branches"));
  }
}

}  // namespace

template <class T>
Outcome compute(const Input& in, Sheet<T>& s, Output& out) {
  const Drive<T> d = drive_of(in, s, out);
  if (!(value(d.e) > value(d.r))) return infeasible(how_to_get_grip(in, s.display()));
  const T P_M = initial_tension(d, s, out);
  slip_under_P_M(in, d, P_M, s, out);
  drive_without_slip(in, d, s, out);
  machine(in, d, s, out);
  return {};
}

template Outcome compute<double>(const Input&, Sheet<double>&, Output&);
template Outcome compute<Num>(const Input&, Sheet<Num>&, Output&);

Outcome solve(const Input& in, Output& out) {
  Sheet<double> s;
  return compute(in, s, out);
}

}  // namespace taut::friction_drive
