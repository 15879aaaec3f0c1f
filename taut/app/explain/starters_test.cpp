#include "taut/app/explain/starters.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "taut/app/explain/explain_machine.hpp"
#include "taut/app/job.hpp"
#include "test/paths.hpp"

namespace starters_test {

using namespace taut;

TEST(Starters, EachRunsAndExplainsItself) {
  EXPECT_GE(app::starters().size(), 6U);
  for (const app::Starter& one : app::starters()) {
    const Result r = app::run(app::Job{.text = std::string(one.text), .name = one.name + ".yaml", .set = {}});
    EXPECT_EQ(exit_code(r), 0) << one.name << ": " << r.message << to_text(r.errors);
    EXPECT_FALSE(one.title.empty()) << one.name;
    EXPECT_EQ(one.text.front(), '#') << one.name << " begins with what it is";
  }
}

TEST(Starters, AreFoundByTheWordsOfTheTrade) {
  const auto name = [](const char* word) {
    const app::Starter* found = app::find_starter(word);
    return found == nullptr ? std::string() : found->name;
  };
  EXPECT_EQ(name("skyline"), "clamped_load");
  EXPECT_EQ(name("tackle"), "six_part_tackle");
  EXPECT_EQ(name("ropeway"), "counterweighted_ropeway");
  EXPECT_EQ(name("guyed_tower"), "guyed_tower");
  EXPECT_EQ(name("rope_saw"), "rope_saw_drive");
  EXPECT_EQ(name("running_skyline"), "running_skyline");
  EXPECT_EQ(name("terrain"), "skyline_over_terrain");
  EXPECT_EQ(name("e"), "") << "several";
  EXPECT_EQ(name(""), "");
}

TEST(Starters, NameTheSchemaForAnEditorAndStillRun) {
  const app::Starter* one = app::find_starter("skyline_over_terrain");
  ASSERT_NE(one, nullptr);
  const std::string deck = app::starter_deck(one->text);
  EXPECT_EQ(deck.substr(0, deck.find('\n')), "# yaml-language-server: $schema=taut.schema.json");
  const Result r = app::run(app::Job{.text = deck, .name = "line.yaml", .set = {}});
  EXPECT_EQ(exit_code(r), 0) << r.message << to_text(r.errors);
}

TEST(ExplainMachine, KnowsItsPartsAndEveryTableOfAnEquilibrium) {
  const std::string text = app::explain_machine("machine").value_or("");
  for (const app::Starter& one : app::starters()) {
    const Result r = app::run(app::Job{.text = std::string(one.text), .name = one.name + ".yaml", .set = {}});
    for (const Table& t : r.tables) {
      if (t.name.find('_') != std::string::npos && t.name != "rope_loads") continue;  // named by its analysis
      EXPECT_NE(text.find("\n  " + t.name + " "), std::string::npos) << one.name << ": " << t.name;
    }
  }
  for (const std::string& topic : app::machine_topics()) {
    EXPECT_NE(text.find(topic), std::string::npos) << topic;
    EXPECT_TRUE(app::explain_machine(topic)) << topic;
  }
  EXPECT_NE(app::explain_machine("rope_loads")->find("rope_loads[].tangential"), std::string::npos);
  EXPECT_NE(app::explain_machine("load_path")->find("load_path.carriage"), std::string::npos);
  EXPECT_FALSE(app::explain_machine("mast_section"));
}

TEST(ExplainMachine, ItsPagesOfTheoryAreThere) {
  const std::string text = app::explain_machine("machine").value_or("");
  std::size_t at = 0, pages = 0;
  while ((at = text.find('[', at)) != std::string::npos) {
    const std::string page = text.substr(at + 1, text.find(']', at) - at - 1);
    at += page.size();
    if (!page.ends_with(".md")) continue;
    ++pages;
    EXPECT_TRUE(std::filesystem::exists(taut_test::source_dir() / "docs/theory" / page)) << page;
  }
  EXPECT_GE(pages, 8U);
}

}  // namespace starters_test
