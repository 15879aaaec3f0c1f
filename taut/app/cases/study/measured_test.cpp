#include "taut/app/cases/study/measured.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace taut::app::measured_test {

using testing::ElementsAre;
using testing::HasSubstr;

/// Two outputs of different kinds and one setting behind a free number.
CaseModel line() {
  CaseModel m;
  m.inputs = {{.path = "free", .unit = si::one, .range = {}, .base = 1},
              {.path = "machine.loads[0].mass", .unit = si::kg, .range = {}, .base = 1000}};
  m.outputs = {{.name = "equilibrium.sky.T_start", .unit = si::N, .label = {}},
               {.name = "equilibrium.sky.sag", .unit = si::m, .label = {}}};
  return m;
}

struct Read {
  MeasuredTable table;
  Measurements all;
  Diagnostics mistakes;
};

Read read(const std::string& csv) {
  Read r;
  r.table = read_measured(csv, "measured.csv", r.mistakes);
  if (r.mistakes.empty()) r.all = in_si(r.table, line(), 1, r.mistakes);
  return r;
}

constexpr const char* head = "output,value,sd,machine.loads[0].mass\n";
constexpr const char* tension = "equilibrium.sky.T_start,";
constexpr const char* sag = "equilibrium.sky.sag,";

TEST(Measured, NumbersAreInSiAndRowsOfOneSettingShareItsState) {
  const Read r = read(std::string("\xEF\xBB\xBF") + head + tension + "31.5 kN,150 N,1 t\n" + sag +
                      "42 cm,10 mm,1000 kg\n" + tension + "40 kN,0.2 kN,1.5 t\n");
  ASSERT_TRUE(r.mistakes.empty()) << to_text(r.mistakes);
  EXPECT_THAT(r.table.outputs, ElementsAre("equilibrium.sky.T_start", "equilibrium.sky.sag"));
  EXPECT_THAT(r.table.paths, ElementsAre("machine.loads[0].mass"));
  EXPECT_THAT(r.all.output, ElementsAre(0, 1, 0));
  EXPECT_THAT(r.all.values, ElementsAre(testing::DoubleEq(31500), testing::DoubleEq(0.42), testing::DoubleEq(40000)));
  EXPECT_THAT(r.all.sd, ElementsAre(testing::DoubleEq(150), testing::DoubleEq(0.01), testing::DoubleEq(200)));
  EXPECT_THAT(r.all.state, ElementsAre(0, 0, 1));
  EXPECT_THAT(r.all.states, ElementsAre(ElementsAre(1000), ElementsAre(1500)));
}

TEST(Measured, TheSdOfATemperatureIsADifference) {
  CaseModel model = line();
  model.outputs[0].unit = si::K.in("degC");
  for (const char* sd : {"2 K", "2 degC"}) {
    Diagnostics mistakes;
    const auto table =
        read_measured(std::string(head) + tension + "20 degC," + sd + ",1 t\n", "measured.csv", mistakes);
    const Measurements all = in_si(table, model, 1, mistakes);
    ASSERT_TRUE(mistakes.empty()) << to_text(mistakes);
    EXPECT_NEAR(all.values.at(0), 293.15, 1e-12);
    EXPECT_NEAR(all.sd.at(0), 2, 1e-12) << sd;
  }
}

TEST(Measured, TellsEachMistakeAtItsPlace) {
  const struct {
    std::string csv, place, words;
  } cases[] = {{head + std::string(tension) + "31.5 kg,150 N,1 t\n", "measured.csv:2:", "31.5 kg"},
               {head + std::string(tension) + "31.5 kN,150 N,1 t\n" + tension + "32 kN,,1 t\n",
                "measured.csv:3:", "in all or in none"},
               {"output,value,machine.loads[0].mass\n" + std::string(tension) + "31.5 kN,1 t\n" + sag + "42 cm,1 t\n",
                "measured.csv:3:", "need an sd each"},
               {head, "measured.csv:1:1", "it has no measurement"},
               {"value,sd\n1 N,1 N\n", "measured.csv:1:", "output"},
               {head + std::string(tension) + "31.5 kN,150 N\n", "measured.csv:2:", ""}};
  for (const auto& [csv, place, words] : cases) {
    const std::string text = to_text(read(csv).mistakes);
    EXPECT_THAT(text, HasSubstr(place)) << csv;
    EXPECT_THAT(text, HasSubstr(words)) << csv;
  }
}

}  // namespace taut::app::measured_test
