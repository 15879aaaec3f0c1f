#include "taut/report/figure/svg_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

namespace taut::report::svg_profile_test {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A line of 200 m with a jack, its carriage's way, and a payload that two limits govern.
Profile profile_of_a_line() {
  Profile p;
  p.name = "payload_profile";
  p.title = "The line & what it carries";
  p.ground = {{0, 0}, {100, 10}, {200, 40}};
  p.supports = {{"stump", {0, 4}, 0}, {"jack", {100, 20}, 10}, {"tower", {200, 55}, 40}, {"far", {180, 70}, NAN}};
  p.ropes = {{"skyline", Role::rope, {{0, 4}, {100, 20}, {NAN, NAN}, {100, 20}, {200, 55}}},
             {"mainline", Role::second_rope, {{150, 30}, {200, 53}}}};
  p.carriage = "car";
  p.carriage_at = {150, 30};
  p.clearance = 3;
  p.value = {.label = "payload", .unit = si::kg.in("t")};
  p.limit = NAN;
  for (int i = 0; i <= 10; ++i) {
    const double x = 110 + 8 * i;
    Profile::Place place{
        .x = x, .z = 10 + 0.2 * x, .ground = 10 + 0.3 * (x - 100), .value = 1000.0 + 100 * i, .governs = {}};
    place.governs = i < 5 ? "tension of 'skyline'" : "clearance of the carriage";
    p.places.push_back(place);
  }
  p.decisive = 0;
  return p;
}

TEST(SvgProfile, ShowsTheLineAndWhatItCarries) {
  const std::string svg = profile_svg(profile_of_a_line(), Display());
  for (const char* words :
       {"class=\"profile\"", "jack, 10 m", "stump, 4 m", ">far<", ">skyline<", ">mainline<", ">way of car<",
        "clearance asked for, 3 m", "governs: tension of", ">car<", "least clearance", "height in m", "payload in t",
        "1 t at x = 110 m", "clearance of the carriage", "aria-label=\"The line &amp; what it carries\""}) {
    EXPECT_TRUE(has(svg, words)) << words;
  }
  EXPECT_FALSE(has(svg, "no answer")) << "every place has one";
  EXPECT_FALSE(has(svg, "nan"));
}

TEST(SvgProfile, TheLineOfTheDecisivePlaceLeavesTheLegendFree) {
  const std::string svg = profile_svg(profile_of_a_line(), Display());
  const std::regex line("class=\"event\" d=\"M([0-9.]+) ([0-9.]+)V([0-9.]+)\""),
      sample("class=\"sample [^>]* y=\"([0-9.]+)\"");
  std::vector<std::pair<double, double>> lines;
  for (std::sregex_iterator at(svg.begin(), svg.end(), line), end; at != end; ++at)
    lines.emplace_back(std::stod((*at)[2]), std::stod((*at)[3]));
  ASSERT_EQ(lines.size(), 2U) << "one in each picture";
  std::size_t samples = 0;
  for (std::sregex_iterator at(svg.begin(), svg.end(), sample), end; at != end; ++at, ++samples) {
    const double y = std::stod((*at)[1]);
    for (const auto& [top, bottom] : lines) EXPECT_TRUE(y > bottom || y < top) << y;
  }
  EXPECT_GT(samples, 0U);
}

TEST(SvgProfile, UnitsAreTheReaders) {
  const Display feet(std::map<std::string, std::string>{{"length", "ft"}, {"mass", "kg"}});
  const std::string svg = profile_svg(profile_of_a_line(), feet);
  EXPECT_TRUE(has(svg, "height in ft"));
  EXPECT_TRUE(has(svg, "payload in kg"));
  EXPECT_TRUE(has(svg, "1000 kg at x = 361 ft")) << svg;
}

TEST(SvgProfile, PlacesWithoutAnAnswerAreHatched) {
  Profile p = profile_of_a_line();
  p.places[4].value = p.places[4].z = NAN;
  p.places[4].governs.clear();
  EXPECT_TRUE(has(profile_svg(p, Display()), "no answer"));
}

TEST(SvgProfile, AFlatLineIsStretchedAndSaysSo) {
  EXPECT_TRUE(profile_scale_words(profile_of_a_line()).empty()) << profile_scale_words(profile_of_a_line());
  Profile flat = profile_of_a_line();
  const auto lower = [](double& z) { z *= 0.1; };
  for (Point& g : flat.ground) lower(g.y);
  for (auto& s : flat.supports) {
    lower(s.top.y);
    lower(s.ground);
  }
  for (auto& r : flat.ropes) {
    for (Point& q : r.points) lower(q.y);
  }
  for (auto& place : flat.places) lower(place.z);
  lower(flat.carriage_at.y);
  EXPECT_TRUE(has(profile_scale_words(flat), "times as large as lengths"));
}

TEST(SvgProfile, AStretchWithOneLimitIsOneSurface) {
  const std::string svg = profile_svg(profile_of_a_line(), Display());
  const auto surfaces = [&](const std::string& kind) {
    std::size_t count = 0;
    for (std::size_t at = svg.find("<path class=\"" + kind); at != std::string::npos;
         at = svg.find("<path class=\"" + kind, at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(surfaces("kind-0"), 1U);
  EXPECT_EQ(surfaces("kind-1"), 1U);
}

TEST(SvgProfile, ManyLimitsShareTheLastColour) {
  Profile p = profile_of_a_line();
  for (std::size_t i = 0; i < p.places.size(); ++i) p.places[i].governs = "limit " + std::to_string(i);
  const std::string svg = profile_svg(p, Display());
  EXPECT_TRUE(has(svg, "other limits"));
  EXPECT_FALSE(has(svg, ">limit 9<"));
}

TEST(SvgProfile, NothingToShowIsSaid) {
  EXPECT_TRUE(has(profile_svg(Profile(), Display()), "Nothing to draw"));
  EXPECT_TRUE(profile_scale_words(Profile()).empty());
}

/// The texts do not lie on each other: their boxes, estimated by their letters, have no common area.
TEST(SvgProfile, NoLabelLiesOnAnother) {
  const std::string svg = profile_svg(profile_of_a_line(), Display());
  struct Text {
    double x, y, wide;
    std::string text;
  };
  std::vector<Text> all;
  const std::regex label("<text class=\"label\" x=\"([0-9.]+)\" y=\"([0-9.]+)\" text-anchor=\"middle\">(.*?)</text>");
  const std::regex tag("<[^>]*>");
  for (std::sregex_iterator i(svg.begin(), svg.end(), label), end; i != end; ++i) {
    const std::string words = std::regex_replace((*i)[3].str(), tag, "");
    all.push_back({std::stod((*i)[1]), std::stod((*i)[2]), 6.0 * static_cast<double>(words.size()), words});
  }
  ASSERT_GT(all.size(), 6U);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      const bool apart_x = std::abs(all[i].x - all[k].x) >= (all[i].wide + all[k].wide) / 2;
      const bool apart_y = std::abs(all[i].y - all[k].y) >= 12;
      EXPECT_TRUE(apart_x || apart_y) << all[i].text << " / " << all[k].text;
    }
  }
}

}  // namespace taut::report::svg_profile_test
