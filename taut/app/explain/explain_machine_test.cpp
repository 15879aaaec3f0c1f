#include "taut/app/explain/explain_machine.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

#include "test/paths.hpp"

namespace taut::app::explain_machine_test {

using testing::HasSubstr;

TEST(ExplainMachine, EveryTopicHasItsKeysOrItsLaw) {
  std::set<std::string> seen;
  for (const std::string& topic : machine_topics()) {
    EXPECT_TRUE(seen.insert(topic).second) << topic << " stands twice";
    const auto text = explain_machine(topic);
    ASSERT_TRUE(text) << topic;
    EXPECT_THAT(*text, HasSubstr(topic)) << topic;
  }
  EXPECT_FALSE(explain_machine("sheaf"));
}

TEST(ExplainMachine, AnalysesPartsAndBlocksHaveTheirPlaceInTheDeck) {
  EXPECT_THAT(*explain_machine("load_path"), HasSubstr("analyses: - load_path: "));
  EXPECT_THAT(*explain_machine("load_path"), HasSubstr("for each position of the carriage"));
  EXPECT_THAT(*explain_machine("sheaves"), HasSubstr("sheaves.NAME.efficiency"));
  EXPECT_THAT(*explain_machine("loads"), HasSubstr("loads[].mass"));
  EXPECT_THAT(*explain_machine("calibrate"), HasSubstr("docs/guide/study.md"));
}

TEST(ExplainMachine, ThePagesThatItNamesAreThere) {
  const std::string text = *explain_machine("machine");
  const std::regex page(R"(\[([a-z-]+\.md)\]|docs/(guide/[a-z-]+\.md))");
  int pages = 0;
  for (std::sregex_iterator one(text.begin(), text.end(), page), end; one != end; ++one, ++pages) {
    const std::string name = (*one)[1].matched ? "theory/" + (*one)[1].str() : (*one)[2].str();
    EXPECT_TRUE(std::filesystem::exists(taut_test::source_dir() / "docs" / name)) << name;
  }
  EXPECT_GT(pages, 10);
}

}  // namespace taut::app::explain_machine_test
