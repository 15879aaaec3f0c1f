#include "taut/structure/section_class.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

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

// RHS 300x200x10 with 500 kN, 120 and 40 kN m. By hand: middle lines 290 x 190 mm, n = N/(t f_y) = 0.140845 m, K = 0.29
// (0.19 + 0.145) - n^2/8 = 0.0946703 m2; the axis crosses the webs d = 80 K/(22.8 + sqrt(22.8^2 + 3200 K)) = 0.147106 m
// apart, if moments are in kN m; the more pressed web to 0.145 + n/4 + d/2 = 0.253764 m, of its flat 270 mm 243.764 mm:
// alpha = 0.902830. Limits 396, 456 times 0.813617 over 13 alpha - 1 = 10.7368.
TEST(SectionClass, MomentsAcrossAWallPressIt) {
  const auto all = wall_classes(row("RHS 300x200x10"), 355e6, of(500e3, 120e3, 40e3));
  EXPECT_NEAR(all[0].slenderness, 27, 1e-9);
  EXPECT_NEAR(all[0].alpha, 0.902830, 1e-6);
  EXPECT_NEAR(all[0].limit_1, 30.0083, 5e-4);
  EXPECT_NEAR(all[0].limit_2, 34.5550, 5e-4);
  EXPECT_NEAR(all[1].limit_1, 26.8493, 5e-5);
  // SHS 350x10 with 1500 kN, 100 and 60 kN m: psi 0.383532 and 0.630119
  const auto square = wall_classes(row("SHS 350x10"), 355e6, of(1500e3, 100e3, 60e3));
  EXPECT_NEAR(square[0].limit_3, 42.8990, 5e-5);
  EXPECT_NEAR(square[1].limit_3, 38.9228, 5e-5);
}

// One moment: c = 185 mm, 1 + N/(2 c t f_y) = 1 + N/(2 x 0.185 x 0.005 x 355 MPa) = 1 + N/656.75 kN, halved.
TEST(SectionClass, UnderOneMomentTheWallAcrossIsPressedAsAWhole) {
  for (const double N : {-600e3, -344.25e3, -1e3, 0.0, 200e3, 600e3}) {
    const auto y = wall_classes(row("SHS 200x5"), 355e6, of(N, 50e3, 0));
    EXPECT_NEAR(y[0].alpha, (1 + N / 656.75e3) / 2, 1e-12) << N;
    EXPECT_EQ(y[1].alpha, 1) << N;
    const auto z = wall_classes(row("SHS 200x5"), 355e6, of(N, 0, 50e3));
    EXPECT_NEAR(z[1].alpha, (1 + N / 656.75e3) / 2, 1e-12) << N;
    EXPECT_EQ(z[0].alpha, 1) << N;
  }
  // a pull that leaves no part of the webs pressed: 2 t (200 - 5) mm f_y = 692.25 kN
  const auto pulled = wall_classes(row("SHS 200x5"), 355e6, of(-800e3, 5e3, 0));
  EXPECT_EQ(pulled[0].alpha, 0);
  EXPECT_EQ(pulled[1].alpha, 1);
}

// A square box bent over its corner: the neutral axis is its diagonal, two walls are pressed as a whole. c/t = 37 is
// above 38 sqrt(235/275) = 35.13; psi = 0: 42 sqrt(235/275)/0.67 = 57.95.
TEST(SectionClass, BentOverItsCornerABoxHasTwoWallsPressed) {
  const WallClass w = section_class(row("SHS 200x5"), 275e6, of(0, 44.55e3, 44.55e3));
  EXPECT_EQ(w.alpha, 1);
  EXPECT_EQ(w.value, 3);
  EXPECT_NEAR(w.limit_2, 35.128, 1e-3);
  EXPECT_NEAR(w.limit_3, 57.949, 1e-3);
}

// Pulled and bent about one axis: the flange on the pressed side is pressed alike, 33, 38, 42 epsilon.
TEST(SectionClass, APullDoesNotRelieveTheFlangeThatIsPressed) {
  const WallClass w = section_class(row("SHS 200x5"), 355e6, of(-344.25e3, 92.34e3, 0));
  EXPECT_EQ(w.wall, "flange");
  EXPECT_NEAR(w.limit_2, 30.9174, 5e-5);
  EXPECT_NEAR(w.limit_3, 34.1719, 5e-5);
  EXPECT_EQ(w.value, 4);
}

/// Of the more pressed flat web and flange, by equal fibres on the middle lines of a box with yield stress in each; the
/// neutral axis is sought by halving its direction, and for each direction its place.
class Fibres {
 public:
  explicit Fibres(const catalogue::SectionRow& r) : flat_web_(flat(r.height, r)), flat_flange_(flat(r.width, r)) {
    const double H = r.height - r.thickness, B = r.width - r.thickness;
    for (int i = 0; i < count; ++i) {
      const double x = (i + 0.5) / count - 0.5;
      for (const double side : {-0.5, 0.5}) {
        all_.push_back({.y = side * B, .z = x * H, .area = r.thickness * H / count, .web = true, .more = side > 0});
        all_.push_back({.y = x * B, .z = side * H, .area = r.thickness * B / count, .web = false, .more = side > 0});
      }
    }
    size_ = H + B;
  }
  struct Alphas {
    double web, flange;
  };
  Alphas alphas(double yield, double N, double M_y, double M_z) const {
    double low = 0, high = M_PI / 2;  // of the normal of the neutral axis from y
    for (int k = 0; k < 40; ++k) {
      const double middle = (low + high) / 2, at = level(middle, yield, N);
      double about_y = 0, about_z = 0;
      for (const Fibre& f : all_) {
        const double force = (f.along(middle) > at ? 1 : -1) * f.area * yield;
        about_y += force * f.z;
        about_z += force * f.y;
      }
      (about_y * M_z < about_z * M_y ? low : high) = middle;
    }
    const double at = level(low, yield, N);
    return {.web = share(true, flat_web_, low, at), .flange = share(false, flat_flange_, low, at)};
  }

