#include "taut/app/explain/explain_name.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "taut/app/explain/explain_machine.hpp"
#include "taut/app/job.hpp"
#include "taut/app/methods.hpp"
#include "test/paths.hpp"

namespace taut::app::explain_name_test {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string text_of(const std::string& name) { return explain_name(name).value_or("nothing"); }

TEST(ExplainName, OfAKeySaysMeaningUnitRangeDefaultPlaceAndALine) {
  const std::string text = text_of("reevings.length");
  for (const char* part :
       {"machine.reevings[].length\n", "unstretched length", "takes     m\n", "above 0 m", "may be left out",
        "part of   machine.reevings", "example   length: ", "related   rope, name, path"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  EXPECT_EQ(text_of("reevings.skyline.length"), text);
  EXPECT_EQ(text_of("machine.reevings[0].length"), text);
  EXPECT_THAT(text_of("design.seek"), HasSubstr("one of    lightest, smallest"));
}

TEST(ExplainName, OfARuleSaysLimitSourceAndTrust) {
  const std::string text = text_of("safety.skyline.ch");
  for (const char* part : {"limit     3\n", "source    SEILAPLAN", "trust     verified", "field: skyline.ch"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  EXPECT_THAT(text_of("layout.break_angle_empty"), HasSubstr("limit     3 deg"));
  EXPECT_THAT(text_of("safety.skyline"), HasSubstr("safety.skyline.ru"));
}

TEST(ExplainName, ListsAllThingsOfOneName) {
  const std::string text = text_of("friction");
  for (const char* part :
       {"machine.sheaves.NAME.friction", "machine.contacts[].static_friction", "friction.steel_dry"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  EXPECT_THAT(text_of("break_angle"), HasSubstr("analyses[].payload.limits.break_angle"));
}

TEST(ExplainName, KnowsMethodsPartsAnalysesAndTheirSingulars) {
  for (const std::string& topic : machine_topics()) {
    EXPECT_THAT(text_of(topic), HasSubstr(explain_machine(topic).value_or("?"))) << topic;
  }
  for (const std::string& method : method_names()) EXPECT_THAT(text_of(method), HasSubstr("Equations"));
  EXPECT_THAT(text_of("sheave"), HasSubstr("sheaves.NAME.efficiency"));
  EXPECT_THAT(text_of("jack"), HasSubstr("'supports'"));
}

TEST(ExplainName, FindsAWordInTheMeanings) {
  const std::string text = text_of("catenary");
  EXPECT_THAT(text, Not(HasSubstr("nothing")));
  EXPECT_THAT(text, HasSubstr("Nothing is named 'catenary'"));
}

TEST(ExplainName, OfAValueOfAnAnalysisSaysUnitAnalysisAndPage) {
  const std::string payload = text_of("payload_min");
  for (const char* part : {"payload_min\n", "meaning   least payload", "unit      t\n", "analysis `payload`",
                           "page      docs/theory/payload.md"}) {
    EXPECT_THAT(payload, HasSubstr(part));
  }
  EXPECT_THAT(text_of("clearance_min"), HasSubstr("over the ground"));
  EXPECT_THAT(text_of("cycle_time"), HasSubstr("analysis `cycle`"));
  EXPECT_THAT(text_of("design_trials"), HasSubstr("`design:`"));
  EXPECT_THAT(text_of("T_max"), StartsWith("T_max\n  meaning   largest tension\n"));
  EXPECT_THAT(text_of("T_max"), HasSubstr("ROPE.T_max"));
  EXPECT_THAT(text_of("skyline.base_tension"), HasSubstr("base tension"));
}

TEST(ExplainName, KnowsEveryValueOfTheseExamples) {
  const std::string examples = (taut_test::source_dir() / "examples").string();
  for (const char* deck :
       {"machines/running_skyline.yaml", "machines/skyline_over_terrain.yaml", "machines/guys_pulled_in_turn.yaml",
        "machines/guyed_tower.yaml", "motion/brake_stop.yaml", "design/crane_hoist.yaml"}) {
    const auto job = read_job(examples + "/" + deck);
    ASSERT_TRUE(job) << deck;
    const Result r = run(*job);
    ASSERT_FALSE(r.values.empty()) << deck << r.message << to_text(r.errors);
    for (const Value& v : r.values) EXPECT_TRUE(explain_name(v.name)) << deck << ": " << v.name;
  }
}

TEST(ExplainName, OfAValueWithAnEndingIsThatOfItsKind) {
  EXPECT_THAT(text_of("payload_min_uphill"), HasSubstr("'payload_min_uphill' is 'payload_min' with an ending"));
  EXPECT_THAT(text_of("frequency_2"), HasSubstr("undamped frequency"));
  EXPECT_THAT(text_of("safety_factor_min"), HasSubstr("breaking force over the largest tension"));
  EXPECT_THAT(text_of("car.z_max"), HasSubstr("BODY.z"));
}

// What the report calls a check or a table, with the names of the deck in it.
TEST(ExplainName, KnowsChecksAndTablesByTheirNamesInTheReport) {
  for (const auto& [name, words] : {std::pair("hoist.drum_ratio", "D/d of the worst drum"),
                                    {"r.on_sheave", "weakened on a sheave"},
                                    {"r.wire_stress_2", "the outer wires"},
                                    {"g1.guy_safety", "checks of a guy: NAME.guy_safety"},
                                    {"spans", "a row for: every"},
                                    {"design_active", "a table of results"},
                                    {"discard_hoist", "tables of results: discard_ROPE"}}) {
    EXPECT_THAT(text_of(name), HasSubstr(words)) << name;
  }
}

TEST(ExplainName, SuggestsForANameThatIsNone) {
  EXPECT_THAT(explain_name("paylaod_min").error(), HasSubstr("did you mean 'payload_min'?"));
  EXPECT_THAT(explain_name("frictoin").error(), HasSubstr("did you mean 'friction'?"));
  EXPECT_THAT(explain_name("sheav").error(), HasSubstr("did you mean 'sheaves'?"));
  EXPECT_THAT(explain_name("qqqqqq").error(), Not(HasSubstr("did you mean")));
  for (const char* odd : {"", ".", "..", "[", "a.b.c.d.e.f", "NAME"}) explain_name(odd);
}

}  // namespace taut::app::explain_name_test
