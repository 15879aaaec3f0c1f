#include "taut/report/figure/tension_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tension_scale_test {

using namespace taut;
using namespace taut::report;

TEST(TensionScale, ColoursAreStepsUpToTheLargest) {
  Animation a;
  a.lines.resize(2);
  a.lines[0].tension = {0, 100, 799, 800, NAN};
  const TensionScale scale = tension_scale(a);
  EXPECT_EQ(scale.most, 800);
  std::string letters;
  for (std::size_t i = 0; i < 5; ++i) letters += tension_letter(a.lines[0], i, scale);
  EXPECT_EQ(letters, "s177-");
  EXPECT_EQ(line_classes(a.lines[0], 0, scale), "line slack");
  EXPECT_EQ(line_classes(a.lines[0], 3, scale), "line t7");
  EXPECT_EQ(line_classes(a.lines[1], 3, scale), "line rope");
}

TEST(TensionScale, NoTensionsNoLegend) {
  Box box;
  EXPECT_EQ(tension_legend(tension_scale({}), Display{}, {}, box), "");
  EXPECT_TRUE(box.empty());
}

}  // namespace tension_scale_test
