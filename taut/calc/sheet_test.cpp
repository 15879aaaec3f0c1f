#include "taut/calc/sheet.hpp"

#include <gtest/gtest.h>

#include "taut/base/expects.hpp"

namespace taut::sheet_test {

struct Input {
  double cutting_force = 2500;
  double friction = 0.3;
  std::vector<double> speeds = {10, 20};
  static const Description& describe() {
    static const Description d = Describe<Input>()
                                     .field(&Input::cutting_force, "cutting_force", "P_p", si::N, "cutting force")
                                     .field(&Input::friction, "friction", "mu", si::one, "friction")
                                     .field(&Input::speeds, "speeds", "U", si::m_per_s, "speeds");
    return d;
  }
};

template <class T>
T formula(const Input& in, Sheet<T>& s) {
  using std::exp;
  s.section("Grip");
  const T P_p = s.given(in.cutting_force);
  const T mu = s.given(in.friction);
  const T e = s.eq("", "e", si::one, exp(mu * 2.0));
  const T P_s = s.eq("15", "P_s", si::N, P_p / (e - 1.0));
  s.check("pull", P_s, si::N, {Sense::at_most, s.named("P_max", si::N, 1e6), "rule", "verified"});
  s.warn([] { return std::string("once"); });
  s.warn("once");
  const auto b = s.root(
      "16", "b", si::m, [&](const T& x) { return P_p * x - s.named("M", si::N_m, 100); }, 0, 1);
  return *b;
}

TEST(Sheet, DoubleAndNumAgreeToTheBitAndNumRecords) {
  const Input in;
  Sheet<double> plain;
  Sheet<Num> note("Ryabukhin 2022", Input::describe(), &in);
  EXPECT_EQ(formula(in, plain), formula(in, note).value());
  Result r;
  note.move_to(r);
  ASSERT_EQ(r.steps.size(), 6U);
  EXPECT_EQ(r.steps[0].kind, Step::Kind::heading);
  EXPECT_EQ(r.steps[1].symbol, "P_p");
  EXPECT_EQ(r.steps[4].source, "Ryabukhin 2022, (15)");
  EXPECT_EQ(formula_text(r.steps[4].formula), "P_p/(e - 1)");
  EXPECT_EQ(r.steps[5].kind, Step::Kind::root);
  EXPECT_DOUBLE_EQ(r.steps[5].value, 0.04);
  ASSERT_EQ(r.checks.size(), 1U);
  EXPECT_TRUE(r.checks[0].passes);
  EXPECT_EQ(r.warnings, std::vector<std::string>{"once"});
}

TEST(Sheet, AWrongDimensionFailsAtItsEquation) {
  const Input in;
  Sheet<Num> s("x", Input::describe(), &in);
  EXPECT_THROW(s.eq("1", "P", si::N, s.given(in.friction)), ContractViolation);
  EXPECT_THROW(s.check("c", s.given(in.friction), si::N, {Sense::at_most, s.given(in.cutting_force), "", ""}),
               ContractViolation);
}

TEST(Sheet, GivenTakesElementsOfListsButNoStrangers) {
  const Input in;
  Sheet<Num> s("x", Input::describe(), &in);
  EXPECT_EQ(formula_text(s.given(in.speeds[1]).formula()), "U");
  const double stranger = 5;
  EXPECT_THROW(s.given(stranger), ContractViolation);
}

TEST(Sheet, SourcesNameCorrections) {
  const Input in;
  Sheet<Num> s("Ryabukhin 2022", Input::describe(), &in);
  s.eq("18*", "P", si::one, 1.0);
  s.eq("", "Q", si::one, 1.0);
  s.eq("", "R", si::one, 1.0, "statics");
  EXPECT_EQ(s.steps()[0].source, "correction of Ryabukhin 2022, (18)");
  EXPECT_EQ(s.steps()[1].source, "Ryabukhin 2022");
  EXPECT_EQ(s.steps()[2].source, "statics");
}

TEST(Sheet, NoRootIsEmptyAndRecordsNothing) {
  const Input in;
  Sheet<Num> s("x", Input::describe(), &in);
  EXPECT_FALSE(s.root(
                    "1", "b", si::m, [&](const Num& x) { return x * x + s.named("A", si::m2, 1); }, 0, 1)
                   .has_value());
  EXPECT_TRUE(s.steps().empty());
}

}  // namespace taut::sheet_test
