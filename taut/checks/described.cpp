#include "taut/checks/described.hpp"

#include "taut/checks/anchor/support_checks.hpp"
#include "taut/checks/guy/guy_checks.hpp"
#include "taut/checks/mast/mast_checks.hpp"
#include "taut/checks/rope/rope_life.hpp"
#include "taut/checks/yarder/yarder_checks.hpp"

namespace taut::checks {

std::vector<TableWords> table_words() {
  return {life_words(),   discard_words(), mast_words(),  mast_choice_words(),
          anchor_words(), support_words(), yarder_words()};
}

}  // namespace taut::checks
