#include "taut/results/answers/key_figure.hpp"

#include <gtest/gtest.h>

namespace taut::results::key_figure_test {

TEST(KeyFigure, TheFirstOfTheMostWantedKindIsTaken) {
  KeyFigure key;
  key.offer(Pictured::machine, "machine");
  EXPECT_EQ(key.name, "machine");
  key.offer(Pictured::load_path, "load_path_profile");
  key.offer(Pictured::load_path, "load_path_profile_2");
  key.offer(Pictured::motion, "motion");
  EXPECT_EQ(key.name, "load_path_profile");
  key.offer(Pictured::payload, "");
  EXPECT_EQ(key.name, "load_path_profile") << "a figure without a name can't be found";
}

TEST(KeyFigure, WhatIsNotJudgedGoesBehindWhatIs) {
  KeyFigure key;
  key.offer(Pictured::payload, "payload_profile", false);
  EXPECT_EQ(key.name, "payload_profile") << "there is nothing else";
  key.offer(Pictured::machine, "machine");
  EXPECT_EQ(key.name, "payload_profile");
  key.offer(Pictured::modes, "mode_1");
  EXPECT_EQ(key.name, "mode_1");
}

}  // namespace taut::results::key_figure_test
