#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/app/job.hpp"
#include "taut/calc/method.hpp"
#include "taut/calc/result.hpp"

namespace taut::io {
struct Node;
}

namespace taut::app {

/// A method as the doors see it: what it is, its fields, its example, and how to run it on a deck's `input:`.
struct MethodEntry {
  const Method* about = nullptr;
  const Description* input = nullptr;
  const Description* output = nullptr;
  const Description* exact = nullptr;  ///< values that the engine adds; none where it does not
  std::string_view example;            ///< the text of examples/<name>.yaml
  /// Reads `input` (and of the map `others` the blocks `checks` and `design`, where the deck has any) and notes every
  /// mistake; without mistakes returns the calculation, ready to be called; else an empty one. `progress`: as in a Job.
  std::function<std::function<Result()>(const io::Node& input, const io::Node* others,
                                        const std::function<bool(const Progress&)>& progress, Diagnostics& mistakes)>
      prepare;
};

/// Every method that taut has, in the order of print. To add one: a line in methods.cpp.
const std::vector<MethodEntry>& methods();

/// nullptr when there is none of that name.
const MethodEntry* find_method(std::string_view name);

/// Names of all methods.
std::vector<std::string> method_names();

}  // namespace taut::app
