#include "taut/app/terrain.hpp"

#include <gtest/gtest.h>

namespace taut::app::terrain_test {

TEST(Terrain, ReadsTheColumnsThatItNeeds) {
  for (const char* text :
       {"x,z\n0,1\n2.5,-3\n", "\xEF\xBB\xBFname;z [m];x [m]\r\na;1;0\r\n# half way\r\nb;-3;2.5\r\n\r\n",
        "\"x_m\"\t\"z_m\"\n0\t1\n2.5\t-3"}) {
    model::description::Terrain terrain;
    Diagnostics mistakes;
    read_terrain(text, "p.csv", terrain, mistakes);
    EXPECT_TRUE(mistakes.empty()) << to_text(mistakes);
    EXPECT_EQ(terrain.x, (std::vector<double>{0, 2.5}));
    EXPECT_EQ(terrain.z, (std::vector<double>{1, -3}));
  }
}

TEST(Terrain, TellsWhatIsWrongAtItsLine) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"", "p.csv:1:1: error: a ground profile has two points"},
      {"x,z\n1,2\n", "two points"},
      {"a,b\n1,2\n", "p.csv:1:1: error: the first line names the columns"},
      {"x [ft],z\n1,2\n", "the first line names the columns"},
      {"x,z\n1,2\n2\n3,1\n", "p.csv:3:1: error: the line has 1 cells"},
      {"x,z\n1,2\nb,3\n4,4\n", "p.csv:3:1: error: x: "},
      {"x,z\n1,2\n2,\n4,4\n", "p.csv:3:1: error: z: "},
      {"x,z\n1,2\n1,3\n", "p.csv:3:1: error: x has to grow"},
  };
  for (const auto& [text, expected] : rows) {
    model::description::Terrain terrain;
    Diagnostics mistakes;
    read_terrain(text, "p.csv", terrain, mistakes);
    EXPECT_NE(to_text(mistakes).find(expected), std::string::npos) << text << "\n" << to_text(mistakes);
  }
}

}  // namespace taut::app::terrain_test
