#include "taut/methods/closed_loop/paper_choice.hpp"

#include <fmt/format.h>

#include <cmath>

#include "taut/methods/closed_loop/sizing.hpp"
#include "taut/units/display.hpp"

namespace taut::closed_loop {
namespace {

/// The estimate of an area has three digits.
constexpr double remarkable = 0.001;

/// A rope as the paper chooses it, and what becomes of it under its own weight.
struct PaperRope {
  const char* equation;
  const char* name;
  double area;    ///< m2
  double factor;  ///< safety factor that it has
  const Peak& peak;
};

void warn(const PaperRope& rope, double wanted, const Display& display, std::vector<std::string>& warnings) {
  if (!(rope.factor < wanted * (1 - remarkable))) return;
  warnings.push_back(
      fmt::format("{} is unsafe for the {} rope: its {} are meant to have a safety factor of {:.3g}, but with "
                  "their own weight "
                  "they have {:.3g}, as the rope is pulled with up to {} ({}). Choose by the corrected area, "
                  "and prove the rope "
                  "chosen with its own weight.",
                  rope.equation, rope.name, display.brief(rope.area, si::m2), wanted, rope.factor,
                  display.brief(rope.peak.tension, si::N), rope.peak.where));
}

}  // namespace

void prove_paper_choice(const Input& in, Output& out, const Display& display, std::vector<std::string>& warnings) {
  if (!in.wire_strength || !in.safety_factor || !std::isfinite(out.F_return_paper)) return;
  Input own = in;
  own.position.clear();
  own.mode = Mode::sag;
  own.sag = std::isfinite(out.f_midspan) ? out.f_midspan : out.f;
  own.winch_pull.reset();
  own.loop_length.reset();
  own.return_rope.reset();
  own.traction_rope.reset();
  own.choose_ropes.reset();
  own.safety_factor.reset();
  own.return_weight = in.weight_per_area * out.F_return_paper;
  own.traction_weight = in.weight_per_area * out.F_traction_paper;
  Output proof;
  if (!solve(own, proof).ok()) return;
  const Peaks peaks = closed_form_peaks_of(proof);
  out.safety_factor_return_paper = *in.wire_strength * out.F_return_paper / peaks.return_rope.tension;
  out.safety_factor_traction_paper = *in.wire_strength * out.F_traction_paper / peaks.traction_rope.tension;
  warn({.equation = "(8)",
        .name = "return",
        .area = out.F_return_paper,
        .factor = out.safety_factor_return_paper,
        .peak = peaks.return_rope},
       *in.safety_factor, display, warnings);
  warn({.equation = "(10)",
        .name = "traction",
        .area = out.F_traction_paper,
        .factor = out.safety_factor_traction_paper,
        .peak = peaks.traction_rope},
       *in.safety_factor, display, warnings);
}

}  // namespace taut::closed_loop
