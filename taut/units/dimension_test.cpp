#include "taut/units/dimension.hpp"

#include <gtest/gtest.h>

#include "taut/base/expects.hpp"

namespace taut::dimension_test {

constexpr Dimension force = dimension(1, 1, -2);

TEST(Dimension, MultipliesAndDivides) {
  EXPECT_EQ(force * dimension(0, 1, 0), dimension(1, 2, -2));
  EXPECT_EQ(force / force, Dimension{});
}

TEST(Dimension, RootOfASquareIsTheThingItself) {
  EXPECT_EQ(power(power(force, 2), 1, 2), force);
  EXPECT_EQ(power(dimension(0, 3, 0), 1, 3), dimension(0, 1, 0));
}

TEST(Dimension, RefusesRootsItCannotHold) { EXPECT_THROW(power(dimension(0, 1, 0), 1, 7), ContractViolation); }

TEST(Dimension, PrintsBaseUnits) {
  EXPECT_EQ(to_text(force), "kg m s^-2");
  EXPECT_EQ(to_text(Dimension{}), "1");
  EXPECT_EQ(to_text(power(force, 1, 2)), "kg^(3/6) m^(3/6) s^-1");
}

}  // namespace taut::dimension_test
