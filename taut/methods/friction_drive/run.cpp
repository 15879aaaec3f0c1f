#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "taut/calc/shown.hpp"
#include "taut/methods/friction_drive/figures.hpp"
#include "taut/methods/friction_drive/friction_drive.hpp"
#include "taut/methods/friction_drive/grip.hpp"
#include "taut/methods/friction_drive/rope_strength.hpp"
#include "taut/methods/friction_drive/tables.hpp"
#include "taut/units/display.hpp"

namespace taut::friction_drive {
namespace {

/// What a pull on the idler does to the rope.
const char* fate_of(double pull, const Input& in, const Output& o) {
  const double reserve = reserve_under(pull, in, o);
  return !holds(reserve) ? "slips" : keeps(reserve, in.grip_reserve) ? "holds" : "holds without the reserve";
}

std::string build_by_neither(double printed, double corrected, const Input& in, const Output& o) {
  const std::string first = fate_of(printed, in, o), second = fate_of(corrected, in, o);
  if (first == "slips" && second == "slips") return "neither: both slip, see the pull on the idler";
  return fmt::format("the pull on the idler; printed {}, corrected {}", first, second);
}

void add_comparisons(const Input& in, const Output& o, Result& r) {
  const auto add = [&](const char* quantity, const char* symbol, double printed, double corrected,
                       const std::string& build_by) {
    r.comparisons.push_back(
        {quantity, symbol, si::N, printed, corrected, not_computed, build_by, shown_below(printed, corrected)});
  };
  add("initial tension, (18)", "P_M", o.P_M_printed, o.P_M, build_by_neither(o.P_M_printed, o.P_M, in, o));
  add("initial tension, (3)", "P_M", o.P_M_3_printed, o.P_M, build_by_neither(o.P_M_3_printed, o.P_M, in, o));
  add("tight branch, (13)", "P_tight", o.P_tight_printed, o.P_tight, "corrected, for the limit of slip");
  add("pull on the idler: (18) derived and without slip", "W", o.P_M, o.takeup_no_slip,
      holds(reserve_under(o.takeup_no_slip, in, o)) ? "without slip; at least that, and the idler loss on top"
                                                    : "neither as it stands: the idler loss makes the one without slip "
                                                      "slip");
  add("pull on the idler: (15), (16) and without slip", "W", o.takeup_15_16, o.takeup_no_slip,
      "without slip; (15), (16) contain the idler loss and put the reserve on the centrifugal tension too");
}

/// A pull that is to be built is rounded up. One with which the rope slips by the idler loss is not to be built.
std::string build_by(const Input& in, const Output& o, const Display& display) {
  const auto at_least = [&](double pull) { return display.brief(pull, si::N, Rounding::up); };
  const bool held = holds(reserve_under(o.takeup_no_slip, in, o));
  const std::string without_loss = fmt::format("the pull without slip, {}, leaves that loss out{}",
                                               at_least(o.takeup_no_slip), held ? "" : ", and the rope slips with it");
  if (!std::isfinite(o.takeup_with_idler_loss)) {
    return fmt::format(
        "with the idler loss {:.3g} and the reserve {:.3g} no pull is enough: raise friction, wrap or fill; {}",
        in.idler_loss, in.grip_reserve, without_loss);
  }
  if (!held) {
    return fmt::format("build by the pull with the idler loss {:.3g}: the take-up has to hold at least {}; {}",
                       in.idler_loss, at_least(o.takeup_with_idler_loss), without_loss);
  }
  return fmt::format(
      "build by the pull without slip: the take-up has to hold at least {}; that leaves out the idler loss, with the "
      "idler loss {:.3g} on the slack branch it is {}",
      at_least(o.takeup_no_slip), in.idler_loss, at_least(o.takeup_with_idler_loss));
}

/// Of the pull that the paper asks for.
void warn_of_paper(const Input& in, const Output& o, const Display& display, std::vector<std::string>& warnings) {
  const auto force = [&](double x) { return display.brief(x, si::N); };
  const double reserve = reserve_under(o.P_M, in, o);
  if (!holds(reserve)) {
    const std::string ratio = std::isfinite(o.slip_ratio) ? fmt::format("{:.4g}", o.slip_ratio) : "infinite";
    warnings.push_back(fmt::format(
        "the paper's initial tension is not safe: with P_M = {} of (18) ({} as printed) the branches "
        "stand as (T_1 - c)/(T_2 - c) = {}, the grip holds e = {:.4g} at most, so the rope slips; beside the idler "
        "loss a take-up that holds P_M passes on {} of the {} cutting force",
        force(o.P_M), force(o.P_M_printed), ratio, o.e, force(cutting_force_under(o.P_M, in, o)),
        force(in.cutting_force)));
  } else if (!keeps(reserve, in.grip_reserve)) {
    warnings.push_back(
        fmt::format("the paper's initial tension has not the reserve that the deck asks for: a take-up that holds P_M "
                    "= {} of (18) keeps the rope from slipping with a reserve of {:.4g}, not {:.4g}",
                    force(o.P_M), reserve, in.grip_reserve));
  }
}

void add_warnings(const Input& in, const Output& o, const Display& display, Result& r) {
  auto& w = r.warnings;
  const auto force = [&](double x) { return display.brief(x, si::N); };
  warn_of_paper(in, o, display, w);
  w.push_back(build_by(in, o, display));
  if (in.friction > 0.4) {
    w.push_back(fmt::format(
        "friction {:.3g} is far above what mine hoists (0.20 to 0.25) and ropeways (0.22 to 0.30) are designed "
        "for: a wet, oily or sap-covered rope has much less; see the plot over friction",
        in.friction));
  }
  if (in.rope_mass * square(in.speed) > 0.25 * o.T_1_no_slip) {
    w.push_back(fmt::format(
        "the centrifugal tension c = {} is more than a quarter of the tight branch: between fixed sheaves "
        "(screw take-up) it has to be added to the tension at rest; set at rest to takeup_no_slip, the grip "
        "is gone at {}",
        force(o.c), display.brief(o.speed_of_lost_grip, si::m_per_s)));
  }
}

void add_assumptions(Result& r) {
  r.assumptions = {
      "The idler is pulled by a constant force (weight); c adds to both branches and leaves their grip alone.",
      "The tight branch is the one that the driving sheave draws in; the cut holds it back.",
      "Friction is the same along the arc; the rope has no bending stiffness, its weight on the sheave is left out.",
      "The cutting force is constant: starts and a bundle's fluctuation are left out.",
      "takeup_no_slip keeps the reserve m on the cutting force alone and leaves out the idler loss."};
}

}  // namespace

Result run(const Input& in) {
  Output out;
  return run(in, out, Display());
}

Result run(const Input& in, Output& out, const Display& display) {
  const Method& m = about();
  Result r = result_of(m, Input::describe(), &in);
  const auto rope = rope_of(in);
  Input with_area = in;
  if (rope && !in.rope_area) with_area.rope_area = rope->area;
  Sheet<Num> s(m.short_source, Input::describe(), &with_area);
  s.show_in(display);
  const Outcome outcome = compute(with_area, s, out);
  s.move_to(r);
  r.status = outcome.status;
  r.message = outcome.message;
  add_assumptions(r);
  if (in.section_factor > 0 || outcome.ok()) r.tables.push_back(readings_table(in, out));
  if (outcome.ok()) {
    add_warnings(in, out, display, r);
    add_comparisons(in, out, r);
    if (rope) check_rope(in, *rope, display, out, r);
    r.unjudged.emplace_back("rope");  // breaking is no limit: checks gives one
    r.figures = {drive_drawing(in, out), arc_plot(in, out), friction_plot(in, out, display), pull_plot(in, out),
                 speed_plot(in, out)};
  } else {
    r.figures = {drive_without_answer(in)};
  }
  r.values = values_of(Output::describe(), &out);
  return r;
}

}  // namespace taut::friction_drive
