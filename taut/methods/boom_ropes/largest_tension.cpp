#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "taut/calc/answers.hpp"
#include "taut/calc/result.hpp"
#include "taut/methods/boom_ropes/boom_ropes.hpp"
#include "taut/methods/boom_ropes/sliding.hpp"
#include "taut/units/display.hpp"

namespace taut::boom_ropes {
namespace {

void raise_to(LargestTension& most, double tension, std::string where) {
  if (std::isnan(tension) || tension <= most.tension) return;
  most = {.tension = tension, .where = std::move(where)};
}

/// Efficiency of the sheave behind which the rope is tighter than at section 3; 1 where it is not.
double tight_side(const Sliding& q, Rope rope) {
  const bool extends = q.operation == Operation::extend;
  if (extends != (rope == Rope::extension)) return 1;
  return rope == Rope::extension ? q.sheave_efficiency_1 : q.sheave_efficiency_2;
}

void raise_to_pretension(const std::optional<double>& given, double settled, LargestTension& most) {
  raise_to(most, settled, "pretension");
  if (given) raise_to(most, *given, "pretension as set");
}

void raise_to_cases(const Table& cases, const char* column, LargestTension& most) {
  for (std::size_t k = 0; k < cases.rows.size(); ++k) {
    const std::string name = text_in(cases, k, "name");
    const std::string where = fmt::format("case {}", name.empty() ? std::to_string(k + 1) : name);
    raise_to(most, number_in(cases, k, column), where);
    raise_to(most, number_in(cases, k, fmt::format("{}_corrected", column)), where + ", corrected stiffness");
  }
}

void raise_to_grid(const Table& grid, const char* column, double efficiency, const Display& display,
                   LargestTension& most) {
  for (std::size_t k = 0; k < grid.rows.size(); ++k) {
    const double tension = number_in(grid, k, column) / efficiency;
    if (!(tension > most.tension || std::isnan(most.tension))) continue;  // most rows: no words are made of them
    std::string where = fmt::format("sliding, boom {} long at {} with {} suspended",
                                    display.brief(number_in(grid, k, "boom_length"), si::m),
                                    display.brief(number_in(grid, k, "luffing_angle"), si::rad),
                                    display.brief(number_in(grid, k, "suspended_weight"), si::N));
    if (efficiency < 1) where += fmt::format(", over the efficiency {:g} of its sheave", efficiency);
    raise_to(most, tension, std::move(where));
  }
}

}  // namespace

LargestTension largest_tension(const Input& in, const Result& r, Rope rope, const Display& display) {
  const bool extension = rope == Rope::extension;
  const char* const column = extension ? "S1" : "S2";
  LargestTension most;
  raise_to_pretension(extension ? in.S10 : in.S20, number_of(r, extension ? "S10_set" : "S20_set"), most);
  raise_to(most, number_of(r, extension ? "S10_set_corrected" : "S20_set_corrected"),
           "pretension, corrected stiffness");
  if (const Table* cases = r.find_table("cases")) raise_to_cases(*cases, column, most);
  const Table* grid = r.find_table("extension");
  if (in.sliding) raise_to(most, sliding_pretension(in, *in.sliding, rope), "pretension of the sliding sections");
  if (grid != nullptr && in.sliding) raise_to_grid(*grid, column, tight_side(*in.sliding, rope), display, most);
  return most;
}

}  // namespace taut::boom_ropes
