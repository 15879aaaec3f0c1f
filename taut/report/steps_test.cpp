#include "taut/report/steps.hpp"

#include <gtest/gtest.h>

#include "taut/calc/num.hpp"

namespace steps_test {

using namespace taut;
using namespace taut::report;

Step equation(const std::string& no, double value) {
  const Num a = Num::named("a", si::N, value);
  return {.kind = Step::Kind::equation,
          .eq = no,
          .symbol = "F_1",
          .formula = (a + a).formula(),
          .value = 2 * value,
          .unit = si::N,
          .source = "Author 2020, (" + no + ")",
          .words = ""};
}

TEST(Steps, ShowFormulaNumbersValueAndSource) {
  Result r;
  r.steps = {equation("4", 1500)};
  const std::string html = steps_html(r);
  EXPECT_NE(html.find("<mi>F</mi><mn>1</mn>"), std::string::npos);
  EXPECT_NE(html.find("<mn>1500</mn>"), std::string::npos);
  EXPECT_NE(html.find("3000 N = <b>3 kN</b>"), std::string::npos);
  EXPECT_NE(html.find("(4)"), std::string::npos);
  EXPECT_NE(html.find(">Author 2020<"), std::string::npos);
}

TEST(Steps, TheNumberIsSaidOnce) {
  EXPECT_EQ(source_without_number(equation("4", 1)), "Author 2020");
  Step s = equation("4*", 1);
  s.source = "correction of Author 2020, (4)";
  EXPECT_EQ(source_without_number(s), "correction of Author 2020");
  s.source = "another book";
  EXPECT_EQ(source_without_number(s), "another book");
}

TEST(Steps, GivenLinesStandTogether) {
  Result r;
  const Step given{.kind = Step::Kind::given,
                   .eq = "",
                   .symbol = "f",
                   .formula = {},
                   .value = 0.12,
                   .unit = si::one,
                   .source = "input",
                   .words = "friction"};
  r.steps = {given, given, equation("1", 1), given};
  const std::string html = steps_html(r);
  std::size_t lines = 0;
  for (std::size_t at = html.find("With "); at != std::string::npos; at = html.find("With ", at + 1)) ++lines;
  EXPECT_EQ(lines, 2U);
}

TEST(Steps, AVeryLongNoteIsCutAndSaysSo) {
  Result r;
  r.steps.assign(5000, equation("4", 1));
  const std::string html = steps_html(r);
  EXPECT_LT(html.size(), 240'000U);
  EXPECT_NE(html.find("more lines are left out here"), std::string::npos);
}

}  // namespace steps_test
