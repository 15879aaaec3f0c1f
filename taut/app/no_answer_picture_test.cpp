#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "taut/report/page_one.hpp"
#include "test/support/machine_decks.hpp"

/// Page 1 of a result without an answer shows the machine as its deck describes it.
namespace taut::no_answer_picture_test {

using taut_test::run_text;
using testing::HasSubstr;
using testing::Not;

std::string skyline(const std::string& rest) {
  return R"(taut: 1
machine:
  temperature: 15 degC
  points: {head: [0 m, 0 m, 18 m], tail: [250 m, 0 m, 120 m]}
  ropes: {skyline: {mass: 1.6 kg/m, stiffness: 26.6 MN}, mainline: {mass: 0.6 kg/m, stiffness: 12 MN}}
  carriages: {car: {mass: 220 kg, rides: skyline, mainline: mainline}}
  reevings:
    - {rope: skyline, path: [{anchor: head}, {through: car}, {anchor: tail}], length: 272 m}
    - {rope: mainline, path: [{anchor: car}, {anchor: head}], length: 150 m}
  loads: [{at: car, mass: 1000 kg}]
  terrain: {x: [-50 m, 60 m, 125 m, 200 m, 300 m], z: [8 m, 10 m, 35 m, 70 m, 112 m]}
)" + rest;
}

/// A load on a winch, and a body too heavy for its cylinder.
constexpr const char* motion = R"(taut: 1
machine:
  points: {lead: [0 m, 0 m, 20 m], stump: [3 m, 0 m, 1 m]}
  ropes: {hoist: {mass: 0 kg/m, stiffness: 10 MN, damping_ratio: 0.03}}
  bodies:
    load: {mass: 2 t, at: [0 m, 0 m, 2 m], free: [x, z]}
    loose: {mass: 9 kg, at: [0 m, 0 m, 2 m], free: [z]}
  actuators: {jack: {from: lead, to: loose, force: 1 N}}
  drums: {winch: {at: [0.2 m, 0 m, 20 m], core_diameter: 400 mm}}
  reevings: [{rope: hoist, path: [{drum: winch, side: left}, {anchor: load}], length: 18 m}]
analyses: [transient: {duration: 2 s, output_step: 10 ms}]
)";

const Drawing& picture_of(const Result& r) {
  static const Drawing none;
  EXPECT_NE(r.status, Status::ok) << to_text(r.errors);
  EXPECT_EQ(r.key_figure, "machine") << r.message;
  if (r.figures.empty() || !std::holds_alternative<Drawing>(r.figures.front())) {
    ADD_FAILURE() << "no drawing: " << r.message << to_text(r.errors);
    return none;
  }
  return std::get<Drawing>(r.figures.front());
}

template <class Kind, class Condition>
bool has(const Drawing& d, Condition&& holds) {
  return std::any_of(d.shapes.begin(), d.shapes.end(), [&](const Shape& one) {
    const auto* own = std::get_if<Kind>(&one);
    return own != nullptr && holds(*own);
  });
}

bool names(const Drawing& d, const std::string& text) {
  return has<Label>(d, [&](const Label& l) { return l.text == text; });
}

bool has_line(const Drawing& d, Role role, std::size_t points) {
  return has<Polyline>(d, [&](const Polyline& p) { return p.role == role && p.points.size() == points; });
}

/// Nothing of it can be taken for an answer.
void expect_described(const Drawing& d, const std::string& why) {
  EXPECT_EQ(d.title, "Machine as described; " + why);
  EXPECT_THAT(d.caption, HasSubstr("ropes are drawn straight, and no tension is known"));
  EXPECT_FALSE(has<Label>(d, [](const Label& l) { return l.force.has_value(); })) << "a tension";
  EXPECT_FALSE(has<ForceArrow>(d, [](const ForceArrow& f) { return f.role == Role::force; })) << "a force of a rope";
  EXPECT_FALSE(has<Polyline>(d, [](const Polyline& p) {
    return (p.role == Role::rope || p.role == Role::second_rope) && p.points.size() != 2;
  })) << "a rope that is not straight";
}

