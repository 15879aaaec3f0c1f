#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "taut/app/job.hpp"
#include "taut/io/file_reader.hpp"

// A motion in two parts, of which the second has another deck than the first.
namespace taut::app::restart_test {

using testing::HasSubstr;

/// A load on two ropes, one on a winch, a cylinder that lifts another load.
const std::string machine = R"(taut: 1
machine:
  points: {left: [-5 m, 0 m, 5 m], right: [5 m, 0 m, 5 m], floor: [40 m, 0 m, 0 m]}
  ropes:
    l: {mass: 0.5 kg/m, stiffness: 5 MN, breaking_force: 40 kN, damping_ratio: 0.05}
    r: {mass: 0.5 kg/m, stiffness: 5 MN, breaking_force: 40 kN, damping_ratio: 0.05}
    w: {mass: 0.5 kg/m, stiffness: 5 MN, breaking_force: 40 kN, damping_ratio: 0.05}
  bodies:
    b: {mass: 2 t, at: [0 m, 0 m, 0 m], free: [x, z]}
    c: {mass: 0.1 t, at: [20.2 m, 0 m, -10 m], free: [z]}
    p: {mass: 0.5 t, at: [40 m, 0 m, 2 m], free: [z]}
  drums: {d: {at: [20 m, 0 m, 5 m], core_diameter: 400 mm, inertia: 10 kg m^2, drive: DRIVE, brake_torque: 5 kN m}}
  signals:
    v: {ramp: {to: SPEED, start: 0.1 s, duration: 0.5 s}}
    u: {ramp: {to: 0.2 m/s, start: 0.1 s, duration: 0.5 s}}
  reevings:
    - {rope: l, path: [{anchor: left}, {anchor: b}], length: 7.07 m}
    - {rope: r, path: [{anchor: right}, {anchor: b}], length: 7.07 m}
    - {rope: w, path: [{drum: d, side: right}, {anchor: c}], length: 14.998 m}
  actuators:
    a: {from: floor, to: p, speed: u, lock_stiffness: 10 MN/m, lock_damping: 50 kN s/m}
  measures:
    rise: MEASURE
    late: {of: p.z, since: 2.5 s}
EVENTS  observe: [b.z, c.z, d.speed, a.speed, l.T_max, p.z]
analyses:
  - transient: {start: assembled, output_step: 20 ms, duration: )";

void replace(std::string& text, const std::string& what, const std::string& by) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what)) text.replace(at, what.size(), by);
}

struct Part {
  std::string duration, events, more = ", step: 1 ms}\n", speed = "0.3 m/s", drive = "{speed: v}",
                                measure = "{of: p.z, since: 0.5 s, relative: difference}";
};

Part a_part(const std::string& duration, const std::string& events, const std::string& more = Part{}.more) {
  Part one;
  one.duration = duration;
  one.events = events;
  one.more = more;
  return one;
}

class Restart : public testing::Test {
 protected:
  Result run(const Part& part) {
    std::string text = machine;
    replace(text, "EVENTS", part.events.empty() ? "" : "  events: [" + part.events + "]\n");
    replace(text, "SPEED", part.speed);
    replace(text, "DRIVE", part.drive);
    replace(text, "MEASURE", part.measure);
    Result r = app::run(Job{.text = text + part.duration + part.more,
                            .name = "deck",
                            .set = {},
                            .progress = {},
                            .read = [this](const std::string& file) -> tl::expected<std::string, io::Unreadable> {
                              return saved_.at(file);
                            }});
    for (const auto& one : r.attachments) saved_[one.name] = one.text;
    return r;
  }
  Result first(const std::string& events) { return run(a_part("2 s", events, ", step: 1 ms, save: s}\n")); }
  Result second(Part part) {
    part.more = ", restart: s" + part.more;
    return run(part);
  }
  std::map<std::string, std::string> saved_;
};

const std::string brakes = "{at: 1 s, brake: d}", breaks = "{at: 3 s, break: r}";

