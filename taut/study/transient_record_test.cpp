#include "taut/study/transient_record.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "taut/base/long_rows.hpp"
#include "test/support/machine_decks.hpp"

/// What is kept of a long motion.
namespace transient_record_test {

namespace solve = taut::solve;

using namespace taut_test;
using taut::Animation;
using taut::Result;
using taut::Status;
using taut::study::TransientRecord;

constexpr double peak_at = 6412.4;

/// A motion of one rope over one sheave, an output each second.
struct Fake {
  solve::TransientResult result;
  TransientRecord record;

  Fake() {
    result.observed.resize(1);
    result.ropes.resize(1);
  }

  void step(int i) {
    solve::TransientFrame frame;
    frame.t = i;
    frame.branches.resize(2);
    frame.contacts.resize(1);
    frame.contacts[0].node = 1;
    frame.energy.kinetic = 10.0 * i;
    result.frames.push_back(frame);
    result.observed[0].push_back(100.0 + i);
    const bool past = i >= peak_at;
    result.ropes[0].T.max = past ? 9e3 : 1e3;
    result.ropes[0].T.t_max = past ? peak_at : 0;
    record.take(result);
    if (result.frames.size() <= 2) return;
    result.frames.erase(result.frames.begin() + 1);
    result.observed[0].erase(result.observed[0].begin() + 1);
  }
};

TEST(TransientRecord, KeepsEveryLineAndABoundedNumberOfFrames) {
  Fake of;
  constexpr int last = 10'006;
  for (int i = 0; i <= last; ++i) of.step(i);
  EXPECT_EQ(of.record.count(), last + 1U);
  const auto t = of.record.lines()->column(0), observed = of.record.lines()->column(1);
  const auto kinetic = of.record.energy().column(0);
  ASSERT_EQ(t.size(), last + 1U);
  bool all = true;
  for (int i = 0; i <= last; ++i) {
    const auto k = static_cast<std::size_t>(i);
    all = all && t[k] == i && observed[k] == 100.0 + i && kinetic[k] == 10.0 * i;
  }
  EXPECT_TRUE(all);
  of.record.show(of.result);
  const auto& frames = of.result.frames;
  EXPECT_LE(frames.size(), 2003U);
  EXPECT_GT(frames.size(), 1000U);
  EXPECT_EQ(frames.front().t, 0);
  EXPECT_EQ(frames.back().t, last);
  bool peak = false;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    EXPECT_GT(frames[i].t, frames[i - 1].t);
    peak = peak || frames[i].t == std::round(peak_at);
    EXPECT_EQ(of.result.observed[0][i], 100 + frames[i].t);
  }
  EXPECT_TRUE(peak) << "the output next to the largest tension";
}

TEST(TransientRecord, ShowsAllOfAShortMotion) {
  Fake of;
  for (int i = 0; i <= 2000; ++i) of.step(i);
  of.record.show(of.result);
  EXPECT_EQ(of.result.frames.size(), 2001U);
}

std::string pendulum(const std::string& analysis) {
  return R"(taut: 1
machine:
  points: {top: [0 m, 0 m, 0 m]}
  ropes: {line: {mass: 0 kg/m, stiffness: 2 MN, damping_ratio: 0.02}}
  bodies: {bob: {mass: 500 kg, at: [3 m, 0 m, -4 m], free: [x, z]}}
  reevings: [{rope: line, path: [{anchor: top}, {anchor: bob}], length: 5 m}]
analyses:
  - transient: {start: assembled, )" +
         analysis + "}\n";
}

