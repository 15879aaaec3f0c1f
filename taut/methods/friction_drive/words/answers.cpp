#include "taut/calc/answers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>

#include "taut/catalogue/rope_words.hpp"
#include "taut/methods/friction_drive/friction_drive.hpp"
#include "taut/methods/friction_drive/grip.hpp"
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

/// A value of the result as text.
using Shown = std::function<std::string(const char* value, Rounding rounding)>;

/// The numbers of a result by which pulls on the idler are judged.
Output grip_of(const Result& r) {
  Output out;
  out.e = number_of(r, "e");
  out.c = number_of(r, "c");
  return out;
}

/// The pull to build: one with which the rope slips by the idler loss is not said to be enough.
std::vector<std::string> pull_words(const Input& in, const Result& r, const Shown& shown) {
  const std::string without = shown("takeup_no_slip", Rounding::up),
                    with = shown("takeup_with_idler_loss", Rounding::up);
  if (with.empty())
    return {"no pull on the idler is enough with the idler loss and this reserve",
            fmt::format("without that loss at least {}", without)};
  if (!holds(reserve_under(number_of(r, "takeup_no_slip"), in, grip_of(r))))
    return {fmt::format("pull on the idler of at least {}", with),
            fmt::format("{} without the idler loss, with which the rope slips", without)};
  return {fmt::format("pull on the idler of at least {}", without), fmt::format("with the idler loss {}", with)};
}

/// What the pull of the paper does, where it is not the one to build.
void add_paper(const Input& in, const Result& r, const Shown& shown, Result& lines) {
  const double reserve = reserve_under(number_of(r, "P_M"), in, grip_of(r));
  const std::string pull = shown("P_M", Rounding::nearest);
  if (!holds(reserve)) {
    const std::string ratio = shown("slip_ratio", Rounding::nearest);  // none where the slack branch has no pull
    add_answer_line(lines, "Paper",
                    {fmt::format("its pull {} of (18) lets the rope slip", pull),
                     fmt::format("the branches stand as {}, the grip holds {}", ratio.empty() ? "infinite" : ratio,
                                 shown("e", Rounding::nearest))});
  } else if (!keeps(reserve, in.grip_reserve)) {
    add_answer_line(lines, "Paper",
                    {fmt::format("its pull {} of (18) holds the rope", pull),
                     fmt::format("with a reserve of {:.4g}, not {:.4g}", reserve, in.grip_reserve)});
  }
}

}  // namespace

std::vector<Answer> answers(const Input& in, const Result& r, const Display& display) {
  Result lines;
  const auto shown = [&](const char* value, Rounding rounding = Rounding::nearest) {
    const Value* v = r.find_value(value);
    return v == nullptr ? std::string() : display.brief(v->value, v->unit, rounding);
  };
  const auto has = [&](const char* value) { return r.find_value(value) != nullptr; };
  add_answer_line(lines, needs_label, pull_words(in, r, shown));
  add_paper(in, r, shown, lines);
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
