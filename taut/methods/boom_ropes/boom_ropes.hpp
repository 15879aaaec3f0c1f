#pragma once
#include <cstddef>
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

/// Three-section telescopic boom: section 2 is driven by a cylinder, section 3 only by two ropes, the extension rope
/// (two branches of tension S1) and the retraction rope (S2). After A. A. Reutov (2021), equations (1)-(8), with a
/// quasi-static model of sections 2 and 3 sliding on their pads. SI and radians; forces along the boom are positive
/// outward.
namespace taut::boom_ropes {

inline constexpr double unset = std::numeric_limits<double>::quiet_NaN();

/// Operation of the boom. lift: the boom rests while a load is lifted; the load pushes section 3 in.
enum class Operation { lift, retract, extend };
/// The rope whose tensioner was pulled last.
enum class Rope { extension, retraction };

/// One state of the static calculation.
struct Case {
  std::string name;
  Operation operation = Operation::lift;
  double luffing_angle = unset;     ///< beta
  double suspended_weight = unset;  ///< G_n, hook block and load
  int falls = 1;                    ///< K
  static const Description& describe();
};

/// Case of the slip angle: the luffing angle at which section 3 slides by its own weight after a rope has broken.
struct Slip {
  double boom_length = unset;
  double suspended_weight = unset;
  double overlap_change = 0;  ///< change of the overlap by the jerk after the break: + pulled in, - pushed out
  int falls = 6;
  static const Description& describe();
};

/// The quasi-static sliding model. Its defaults are those of the crane KS-55713-5K-1, calibrated on the published
/// results or assumed.
struct Sliding {
  double retracted_length = 9;        ///< boom length for which the overlaps are given
  double stroke = 6;                  ///< of section 2 in section 1, and of section 3 in section 2
  double head_distance = 7.65;        ///< h_3
  double center_3 = 3.4;              ///< c_3
  double center_2 = 3.6;              ///< c_2
  double overlap_23 = 7.35;           ///< a_23
  double overlap_12 = 8.20;           ///< a_12
  double gap = 0.95;                  ///< e_23
  double pad_height_3 = 0.50;         ///< b_3
  double pad_height_2 = 0.60;         ///< b_2
  double offset_extension = 0;        ///< z_1
  double offset_retraction = 0;       ///< z_2
  double offset_hoist = 0;            ///< z_h
  double offset_lead = 0.25;          ///< z_k
  double offset_cylinder = -0.25;     ///< z_c
  double section2_weight = 12.0e3;    ///< G_2
  double sheave_efficiency_1 = 0.98;  ///< eta_1
  double sheave_efficiency_2 = 0.98;  ///< eta_2
  double extension_length = 16.5;     ///< half of the extension rope
  double retraction_length = 8.2;     ///< l_2
  std::optional<double> S10;          ///< default: that of Input, else calibrated
  std::optional<double> S20;
  double kinetic_friction = 0.15;        ///< f
  double static_friction = 0.155;        ///< f_0, for slip angles
  double extension_stiffness = 0.778e6;  ///< C_1
  double retraction_stiffness = 1.61e6;  ///< C_2
  double minimum_tension = 1;            ///< below it a rope counts as slack
  std::optional<int> falls;              ///< K; 8 when lifting, else 6
  std::vector<double> boom_length;
  std::vector<double> luffing_angle;
  std::vector<double> suspended_weight;
  Operation operation = Operation::extend;
  std::vector<Slip> slip_angles;
  static const Description& describe();
};

struct Input {
  double section_weight = unset;        ///< G_3
  double pad_friction = unset;          ///< f_0
  double tackle_efficiency = unset;     ///< zeta
  double extension_stiffness = unset;   ///< C_1, half rope
  double retraction_stiffness = unset;  ///< C_2
  Rope tensioned_last = Rope::extension;
  int tensioning_steps = 4;
  double slip_friction = 0.155;  ///< f_0 of the slip angle without jamming
  std::optional<double> S10;     ///< pretension as set, default: that of `sliding`; checked against (3)
  std::optional<double> S20;
  std::optional<double> stiffness_ratio;  ///< kappa = C_2/C_1 as measured, for the corrected stiffness
  std::vector<Case> cases;
  std::optional<Sliding> sliding;
  static const Description& describe();
};

/// One position of the sliding model. Without equilibrium the values are NaN, and `reason` tells why.
struct SlidingPoint {
  double luffing_angle = unset;
  double boom_length = unset;
  double suspended_weight = unset;
  double Fh = unset;  ///< cylinder force, + pushes section 2 out
  double S1 = unset;  ///< one branch of the extension rope, at section 3
  double S2 = unset;  ///< retraction rope, at section 3
  double Nf = unset;  ///< pad forces; + the lower pad carries
  double Nr = unset;
  double Mf = unset;
  double Mr = unset;
  double X = unset;  ///< elongation of half the extension rope since pretensioning
  std::string reason;
  bool ok() const { return reason.empty(); }
  /// Front and rear pads of section 3 carry on opposite sides: the friction then exceeds that of the weight alone.
  bool jamming() const { return (Nf < 0) != (Nr < 0); }
};

/// Both tensions after one step of the alternate tensioning (Table 1), for each order.
struct TensioningStep {
  double S10_extension_first = 0;
  double S20_extension_first = 0;
  double S10_retraction_first = 0;
  double S20_retraction_first = 0;
};

struct Output {
  std::vector<double> F;  ///< [case]
  double F0_extension = unset;
  double F0_retraction = unset;
  double lambda_1 = unset;
  double lambda_2 = unset;
  double S10_min = unset;
  double S20_min = unset;
  double S10_balance = unset;
  double S10_set = unset;
  double S20_set = unset;
  double F0_set = unset;
  double S10_set_corrected = unset;  ///< where section 3 slides: the ropes settle by their stiffness, C1_corrected
  double S20_set_corrected = unset;
  double C1_corrected = unset;
  double lambda_1_corrected = unset;
  double lambda_2_corrected = unset;
  double S10_min_corrected = unset;
  double S20_min_corrected = unset;
  double S10_balance_corrected = unset;
  double beta1_light = unset;
  double beta1_heavy = unset;
  double Fh = unset;
  double S1 = unset;
  double S2 = unset;
  double Fh_max = unset;
  double Fh_min = unset;
  double S1_max = unset;
  double S1_min = unset;
  double S2_max = unset;
  double S2_min = unset;
  double governing_angle = unset;
  double governing_length = unset;
  double governing_weight = unset;
  // Indices, not result values: the cases that govern (3), and the governing position of the grid.
  std::size_t highest_case = 0;
  std::size_t lowest_case = 0;
  std::size_t governing_point = 0;
  std::vector<SlidingPoint> grid;  ///< nested in this order: weights, angles, lengths
  static const Description& describe();
};

const Method& about();
std::vector<Complaint> complaints(const Input& in);

/// The equations in the paper's order. T: double, or Num for the calculation note. Infeasible when no position of the
/// sliding grid has an equilibrium.
template <class T>
Outcome compute(const Input& in, Sheet<T>& s, Output& out);
Outcome solve(const Input& in, Output& out);
/// `display`: the units of its assumptions.
Result run(const Input& in, const Display& display);
Result run(const Input& in);
/// The lines of the main answer, from a result of this input that is ok.
std::vector<Answer> answers(const Input& in, const Result& r, const Display& display);

/// Whether the deck has the pretension that the cases are calculated with: its own, or that of the sliding sections,
/// which are the same ropes.
bool has_pretension(const Input& in);

/// C1 and C2 as printed (unit corrected), and kappa = C2/C1 from the tensions in Table 2.
inline constexpr double printed_C1 = 2.72e6;
inline constexpr double printed_C2 = 1.61e6;
inline constexpr double table_2_ratio = 2.07;
/// The ratio kappa for the corrected stiffness: that of the deck; else that of Table 2 when the deck has the printed
/// stiffnesses; else empty.
std::optional<double> measured_ratio(const Input& in);

/// F by (4), (5) and their counterpart for extending: the sum of all longitudinal forces on section 3 except those of
/// the two ropes, N.
double force(const Input& in, const Case& one);

/// Tensions of a case with the pretensions `out.S10_set`, `out.S20_set`, by (2). Where (2) gives a negative tension the
/// rope is slack (0), and the tension of the other one follows from (1).
struct RopeTensions {
  double S1 = unset;
  double S2 = unset;
  bool extension_slack = false;
  bool retraction_slack = false;
};
RopeTensions tensions(const Output& out, double F);
/// The same with the shares of the corrected stiffness, where there is one, and with the pretension that settles by it.
std::optional<RopeTensions> corrected_tensions(const Output& out, double F);

/// The largest tension of a rope and the state that has it; NaN without any.
struct LargestTension {
  double tension = unset;  ///< N, of one branch of the extension rope
  std::string where;       ///< "case static test", in the display units
};
/// Of all states of a result of `in`: the pretension as set and as it settles, that of the sliding sections, each case
/// by the printed and by the corrected stiffness (neither is the safe one for both ropes), and each position of the
/// sliding grid. There the rope runs off section 3 over a sheave into the anchor branch (extension rope, boom
/// extending) or out of it (retraction rope, boom retracting), whose tension is that at section 3 over the efficiency
/// of the sheave.
LargestTension largest_tension(const Input& in, const Result& r, Rope rope, const Display& display);

/// Table 1: the tensioners are pulled alternately until section 3, held by `friction` = f0 G3, begins to slip:
/// extension S1 := (S2 + friction)/2, retraction S2 := 2 S1 + friction.
std::vector<TensioningStep> tensioning(double friction, int steps);

}  // namespace taut::boom_ropes
