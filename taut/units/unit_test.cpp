#include "taut/units/unit.hpp"

#include <gtest/gtest.h>

#include "taut/units/parse.hpp"

namespace taut::unit_test {

TEST(Unit, EveryCoherentUnitIsShownInOneThatFits) {
  for (const Unit& u : {si::rad,      si::m,       si::m2,       si::m3,      si::m4,    si::s,       si::kg,
                        si::N,        si::N_m,     si::J,        si::W,       si::Pa,    si::N_per_m, si::kg_per_m,
                        si::N_per_m3, si::m_per_s, si::m_per_s2, si::m_per_N, si::per_s, si::kg_m2,   si::N_s_per_m}) {
    EXPECT_TRUE(unit_factor(u.shown, u).has_value()) << u.symbol << " shown in " << u.shown;
    EXPECT_EQ(unit_factor(u.symbol, u).value_or(0), 1.0) << u.symbol;
  }
}

TEST(Unit, AnAngleNeedsItsUnitInTextThoughItHasNoDimension) {
  EXPECT_TRUE(si::rad.needs_text());
  EXPECT_FALSE(si::one.needs_text());
  EXPECT_EQ(si::m.in("mm").shown, "mm");
}

}  // namespace taut::unit_test
