#include "taut/catalogue/trust.hpp"

#include <gtest/gtest.h>

namespace taut::catalogue::trust_test {

TEST(Trust, names_go_both_ways) {
  for (const Trust trust : {Trust::verified, Trust::derived, Trust::unverified}) {
    EXPECT_EQ(parse_trust(to_text(trust)), trust);
  }
  EXPECT_FALSE(parse_trust("Verified"));
  EXPECT_FALSE(parse_trust(""));
}

TEST(Trust, AsACheckHasItAndWhy) {
  EXPECT_EQ(trust_words(Trust::verified, "read"), "verified");
  EXPECT_EQ(trust_words(Trust::derived, ""), "derived");
  EXPECT_EQ(trust_words(Trust::unverified, "recalled"), "UNVERIFIED: recalled");
  EXPECT_EQ(trust_words(Trust::unverified, ""), "UNVERIFIED: its row of the catalogue says so");
}

TEST(Trust, order) {
  EXPECT_TRUE(at_least(Trust::verified, Trust::derived));
  EXPECT_TRUE(at_least(Trust::derived, Trust::derived));
  EXPECT_FALSE(at_least(Trust::unverified, Trust::derived));
  EXPECT_EQ(weaker(Trust::verified, Trust::unverified), Trust::unverified);
  EXPECT_EQ(weaker(Trust::derived, Trust::verified), Trust::derived);
}

}  // namespace taut::catalogue::trust_test
