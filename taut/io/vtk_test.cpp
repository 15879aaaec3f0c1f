#include "taut/io/vtk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace taut::io::vtk_test {

using testing::HasSubstr;

Scene falling() {
  Scene s;
  s.name = "motion";
  s.t = {0, 0.25};
  SceneLine rope{.name = "hoist",
                 .role = Role::rope,
                 .points = {{{0, 0, 10}, {0, 0, 5}}, {{0, 0, 10}, {1, 0, 6}, {0, 0, 4}}},
                 .tension = {}};
  rope.tension = {{100, 100}, {90, 90, 90}};
  s.lines = {rope, {.name = "empty", .role = Role::rope, .points = {{}, {}}, .tension = {}}};
  s.points = {{.name = "hook", .radius = 0.25, .at = {{0, 0, 5}, {0, 0, 4}}, .velocity = {{0, 0, 0}, {0, 0, -1.5}}}};
  return s;
}

TEST(Vtk, OneFileForEachTimeAndOneThatNamesThem) {
  const auto files = to_vtk(falling());
  ASSERT_EQ(files.size(), 3U);
  EXPECT_EQ(files[0].first, "motion_0000.vtp");
  EXPECT_EQ(files[2].first, "motion.pvd");
  EXPECT_THAT(files[2].second, HasSubstr("timestep=\"0.25\" part=\"0\" file=\"motion_0001.vtp\""));
}

TEST(Vtk, PointsLinesAndTheirData) {
  const std::string text = to_vtk(falling())[1].second;
  EXPECT_THAT(text, HasSubstr("NumberOfPoints=\"4\" NumberOfVerts=\"1\" NumberOfLines=\"1\""));
  EXPECT_THAT(text, HasSubstr("Name=\"tension\" NumberOfComponents=\"1\" format=\"ascii\">\n0\n90\n90\n90\n"));
  EXPECT_THAT(text, HasSubstr("Name=\"velocity\" NumberOfComponents=\"3\" format=\"ascii\">\n0 0 -1.5\n0 0 0\n"));
  EXPECT_THAT(text, HasSubstr("<Lines>\n<DataArray type=\"Int64\" Name=\"connectivity\" NumberOfComponents=\"1\" "
                              "format=\"ascii\">\n1 2 3\n"));
  EXPECT_THAT(text, HasSubstr("Name=\"part\" NumberOfComponents=\"1\" format=\"ascii\">\n2\n0\n"));
}

TEST(Vtk, WhatIsNotFiniteIsZero) {
  Scene s = falling();
  s.lines[0].points[0][0][2] = NAN;
  s.lines[0].tension[0][0] = NAN;
  EXPECT_EQ(to_vtk(s)[0].second.find("nan"), std::string::npos);
}

}  // namespace taut::io::vtk_test