/// `share`: of each value, and of 1 m or 1 m/s.
void expect_equal(const Result& r, const Result& whole, double share = 1e-12) {
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  for (const std::string name : {"b.z_end", "c.z_end", "d.speed_end", "a.speed_end", "p.z_end", "rise_end"}) {
    const Value *is = r.find_value(name), *other = whole.find_value(name);
    ASSERT_TRUE(is != nullptr && other != nullptr) << name;
    EXPECT_NEAR(is->value, other->value, share * std::max(1.0, std::abs(other->value))) << name;
  }
}

// An event is known by its words and its time, wherever it stands: those that have happened do not happen again, and
// what they have done stays, whether the deck still has them or not; new ones are to come.
TEST_F(Restart, EventsOfTheSecondDeckHappen) {
  const std::string both = fmt::format("{}, {}", brakes, breaks);
  const Result whole = run(a_part("4 s", both));
  ASSERT_EQ(whole.status, Status::ok) << whole.message << to_text(whole.errors);
  EXPECT_GT(whole.find_value("l.T_max")->value, 25e3) << "where r breaks";
  ASSERT_EQ(first(brakes).status, Status::ok);
  for (const std::string& events : {both, fmt::format("{}, {}", breaks, brakes), breaks}) {
    SCOPED_TRACE(events);
    expect_equal(second(a_part("2 s", events)), whole);
  }
  const Result r = second(a_part("2 s", brakes + ", {at: 1.5 s, break: r}"));
  EXPECT_EQ(r.status, Status::infeasible);
  EXPECT_THAT(r.message, HasSubstr("'break r' at 1.5 s has not happened in it, and it is of 2 s"));
}

// A drum goes on by the drive that the deck gives now: here it begins to take in more from the restart on.
TEST_F(Restart, DrivesAreThoseOfTheSecondDeck) {
  ASSERT_EQ(first("").status, Status::ok);
  Part faster = a_part("2 s", "");
  faster.speed = "0.8 m/s";
  const Result r = second(faster);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(r.find_value("d.speed_end")->value, 0.8, 1e-9);
  EXPECT_GT(r.find_value("w.T_max")->value, 2000) << "it is jerked";
  Part weaker = a_part("2 s", "");
  weaker.drive = "{torque: 20 N m}";
  const Result falls = second(weaker);
  ASSERT_EQ(falls.status, Status::ok) << falls.message << to_text(falls.errors);
  EXPECT_LT(falls.find_value("d.speed_end")->value, -1) << "1 kN at 0.2 m are 200 N m";
}

// A drive that an event has given is that of the event, as the deck has it now. Without it nobody knows the drive.
TEST_F(Restart, DrivesOfEventsAreThoseOfTheSecondDeck) {
  const std::string drives = "{at: 1 s, drive: d, speed: 0.5 m/s}";
  const Result whole = run(a_part("4 s", drives));
  ASSERT_EQ(first(drives).status, Status::ok);
  Part another = a_part("2 s", drives);
  another.speed = "0.8 m/s";
  expect_equal(second(another), whole);
  const Result r = second(a_part("2 s", ""));
  EXPECT_EQ(r.status, Status::infeasible);
  EXPECT_THAT(r.message, HasSubstr("has given 'd' the drive that it has there: leave that event in the deck"));
}

// In three parts what has happened stays, also where the second one does not know of it.
TEST_F(Restart, WhatHasHappenedStaysInAThirdPart) {
  const std::string lifts = "{when: p.z > 2.1 m, brake: d}";
  const Result whole = run(a_part("4 s", lifts));
  ASSERT_EQ(first(lifts).status, Status::ok);
  Part between = a_part("1 s", "", ", step: 1 ms, save: s}\n");
  ASSERT_EQ(second(between).status, Status::ok);
  expect_equal(second(a_part("1 s", lifts)), whole);
  // a brake that the deck describes as set, and then no more, was set by the event all the same
  ASSERT_EQ(first(lifts).status, Status::ok);
  between.drive = "{speed: v, brake: set}";
  between.events = lifts;
  ASSERT_EQ(second(between).status, Status::ok);
  expect_equal(second(a_part("1 s", lifts)), whole);
}