 private:
  static constexpr int count = 2000;
  struct Fibre {
    double y, z, area;
    bool web, more;
    double along(double angle) const { return y * std::cos(angle) + z * std::sin(angle); }
  };
  static double flat(double side, const catalogue::SectionRow& r) { return side - 3 * r.thickness; }
  double level(double angle, double yield, double N) const {
    double low = -size_, high = size_;
    for (int k = 0; k < 40; ++k) {
      const double middle = (low + high) / 2;
      double sum = 0;
      for (const Fibre& f : all_) sum += (f.along(angle) > middle ? 1 : -1) * f.area * yield;
      (sum > N ? low : high) = middle;
    }
    return low;
  }
  double share(bool web, double flat, double angle, double at) const {
    double pressed = 0, whole = 0;
    for (const Fibre& f : all_) {
      if (f.web != web || !f.more || std::abs(web ? f.z : f.y) > flat / 2) continue;
      whole += 1;
      pressed += f.along(angle) > at ? 1 : 0;
    }
    return pressed / whole;
  }
  std::vector<Fibre> all_;
  double flat_web_, flat_flange_, size_ = 0;
};

/// The same box turned by a right angle.
catalogue::SectionRow turned(catalogue::SectionRow r) {
  std::swap(r.height, r.width);
  std::swap(r.W_el_y, r.W_el_z);
  return r;
}

TEST(SectionClass, ThePressedPartIsThatOfFibres) {
  struct Case {
    const char* section;
    double n, M_y, M_z;  // share of the thin box, and moments in any ratio
  };
  for (const Case& c : {Case{.section = "RHS 300x200x10", .n = 0.15, .M_y = 3, .M_z = 1},
                        Case{.section = "RHS 300x200x10", .n = -0.15, .M_y = 3, .M_z = 1},
                        Case{.section = "RHS 300x200x10", .n = 0, .M_y = 1, .M_z = 3},
                        Case{.section = "RHS 300x200x10", .n = 0.3, .M_y = 1, .M_z = 3},
                        Case{.section = "RHS 300x200x10", .n = -0.3, .M_y = 1, .M_z = 3},
                        Case{.section = "RHS 300x200x5", .n = -0.45, .M_y = 1, .M_z = 1},
                        Case{.section = "RHS 300x200x5", .n = -0.7, .M_y = 2, .M_z = 1.5},
                        Case{.section = "RHS 300x200x5", .n = -0.2, .M_y = 1.6, .M_z = 1},
                        Case{.section = "RHS 300x200x5", .n = 0.2, .M_y = 1.6, .M_z = 1},
                        Case{.section = "RHS 300x200x5", .n = 0.6, .M_y = 2, .M_z = 1},
                        Case{.section = "SHS 200x5", .n = 0, .M_y = 1, .M_z = 1},
                        Case{.section = "SHS 200x5", .n = 0, .M_y = 1, .M_z = 0.5},
                        Case{.section = "SHS 200x5", .n = 0.1, .M_y = 1, .M_z = 0.9},
                        Case{.section = "SHS 200x5", .n = -0.1, .M_y = 1, .M_z = 0.9},
                        Case{.section = "SHS 200x5", .n = -0.6, .M_y = 1, .M_z = 0.8},
                        Case{.section = "SHS 200x5", .n = -0.85, .M_y = 0.8, .M_z = 1},
                        Case{.section = "SHS 350x10", .n = 0.35, .M_y = 10, .M_z = 6},
                        Case{.section = "SHS 350x10", .n = -0.35, .M_y = 10, .M_z = 6}}) {
    const auto r = row(c.section);
    const double yield = 355e6, N = c.n * 2 * r.thickness * (r.height + r.width - 2 * r.thickness) * yield;
    const Fibres::Alphas fibres = Fibres(r).alphas(yield, N, c.M_y, c.M_z);
    const auto walls = wall_classes(r, yield, of(N, c.M_y * 1e3, c.M_z * 1e3));
    EXPECT_NEAR(walls[0].alpha, fibres.web, 3e-3) << c.section << " " << c.n << " " << c.M_y << " " << c.M_z;
    EXPECT_NEAR(walls[1].alpha, fibres.flange, 3e-3) << c.section << " " << c.n << " " << c.M_y << " " << c.M_z;
    const auto other = wall_classes(turned(r), yield, of(N, c.M_z * 1e3, c.M_y * 1e3));
    EXPECT_NEAR(other[1].alpha, walls[0].alpha, 1e-12);
    EXPECT_NEAR(other[0].alpha, walls[1].alpha, 1e-12);
    EXPECT_DOUBLE_EQ(other[1].limit_3, walls[0].limit_3);
    EXPECT_DOUBLE_EQ(other[0].limit_3, walls[1].limit_3);
  }
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
