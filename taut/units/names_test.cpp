#include "taut/units/names.hpp"

#include <gtest/gtest.h>

#include <set>

namespace taut::names_test {

TEST(Names, AreUniqueAndNeverRefused) {
  std::set<std::string_view> seen;
  for (const NameRow& r : name_rows()) EXPECT_TRUE(seen.insert(r.name).second) << r.name;
  for (const RefusedName& r : refused_names()) EXPECT_TRUE(seen.insert(r.name).second) << r.name;
}

}  // namespace taut::names_test
