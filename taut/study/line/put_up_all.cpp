#include "taut/study/line/put_up_all.hpp"

#include <vector>

#include "taut/study/put_up.hpp"

namespace taut::study {

Outcome put_up_all(machine::Model& model) {
  if (Outcome outcome = install_guys(model); !outcome.ok()) return outcome;
  std::vector<PutUpLine> lines;
  if (Outcome outcome = put_up_lines(model, lines); !outcome.ok()) return outcome;
  return set_screws(model);
}

}  // namespace taut::study
