#include "taut/app/methods.hpp"

#include <gtest/gtest.h>

#include <set>

#include "taut/app/job.hpp"

namespace taut::app {
namespace {

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
    const Result r = run(Job{std::string(m.example), "example", {}});
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    EXPECT_FALSE(r.steps.empty());
    EXPECT_FALSE(r.figures.empty());
    EXPECT_FALSE(r.comparisons.empty());
  }
}

TEST(Methods, EveryValueOfAResultIsDescribed) {
  for (const MethodEntry& m : methods()) {
    const Result r = run(Job{std::string(m.example), "example", {}});
    std::set<std::string> seen;
    for (const Value& v : r.values) {
      EXPECT_TRUE(seen.insert(v.name).second) << m.about->name << " says twice: " << v.name;
      EXPECT_FALSE(v.label.empty()) << m.about->name << ": " << v.name;
    }
  }
}

}  // namespace
}  // namespace taut::app
