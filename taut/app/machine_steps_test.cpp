#include "taut/app/machine_steps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

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
