#include "taut/calc/answers.hpp"

#include <fmt/format.h>

#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/boom_ropes/sliding.hpp"
#include "taut/units/display.hpp"

namespace taut::boom_ropes {

namespace {

/// As the deck has it. Precondition: has_pretension(in).
double pretension_of(const Input& in, Rope rope) {
  if (in.sliding) return sliding_pretension(in, *in.sliding, rope);
  return *(rope == Rope::extension ? in.S10 : in.S20);
}

}  // namespace

std::vector<Answer> answers(const Input& in, const Result& r, const Display& display) {
  Result lines;
  const auto shown = [&](const char* value, Rounding rounding = Rounding::nearest) {
    const Value* v = r.find_value(value);
    return v == nullptr ? std::string() : display.brief(v->value, v->unit, rounding);
  };
  const auto has = [&](const char* value) { return r.find_value(value) != nullptr; };
  if (has("S10_set") && has("S20_set")) {
    const bool is_given = has_pretension(in);
    const auto given = [&](Rope rope, const std::string& printed) {
      if (!is_given) return shown(printed.c_str(), Rounding::up);
      const double tension = pretension_of(in, rope);
      const std::string corrected = printed + "_corrected";
      const char* const set = has(corrected.c_str()) ? corrected.c_str() : printed.c_str();
      const std::string own = display.brief(tension, si::N.in("kN"));
      return own == shown(set) ? own : fmt::format("{}, settles at {}", own, shown(set));
    };
    add_answer_line(lines, is_given ? given_label : needs_label,
                    {fmt::format("pretension of the extension rope {} (one branch)", given(Rope::extension, "S10_set")),
                     fmt::format("of the retraction rope {}", given(Rope::retraction, "S20_set"))});
  }
  if (has("S10_min_corrected") && has("S20_min_corrected")) {
    add_answer_line(lines, "Least",
                    {fmt::format("pretension of the extension rope {}, of the retraction rope {}, by the corrected "
                                 "stiffness",
                                 shown("S10_min_corrected", Rounding::up), shown("S20_min_corrected", Rounding::up))});
  } else if (has("S10_min") && has("S20_min")) {
    add_answer_line(lines, "Least",
                    {fmt::format("pretension of the extension rope {}, of the retraction rope {}",
                                 shown("S10_min", Rounding::up), shown("S20_min", Rounding::up))});
  }
  if (has("S1_max") || !in.cases.empty()) {
    const auto up_to = [&](const char* words, Rope rope) {
      const LargestTension most = largest_tension(in, r, rope, display);
      return fmt::format("{} up to {} ({})", words, display.brief(most.tension, si::N), most.where);
    };
    add_answer_line(
        lines, "Load",
        {up_to("one branch of the extension rope", Rope::extension), up_to("retraction rope", Rope::retraction)});
  }
  if (has("S1_max")) {
    add_answer_line(lines, "Cylinder",
                    {fmt::format("force from {} to {}", shown("Fh_min"), shown("Fh_max")),
                     fmt::format("largest at {}, boom {} long, {} suspended", shown("governing_angle"),
                                 shown("governing_length"), shown("governing_weight"))});
  }
  if (lines.answers.empty() && has("lambda_1")) {
    add_answer_line(lines, "Shares",
                    {fmt::format("of a change of the force each extension branch takes {}, the retraction rope {}",
                                 shown("lambda_1"), shown("lambda_2"))});
  }
  return lines.answers;
}

}  // namespace taut::boom_ropes
