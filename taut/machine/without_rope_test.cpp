#include "taut/machine/without_rope.hpp"

#include <gtest/gtest.h>

namespace taut::machine::without_rope_test {

Reeving named(const std::string& name) {
  Reeving rope;
  rope.name = name;
  return rope;
}

/// Two carriages: `first` rides on rope 2, is pulled by 0 and 1; `second` rides on 2, too, and is fixed to 3.
Model machine() {
  Model m;
  m.reevings = {named("main"), named("back"), named("track"), named("haul")};
  Carriage first{"first", 0, 2, 1, 0};
  first.haulback = 1;
  Carriage second{"second", 1, 2, 2, -1};
  second.grip_reeving = 3;
  m.carriages = {first, second};
  m.tensioners = {{0, true, {}}};
  return m;
}

TEST(WithoutRope, TheIndicesOfTheOthersFollow) {
  const auto m = without_rope(machine(), 0);
  ASSERT_TRUE(m);
  ASSERT_EQ(m->reevings.size(), 3U);
  const auto name = [&](int rope) { return m->reevings.at(static_cast<std::size_t>(rope)).name; };
  EXPECT_EQ(m->carriages[0].mainline, -1);
  EXPECT_EQ(name(m->carriages[0].haulback), "back");
  for (const Carriage& car : m->carriages) EXPECT_EQ(name(car.reeving), "track") << car.name;
  EXPECT_EQ(name(m->carriages[1].grip_reeving), "haul");
  EXPECT_TRUE(m->tensioners.empty());
}

TEST(WithoutRope, WhatCarriesACarriageStays) {
  EXPECT_FALSE(without_rope(machine(), 2));
  EXPECT_FALSE(without_rope(machine(), 3));
}

}  // namespace taut::machine::without_rope_test
