#pragma once
#include <string>
#include <vector>

#include "taut/machine/compile.hpp"

/// For the tests of a machine's compilation.
namespace taut_test {

/// Complaints as "place: message" lines.
inline std::string lines_of(const std::vector<taut::Complaint>& complaints) {
  std::string all;
  for (const taut::Complaint& c : complaints) all += c.path + ": " + c.message + "\n";
  return all;
}

/// All mistakes of a machine; empty: none.
inline std::string complaints_of(const taut::machine::Machine& m) {
  const auto model = taut::machine::compile(m);
  return model ? std::string() : lines_of(model.error());
}

}  // namespace taut_test
