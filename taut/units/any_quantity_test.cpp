#include "taut/units/any_quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace taut::any_quantity_test {

TEST(AnyQuantity, ItsUnitSaysWhatItIs) {
  struct Case {
    const char* text;
    double value;
    Unit unit;
  };
  for (const Case& c : {Case{"30 m/min", 0.5, si::m_per_s}, Case{"12 kN", 12e3, si::N}, Case{"-3.5", -3.5, si::one},
                        Case{"5 %", 0.05, si::one}, Case{"180 deg", M_PI, si::rad}, Case{"2 kN m", 2e3, si::N_m},
                        Case{"120 cm", 1.2, si::m}, Case{"2 s", 2, si::s}}) {
    const auto found = parse_any_quantity(c.text);
    ASSERT_TRUE(found) << c.text;
    EXPECT_NEAR(found->value, c.value, 1e-12 * std::abs(c.value)) << c.text;
    EXPECT_TRUE(same_kind(found->unit, c.unit)) << c.text;
  }
}

TEST(AnyQuantity, SaysWhyNot) {
  for (const char* text : {"fast", "3 furlongz", "1,5 m", "1 kg^3 m^2"}) {
    const auto found = parse_any_quantity(text);
    ASSERT_FALSE(found) << text;
    EXPECT_FALSE(found.error().message.empty()) << text;
    EXPECT_EQ(found.error().message.find("a plain number is expected"), std::string::npos) << found.error().message;
  }
  EXPECT_FALSE(same_kind(si::rad, si::one));
}

}  // namespace taut::any_quantity_test
