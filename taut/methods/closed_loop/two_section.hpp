#pragma once
#include <functional>
#include <optional>

#include "taut/methods/closed_loop/paper.hpp"
#include "taut/methods/closed_loop/quick.hpp"

namespace taut::closed_loop {

/// Where the two sections of the carriage stand. Section 1 carries the rollers and the rope clamp, section 2 the
/// gathering force. Lengths m.
struct Sections {
  double d = 0;   ///< horizontal distance of the sections
  double x1 = 0;  ///< A to section 1
  double x2 = 0;
  double y1 = 0;  ///< section 1 to B
  double y2 = 0;
  double f1 = 0;  ///< vertical sag under the chord AB at section 1
  double f2 = 0;
  double t1 = 0;  ///< slope of the line from section 1 to B, tan(alpha_1)
};

/// Which of the quantities the deck gives.
struct SectionRule {
  double distance = 0;
  DistanceKind kind = DistanceKind::horizontal;
  Section sag_of = Section::first;
  Section position_of = Section::first;
};

/// The sections for a horizontal distance `d` and a sag `delta_f` of section 2 under the line from section 1 to B.
Sections place(const Case<double>& c, const SectionRule& rule, double d, double delta_f);

/// The smallest positive root of `g` in delta_f; empty when there is none below the sag (sag of section 2 given) or 50
/// times it (of section 1).
std::optional<double> smallest_delta_f(const Case<double>& c, const SectionRule& rule,
                                       const std::function<double(double)>& g);

/// Repeats `delta_f_at(d)` until the horizontal distance `d` fits the rule: at once when it is given, otherwise until
/// the straight rope between the sections is as long as it should be.
std::optional<double> fit_distance(const Case<double>& c, const SectionRule& rule, double& d,
                                   const std::function<std::optional<double>(double)>& delta_f_at);

/// Infeasible: section 2 finds no place below the line from section 1 to B.
Outcome no_equilibrium(const Case<double>& c);

/// A solution of one of the systems.
struct TwoSection {
  Sections at;
  double delta_f = 0;
  double P_b = 0;
  double T_B1 = 0;  ///< upper branch, oblique
  double T_B2 = 0;  ///< lower branch right of section 2, oblique
};

/// Equations (11)-(16) as printed, unrounded: one x, P and K resolved on the chord AB, T_B2 the same in (12) and (13),
/// f_2 = f_1 + delta_f. Empty when they have no solution with delta_f > 0.
std::optional<TwoSection> solve_as_printed(const Case<double>& c, const SectionRule& rule, double P, double K);

/// The corrected system: sections distinguished, S resolved on the chord of its own thread, horizontal forces equated,
/// sags from the chord AB, the carriage's weight at section 1. Writes P_b, T_b, T_n, T_up, T_lA of `p`. Infeasible: no
/// solution with delta_f > 0, or P_b <= 0.
template <class T>
Outcome corrected_system(const Case<T>& c, const Case<double>& plain, const SectionRule& rule, Sheet<T>& s, Paper<T>& p,
                         T& delta_f);

/// What the closed-form tier gives for two sections.
template <class T>
struct SectionForces {
  Quick<T> q;  ///< T_lLB: right of section 2
  T T_12;      ///< rope between the sections
  T delta_f;
  Sections at;
};

/// The closed-form tier for the two sections: roller force normal to the upper branch at section 1, true tensions over
/// the sheave. Infeasible and not converged as quick_tensions.
template <class T>
Outcome two_section_tensions(const Case<T>& c, const Case<double>& plain, const SectionRule& rule, Sheet<T>& s,
                             SectionForces<T>& out);

}  // namespace taut::closed_loop
