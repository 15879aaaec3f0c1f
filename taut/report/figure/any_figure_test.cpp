#include "taut/report/figure/any_figure.hpp"

#include <gtest/gtest.h>

namespace any_figure_test {

using namespace taut;
using namespace taut::report;

TEST(AnyFigure, EachKindIsOneStaticPicture) {
  Drawing drawing;
  drawing.shapes = {Polyline{.points = {{.x = 0, .y = 0}, {.x = 1, .y = 1}}}};
  Plot plot;
  plot.curves = {{.label = "T", .x = {0, 1}, .y = {1, 2}}};
  Animation animation;
  animation.t = {0, 1};
  animation.lines.resize(1);
  animation.lines[0].points = {{{.x = 0, .y = 0}, {.x = 1, .y = 1}}, {{.x = 0, .y = 0}, {.x = 1, .y = 2}}};
  for (const Figure& figure : {Figure(drawing), Figure(plot), Figure(animation)}) {
    const std::string text = figure_svg(figure, Display{});
    EXPECT_TRUE(text.starts_with("<svg class=")) << text;
    EXPECT_EQ(text.find("<svg", 1), std::string::npos);
    EXPECT_EQ(text.find("<script"), std::string::npos);
    EXPECT_EQ(text.find(" id="), std::string::npos);
  }
}

TEST(AnyFigure, NothingToShowIsSaid) {
  for (const Figure& figure : {Figure(Drawing{}), Figure(Plot{}), Figure(Animation{})}) {
    EXPECT_NE(figure_svg(figure, Display{}).find("class=\"empty\""), std::string::npos);
  }
}

}  // namespace any_figure_test
