#include "taut/calc/answers.hpp"

#include <fmt/format.h>

#include "taut/catalogue/rope_words.hpp"
#include "taut/methods/friction_drive/friction_drive.hpp"
#include "taut/units/display.hpp"

namespace taut::friction_drive {

std::vector<Answer> answers(const Input& in, const Result& r, const Display& display) {
  Result lines;
  const auto shown = [&](const char* value, Rounding rounding = Rounding::nearest) {
    const Value* v = r.find_value(value);
    return v == nullptr ? std::string() : display.brief(v->value, v->unit, rounding);
  };
  const auto has = [&](const char* value) { return r.find_value(value) != nullptr; };
  std::vector<std::string> least = {
      fmt::format("pull on the idler of at least {}", shown("takeup_no_slip", Rounding::up))};
  least.push_back(has("takeup_with_idler_loss")
                      ? fmt::format("with the idler loss {}", shown("takeup_with_idler_loss", Rounding::up))
                      : std::string("with the idler loss no pull is enough"));
  add_answer_line(lines, needs_label, least);
  if (number_of(r, "slip_ratio") > number_of(r, "e")) {
    add_answer_line(lines, "Paper",
                    {fmt::format("its pull {} of (18) lets the rope slip", shown("P_M")),
                     fmt::format("the branches stand as {}, the grip holds {}", shown("slip_ratio"), shown("e"))});
  }
  if (in.rope) {
    const auto row = catalogue::find_rope_in_words(*in.rope);
    std::vector<std::string> parts = {fmt::format("rope {}", row ? catalogue::words_of_rope(*row) : *in.rope)};
    if (has("safety_factor"))
      parts.push_back(fmt::format("breaking force over largest tension {}", shown("safety_factor")));
    add_answer_line(lines, given_label, parts);
  }
  add_answer_line(
      lines, "Tension",
      {fmt::format("tight branch {}, slack branch {}, without slip", shown("T_1_no_slip"), shown("T_2_no_slip"))});
  std::vector<std::string> drive;
  if (has("torque_working")) drive.push_back(fmt::format("torque {}", shown("torque_working")));
  drive.push_back(fmt::format("power {} into the cut", shown("power_working")));
  add_answer_line(lines, "Drive", drive);
  if (has("slips_exact")) {
    const bool slips = number_of(r, "slips_exact") > 0;
    // without one in the deck it is the weight that the method says to build
    const std::string pull = in.take_up ? fmt::format("the deck's {}", shown("take_up_exact"))
                                        : fmt::format("a pull of {} on the idler", shown("take_up_exact"));
    add_answer_line(lines, "Take-up",
                    {fmt::format("{} {}", pull, slips ? "lets the rope slip on its whole arc" : "holds the rope"),
                     fmt::format("{} of the working arc is used", shown("arc_used_exact"))});
  }
  return lines.answers;
}

}  // namespace taut::friction_drive
