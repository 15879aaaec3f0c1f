#pragma once
#include <string>
#include <utility>
#include <vector>

#include "taut/machine/builder.hpp"

/// Machines as decks describe them, for the tests of their compilation.
namespace taut::machine::described {

using description::PathElement;

/// Parallel falls whose second block the compiler finds itself.
inline PathElement parts(int count, PathElement stop) {
  stop.parts = count;
  return stop;
}

inline description::Rope steel(const std::string& name) {
  description::Rope rope;
  rope.name = name;
  rope.mass = 2;
  rope.stiffness = 1e7;
  return rope;
}

/// A span with a support, a rolling carriage and its mainline from a drum.
inline Machine line() {
  Machine m;
  m.points = {{.name = "head", .body = {}, .at = {0, 0, 10}}, {.name = "tail", .body = {}, .at = {100, 0, 30}}};
  m.ropes = {steel("skyline"), steel("main")};
  description::Round jack;
  jack.name = "jack";
  jack.at = {60, 0, 22};
  jack.friction = 0.1;
  m.supports = {jack};
  description::Drum winch;
  winch.name = "winch";
  winch.at = {-5, 0, 0};
  winch.core_diameter = 0.4;
  m.drums = {winch};
  description::Carriage car;
  car.name = "car";
  car.mass = 200;
  car.rides = "skyline";
  car.mainline = "main";
  m.carriages = {car};
  description::Reeving sky;
  sky.rope = "skyline";
  sky.path = {anchor("head"), through("car"), over("jack"), anchor("tail")};
  sky.length = 103;
  description::Reeving main;
  main.rope = "main";
  main.path = {on_drum("winch"), anchor("car")};
  main.tension_at_start = 5e3;
  m.reevings = {sky, main};
  return m;
}

/// A tackle between a fixed head and a hook.
inline Machine tackle(int parts, std::vector<PathElement> path) {
  Machine m;
  m.ropes = {steel("hoist")};
  m.points = {{.name = "lead", .body = {}, .at = {-3, 0, 0}},
              {.name = "pin", .body = {}, .at = {0.2, 0, 10}},
              {.name = "eye", .body = {"hook"}, .at = {0, 0, 0.3}}};
  description::Body hook;
  hook.name = "hook";
  hook.at = {0, 0, 4};
  hook.free = {"z"};
  m.bodies = {hook};
  for (const char* name : {"head", "block", "third"}) {
    description::Round sheave;
    sheave.name = name;
    sheave.diameter = 0.4;
    sheave.at = {0, 0, 10};
    m.sheaves.push_back(sheave);
  }
  m.sheaves[1].body = "hook";
  m.sheaves[1].at = {0, 0, 0};
  description::Reeving r;
  r.rope = "hoist";
  r.path = std::move(path);
  r.tension_at_start = 100.0 * parts;
  m.reevings = {r};
  return m;
}

}  // namespace taut::machine::described
