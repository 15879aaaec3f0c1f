#include "taut/units/factor.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <udunits2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <string>

#include "taut/units/parse.hpp"

namespace taut::factor_test {
namespace {

struct UnitFree {
  void operator()(ut_unit* u) const { ut_free(u); }
};
struct SystemFree {
  void operator()(ut_system* s) const { ut_free_system(s); }
};
using UnitPtr = std::unique_ptr<ut_unit, UnitFree>;

/// Our names as UDUNITS-2 spells them; those that are not here have the same spelling.
const std::map<std::string_view, std::string_view> spelt = {{"in", "inch"},
                                                            {"ft", "international_foot"},
                                                            {"yd", "international_yard"},
                                                            {"t", "tonne"},
                                                            {"lb", "0.45359237 kg"},
                                                            {"kgf", "kilogram_force"},
                                                            {"tf", "1000 kilogram_force"},
                                                            {"lbf", "pound_force"},
                                                            {"kip", "1000 pound_force"},
                                                            {"ksi", "1000 psi"},
                                                            {"rad", "radian"},
                                                            {"mrad", "milliradian"},
                                                            {"deg", "arc_degree"},
                                                            {"°", "arc_degree"},
                                                            {"gon", "0.9 arc_degree"},
                                                            {"%", "0.01"}};

/// What UDUNITS makes of 0 and of 1 of a product of units.
class Witness {
 public:
  Witness() {
    ut_set_error_message_handler(ut_ignore);
    system_.reset(ut_read_xml(nullptr));
  }
  bool ready() const { return system_ != nullptr; }

  struct Line {
    double at_zero = std::numeric_limits<double>::quiet_NaN();
    double at_one = std::numeric_limits<double>::quiet_NaN();
  };
  Line convert(const std::vector<UnitPower>& product) const {
    std::string from;
    Dimension dimension;
    for (const UnitPower& f : product) {
      const auto at = spelt.find(f.row->name);
      from +=
          fmt::format("{}({})^{}", from.empty() ? "" : ".", at == spelt.end() ? f.row->name : at->second, f.exponent);
      dimension = dimension * power(f.row->dimension, f.exponent);
    }
    const std::string to =
        fmt::format("(kg)^{}.(m)^{}.(s)^{}.(K)^{}", dimension.mass / whole_exponent, dimension.length / whole_exponent,
                    dimension.time / whole_exponent, dimension.temperature / whole_exponent);
    const UnitPtr source(ut_parse(system_.get(), from.c_str(), UT_UTF8));
    const UnitPtr target(ut_parse(system_.get(), to.c_str(), UT_UTF8));
    if (source == nullptr || target == nullptr) return {};
    cv_converter* converter = ut_get_converter(source.get(), target.get());
    if (converter == nullptr) return {};
    const Line line{.at_zero = cv_convert_double(converter, 0.0), .at_one = cv_convert_double(converter, 1.0)};
    cv_free(converter);
    return line;
  }

