#include "taut/report/text/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace quantity_test {

using namespace taut;
using namespace taut::report;

Display display(std::map<std::string, std::string> units) {
  Result r;
  r.display = std::move(units);
  return display_of(r);
}

TEST(Quantity, ShowsTheUnitOfTheDeck) {
  EXPECT_EQ(quantity_shown(138864.558, si::N, display({})), "138.86 kN");
  EXPECT_EQ(quantity_shown(138864.558, si::N, display({{"force", "N"}}), 6), "138865 N");
  EXPECT_EQ(quantity_shown(0.3183905, si::m.in("mm"), display({})), "318.39 mm");
  EXPECT_EQ(quantity_shown(258.15, si::K.in("degC"), display({})), "−15 °C");
  EXPECT_EQ(quantity_shown(std::numbers::pi / 3, si::rad, display({})), "60°");
  EXPECT_EQ(quantity_shown(std::atan(0.3), si::rad, display({{"angle", "%"}})), "30 %");
  EXPECT_EQ(quantity_shown(0.12, si::one, display({})), "0.12");
}

TEST(Quantity, IgnoresAUnitThatDoesNotFit) {
  EXPECT_EQ(quantity_shown(1000, si::N, display({{"force", "m"}, {"nonsense", "kN"}})), "1 kN");
}

TEST(Quantity, NumbersForPrint) {
  EXPECT_EQ(number_shown(-1.5e-9), "−1.5×10⁻⁹");
  EXPECT_EQ(number_shown(2.5e12), "2.5×10¹²");
  EXPECT_EQ(number_shown(0), "0");
  EXPECT_EQ(number_shown(-0.0), "0");
  EXPECT_EQ(number_shown(123456.7, 3), "123457");  // whole digits are never dropped
  EXPECT_EQ(number_shown(std::nan("")), "–");
  EXPECT_EQ(number_shown(-std::numeric_limits<double>::infinity()), "−∞");
  EXPECT_EQ(number_plain(-1.5e-9), "-1.5e-09");
}

TEST(Quantity, UnitNamesForPrint) {
  EXPECT_EQ(unit_text("kN m"), "kN·m");
  EXPECT_EQ(unit_text("N/mm2"), "N/mm²");
  EXPECT_EQ(unit_text("m^4"), "m⁴");
  EXPECT_EQ(unit_text("1/s"), "1/s");
  EXPECT_EQ(unit_text("deg"), "°");
  EXPECT_EQ(unit_text(""), "");
}

TEST(Quantity, AColumnHasOneNumberOfDecimals) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(column_shown({318.3905, 9.5, 100}), (Texts{"318.39", "9.50", "100.00"}));
  EXPECT_EQ(column_shown({10, 200, 3000}), (Texts{"10", "200", "3000"}));
  EXPECT_EQ(column_shown({1.5, 2.25}), (Texts{"1.50", "2.25"}));
  EXPECT_EQ(column_shown({1000, 1e-7, std::nan("")}), (Texts{"1000", "1×10⁻⁷", "–"}));
  EXPECT_EQ(column_shown({}), Texts{});
  EXPECT_EQ(column_shown({1e12, 2e12}), (Texts{"1×10¹²", "2×10¹²"}));
}

}  // namespace quantity_test