TEST(NoAnswerPicture, OfALoadPathAndOfAMachineAtRest) {
  for (const char* analysis : {"analyses: [load_path: {carriage: car, from: 8 m, to: 12 m, steps: 5}]\n",
                               "analyses: [equilibrium: {carriage: car, x: 8 m}]\n"}) {
    const Result r = run_text(skyline(analysis));
    const Drawing& d = picture_of(r);
    expect_described(d, "no equilibrium was found");
    for (const char* name : {"head", "tail", "car", "skyline", "mainline"}) EXPECT_TRUE(names(d, name)) << name;
    EXPECT_TRUE(has_line(d, Role::rope, 2));
    EXPECT_TRUE(has_line(d, Role::second_rope, 2));
    EXPECT_TRUE(has_line(d, Role::ground, 5)) << "the ground, cut where the drawing ends";
    EXPECT_TRUE(has<ForceArrow>(d, [](const ForceArrow& f) { return f.label == "W car" && f.fy < 0; }));
    const report::PageOne page = report::page_one(r);
    EXPECT_THAT(page.html, HasSubstr("<b>Machine as described; no equilibrium was found.</b> This is not an answer"));
    EXPECT_EQ(page.figures.size(), 1U);
  }
}

TEST(NoAnswerPicture, OfALineThatCantBePutUp) {
  const Result r = run_text(R"(taut: 1
machine:
  ropes: {guy: {mass: 1.6 kg/m, stiffness: 20 MN}}
  bodies: {tower: {mass: 2 t, centre: [0 m, 0 m, 8 m], free: [rx, ry, rz]}}
  points: {head: {body: tower, at: [0 m, 0 m, 16 m]}, left: [-20 m, 6 m, 0 m], spare: {body: tower, at: [0 m, 0 m, 9 m]}}
  guys: {g1: {rope: guy, from: head, to: left, install: {tension: 1 N}}}
)");
  const Drawing& d = picture_of(r);
  expect_described(d, "no equilibrium was found");
  for (const char* name : {"head", "left", "spare", "g1"}) EXPECT_TRUE(names(d, name)) << name;
}

TEST(NoAnswerPicture, OfAMotionWithoutAStart) {
  const Result r = run_text(motion);
  const Drawing& d = picture_of(r);
  expect_described(d, "no answer was found");
  for (const char* name : {"winch", "load", "loose", "lead", "stump"}) EXPECT_TRUE(names(d, name)) << name;
  const auto cylinder = [](const Polyline& p) {
    return p.role == Role::structure && p.points.front().y == 20 && p.points.back().y == 2;
  };
  EXPECT_TRUE(has<Polyline>(d, cylinder));
}

TEST(NoAnswerPicture, OfADesignThatNothingFulfils) {
  const Result r = run_text(R"(taut: 1
machine:
  points: {pin: [0 m, 0 m, 10 m]}
  ropes: {line: {}}
  bodies: {hook: {mass: 5000 t, at: [0 m, 0 m, 2 m], free: [x, z]}}
  reevings: [{rope: line, path: [{anchor: pin}, {anchor: hook}], length: 8 m}]
checks: {ropes: {line: {safety_factor: 3}}}
design: {seek: lightest, ropes: {line: {construction: 6x36, core: IWRC, grade: 1960 MPa, modulus: 100 GPa}}}
)");
  const Drawing& d = picture_of(r);
  expect_described(d, "no design was found");
  EXPECT_TRUE(names(d, "line"));
}

TEST(NoAnswerPicture, AnAnswerKeepsItsOwn) {
  const Result r = run_text(taut_test::skyline_deck("  - equilibrium: {motion: at_rest}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const auto& d = std::get<Drawing>(r.figures.front());
  EXPECT_EQ(d.title, "Side view");
  EXPECT_TRUE(has<Label>(d, [](const Label& l) { return l.text == "T skyline" && l.force > 0; }));
  EXPECT_THAT(report::page_one(r).html, Not(HasSubstr("as described")));
}

}  // namespace taut::no_answer_picture_test
