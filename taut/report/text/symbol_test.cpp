#include "taut/report/text/symbol.hpp"

#include <gtest/gtest.h>

namespace symbol_test {

using namespace taut::report;
using Texts = std::vector<std::string>;

TEST(Symbol, GreekNamesBecomeLetters) {
  EXPECT_EQ(split_symbol("gamma_sky").base, "γ");
  EXPECT_EQ(split_symbol("gamma_sky").subscripts, Texts{"sky"});
  EXPECT_EQ(split_symbol("Delta_f").base, "Δ");
  EXPECT_EQ(split_symbol("lambda_1").subscripts, Texts{"1"});
  EXPECT_EQ(split_symbol("T_alpha").subscripts, Texts{"α"});
  EXPECT_EQ(split_symbol("sigma_0").base, "σ");
}

TEST(Symbol, FurtherSubscriptsAreJoinedByAComma) {
  EXPECT_EQ(split_symbol("F_span_sky").subscripts, (Texts{"span", "sky"}));
  EXPECT_EQ(symbol_mathml("F_span_sky"),
            "<msub><mi>F</mi><mrow><mi>span</mi><mo separator=\"true\">,</mo><mi>sky</mi></mrow></msub>");
}

TEST(Symbol, DigitsAtTheEndAreASubscript) {
  EXPECT_EQ(split_symbol("S1").base, "S");
  EXPECT_EQ(split_symbol("S1").subscripts, Texts{"1"});
  EXPECT_EQ(split_symbol("beta1_light").subscripts, (Texts{"1", "light"}));
}

TEST(Symbol, WordsStayWords) {
  for (const char* word : {"branch_angle", "T_1 of P_M", "P_M-1", "a b", "wrap", "no__gap", "_x", "x_", "6x36", ""}) {
    EXPECT_TRUE(split_symbol(word).is_word) << word;
  }
}

TEST(Symbol, BracketsPrimesAndStars) {
  EXPECT_TRUE(split_symbol("[sigma]").bracketed);
  EXPECT_EQ(split_symbol("[sigma]").base, "σ");
  EXPECT_EQ(split_symbol("T'").after, "′");
  EXPECT_EQ(split_symbol("F_0*").after, "*");
  EXPECT_EQ(symbol_mathml("F_0*"), "<msubsup><mi>F</mi><mn>0</mn><mo>*</mo></msubsup>");
}

TEST(Symbol, InASentenceOnlyWhatIsMeantAsOne) {
  EXPECT_EQ(prose_html("build by D_tube, not a tube"), "build by <i>D</i><sub>tube</sub>, not a tube");
  EXPECT_EQ(prose_html("block_friction and mast_section stay"), "block_friction and mast_section stay");
  EXPECT_EQ(prose_html("tan(psi) of the etalon"), "tan(<i>ψ</i>) of the etalon");
  EXPECT_EQ(prose_html("<b>R_s"), "&lt;b&gt;<i>R</i><sub><i>s</i></sub>");
}

TEST(Symbol, ALabelThatIsOneNameIsASymbol) {
  EXPECT_EQ(to_html(label_runs("l")), "<i>l</i>");
  EXPECT_EQ(to_html(label_runs("h = 8 m")), "<i>h</i> = 8 m");
  EXPECT_EQ(to_html(label_runs("a tube")), "a tube");
  EXPECT_EQ(to_html(label_runs("drum")), "drum");
  EXPECT_EQ(to_html(label_runs("T_1 of P_M")), "<i>T</i><sub>1</sub> of <i>P</i><sub><i>M</i></sub>");
}

TEST(Symbol, SvgLowersSubscriptsAndComesBack) {
  const std::string svg = to_svg(prose_runs("R_sky = 1"));
  EXPECT_NE(svg.find("<tspan class=\"s\" dy=\".28em\">sky</tspan>"), std::string::npos) << svg;
  EXPECT_NE(svg.find("<tspan class=\"t\" dy=\"-.2em\"> = 1</tspan>"), std::string::npos) << svg;
}

}  // namespace symbol_test
