#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/calc/method.hpp"
#include "taut/calc/outcome.hpp"
#include "taut/calc/result.hpp"
#include "taut/calc/sheet.hpp"

namespace taut {
class Display;
}

/// Friction drive of an endless rope with cutters (rope-saw), after Ryabukhin, Grigoriev, Ivanov (2022).
///
/// The rope runs over a driving sheave and an idler that is pulled by a constant force. Given are the cutting force,
/// the speed and the friction. Results are the branch forces at the limit of slip, the initial tension P_M of the
/// paper, and the take-up pull at which the rope does not slip (with P_M it slips).
///
/// All forces are tensions, N, positive when they pull. T_1, P_tight: the branch that runs onto the driving sheave;
/// T_2, P_slack: the branch that leaves it. Both contain the centrifugal tension c = q U^2.
namespace taut::friction_drive {

inline constexpr double not_computed = std::numeric_limits<double>::quiet_NaN();

/// The take-up of the exact solution: a constant pull on the idler, or fixed centres set at rest.
struct TakeUp {
  std::optional<double> weight;  ///< N; or
  std::optional<double> mass;    ///< kg, of a hanging weight; or
  std::optional<double> screw;   ///< N, pull on the idler at rest without load

  static const Description& describe();
};

/// Where the cutting force acts: at the idler, which then feels the whole tight tension as in the method, or in the
/// middle of the tight branch.
enum class CutPlace { at_idler, in_tight_branch };

struct Input {
  double cutting_force = not_computed;  ///< P_p, N
  double friction = not_computed;       ///< mu, 0 < mu <= 1.5
  double wrap = not_computed;           ///< alpha on the driving sheave, rad
  double rope_mass = not_computed;      ///< q, kg/m, with the cutters
  double speed = not_computed;          ///< U, m/s
  double grip_reserve = 1.2;            ///< m >= 1
  double section_factor = 0;            ///< k of Andreev's formula
  double fill_ratio = 1;                ///< K_fill / K_fill_max
  double rest_arc = 0;                  ///< m_a d/R, rad
  double idler_loss = 1.08;             ///< r, the factor in (14)
  std::optional<double> rope_area;      ///< A, m2
  std::optional<double> sheave_radius;  ///< R to the rope's centre, m
  std::optional<std::string> rope;      ///< of the catalogue: id, or construction, core, diameter and grade in words
  /// This and the following members are for the exact solution, not in the published method.
  std::optional<TakeUp> take_up;
  std::optional<double> rope_stiffness;   ///< EA, N
  std::optional<double> centre_distance;  ///< of the sheaves, m
  std::optional<double> idler_radius;     ///< to the rope's centre, m; for checks of the rope
  CutPlace cut = CutPlace::at_idler;

  static const Description& describe();
};

struct Output {
  double euler_ratio = not_computed;             ///< exp(mu alpha)
  double andreev_ratio = not_computed;           ///< exp(mu phi)
  double phi = not_computed;                     ///< rad
  double e = not_computed;                       ///< exp(mu phi)
  double c = not_computed;                       ///< N
  double P_slack = not_computed;                 ///< N, (15)
  double P_tight = not_computed;                 ///< N, (16)
  double P_tight_printed = not_computed;         ///< N, (13) as printed
  double P_T = not_computed;                     ///< N, (17)
  double P_M = not_computed;                     ///< N, (18) derived
  double P_M_printed = not_computed;             ///< N, (18) as printed
  double P_M_3_printed = not_computed;           ///< N, (3) as printed
  double T_1 = not_computed;                     ///< N, with P_M
  double T_2 = not_computed;                     ///< N, with P_M
  double slip_ratio = not_computed;              ///< (T_1 - c)/(T_2 - c)
  double cutting_force_at_P_M = not_computed;    ///< N, largest cutting force when the take-up keeps P_M
  double T_1_no_slip = not_computed;             ///< N
  double T_2_no_slip = not_computed;             ///< N
  double takeup_no_slip = not_computed;          ///< N
  double takeup_with_idler_loss = not_computed;  ///< N
  double takeup_15_16 = not_computed;            ///< N, P_tight + P_slack - 2 c
  double speed_of_lost_grip = not_computed;      ///< m/s
  double F_0 = not_computed;                     ///< N, tension of each branch at rest
  double sigma_0 = not_computed;                 ///< Pa
  double sigma_tight = not_computed;             ///< Pa
  double torque = not_computed;                  ///< N m, (1), (2)
  double torque_working = not_computed;          ///< N m
  double power = not_computed;                   ///< W
  double power_working = not_computed;           ///< W
  double diameter_ratio = not_computed;          ///< D/d
  double safety_factor = not_computed;           ///< minimum breaking force over the largest tension

  static const Description& describe();
};

const Method& about();

/// The rules between fields that the deck violates, and names that the catalogue does not have. Paths below `input`.
std::vector<Complaint> complaints(const Input& in);

/// The equations of the paper in its order, the corrected ones beside them, and the drive that does not slip.
/// Infeasible when e <= idler_loss: the grip is then too small to turn the idler. Does not use `rope`. T is double or
/// Num.
template <class T>
Outcome compute(const Input& in, Sheet<T>& s, Output& out);

/// compute<double>, without allocation.
Outcome solve(const Input& in, Output& out);

/// The result for a report: values, steps, checks, comparisons, tables, figures, and the strength of the rope.
Result run(const Input& in);
/// The same, with its values for whoever goes on from there. `display`: the units of its messages.
Result run(const Input& in, Output& out, const Display& display);
/// The lines of the main answer, from a result of this input that is ok.
std::vector<Answer> answers(const Input& in, const Result& r, const Display& display);

}  // namespace taut::friction_drive
