#include "taut/app/fingerprint.hpp"

#include <gtest/gtest.h>

TEST(Fingerprint, IsSha1) {
  // test vectors of RFC 3174
  EXPECT_EQ(taut::app::fingerprint("abc"), "a9993e364706816aba3e25717850c26c9cd0d89d");
  EXPECT_EQ(taut::app::fingerprint(""), "da39a3ee5e6b4b0d3255bfef95601890afd80709");
}

TEST(Fingerprint, IsOfEverythingThatWasRead) {
  using taut::app::fingerprint;
  EXPECT_EQ(fingerprint("abc", {}, {}), fingerprint("abc"));
  const std::vector<std::string> all = {
      fingerprint("d", {}, {}),          fingerprint("d", {"ab", "c"}, {}), fingerprint("d", {"a", "bc"}, {}),
      fingerprint("d", {"c", "ab"}, {}), fingerprint("d", {"abc"}, {}),     fingerprint("d", {}, {"abc"}),
      fingerprint("d", {"ab"}, {"c"}),   fingerprint("d", {}, {"ab", "c"}), fingerprint("dabc", {}, {})};
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(all[i], all[j]) << i << " " << j;
  }
}
