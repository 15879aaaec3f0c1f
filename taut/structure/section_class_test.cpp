#include "taut/structure/section_class.hpp"

#include <gtest/gtest.h>

#include "taut/catalogue/section_search.hpp"

namespace taut::structure::section_class_test {

catalogue::SectionRow row(const char* name) { return *catalogue::find_section(name); }
CrossForces of(double N, double M_y, double M_z) {
  CrossForces f;
  f.N = N;
  f.M_y = M_y;
  f.M_z = M_z;
  return f;
}

// By hand: epsilon^2 = 235/355 = 0.661972, limits 33.0986, 46.3380, 59.5775.
TEST(SectionClass, TubesByTheirSlenderness) {
  const WallClass w = section_class(row("CHS 508x16"), 355e6, of(1, 1, 1));
  EXPECT_EQ(w.wall, "tube");
  EXPECT_DOUBLE_EQ(w.slenderness, 31.75);
  EXPECT_NEAR(w.limit_1, 33.0986, 5e-5);
  EXPECT_NEAR(w.limit_2, 46.3380, 5e-5);
  EXPECT_NEAR(w.limit_3, 59.5775, 5e-5);
  EXPECT_EQ(w.value, 1);
  EXPECT_EQ(section_class(row("CHS 508x12.5"), 355e6, {}).value, 2);  // 40.64
  EXPECT_EQ(section_class(row("CHS 508x10"), 355e6, {}).value, 3);    // 50.8
  EXPECT_EQ(section_class(row("CHS 508x8"), 355e6, {}).value, 4);     // 63.5
  EXPECT_EQ(section_class(row("CHS 508x8"), 235e6, {}).value, 2);
}

// epsilon = 0.813616: a pressed wall 33, 38, 42 times it: 26.849, 30.917, 34.172.
TEST(SectionClass, BoxesInPureCompression) {
  const WallClass w = section_class(row("SHS 350x10"), 355e6, of(1500e3, 0, 0));
  EXPECT_NEAR(w.slenderness, 32, 1e-9);
  EXPECT_NEAR(w.limit_1, 26.8493, 5e-5);
  EXPECT_NEAR(w.limit_2, 30.9174, 5e-5);
  EXPECT_NEAR(w.limit_3, 34.1719, 5e-5);
  EXPECT_EQ(w.value, 3);
  EXPECT_EQ(section_class(row("SHS 350x8"), 355e6, of(1500e3, 0, 0)).value, 4);   // 40.75
  EXPECT_EQ(section_class(row("SHS 350x12"), 355e6, of(1500e3, 0, 0)).value, 1);  // 26.17
}

// A web in plain bending: 72, 83, 124 epsilon.
TEST(SectionClass, WebsInBending) {
  for (const WallClass& w : wall_classes(row("RHS 300x200x5"), 235e6, of(0, 10e3, 0))) {
    if (w.wall == "web") {
      EXPECT_NEAR(w.limit_1, 72, 1e-9);
      EXPECT_NEAR(w.limit_2, 83, 1e-9);
      EXPECT_NEAR(w.limit_3, 124, 1e-9);
    } else {
      EXPECT_NEAR(w.limit_1, 33, 1e-9);
      EXPECT_NEAR(w.limit_2, 38, 1e-9);
      EXPECT_NEAR(w.limit_3, 42, 1e-9);
    }
  }
}

// RHS 300x200x10 with 500 kN, 120 and 40 kN m, by hand: alpha of the web 0.777902, limits 35.356, 40.713.
TEST(SectionClass, MomentsAcrossAWallPressIt) {
  const auto all = wall_classes(row("RHS 300x200x10"), 355e6, of(500e3, 120e3, 40e3));
  EXPECT_NEAR(all[0].slenderness, 27, 1e-9);
  EXPECT_NEAR(all[0].limit_1, 35.3563, 5e-5);
  EXPECT_NEAR(all[0].limit_2, 40.7133, 5e-5);
  EXPECT_NEAR(all[1].limit_1, 26.8493, 5e-5);
  // SHS 350x10 with 1500 kN, 100 and 60 kN m: psi 0.383532 and 0.630119
  const auto square = wall_classes(row("SHS 350x10"), 355e6, of(1500e3, 100e3, 60e3));
  EXPECT_NEAR(square[0].limit_3, 42.8990, 5e-5);
  EXPECT_NEAR(square[1].limit_3, 38.9228, 5e-5);
}

TEST(SectionClass, SignsAndOrderOfAxesDontCount) {
  const auto box = row("SHS 200x5");
  for (const double N : {-100e3, 0.0, 300e3}) {
    const int own = section_class(box, 355e6, of(N, 20e3, 5e3)).value;
    EXPECT_EQ(section_class(box, 355e6, of(N, -20e3, 5e3)).value, own);
    EXPECT_EQ(section_class(box, 355e6, of(N, 20e3, -5e3)).value, own);
    EXPECT_EQ(section_class(box, 355e6, of(N, 5e3, 20e3)).value, own);
  }
}

TEST(SectionClass, TensionHasNoLimit) {
  EXPECT_EQ(section_class(row("SHS 350x8"), 460e6, of(-1e6, 0, 0)).value, 1);
  EXPECT_EQ(section_class(row("SHS 350x8"), 460e6, {}).value, 1);
}

TEST(SectionClass, ClassFourSaysWhatToDo) {
  const auto thin = row("CHS 508x8");
  const std::string words = class_4_words(thin, section_class(thin, 355e6, {}));
  EXPECT_NE(words.find("class 4"), std::string::npos);
  EXPECT_NE(words.find("63.5"), std::string::npos);
  EXPECT_NE(words.find("thicker wall"), std::string::npos);
  const auto thick = row("CHS 508x16");
  EXPECT_EQ(class_4_words(thick, section_class(thick, 355e6, {})), "");
}

TEST(SectionClass, WrittenLineByLine) {
  static const Description none;
  Sheet<Num> s("test", none, nullptr);
  write_class(row("RHS 300x200x10"), 355e6, of(500e3, 120e3, 0), s);
  write_class(row("CHS 508x16"), 355e6, of(500e3, 120e3, 0), s);
  ASSERT_EQ(s.steps().size(), 6U);
  EXPECT_NEAR(s.steps()[0].value, 0.813617, 1e-6);
  EXPECT_EQ(s.steps()[4].symbol, "D/t");
  EXPECT_NEAR(s.steps()[4].value, 31.75, 1e-12);
}

}  // namespace taut::structure::section_class_test
