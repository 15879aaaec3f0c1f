#include "taut/catalogue/lookup.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace taut::catalogue::lookup_test {

TEST(Lookup, normalised_names) {
  EXPECT_EQ(normalised("CHS 508\u00d716"), "chs508x16");
  EXPECT_EQ(normalised("6\u044536\u2013IWRC"), "6x36-iwrc");    // Cyrillic letter, en dash
  EXPECT_EQ(normalised("09\u04132\u0421"), "09\u04132\u0421");  // other Cyrillic letters stay
  EXPECT_EQ(normalised(""), "");
}

TEST(Lookup, names_are_compared_as_they_are_normalised) {
  const std::vector<std::string> names{"CHS 508\u00d716", "chs508x16", "chs508x1", "chs508x160",
                                       "508\u2013x",      "\u0413",    " ",        ""};
  for (const std::string& name : names) {
    for (const std::string& other : names) {
      const std::string wanted = normalised(other);
      EXPECT_EQ(is_named(name, wanted), normalised(name) == wanted) << name << " / " << other;
    }
  }
}

TEST(Lookup, nearest_names_first) {
  const std::vector<std::string> names{"S235", "S355", "S355H", "09G2S"};
  EXPECT_EQ(nearest_names("s355j", names, 2), (std::vector<std::string>{"S355", "S355H"}));
  EXPECT_TRUE(nearest_names("oak", names, 3).empty());
  EXPECT_TRUE(nearest_names("", names, 3).empty());
  EXPECT_TRUE(nearest_names(std::string(10'000, 's'), names, 3).empty());
}

TEST(Lookup, long_and_strange_names_stay_readable_in_messages) {
  EXPECT_EQ(in_quotes("a\nb"), "'a?b'");
  EXPECT_EQ(in_quotes(std::string(1'000'000, 'x')), fmt::format("'{}...'", std::string(60, 'x')));
  // A two-byte letter across the cut is left out whole.
  EXPECT_EQ(in_quotes(fmt::format("{}\u0413\u0413", std::string(59, 'x'))),
            fmt::format("'{}...'", std::string(59, 'x')));
}

TEST(Lookup, texts) {
  EXPECT_EQ(listed({"a", "b", "c"}, 2), "a, b and 1 more");
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(short_number(16.000000001), "16");
  EXPECT_EQ(to_text(LookupError{"no steel 'S350'", {"S355", "S235"}}),
            "no steel 'S350'; did you mean 'S355' or 'S235'?");
  EXPECT_EQ(to_text(LookupError{"no steel 'oak'", {}}), "no steel 'oak'");
}

}  // namespace taut::catalogue::lookup_test
