#pragma once
#include "taut/math/degree.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"

namespace taut::boom_ropes {

/// The boom of the paper's example, without its cases: figures as printed.
inline Input printed_boom() {
  Input in;
  in.section_weight = 8.44e3;
  in.pad_friction = 0.15;
  in.tackle_efficiency = 0.95;
  in.extension_stiffness = 2.72e6;
  in.retraction_stiffness = 1.61e6;
  return in;
}

/// The paper's cases.
inline Case lifting(const char* name, double weight) {
  return {
      .name = name, .operation = Operation::lift, .luffing_angle = 77 * degree, .suspended_weight = weight, .falls = 8};
}
inline Case retracting(const char* name, double weight) {
  return {.name = name,
          .operation = Operation::retract,
          .luffing_angle = 5 * degree,
          .suspended_weight = weight,
          .falls = 6};
}

/// The two that govern its ropes.
inline Input governing_boom() {
  Input in = printed_boom();
  in.cases = {lifting("static test", 296.8e3), retracting("retract hook", 2.94e3)};
  return in;
}

/// All four.
inline Input whole_boom() {
  Input in = printed_boom();
  in.cases = {lifting("rated lift", 248.2e3), lifting("static test", 296.8e3), retracting("retract 3 t", 32.4e3),
              retracting("retract hook", 2.94e3)};
  return in;
}

/// A position of its sections: angle in degrees, length in m, weight in N.
inline Sliding sliding_at(Operation operation, double angle, double length, double weight) {
  Sliding q;
  q.operation = operation;
  q.luffing_angle = {angle * degree};
  q.boom_length = {length};
  q.suspended_weight = {weight};
  return q;
}

}  // namespace taut::boom_ropes