// A drum that pulls turns as its rope goes: what drives it then has to know how fast.
TEST_F(Restart, APullingDrumGetsAnotherDriveByAnEvent) {
  const std::string pulls = "{at: 1 s, drive: d, pull: 1.1 kN}";
  ASSERT_EQ(first(pulls).status, Status::ok);
  Part other = a_part("1 s", pulls);
  other.drive = "{speed: v, brake: set}";
  EXPECT_THAT(second(other).message, HasSubstr("'d' pulls its rope in it: an event has to give it another drive"));
  other.events += ", {at: 2 s, brake: d}";
  other.drive = "{speed: v}";
  EXPECT_EQ(second(other).status, Status::ok);
}

// A measure of the same name that counts otherwise is another one.
TEST_F(Restart, AMeasureThatTheFirstPartDoesNotHaveCanNotLookBack) {
  ASSERT_EQ(first("").status, Status::ok);
  Part other = a_part("1 s", "");
  other.measure = "{of: p.z, since: 1.5 s, relative: difference}";
  EXPECT_THAT(second(other).message, HasSubstr("does not know the measure 'rise'"));
  other.measure = "{of: p.z, since: 2 s, relative: difference}";
  const Result r = second(other);
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  EXPECT_NEAR(r.find_value("rise_end")->value, 0.2, 1e-3);
}

// Measures go on, also where the integrator begins anew: with another kind of step, say.
TEST_F(Restart, MeasuresGoOn) {
  const Result whole = run(a_part("4 s", ""));
  ASSERT_EQ(first("").status, Status::ok);
  expect_equal(second(a_part("2 s", "")), whole);
  expect_equal(second(a_part("2 s", "", ", tolerance: 1e-6}\n")), whole, 1e-4);
}

// What is numbered alike is not the same part.
TEST_F(Restart, PartsAreKnownByTheirNames) {
  ASSERT_EQ(first("").status, Status::ok);
  std::string& state = saved_.at("s");
  replace(state, "\"actuators\": [\n   \"a\"", "\"actuators\": [\n   \"z\"");
  const Result r = second(a_part("1 s", ""));
  EXPECT_EQ(r.status, Status::infeasible);
  EXPECT_THAT(r.message, HasSubstr("its actuators are others"));
}

// A rope of the first part that hangs can't go on straight: its length is that of another shape.
TEST_F(Restart, RopesKeepTheirShape) {
  ASSERT_EQ(run(a_part("1 s", "", ", save: s, branches: catenary}\n")).status, Status::ok);
  EXPECT_EQ(second(a_part("1 s", "", ", branches: catenary}\n")).status, Status::ok);
  const Result straight = second(a_part("1 s", "", "}\n"));
  EXPECT_EQ(straight.status, Status::infeasible);
  EXPECT_THAT(straight.message, HasSubstr("hung as a catenary between"));
  ASSERT_EQ(run(a_part("1 s", "", ", save: s}\n")).status, Status::ok);
  EXPECT_THAT(second(a_part("1 s", "", ", branches: catenary}\n")).message, HasSubstr("was straight between"));
}

// p is above 2.15 m from 1 s on: what counts since 2.5 s only can't hold before.
TEST_F(Restart, AConditionCountsSinceItsTime) {
  const Result r = run(a_part("4 s", "{when: late > 2.15 m, break: r}"));
  ASSERT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
  const Table* events = r.find_table("events");
  ASSERT_NE(events, nullptr);
  double t = 0;
  for (const auto& row : events->rows) {
    if (std::get<std::string>(row[1]) == "break") t = std::get<double>(row[0]);
  }
  EXPECT_NEAR(t, 2.5, 2e-3);
}

}  // namespace taut::app::restart_test
