#include "taut/base/expects.hpp"

#include <gtest/gtest.h>

TEST(Expects, SaysNothingWhenThePromiseHolds) { EXPECT_NO_THROW(taut::expects(true, "fine")); }

TEST(Expects, NamesThePlaceOfTheBrokenPromise) {
  try {
    taut::expects(false, "the rope has two ends");
    FAIL() << "no exception";
  } catch (const taut::ContractViolation& e) {
    const std::string text = e.what();
    EXPECT_NE(text.find("expects_test.cpp:9: "), std::string::npos) << text;
    EXPECT_NE(text.find("the rope has two ends"), std::string::npos);
  }
}
