#include "taut/calc/num.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cstdint>

#include "taut/base/expects.hpp"

namespace taut::num_test {

/// A formula that uses every operation; written once, as a method's would be.
template <class T>
T everything(const T& x, const T& y, const T& force) {
  using std::abs, std::acos, std::asin, std::asinh, std::atan, std::atan2, std::atanh, std::cbrt, std::cos, std::cosh,
      std::exp, std::hypot, std::log, std::max, std::min, std::pow, std::sin, std::sinh, std::sqrt, std::tan, std::tanh;
  T sum = exp(-x) + sqrt(y) * sin(x) / (cos(x) + 2.0) - tan(0.1 * x) + atan2(x, y) + pow(x, 3) - log(y + 1.0);
  sum += asin(x / (1.0 + x)) * acos(x / (1.0 + x)) + atan(y) + sinh(x) / cosh(x) - tanh(x) + asinh(y) + cbrt(y) +
         atanh(x / (1.0 + x));
  sum *= hypot(x, y) + abs(x - y);
  sum -= max(x, y) / min(x + 1.0, y + 1.0);
  sum /= 3.0;
  return force * sum;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

RC_GTEST_PROP(Num, IsBitIdenticalToDouble, ()) {
  const double x = *rc::gen::inRange(0, 1000000) * 1e-6;
  const double y = *rc::gen::inRange(1, 1000000) * 1e-5;
  const double f = *rc::gen::inRange(-1000000, 1000000) * 0.1;
  const Num n = everything(Num::named("x", si::one, x), Num::named("y", si::one, y), Num::named("F", si::N, f));
  RC_ASSERT(same_bits(everything(x, y, f), n.value()));
  RC_ASSERT(n.dimension() == si::N.dimension);
}

TEST(Num, ThrowsWhenDimensionsDoNotFit) {
  const Num force = Num::named("F", si::N, 5);
  const Num length = Num::named("l", si::m, 2);
  EXPECT_THROW(force + length, ContractViolation);
  EXPECT_THROW(force - 1.0, ContractViolation);
  EXPECT_THROW(exp(force), ContractViolation);
  EXPECT_THROW(sin(length), ContractViolation);
  EXPECT_THROW(atan2(force, length), ContractViolation);
  EXPECT_THROW((void)(force < length), ContractViolation);
  EXPECT_NO_THROW(force * length + Num::named("M", si::N_m, 1));
}

TEST(Num, CarriesDimensionsThroughRootsAndPowers) {
  const Num force = Num::named("F", si::N, 9);
  EXPECT_EQ(sqrt(force * force).dimension(), si::N.dimension);
  EXPECT_EQ(pow(Num::named("d", si::m, 2), 3).dimension(), si::m3.dimension);
  EXPECT_EQ((force / Num::named("A", si::m2, 3)).dimension(), si::Pa.dimension);
}

TEST(Num, SquaresAndCubesArePowersInTheFormula) {
  const Num d = Num::named("d", si::m, 0.3);
  EXPECT_EQ(formula_text(cube(d).formula()), "d^3");
  EXPECT_EQ(formula_text(square(d + d).formula()), "(d + d)^2");
  EXPECT_EQ(cube(d).dimension(), si::m3.dimension);
  EXPECT_EQ(cube(d).value(), cube(0.3));
  EXPECT_EQ(square(d).value(), 0.3 * 0.3);
}

TEST(Num, ComparesByValue) {
  EXPECT_TRUE(Num(1) < Num(2));
  EXPECT_TRUE(Num(2) >= Num(2));
  EXPECT_TRUE(Num(2) <= Num(2));
  EXPECT_TRUE(Num(3) > Num(2));
}

}  // namespace taut::num_test
