#include "taut/study/deck/parameter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "taut/machine/description/machine.hpp"

namespace taut::study::parameter_test {

class PutNumber : public testing::Test {
 protected:
  void SetUp() override {
    machine.loads.emplace_back();
    machine.loads[0].mass = 900;
    machine.loads[0].force = {3e3, 0, 4e3};
  }
  auto at(const std::string& path) { return find_parameter(machine::Machine::describe(), &machine, path); }

  machine::Machine machine;
};

TEST_F(PutNumber, ChangesWhatThePathLeadsTo) {
  EXPECT_TRUE(put(*at("loads[0].mass"), 1200).ok());
  EXPECT_EQ(machine.loads[0].mass, 1200);
}

TEST_F(PutNumber, RefusesWhatTheFieldDoesNotAllowAndLeavesTheOldNumber) {
  for (const double value : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const Outcome outcome = put(*at("loads[0].mass"), value);
    EXPECT_EQ(outcome.status, Status::infeasible) << value;
    EXPECT_NE(outcome.message.find("'loads[0].mass' must be"), std::string::npos) << outcome.message;
  }
  EXPECT_EQ(machine.loads[0].mass, 900);
}

TEST_F(PutNumber, HasOnePlaceUnderAllSpellings) {
  machine.loads[0].at = "car";
  for (const char* path : {"loads[0].mass", "loads.0.mass", "loads.car.mass", "machine.loads.car.mass"}) {
    EXPECT_EQ(at(path)->place, "loads[0].mass") << path;
  }
  EXPECT_EQ(at("loads[0].force.z")->place, "loads[0].force[2]");
  EXPECT_EQ(at("loads.car.force[2]")->place, "loads[0].force[2]");
  EXPECT_EQ(at("loads.car.force.angle")->place, "loads[0].force.angle");
}

TEST_F(PutNumber, RefusesANameThatFitsTwoEntries) {
  machine.loads.resize(3);
  machine.loads[0].at = "car";
  machine.loads[2].at = "car";
  machine.loads[2].mass = 100;
  const auto found = at("loads.car.mass");
  ASSERT_FALSE(found.has_value()) << found->place;
  EXPECT_NE(found.error().find("is the 'at' of 2 entries: write the index of one, [0], [2]"), std::string::npos)
      << found.error();
  EXPECT_EQ(at("loads[2].mass")->value, 100);
  machine.loads[2].name = "car";  // a name goes before a place
  EXPECT_EQ(at("loads.car.mass")->place, "loads[2].mass");
}

TEST_F(PutNumber, ANameWithADotGoesBeforeTheOneItBeginsWith) {
  machine.loads.resize(2);
  machine.loads[0].at = "mast";
  machine.loads[1].at = "mast.top";
  machine.loads[1].mass = 7;
  EXPECT_EQ(at("loads.mast.top.mass")->value, 7);
  EXPECT_EQ(at("loads.mast.mass")->value, 900);
}

TEST_F(PutNumber, AnAngleOfAForceHasNotTheRangeOfItsComponents) {
  const auto angle = at("loads[0].force.angle");
  ASSERT_TRUE(angle.has_value()) << angle.error();
  EXPECT_TRUE(angle->range().contains(-1e3));
  ASSERT_TRUE(put(*angle, 0).ok());
  EXPECT_NEAR(machine.loads[0].force->at(0), 5e3, 1e-9);
  EXPECT_NEAR(machine.loads[0].force->at(2), 0, 1e-9);
}

TEST_F(PutNumber, ReadsATextInTheUnitOfTheParameter) {
  const auto mass = at("loads[0].mass");
  std::vector<Complaint> complaints;
  EXPECT_EQ(value_of("1.2 t", *mass, "to", complaints), std::optional(1200.0));
  EXPECT_TRUE(complaints.empty());
  EXPECT_FALSE(value_of("1.2 kN", *mass, "from", complaints));
  EXPECT_FALSE(value_of("-1 kg", *mass, "to", complaints));
  ASSERT_EQ(complaints.size(), 2U);
  EXPECT_EQ(complaints[0].path, "from");
  EXPECT_NE(complaints[1].message.find("not -1 kg"), std::string::npos) << complaints[1].message;
}

}  // namespace taut::study::parameter_test
