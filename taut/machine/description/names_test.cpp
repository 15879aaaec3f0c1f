#include "taut/machine/description/names.hpp"

#include <gtest/gtest.h>

#include "taut/machine/compile.hpp"
#include "test/support/complaints.hpp"
#include "test/support/described.hpp"

namespace taut::machine::names_test {

using namespace described;

TEST(Names, NamesThatNothingHasAreToldWithoutLookingAtValues) {
  Machine m = line();
  m.ropes[0].mass = {};
  m.points[1].at = m.points[0].at;  // as if it had not been read
  m.carriages[0].mainline = "mian";
  m.carriages[0].rides = "";  // missing: reported when it was read
  m.reevings[0].path[2] = over("jak");
  m.reevings[1].path[0] = on_drum("winsh");
  m.loads.push_back({"cart", 100.0, {}});
  m.take_up.push_back({"slide", 100.0, {}});
  description::Guy guy;
  guy.name = "g";
  guy.rope = "wire";
  guy.from = "head";
  guy.to = "tial";
  m.guys = {guy};
  m.sheaves.push_back(m.supports[0]);
  m.sheaves[0].name = "block";
  m.sheaves[0].body = "mast";
  EXPECT_EQ(taut_test::lines_of(unknown_names(m)),
            "sheaves.block.body: there is no body 'mast'\n"
            "carriages.car.mainline: there is no reeving 'mian'; did you mean 'main'?\n"
            "reevings[0].path[2].over: there is no sheave or support 'jak'; did you mean 'jack'?\n"
            "reevings[1].path[0].drum: there is no drum 'winsh'; did you mean 'winch'?\n"
            "guys.g.rope: there is no rope 'wire'\n"
            "guys.g.to: there is no point or body 'tial'; did you mean 'tail'?\n"
            "loads[0].at: there is no body, carriage or point 'cart'; did you mean 'car'?\n"
            "take_up[0].body: there is no body or carriage 'slide'\n");
  for (const Machine& good : {line(), tackle(4, {anchor("lead"), falls(4, "head", "block"), anchor("eye")})}) {
    EXPECT_EQ(taut_test::lines_of(unknown_names(good)), "");
  }
}

}  // namespace taut::machine::names_test
