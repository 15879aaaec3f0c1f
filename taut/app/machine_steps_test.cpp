#include "taut/app/machine_steps.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "taut/calc/formula.hpp"
#include "taut/units/expression.hpp"
#include "test/support/machine_decks.hpp"

/// The written steps of a machine's result: each has to give what the engine found.
namespace taut::app::machine_steps_test {

using namespace taut_test;

/// The first equation of this symbol, or of any where it is empty, below the heading that begins with `heading`.
const Step* step_of(const Result& r, const std::string& heading, const std::string& symbol = "") {
  bool below = false;
  for (const Step& s : r.steps) {
    if (s.kind == Step::Kind::heading) {
      below = s.words.starts_with(heading);
    } else if (below && s.kind == Step::Kind::equation && (symbol.empty() || s.symbol == symbol)) {
      return &s;
    }
  }
  return nullptr;
}

double written(const Result& r, const std::string& symbol) {
  const Step* s = step_of(r, "The span with the largest tension", symbol);
  EXPECT_NE(s, nullptr) << symbol;
  return s == nullptr ? std::nan("") : s->value;
}

constexpr const char* losses = "Losses where a rope runs over something";

/// A rope of 5 N/m from a winch over a sheave with losses to a load of 10 kN.
std::string hoist(const std::string& law, const std::string& motion) {
  return "taut: 1\nmachine:\n  bodies: {load: {mass: 1000 kg, at: [0 m, 0 m, 0 m], free: [z]}}\n"
         "  sheaves: {head: {at: [0 m, 0 m, 20 m], diameter: 400 mm, " +
         law +
         "}}\n  points: {winch: [-30 m, 0 m, 0 m]}\n  ropes: {r: {mass: 0.5 kg/m, stiffness: 20 MN, "
         "breaking_force: 100 kN}}\n  reevings: [{rope: r, path: [{anchor: winch}, {over: head}, {anchor: load}], "
         "length: 50 m}]\nanalyses: [equilibrium: {motion: " +
         motion + "}]\n";
}

TEST(MachineSteps, TheSpanWithTheLargestTensionClosesByItsWrittenFormulas) {
  const Result r = run_text(hoist("efficiency: 0.95", "hoist"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const double T = std::max(written(r, "T_0"), written(r, "T_1"));
  EXPECT_NEAR(T, value_of(r, "T_max"), 1e-9 * T);
  EXPECT_NEAR(written(r, "S"), 100e3 / T, 1e-9);
  const Table& spans = table_of(r, "spans");
  ASSERT_GT(cell(spans, 0, "T_to"), cell(spans, 1, "T_from"));
  EXPECT_NEAR(std::hypot(written(r, "x"), written(r, "z")), cell(spans, 0, "chord"), 1e-7);
}

/// The heading that begins so, else an empty text.
std::string heading_of(const Result& r, const std::string& begin) {
  for (const Step& s : r.steps) {
    if (s.kind == Step::Kind::heading && s.words.starts_with(begin)) return s.words;
  }
  return {};
}

// 2 t at the end of the sweep: twice the tension of the equilibrium.
TEST(MachineSteps, TheHardestStateOfASweepIsTheOneShown) {
  std::string deck = hoist("efficiency: 0.95", "hoist");
  deck.replace(deck.rfind("]"), 1,
               ", sweep: {parameter: bodies.load.mass, from: 1 t, to: 2 t, steps: 2, motion: hoist}]");
  const Result r = run_text(deck);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NE(heading_of(r, "The span with the largest").find("(sweep, bodies.load.mass = 2000 kg, hoist)"),
            std::string::npos);
  EXPECT_NEAR(written(r, "S"), value_of(r, "r.safety_factor"), 1e-6);
  EXPECT_EQ(r.find_value("r.safety_factor")->label, "breaking force over the largest static tension of r");
}

// At rest the sheave may hold either side up: the checks take 1/0.95 of the span's tension, so its S is not theirs.
TEST(MachineSteps, ASpanWithoutTheFrictionOfTheChecksDoesNotPassForTheLargest) {
  const Result r = run_text(hoist("efficiency: 0.95", "at_rest"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_EQ(heading_of(r, "The span with the largest"), "");
  const Step* S = step_of(r, "The span shown, not the largest tension", "S");
  ASSERT_NE(S, nullptr);
  EXPECT_GT(S->value, 1.02 * value_of(r, "r.safety_factor"));
  EXPECT_TRUE(S->source.starts_with("breaking force over the tension shown; the largest one of r is 10.3"))
      << S->source;
  const auto note = std::find_if(r.steps.begin(), r.steps.end(), [](const Step& s) {
    return s.kind == Step::Kind::note && s.words.find("with friction of either sense") != std::string::npos;
  });
  ASSERT_NE(note, r.steps.end());
  EXPECT_TRUE(note->words.starts_with("The largest tension (r, at rest) is 10.3")) << note->words;
}

std::string skyline(const std::string& analyses) {
  return R"(taut: 1
machine:
  points: {a: [0 m, 0 m, 30 m], b: [200 m, 0 m, 90 m]}
  ropes: {sky: {mass: 1.6 kg/m, stiffness: 20 MN, breaking_force: 250 kN}}
  carriages: {car: {mass: 300 kg, rides: sky, hold: clamped, at: [100 m, 0 m, 50 m]}}
  reevings: [{rope: sky, path: [{anchor: a}, {through: car}, {anchor: b}], length: 210 m}]
  loads: [{at: car, mass: 2 t}]
analyses:
)" + analyses;
}

// The tension is largest in the middle of the span.
TEST(MachineSteps, OfTwoLoadPathsTheOneShownIsNamed) {
  const Result r =
      run_text(skyline("  - load_path: {carriage: car, from: 20 m, to: 40 m, steps: 1}\n"
                       "  - load_path: {name: middle, carriage: car, from: 80 m, to: 100 m, steps: 1}\n"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NE(heading_of(r, "The span with the largest").find("(middle, at rest, x = 100 m)"), std::string::npos)
      << heading_of(r, "The span");
}

/// What a person gets from the numbers that are printed.
double by_hand(std::string numbers) {
  const NameMeaning nothing = [](std::string_view) -> tl::expected<Measure, std::string> {
    return tl::unexpected(std::string("no name"));
  };
  for (std::size_t at = numbers.find("atanh("); at != std::string::npos; at = numbers.find("atanh(")) {
    const std::size_t from = at + 5;
    std::size_t to = from;
    for (int open = 0; to < numbers.size(); ++to) {
      open += numbers[to] == '(' ? 1 : numbers[to] == ')' ? -1 : 0;
      if (open == 0) break;
    }
    const auto inside = evaluate(numbers.substr(from, to + 1 - from), nothing);
    if (!inside) return std::nan("");
    numbers.replace(at, to + 1 - at, fmt::format("{:.17g}", std::atanh(inside->value)));
  }
  const auto all = evaluate(numbers, nothing);
  return all ? all->value : std::nan("");
}

// A taut rope: T_1 - T_0 is a hundredth of T_0, so that of its six digits four are left over.
TEST(MachineSteps, ThePrintedNumbersOfACatenaryGiveItsResult) {
  const Result r = run_text(skyline("  - equilibrium: {carriage: car, x: 100 m}\n"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  for (const char* symbol : {"x", "z"}) {
    const Step* s = step_of(r, "The span with the largest tension", symbol);
    ASSERT_NE(s, nullptr);
    const std::string numbers = numbers_text(s->formula);
    EXPECT_NEAR(by_hand(numbers), s->value, 2e-5 * std::abs(s->value)) << symbol << " = " << numbers;
  }
}

TEST(MachineSteps, TheLawThatLimitsAContactIsTheOneWritten) {
  // mu theta = 0.02 * 2.5 rad gives way before the bearing's ln(1/0.8)
  for (const auto& [law, words] : {std::pair("efficiency: 0.95", "head: efficiency of the sheave"),
                                   std::pair("efficiency: 0.8, friction: 0.02", "head: Euler-Eytelwein")}) {
    const Result r = run_text(hoist(law, "hoist"));
    const Step* s = step_of(r, losses);
    ASSERT_NE(s, nullptr) << law;
    EXPECT_EQ(s->source, words);
    EXPECT_EQ(s->symbol, "T_in") << "the winch hauls against the rope's path";
    EXPECT_NEAR(s->value, cell(table_of(r, "sheaves"), 0, "T_in"), 1e-6 * s->value);
  }
}

TEST(MachineSteps, AContactThatIsNotAtItsLimitIsNotWritten) {
  const Result r = run_text(hoist("efficiency: 0.95", "at_rest"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_EQ(step_of(r, losses), nullptr);
}

}  // namespace taut::app::machine_steps_test
