#include "taut/report/text/mathml.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "taut/calc/num.hpp"
#include "taut/report/text/formula_width.hpp"

namespace mathml_test {

using namespace taut;
using namespace taut::report;

Num named(const char* symbol, double value) { return Num::named(symbol, si::one, value); }
std::string symbols(const Num& x) { return to_mathml(x.formula(), Leaves::symbols); }
std::string numbers(const Num& x) { return to_mathml(x.formula(), Leaves::numbers); }

bool is_balanced(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
    const std::size_t end = xml.find('>', at);
    if (xml[end - 1] == '/') continue;
    const bool closes = xml[at + 1] == '/';
    const std::size_t from = at + (closes ? 2 : 1);
    const std::string name = xml.substr(from, std::min(xml.find(' ', from), end) - from);
    if (!closes) {
      open.push_back(name);
    } else if (open.empty() || open.back() != name) {
      return false;
    } else {
      open.pop_back();
    }
  }
  return open.empty();
}

TEST(Mathml, FractionsNeedNoParentheses) {
  const Num a = named("a", 1), b = named("b", 2), c = named("c", 3);
  EXPECT_EQ(symbols((a + b) / c), "<mfrac><mrow><mi>a</mi><mo>+</mo><mi>b</mi></mrow><mrow><mi>c</mi></mrow></mfrac>");
}

TEST(Mathml, SumsInProductsDo) {
  const Num a = named("a", 1), b = named("b", 2), c = named("c", 3);
  EXPECT_NE(symbols((a + b) * c).find(">(</mo><mi>a</mi>"), std::string::npos);
  EXPECT_NE(symbols(a - (b - c)).find(">(</mo><mi>b</mi>"), std::string::npos);
  EXPECT_EQ(symbols(a - b - c).find(">(</mo>"), std::string::npos);
}

TEST(Mathml, NegativeValuesAreFencedAmongNumbers) {
  const Num a = named("a", 2), b = named("b", -3);
  EXPECT_EQ(symbols(a - b).find(">(</mo>"), std::string::npos);
  EXPECT_NE(numbers(a - b).find(">(</mo>"), std::string::npos);
  EXPECT_NE(numbers(pow(b, 2)).find(">(</mo>"), std::string::npos);
  EXPECT_EQ(numbers(b + a).find(">(</mo>"), std::string::npos);
}

TEST(Mathml, DotsOnlyWhereNumbersMeet) {
  const Num a = named("a", 2), b = named("b", 3);
  EXPECT_EQ(symbols(a * b).find("⋅"), std::string::npos);
  EXPECT_NE(numbers(a * b).find("⋅"), std::string::npos);
  EXPECT_NE(symbols(sin(a) * b).find("⋅"), std::string::npos);  // sin(a) b could be read as sin(a b)
  EXPECT_NE(symbols(a * 2.0).find("⋅"), std::string::npos);
}

TEST(Mathml, RootsPowersFunctions) {
  const Num a = named("alpha", 0.5), b = named("b", 2);
  EXPECT_EQ(symbols(sqrt(b)), "<msqrt><mi>b</mi></msqrt>");
  EXPECT_EQ(symbols(cbrt(b)), "<mroot><mrow><mi>b</mi></mrow><mn>3</mn></mroot>");
  EXPECT_EQ(symbols(pow(b, 3)), "<msup><mrow><mi>b</mi></mrow><mrow><mn>3</mn></mrow></msup>");
  EXPECT_NE(symbols(atan(a)).find("<mi>arctan</mi>"), std::string::npos);
  EXPECT_NE(symbols(exp(a)).find("<mi>exp</mi>"), std::string::npos);
  EXPECT_NE(symbols(hypot(a, b)).find("<msqrt><msup>"), std::string::npos);
}

TEST(Mathml, NumbersHavePowersOfTenAndPi) {
  EXPECT_EQ(number_mathml(std::numbers::pi), "<mi>π</mi>");
  EXPECT_NE(number_mathml(1.5e-7).find("<mn>1.5</mn>"), std::string::npos);
  EXPECT_NE(number_mathml(-2).find("−"), std::string::npos);
  EXPECT_EQ(number_mathml(0.25), "<mn>0.25</mn>");
}

TEST(Mathml, TheUnknownStaysASymbol) {
  const Num b = named("b", 2), n = named("N", 3);
  EXPECT_EQ(to_mathml((n * b).formula(), Leaves::numbers, "b").find("<mn>2</mn>"), std::string::npos);
}

TEST(Mathml, PiecesTogetherAreTheFormula) {
  const Num a = named("a", 1), b = named("b", 2), c = named("c", -3);
  const auto pieces = mathml_pieces((a + b - c).formula(), Leaves::numbers);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_NE(pieces[1].mathml.find('+'), std::string::npos);
  EXPECT_NE(pieces[2].mathml.find("−"), std::string::npos);
  EXPECT_NE(pieces[2].mathml.find(">(</mo>"), std::string::npos);
  EXPECT_EQ(mathml_pieces((a / b).formula(), Leaves::symbols).size(), 1U);
  EXPECT_TRUE(mathml_pieces({}, Leaves::symbols).empty());
}

TEST(Mathml, EverythingIsBalancedAndAWildFormulaEnds) {
  Num x = named("x_<b>", 1.5);
  const Num y = named("y", -2);
  for (int i = 0; i < 14; ++i) {  // doubles with every round
    x = (sqrt(abs(x * y)) + x / y) * exp(x - y);
    x = x + x;
  }
  const std::string all = to_mathml(x.formula(), Leaves::numbers);
  EXPECT_TRUE(is_balanced(all));
  EXPECT_LT(all.size(), 2'000'000U);
  for (const Piece& p : mathml_pieces(x.formula(), Leaves::symbols)) EXPECT_TRUE(is_balanced(p.mathml));
}

TEST(FormulaWidth, GrowsWithTheFormula) {
  const Num a = named("a", 1), b = named("b_long", 1234.5);
  const auto w = [](const Num& x) { return formula_width(*x.formula(), Leaves::symbols); };
  EXPECT_LT(w(a), w(a + b));
  EXPECT_LT(w((a + b) / a), w(a + b + a));
  EXPECT_LT(formula_width(*a.formula(), Leaves::numbers), formula_width(*b.formula(), Leaves::numbers));
}

}  // namespace mathml_test
