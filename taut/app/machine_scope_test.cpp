#include "taut/app/machine_scope.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace taut::app::machine_scope_test {

using testing::HasSubstr;
using testing::IsEmpty;

MachineDeck with_contact_and_cylinder() {
  MachineDeck deck;
  deck.machine.contacts.emplace_back();
  deck.machine.actuators.emplace_back();
  return deck;
}

study::AnalysisRequest transient() {
  study::AnalysisRequest one;
  one.transient.emplace();
  return one;
}

TEST(MachineScope, StaticsRefusesContactsAndCylinders) {
  MachineDeck deck = with_contact_and_cylinder();
  for (const bool asked : {false, true}) {
    if (asked) {
      deck.analyses = {transient(), {}};
      deck.analyses[1].equilibrium.emplace();
    }
    const auto complaints = not_computed(deck);
    ASSERT_EQ(complaints.size(), 2U) << asked;
    EXPECT_EQ(complaints[0].path, "machine.contacts");
    EXPECT_EQ(complaints[1].path, "machine.actuators");
    EXPECT_THAT(complaints[1].message, HasSubstr("give the force as a load"));
  }
}

TEST(MachineScope, MotionComputesThem) {
  MachineDeck deck = with_contact_and_cylinder();
  deck.analyses = {transient()};
  EXPECT_THAT(not_computed(deck), IsEmpty());
}

TEST(MachineScope, AMachineWithoutThemIsComputedByAll) { EXPECT_THAT(not_computed(MachineDeck{}), IsEmpty()); }

}  // namespace taut::app::machine_scope_test
