#pragma once
#include <optional>
#include <string>

#include "taut/calc/field.hpp"
#include "taut/study/requests/transient_deck.hpp"

namespace taut::study {

/// Small vibrations of the machine about where its motion would begin.
struct ModesRequest {
  std::optional<std::string> name;  ///< ending of its tables' names
  int count = 10;
  TransientRequest::Start start = TransientRequest::Start::settled;
  double damping_ratio = 0;
  bool rope_mass = true;
  TransientRequest::Branches branches = TransientRequest::Branches::straight;
  bool judge = true;  ///< false: its states do not count for the verdict
  static const Description& describe();
};

}  // namespace taut::study
