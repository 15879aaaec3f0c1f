#include "taut/app/methods.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "taut/app/job.hpp"
#include "test/paths.hpp"

namespace taut::app::methods_test {

TEST(Methods, AreFoundByName) {
  EXPECT_EQ(find_method("mast_section")->about->name, "mast_section");
  EXPECT_EQ(find_method("mast"), nullptr);
  EXPECT_EQ(method_names().size(), methods().size());
}

TEST(Methods, EachHasSourceScopeLimitsErrataAndAnExampleThatRuns) {
  for (const MethodEntry& m : methods()) {
    SCOPED_TRACE(m.about->name);
    EXPECT_FALSE(m.about->title.empty());
    EXPECT_FALSE(m.about->source.empty());
    EXPECT_FALSE(m.about->scope.empty());
    EXPECT_FALSE(m.about->limits.empty());
    EXPECT_FALSE(m.about->errata.empty());
    const Result r = run(Job{.text = std::string(m.example), .name = "example", .set = {}});
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    EXPECT_FALSE(r.steps.empty());
    EXPECT_FALSE(r.figures.empty());
    EXPECT_FALSE(r.comparisons.empty());
  }
}

/// "Suite.Name" of every GoogleTest test and rapidcheck property below a folder.
std::set<std::string> tests_below(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
    if (file.path().extension() != ".cpp") continue;
    std::ifstream in(file.path());
    for (std::string line; std::getline(in, line);) {
      std::string rest;
      for (const char* macro : {"TEST(", "RC_GTEST_PROP("}) {
        if (line.starts_with(macro)) rest = line.substr(std::string(macro).size());
      }
      const std::size_t comma = rest.find(", ");
      if (comma == std::string::npos) continue;
      names.insert(rest.substr(0, comma) + "." +
                   rest.substr(comma + 2, rest.find_first_of(",)", comma + 2) - comma - 2));
    }
  }
  return names;
}

TEST(Methods, EveryErratumNamesATestThatExistsAndStandsInTheDocs) {
  std::set<std::string> tests = tests_below(taut_test::source_dir() / "test/cases");
  tests.merge(tests_below(taut_test::source_dir() / "taut/methods"));
  for (const MethodEntry& m : methods()) {
    std::ifstream file(taut_test::source_dir() / "docs/methods" / (m.about->name + ".md"));
    std::stringstream page;
    page << file.rdbuf();
    for (const Erratum& e : m.about->errata) {
      EXPECT_TRUE(tests.contains(e.test)) << m.about->name << " " << e.where << ": there is no test " << e.test;
      // a page may name the suite once, above its table
      const std::size_t dot = e.test.find('.');
      const std::string suite = e.test.substr(0, dot), alone = "`" + e.test.substr(dot + 1) + "`";
      const bool in_full = page.str().find(e.test) != std::string::npos;
      const bool below_suite =
          page.str().find(suite + ".NAME") < page.str().find(alone) && page.str().find(alone) != std::string::npos;
      EXPECT_TRUE(in_full || below_suite) << "docs/methods/" << m.about->name << ".md lacks " << e.test;
    }
  }
}

TEST(Methods, EveryValueOfAResultIsDescribed) {
  for (const MethodEntry& m : methods()) {
    const Result r = run(Job{.text = std::string(m.example), .name = "example", .set = {}});
    std::set<std::string> seen;
    for (const Value& v : r.values) {
      EXPECT_TRUE(seen.insert(v.name).second) << m.about->name << " says twice: " << v.name;
      EXPECT_FALSE(v.label.empty()) << m.about->name << ": " << v.name;
    }
  }
}

}  // namespace taut::app::methods_test