TEST(TransientRecord, ALongMotionHasAllItsLinesAndAPlayableNumberOfFrames) {
  const Result r = run_text(pendulum("duration: 12 s, output_step: 2 ms, tolerance: 1e-3"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  ASSERT_TRUE(r.series.at(0).long_rows);
  EXPECT_EQ(r.series[0].long_rows->size(), 6001U);
  EXPECT_EQ(r.series[0].long_rows->width(), r.series[0].columns.size());
  for (const auto& figure : r.figures) {
    const auto* moving = std::get_if<Animation>(&figure);
    EXPECT_LE(moving == nullptr ? 0 : moving->t.size(), 2003U);
  }
  EXPECT_LE(r.scenes.at(0).t.size(), 2003U);
  // a plot has the peaks of all lines
  const auto T = r.series[0].long_rows->column(3);
  double largest = 0, plotted = 0;
  for (const double x : T) largest = std::max(largest, x);
  for (const auto& figure : r.figures) {
    const auto* plot = std::get_if<taut::Plot>(&figure);
    if (plot == nullptr) continue;
    for (const auto& curve : plot->curves) {
      if (curve.label != r.series[0].columns[3].name) continue;
      for (const double y : curve.y) plotted = std::max(plotted, y);
    }
  }
  EXPECT_EQ(plotted, largest);
}

TEST(TransientRecord, TooManyNumbersAreRefusedBeforehand) {
  expect_mistake(run_text(pendulum("duration: 3000 s, output_step: 1 ms")), "makes 3e+06 lines; up to 1000000 are");
  // many ropes, each with its own quantity
  std::string many = pendulum("duration: 900 s, output_step: 1 ms");
  std::string ropes, observed = "bob.x";
  for (int i = 0; i < 120; ++i) {
    ropes += fmt::format(", {{name: r{}, rope: line, path: [{{anchor: top}}, {{anchor: bob}}], length: 6 m}}", i);
    observed += fmt::format(", r{}.T_max", i);
  }
  const std::string end = "length: 5 m}";
  many.replace(many.find(end) + end.size(), 0, ropes);
  many.replace(many.find("analyses:"), 0, "  observe: [" + observed + "]\n");
  expect_mistake(run_text(many), "makes 900001 lines of 122 columns, 1.1e+08 numbers");
}

TEST(TransientRecord, EnergyOpenBeyondTheToleranceIsUnsafe) {
  const Result open = run_text(pendulum("duration: 2 s, step: 5 ms, tolerance: 1e-9"));
  ASSERT_EQ(open.status, Status::ok) << open.message << to_text(open.errors);
  ASSERT_FALSE(open.unsafe.empty());
  EXPECT_NE(open.unsafe.front().find("the energy ledger is open by "), std::string::npos) << open.unsafe.front();
  EXPECT_LE(open.unsafe.front().size(), 160U);
  const Result closed = run_text(pendulum("duration: 2 s, tolerance: 1e-5"));
  EXPECT_TRUE(closed.unsafe.empty()) << closed.unsafe.front();
  const Result coarse = run_text(pendulum("duration: 2 s, step: 5 ms, method: verlet, tolerance: 1e-5"));
  ASSERT_EQ(coarse.unsafe.size(), 1U) << "its energy is closed, its tensions are not right";
  EXPECT_NE(coarse.unsafe.front().find(" in the tensions"), std::string::npos) << coarse.unsafe.front();
  const Result own = run_text(pendulum("duration: 2 s, method: verlet, tolerance: 1e-4"));
  ASSERT_EQ(own.status, Status::ok) << own.message << to_text(own.errors);
  EXPECT_TRUE(own.unsafe.empty()) << own.unsafe.front();
}

/// A mass between two stiff ropes shakes without end: steps beyond a number are no more within the tolerance of all.
TEST(TransientRecord, StepsThatErrByMoreThanTheToleranceAreTold) {
  const std::string deck = R"(taut: 1
machine:
  points: {a: [-1 m, 0 m, 0 m], b: [1 m, 0 m, 0 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 1 MN}}
  bodies: {bob: {mass: 2 kg, at: [2 mm, 0 m, 0 m], guide: [1, 0, 0]}}
  reevings:
    - {name: left, rope: r, path: [{anchor: a}, {anchor: bob}], length: 0.99 m}
    - {name: right, rope: r, path: [{anchor: bob}, {anchor: b}], length: 0.99 m}
analyses: [{transient: {duration: DURATION, start: assembled, tolerance: 1e-6}}]
)";
  const auto lasting = [&](const std::string& duration) {
    std::string text = deck;
    text.replace(text.find("DURATION"), 8, duration);
    return run_text(text);
  };
  const auto told = [](const std::vector<std::string>& all) {
    return std::any_of(all.begin(), all.end(),
                       [](const std::string& one) { return one.find("errors of its steps add up to") < one.size(); });
  };
  const Result within = lasting("0.1 s"), beyond = lasting("0.5 s"), far = lasting("0.75 s");
  EXPECT_FALSE(told(within.warnings) || told(within.unsafe));
  EXPECT_TRUE(told(beyond.warnings) || told(beyond.unsafe)) << to_text(beyond.errors) << beyond.message;
  for (const std::string& one : far.warnings) EXPECT_LE(one.size(), 160U) << one;
}

/// A formula has to have a value and a rate all over the motion; a steady speed is not read from one.
TEST(TransientRecord, AFormulaWithoutAValueIsRefused) {
  const auto hoist = [](const std::string& formula, const std::string& analyses) {
    return run_text(fmt::format(R"(taut: 1
machine:
  signals: {{v: {{formula: "{}"}}}}
  ropes: {{r: {{mass: 0.4 kg/m, stiffness: 1 MN}}}}
  bodies: {{hook: {{mass: 200 kg, at: [0 m, 0 m, 0 m], guide: [0, 0, 1]}}}}
  drums: {{winch: {{at: [0 m, 0 m, 10 m], drive: {{speed: v}}, core_diameter: 100 mm}}}}
  reevings: [{{rope: r, path: [{{drum: winch}}, {{anchor: hook}}], length: 10 m}}]
analyses: [{}]
)",
                                formula, analyses));
  };
  const std::string motion = "transient: {duration: 2 s, tolerance: 1e-3}";
  const auto mistake = [&](const std::string& formula) { return to_text(hoist(formula, "{" + motion + "}").errors); };
  EXPECT_EQ(mistake("0.2 m/s * sin(pi * t / 2 s)"), "");
  EXPECT_NE(mistake("0.2 m/s * sqrt(1 - t / 1 s)").find("has no finite rate at t = 1 s"), std::string::npos);
  EXPECT_NE(mistake("0.2 m/s * sqrt(t / 1 s)").find("has no finite rate at t = 0 s"), std::string::npos);
  EXPECT_NE(mistake("0.2 m/s * x").find("there is no 'x' here"), std::string::npos);
  EXPECT_EQ(mistake("0.2 m/s * x").find("here a speed is wanted"), std::string::npos) << "told once";
}

}  // namespace transient_record_test
