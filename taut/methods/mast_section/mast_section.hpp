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

/// Section of the mast of a tractor-mounted cable yarder, after Shoshin, Dorozhko, Shtollmann, Yarmolik (2022).
///
/// A vertical mast, clamped at its foot, carries the blocks of skyline and mainline. Each rope arrives from the span at
/// the angle alpha below the horizontal, passes over its block and runs down to its drum. The largest rope forces give
/// the resultants at the blocks, the internal forces at the clamp and the smallest section with N/A + M/W <= [sigma].
///
/// Signs: N > 0 is compression; Q > 0 pulls the head towards the span; M > 0 bends the mast towards the span, so that
/// the largest compression is on the side of the span. alpha and gamma are positive below the horizontal.
namespace taut::mast_section {

inline constexpr double not_computed = std::numeric_limits<double>::quiet_NaN();

/// Wrap angle of the rope on its block: geometric: 90 deg + alpha, as in figure 5; paper: 120 deg for any alpha, as the
/// paper calculates.
enum class Wrap { geometric, paper };
enum class SectionKind { any, chs, shs, rhs };
enum class FormingChoice { any, hot, cold, seamless, welded };
enum class LeastTrust { verified, derived, unverified };

/// The span; with it the branch angle follows from the position of the carriage by (10), (11).
struct Span {
  double length = not_computed;              ///< l, horizontal, m
  double chord_slope = 0;                    ///< psi, rad; positive where the chord falls away from the mast
  std::vector<double> carriage_position;     ///< x from the mast, m, 0 < x <= l
  double rope_weight = not_computed;         ///< w of the skyline, N/m
  double load = not_computed;                ///< Q at the carriage, N
  double horizontal_tension = not_computed;  ///< H of the skyline, N

  static const Description& describe();
};

/// Which sections of the catalogue may be chosen.
struct ChooseSection {
  SectionKind shape = SectionKind::any;
  FormingChoice forming = FormingChoice::any;
  std::optional<std::string> standard;  ///< the beginning of its name: "EN 10210"
  LeastTrust least_trust = LeastTrust::unverified;
  /// Largest ratio of outer size to wall thickness. The lightest section by stress alone is wide and thin and buckles
  /// locally; up to 35 sections of S355 reach the yield stress (EN 1993-1-1 table 5.2, as recalled: class 3 of a box
  /// ends at 37, of a tube at 59).
  double largest_slenderness = 35;

  static const Description& describe();
};

/// Foot of the mast in the exact solution. The published method has the clamped one only.
enum class Base { clamped, hinged };
enum class GuyEnd { top, anchor };

/// Installation of a guy, while the mast is vertical and unloaded.
struct GuyInstall {
  double tension = not_computed;  ///< N
  GuyEnd at = GuyEnd::top;        ///< end at which it has this tension

  static const Description& describe();
};

/// A guyline, for the exact solution only: the published method neglects guys.
struct Guy {
  std::optional<std::string> rope;          ///< of the catalogue: weight, breaking force and, with `modulus`, stiffness
  std::optional<double> stiffness;          ///< EA, N
  double modulus = 100e9;                   ///< Pa, on the rope's metallic area, where no stiffness is given
  std::optional<double> weight;             ///< N/m
  std::optional<double> breaking_force;     ///< N
  double plan_angle = not_computed;         ///< rad, from the span's direction, counter-clockwise seen from above
  double anchor_distance = not_computed;    ///< m, horizontal, from the mast's axis
  double anchor_height = 0;                 ///< m, above the clamp
  std::optional<double> attachment_height;  ///< m above the clamp; default: that of the higher block
  std::optional<GuyInstall> install;        ///< or
  std::optional<double> length;             ///< unstretched, m
  bool may_slack = false;                   ///< it may go slack: no unsafe warning