 private:
  std::unique_ptr<ut_system, SystemFree> system_;
};

const NameRow* row_of(std::string_view name) {
  for (const NameRow& row : name_rows()) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

bool is_latin(const NameRow& row) {
  return row.name == "°" ||
         std::all_of(row.name.begin(), row.name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80U; });
}

/// Names whose factor UDUNITS rounds several times on its way; ours is the nearest double (the next test).
bool rounded_by_the_witness(std::string_view name) {
  return name == "in" || name == "yd" || name == "psi" || name == "ksi";
}

TEST(UnitFactors, AreThoseOfUdunitsToTheLastBit) {
  const Witness witness;
  ASSERT_TRUE(witness.ready()) << "install libudunits2-dev";
  for (const NameRow& row : name_rows()) {
    if (!is_latin(row)) continue;
    const auto line = witness.convert({{.row = &row, .exponent = 1}});
    EXPECT_EQ(line.at_zero, row.scale.zero) << row.name;
    const double factor = factor_of({{.row = &row, .exponent = 1}});
    if (rounded_by_the_witness(row.name)) {
      EXPECT_NEAR(factor, line.at_one, 1e-15 * factor) << row.name;
    } else {
      EXPECT_EQ(factor, line.at_one - line.at_zero) << row.name;
    }
  }
}

TEST(UnitFactors, OfProductsAreThoseOfUdunitsWithinItsRounding) {
  const Witness witness;
  ASSERT_TRUE(witness.ready());
  const auto& rows = name_rows();
  for (const NameRow& a : rows) {
    if (!is_latin(a)) continue;
    for (const NameRow& b : rows) {
      if (!is_latin(b) || &a == &b) continue;
      const int power = static_cast<int>((&a - rows.data()) + (&b - rows.data())) % 4 + 1;
      const std::vector<UnitPower> product = {{.row = &a, .exponent = 2}, {.row = &b, .exponent = -power}};
      const double factor = factor_of(product);
      EXPECT_NEAR(factor, witness.convert(product).at_one, 4e-15 * factor)
          << a.name << "^2 " << b.name << "^-" << power;
    }
  }
}

TEST(UnitFactors, AreTheNearestDoubles) {
  const auto factor = [](std::string_view name, int exponent) {
    return factor_of({{.row = row_of(name), .exponent = exponent}});
  };
  EXPECT_EQ(factor("in", 1), 0.0254);
  EXPECT_EQ(factor("yd", 1), 0.9144);
  EXPECT_EQ(factor("psi", 1), 6894.757293168362);
  EXPECT_EQ(factor("ksi", 1), 6894757.293168361);
  EXPECT_EQ(factor("mm", 4), 1e-12);
  EXPECT_EQ(factor("cm", -3), 1e6);
  EXPECT_EQ(factor("us", -4), 1e24);
  EXPECT_EQ(factor("in", 2), 6.4516e-4);
  EXPECT_EQ(factor("lbf", -1), 1e13 / 44482216152605);
  EXPECT_EQ(factor("deg", 1), std::numbers::pi / 180);
  EXPECT_EQ(factor("deg", -1), 180 / std::numbers::pi);
  EXPECT_EQ(factor_of({{row_of("kgf"), 1}, {row_of("mm"), -2}}), 9806650.0);
  EXPECT_EQ(factor_of({{row_of("km"), 1}, {row_of("h"), -1}}), 1 / 3.6);
  EXPECT_EQ(factor_of({{row_of("deg"), 1}, {row_of("deg"), -1}}), 1.0);
  EXPECT_EQ(factor_of({}), 1.0);
}

TEST(UnitFactors, CyrillicNamesAreThoseOfTheirUnit) {
  struct Case {
    const char* cyrillic;
    const char* latin;
    Unit unit;
  };
  for (const Case& c : {Case{.cyrillic = "63 кН", .latin = "63 kN", .unit = si::N},
                        {.cyrillic = "12 мм", .latin = "12 mm", .unit = si::m},
                        {.cyrillic = "160 МПа", .latin = "160 MPa", .unit = si::Pa},
                        {.cyrillic = "12 град", .latin = "12 deg", .unit = si::rad},
                        {.cyrillic = "3.2 т", .latin = "3.2 t", .unit = si::kg},
                        {.cyrillic = "1.5 кгс/м", .latin = "1.5 kgf/m", .unit = si::N_per_m},
                        {.cyrillic = "4 м/с²", .latin = "4 m/s²", .unit = si::m_per_s2},
                        {.cyrillic = "160 Н/мм2", .latin = "160 N/mm2", .unit = si::Pa},
                        {.cyrillic = "100 кН с/м", .latin = "100 kN s/m", .unit = si::N_s_per_m},
                        {.cyrillic = "5 1/с", .latin = "5 1/s", .unit = si::per_s}}) {
    const auto read = parse_quantity(c.cyrillic, c.unit);
    ASSERT_TRUE(read.has_value()) << c.cyrillic << ": " << read.error().message;
    EXPECT_EQ(*read, parse_quantity(c.latin, c.unit).value()) << c.cyrillic;
  }
  EXPECT_FALSE(parse_quantity("63 кH", si::N).has_value()) << "letters of both alphabets in one name";
}

TEST(UnitFactors, APowerOfAnAngleIsNoAngle) {
  EXPECT_FALSE(parse_quantity("5 deg^2", si::rad).has_value());
  EXPECT_FALSE(parse_quantity("5 1/deg", si::rad).has_value());
  EXPECT_EQ(parse_quantity("5 deg m/m", si::rad).value(), parse_quantity("5 deg", si::rad).value());
}

}  // namespace
}  // namespace taut::factor_test
