#include "taut/calc/answers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "taut/catalogue/rope_words.hpp"
#include "taut/methods/friction_drive/friction_drive.hpp"
#include "taut/units/display.hpp"

namespace taut::friction_drive {
namespace {

/// "the deck's screw, set to 30 kN at rest, pulls 27 kN and", "the deck's 12 kN", "a pull of 8.6 kN on the idler".
std::string take_up_words(const Input& in, const std::string& pull, const Display& display) {
  // without one in the deck it is the weight that the method says to build
  if (!in.take_up) return fmt::format("a pull of {} on the idler", pull);
  if (!in.take_up->screw) return fmt::format("the deck's {}", pull);
  return fmt::format("the deck's screw, set to {} at rest, pulls {} while the rope runs and",
                     display.brief(*in.take_up->screw, si::N), pull);
}

/// What the driving sheave has to pull is more than the cut takes, by the loss at the idler: T_1 - T_2.
std::vector<std::string> drive_words(const Input& in, const Result& r, const Display& display) {
  const double pull = number_of(r, "T_1_exact") - number_of(r, "T_2_exact");
  const bool slips = number_of(r, "slips_exact") > 0;
  const double cut = number_of(r, "power_working");
  const std::string into_the_cut = fmt::format("power {} into the cut", display.brief(cut, si::W));
  if (std::isnan(pull)) {
    if (!in.sheave_radius) return {into_the_cut};
    return {fmt::format("torque {}", display.brief(number_of(r, "torque_working"), si::N_m)), into_the_cut};
  }
  std::vector<std::string> words;
  const char* const where = slips ? " at the limit of slip" : "";
  if (in.sheave_radius)
    words.push_back(fmt::format("torque {}{}", display.brief(*in.sheave_radius * pull, si::N_m), where));
  words.push_back(fmt::format("power {} at the driving sheave{}", display.brief(in.speed * pull, si::W), where));
  words.push_back(slips ? fmt::format("the cut asks for {}", display.brief(cut, si::W)) : into_the_cut);
  return words;
}

}  // namespace

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
  const bool slips = number_of(r, "slips_exact") > 0;
  if (has("T_1_exact")) {
    add_answer_line(lines, "Tension",
                    {fmt::format("tight branch {}, slack branch {}{}", shown("T_1_exact"), shown("T_2_exact"),
                                 slips ? " at the limit of slip" : ""),
                     fmt::format("least without slip {} and {}", shown("T_1_no_slip"), shown("T_2_no_slip"))});
  } else {
    add_answer_line(
        lines, "Tension",
        {fmt::format("tight branch {}, slack branch {}, without slip", shown("T_1_no_slip"), shown("T_2_no_slip"))});
  }
  add_answer_line(lines, "Drive", drive_words(in, r, display));
  if (has("slips_exact")) {
    add_answer_line(lines, "Take-up",
                    {fmt::format("{} {}", take_up_words(in, shown("take_up_exact"), display),
                                 slips ? "lets the rope slip on its whole arc" : "holds the rope"),
                     fmt::format("{} of the working arc is used", shown("arc_used_exact"))});
  }
  return lines.answers;
}

}  // namespace taut::friction_drive