  static const Description& describe();
};

struct Input {
  double skyline_force = not_computed;          ///< T_sky, N
  double mainline_force = not_computed;         ///< T_main, N
  double skyline_block_height = not_computed;   ///< h_sky above the clamp, m
  std::optional<double> mainline_block_height;  ///< h_main, m; default: as the skyline's
  double block_friction = 0.12;                 ///< f
  Wrap wrap = Wrap::geometric;
  /// Force at which a brake slips while the rope is paid out, N; none: it does not slip.
  std::optional<double> paid_out_force;
  std::optional<double> branch_angle;  ///< alpha, rad; or
  std::optional<Span> span;
  std::optional<double> allowable_stress;  ///< [sigma], Pa; or
  std::optional<std::string> steel;        ///< of the catalogue, with
  std::optional<double> safety;            ///< n: [sigma] = f_y / n
  double tube_ratio = 0.9;                 ///< c = d/D
  std::optional<std::string> section;      ///< "CHS 508x16": a section to check
  std::optional<ChooseSection> choose_section;
  std::vector<Guy> guys;  ///< these and the following members are for the exact solution, not in the published method
  std::optional<double> lateral_force;  ///< N, across the span, at the skyline block
  Base base = Base::clamped;

  static const Description& describe();
};

/// Values at the governing carriage position. Each section size is the largest that any position requires.
struct Output {
  double x = not_computed;                  ///< m, governing carriage position, where the span is given
  double f_x = not_computed;                ///< m, skyline sag there
  double alpha = not_computed;              ///< rad
  double wrap = not_computed;               ///< rad
  double F_span_sky = not_computed;         ///< N
  double R_sky = not_computed;              ///< N
  double gamma_sky = not_computed;          ///< rad
  double gamma_sky_printed = not_computed;  ///< rad, (9) as printed
  double F_span_main = not_computed;        ///< N
  double R_main = not_computed;             ///< N
  double gamma_main = not_computed;         ///< rad
  double N = not_computed;                  ///< N
  double M = not_computed;                  ///< N m
  double Q = not_computed;                  ///< N
  double sigma_allow = not_computed;        ///< Pa
  double b_square = not_computed;           ///< m
  double B_hollow = not_computed;           ///< m, outer side
  double B_hollow_printed = not_computed;   ///< m, with 1.33 and 6.41
  double D_tube = not_computed;             ///< m
  double D_tube_printed = not_computed;     ///< m, with 1.27 and 10
  double t_tube = not_computed;             ///< m, wall of D_tube
  double N_payout = not_computed;           ///< N, rope paid out under load
  double M_payout = not_computed;           ///< N m
  double D_tube_payout = not_computed;      ///< m
  double D_tube_mixed = not_computed;       ///< m, one rope hauled in, the other paid out
  double D_tube_rest = not_computed;        ///< m, at least one rope at rest
  double D_tube_worst = not_computed;       ///< m, the largest of the four
  double section_stress = not_computed;     ///< Pa, in the section checked or chosen
  double section_allowable = not_computed;  ///< Pa
  double section_mass = not_computed;       ///< kg/m

  static const Description& describe();
};

const Method& about();

/// The rules between fields that the deck violates, and names that the catalogue does not have. Paths below `input`.
std::vector<Complaint> complaints(const Input& in);

/// (1)-(16) and the table of section kinds, in the paper's order. Of several carriage positions it computes the one
/// that requires the largest tube; where another position governs another kind of section, that kind is computed there.
/// Precondition: complaints(in) is empty. T is double or Num.
template <class T>
Outcome compute(const Input& in, Sheet<T>& s, Output& out);

/// compute<double>: of one carriage position without allocation when [sigma] is given.
Outcome solve(const Input& in, Output& out);

/// Whether the mast is another than the method's clamped cantilever in one plane: it has guys, a side force or a hinge.
/// The method's moment, shear and axial force at the foot are then not those of this mast.
bool is_beyond_method(const Input& in);

/// The result for a report: values, steps, tables of positions and of catalogue sections, checks, figures. A section
/// is chosen and checked for ropes hauled in, paid out and at rest, by first order; run.hpp has the same by second
/// order.
Result run(const Input& in);
/// The lines of the main answer, from a result of this input that is ok.
std::vector<Answer> answers(const Input& in, const Result& r, const Display& display);

}  // namespace taut::mast_section
