#pragma once
// What tests read from the result of a machine with one driven sheave.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <variant>

#include "taut/app/job.hpp"

namespace taut_test::drive_results {

using namespace taut;

inline double value(const Result& r, const std::string& name) {
  const Value* v = r.find_value(name);
  EXPECT_NE(v, nullptr) << name << ' ' << r.message << to_text(r.errors);
  return v == nullptr ? std::nan("") : v->value;
}

inline double drive(const Result& r, const std::string& column) {
  for (const Table& t : r.tables) {
    for (std::size_t i = 0; t.name == "drives" && i < t.columns.size(); ++i) {
      if (t.columns[i].name == column) return std::get<double>(t.rows.at(0).at(i));
    }
  }
  ADD_FAILURE() << column << ' ' << r.message << to_text(r.errors);
  return std::nan("");
}

}  // namespace taut_test::drive_results
