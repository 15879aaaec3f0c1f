#include "taut/app/fingerprint.hpp"

#include <gtest/gtest.h>

TEST(Fingerprint, IsSha1) {
  // test vectors of RFC 3174
  EXPECT_EQ(taut::app::fingerprint("abc"), "a9993e364706816aba3e25717850c26c9cd0d89d");
  EXPECT_EQ(taut::app::fingerprint(""), "da39a3ee5e6b4b0d3255bfef95601890afd80709");
}
