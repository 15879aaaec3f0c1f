#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "test/support/machines.hpp"

/// The three-section boom of Reutov (2021) as a machine built by code, with the data of an independent model of it.
namespace taut_test {

/// Boom frame: x along the boom, z up at angle 0, origin at the foot. SI.
struct Boom {
  double angle = 52 * std::numbers::pi / 180;
  double travel = 0;  ///< of section 2 in 1 and of 3 in 2 where the motion begins
  double lag = 0;     ///< section 3 stays behind there: X of the ropes
  double load = 3000, hook = 300;
  int falls = 6;
  double eta = 0.98, zeta = 0.95, f0 = 0.155, f_inf = 0.15;
  double S10 = 95.5e3, S20 = 187e3;
  double C1 = 0.778e6, C2 = 1.61e6, half_length = 16.5, return_length = 8.2;
  double G2 = 12e3, G3 = 8.44e3;
  bool ropes = true;
  double speed = 0.2;  ///< of the cylinder, m/s, from `start` on
  double start = 1;    ///< s; it is locked before
  bool retracts = false;
  bool moves = true;
  double winding = 0;  ///< of the hook while it lifts the load from the ground, m/s; 0: the load hangs
  double gravity = 9.81;
};

namespace boom_bodies {
inline constexpr int s1 = 0, s2 = 1, s3 = 2, hook = 3, load = 4;
}

inline machine::Signal boom_ramp(double to, double start, const taut::Unit& unit) {
  machine::Signal s;
  s.unit = unit;
  s.law = taut::machine::Moves{
      .from = 0, .moves = {{.at = start, .to = to, .over = 0.5, .change = taut::machine::Change::linear}}};
  return s;
}

inline void add_boom_bodies(const Boom& b, machine::Model& m) {
  using Eigen::AngleAxisd;
  const taut::Matrix3 R = AngleAxisd(-b.angle, Vector3::UnitY()).toRotationMatrix();
  const auto section = [&](const char* name, double at, double weight, double inertia, double centre) {
    machine::Body s = body(name, R * Vector3(at, 0, 0), weight / b.gravity, "xzY");
    s.orientation = R;
    s.inertia = Vector3::Constant(inertia);
    s.centre = {centre, 0, 0};
    m.bodies.push_back(s);
  };
  machine::Body s1 = body("s1", origin, 0, "");
  s1.orientation = R;
  m.bodies.push_back(s1);
  section("s2", 0.4 + b.travel, b.G2, 7000, 3.6);
  section("s3", 1.35 + 2 * b.travel - b.lag, b.G3, 4800, 3.4);
  const Vector3 head = R * Vector3(9 + 2 * b.travel - b.lag, 0, 0);
  if (b.hook > 0) m.bodies.push_back(body("hook", head - Vector3(0, 0, 4), b.hook, "xz"));
  if (b.hook > 0 && b.load > 0) m.bodies.push_back(body("load", head - Vector3(0, 0, 7), b.load, "xz"));
}

inline void add_boom_pads(const Boom& b, machine::Model& m) {
  using namespace boom_bodies;
  const auto face = [&](int on, double z, double normal) {
    machine::Face f;
    f.body = on;
    f.from = {-1, 0, z};
    f.to = {10, 0, z};
    f.normal = {0, 0, normal};
    m.faces.push_back(f);
    return static_cast<int>(m.faces.size()) - 1;
  };
  const auto pad = [&](const char* name, int of, double x, double z, int on) {
    machine::FaceContact c;
    c.name = name;
    c.body = of;
    c.at = {x, 0, z};
    c.face = on;
    c.stiffness = 1e8;
    c.damping = 1e5;
    c.tangential_stiffness = 5e7;
    c.tangential_damping = 5e4;
    c.clearance = z > 0 ? 2e-3 : 0;
    c.static_friction = b.f0;
    c.kinetic_friction = b.f_inf;
    m.contacts.push_back(c);
  };
  pad("front2_low", s1, 8.6, -0.3, face(s2, -0.3, -1));
  pad("front2_high", s1, 8.6, 0.3, face(s2, 0.3, 1));
  pad("rear2_low", s2, 0, -0.3, face(s1, -0.3, 1));
  pad("rear2_high", s2, 0, 0.3, face(s1, 0.3, -1));
  pad("front3_low", s2, 8.3, -0.25, face(s3, -0.25, -1));
  pad("front3_high", s2, 8.3, 0.25, face(s3, 0.25, 1));
  pad("rear3_low", s3, 0, -0.25, face(s2, -0.25, 1));
  pad("rear3_high", s3, 0, 0.25, face(s2, 0.25, -1));
  machine::Face stop;
  stop.body = s2;
  stop.from = {0.8, 0, -0.3};
  stop.to = {0.8, 0, 0.3};
  stop.normal = {1, 0, 0};
  m.faces.push_back(stop);
  pad("end_stop", s3, 0, 0, static_cast<int>(m.faces.size()) - 1);
  m.contacts.back().stiffness = 2e7;
  m.contacts.back().damping = 5e4;
  m.contacts.back().static_friction = m.contacts.back().kinetic_friction = 0;
}

/// A rope given by its unstretched length, so that it has the tension S at the length l and the stiffness C there.
inline machine::Reeving boom_rope(const char* name, std::vector<machine::Node> path, double C, double l, double S,
                                  double damping) {
  const double EA = C * l - S;
  machine::Reeving r = reeve(name, std::move(path), l / (1 + S / EA), 0, EA);
  r.damping_time = damping / C;
  return r;
}

inline void add_boom_ropes(const Boom& b, machine::Model& m) {
  using namespace boom_bodies;
  if (b.ropes) {
    const double rear = 9 - (b.half_length - 7.65), front = 0.25 + b.return_length;
    m.reevings.push_back(boom_rope(
        "extension",
        {anchor_on("rear", s1, {rear, 0, 0}), sheave("head_2", {8.6, 0, 0}, 0, 1, b.eta, s2), anchor_on("tail", s3)},
        b.C1, b.half_length, b.S10, 14e3));
    m.reevings.back().copies = 2;
    m.reevings.push_back(boom_rope("retraction",
                                   {anchor_on("front", s1, {front, 0, 0}), sheave("tail_2", origin, 0, 1, b.eta, s2),
                                    anchor_on("back", s3, {-0.8, 0, 0})},
                                   b.C2, b.return_length, b.S20, 29e3));
  }
  if (b.hook <= 0) return;
  const double weight = (b.hook + (b.winding > 0 ? 0 : b.load)) * b.gravity;
  std::vector<machine::Node> path = {anchor_on("winch", s1, {0, 0, 0.25}),
                                     sheave("lead", {7.65, 0, 0.25}, 0, 1, b.zeta, s3), over("head", {7.65, 0, 0}, s3)};
  for (int k = 1; k < b.falls; ++k) {
    path.push_back(k % 2 == 1 ? over("block", origin, hook) : over("head", {7.65, 0, 0}, s3));
  }
  path.push_back(b.falls % 2 == 0 ? anchor_on("pin", s3, {7.65, 0, 0}) : anchor_on("pin", hook));
  const double C = b.falls * 9e6 / 4, lead = 9 + 2 * b.travel - b.lag, l = lead + 0.25 + 4 * b.falls;
  machine::Reeving hoist = reeve("hoist", std::move(path), weight / b.falls, 0, C * l / b.falls / b.falls);
  hoist.given = machine::Given::tension_at_start;
  hoist.damping_time = 20e3 / C;
  m.reevings.push_back(hoist);
  if (b.load <= 0) return;
  machine::Reeving sling = reeve("sling", {anchor_on("hook", hook), anchor_on("load", load)}, 3, 0, 8e6 * 3);
  sling.damping_time = 20e3 / 8e6;
  if (b.winding <= 0) {
    sling.given = machine::Given::tension_at_start;
    sling.value = b.load * b.gravity;
  }
  m.reevings.push_back(sling);
}

/// The winch takes in rope by its unstretched length; the load lies on the ground at first.
inline void add_boom_winding(const Boom& b, machine::Model& m) {
  if (b.winding <= 0) return;
  const double v = -b.winding * b.falls;
  machine::Tensioner winch;
  winch.reeving = static_cast<int>(m.reevings.size()) - 2;
  winch.change.unit = taut::si::m;
  const double until = b.start + 60;
  winch.change.law = taut::machine::Curve{
      .t = {b.start, b.start + 0.5, until}, .value = {0, v * 0.25, v * (0.25 + 59.5)}, .slopes = {0, v, v}};
  m.tensioners.push_back(winch);
  machine::Face ground;
  const Vector3 load = m.bodies[boom_bodies::load].position;
  ground.from = load - Vector3(20, 0, 0);
  ground.to = load + Vector3(20, 0, 0);
  m.faces.push_back(ground);
  machine::FaceContact support;
  support.name = "support";
  support.body = boom_bodies::load;
  support.face = static_cast<int>(m.faces.size()) - 1;
  support.stiffness = support.tangential_stiffness = 1e8;
  support.damping = support.tangential_damping = 1e5;
  m.contacts.push_back(support);
}

inline void add_boom_drives(const Boom& b, machine::Model& m) {
  using namespace boom_bodies;
  machine::Actuator cylinder;
  cylinder.name = "cylinder";
  cylinder.from_body = s1;
  cylinder.from = {-1, 0, -0.25};
  cylinder.to_body = s2;
  cylinder.to = {1, 0, -0.25};
  cylinder.kind = taut::machine::ActuatorKind::law;
  cylinder.F0 = 100e3;
  cylinder.gain = 2e6;
  cylinder.signal = boom_ramp(b.speed, b.start, taut::si::m_per_s);
  cylinder.mode = taut::machine::ActuatorMode::lock;
  cylinder.lock_stiffness = 30e6;
  cylinder.lock_damping = 0.2e6;
  m.actuators.push_back(cylinder);
  if (b.moves) {
    machine::Event go;
    go.words = "go";
    go.kind = taut::machine::EventKind::actuator;
    go.at = b.start;
    go.index = 0;
    go.mode = b.retracts ? taut::machine::ActuatorMode::retract : taut::machine::ActuatorMode::extend;
    m.events.push_back(go);
  }
}

inline machine::Model boom_machine(const Boom& b) {
  machine::Model m;
  m.gravity = b.gravity;
  add_boom_bodies(b, m);
  add_boom_pads(b, m);
  add_boom_ropes(b, m);
  add_boom_winding(b, m);
  add_boom_drives(b, m);
  return m;
}

/// Tensions at section 3's end (of one branch), the cylinder's force, the boom's length.
struct BoomState {
  double S1 = 0, S2 = 0, Fh = 0, Lb = 0;
};
template <class Frame>
BoomState boom_state(const Boom& b, const Frame& f) {
  BoomState s;
  if (b.ropes) {
    s.S1 = f.branches[1].T_to;
    s.S2 = f.branches[3].T_to;
  }
  s.Fh = f.actuators[0].F;
  s.Lb = (f.bodies[boom_bodies::s3].position + f.bodies[boom_bodies::s3].orientation * Vector3(7.65, 0, 0)).norm();
  return s;
}

}  // namespace taut_test
