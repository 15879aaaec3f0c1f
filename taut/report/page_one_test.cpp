#include "taut/report/page_one.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "test/golden/made_result.hpp"

namespace taut::report::page_one_test {

using testing::HasSubstr;
using testing::Not;

std::size_t times(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

/// The made result passing.
Result passing() {
  Result r = taut_test::made_result();
  std::erase_if(r.checks, [](const Check& c) { return !c.passes; });
  r.warnings.clear();
  r.unsafe.clear();
  return r;
}

TEST(PageOne, HasTheOrderOfTheContract) {
  Result r = taut_test::made_result();
  r.answers = {{.label = "Build", .text = "CHS 610x25"}, {.label = "Carries", .text = "2.96 t"}};
  r.project.project = "Hinterwald";
  const std::string html = page_one(r).html;
  std::size_t last = 0;
  for (const char* part : {"<h1>", "Hinterwald", "class=\"verdict bad\"", "<dt>Build</dt><dd>CHS 610x25", "2.96 t",
                           "<figure class=\"key\"", "class=\"checks worst\"", "<aside>", "class=\"foot\""}) {
    const std::size_t at = html.find(part);
    ASSERT_NE(at, std::string::npos) << part;
    EXPECT_GT(at, last) << part;
    last = at;
  }
}

TEST(PageOne, ShowsTheFigureThatTheResultNames) {
  Result r = taut_test::made_result();
  EXPECT_EQ(page_one(r).figures.front(), &r.figures[0]);
  r.key_figure = "forces";
  EXPECT_EQ(page_one(r).figures.front(), &r.figures[2]);
  r.key_figure = "no such figure";
  EXPECT_EQ(page_one(r).figures.front(), &r.figures[0]);
  r.figures.clear();
  EXPECT_TRUE(page_one(r).figures.empty());
}

TEST(PageOne, ADrawingSaysWhichStateItShows) {
  Result r = passing();
  Drawing d = std::get<Drawing>(r.figures[0]);
  d.caption = "Equilibrium, inhaul.";
  r.figures[0] = d;
  EXPECT_THAT(page_one(r).html, HasSubstr("Equilibrium, inhaul."));
}

TEST(PageOne, OnlyWhatPassesIsSigned) {
  Result r = passing();
  r.project.checked_by = "B. Keller";
  EXPECT_THAT(page_one(r).html, HasSubstr("checked B. Keller"));
  for (const Status status : {Status::infeasible, Status::not_converged}) {
    r.status = status;
    EXPECT_THAT(page_one(r).html, Not(HasSubstr("class=\"signature\"")));
    EXPECT_THAT(page_one(r).html, HasSubstr("not for signature"));
  }
  EXPECT_THAT(page_one(taut_test::made_result()).html, HasSubstr("Fails: not for signature"));
  EXPECT_THAT(page_one(Result{}).html, HasSubstr("Not judged: not for signature"));
}

TEST(PageOne, EveryTextIsBounded) {
  Result r = taut_test::made_result();
  const std::string words = "many words ";
  std::string text;
  while (text.size() < 2000) text += words;
  r.title = r.source = r.method_title = r.deck_name = r.deck_hash = text;
  r.project = {.project = text, .number = text, .author = text, .checked_by = text, .date = text, .revision = text};
  r.overrides = {text, text};
  r.beside = {text};
  r.warnings.assign(30, text);
  r.unsafe = r.warnings;
  r.answers.assign(40, {.label = text, .text = text});
  r.checks.assign(60, make_check(text, 2, si::N, {.sense = Sense::at_most, .limit = 1, .rule = text, .trust = text}));
  for (std::size_t i = 0; i < r.checks.size(); ++i) r.checks[i].part = fmt::format("{}{}", text, i);
  r.figures.clear();
  const std::string html = page_one(r).html;
  EXPECT_LT(times(html, words), 700U);
  EXPECT_EQ(times(html, "<tr class="), 10U);
  EXPECT_EQ(times(html, "<dt>"), 13U);
  EXPECT_THAT(html, HasSubstr("28 more below"));
  EXPECT_THAT(html, HasSubstr("26 more on page 2"));
  const std::string full = full_texts_html(r);
  for (const char* name : {"Title:", "Project:", "Source:", "Verdict:", "Scope:", "Set over the deck:"}) {
    EXPECT_THAT(full, HasSubstr(name));
  }
}

TEST(PageOne, TheTextsComeBeforeThePicture) {
  Result r = taut_test::made_result();
  ASSERT_FALSE(page_one(r).figures.empty());
  r.answers.assign(12, {.label = "Build", .text = std::string(400, 'x')});
  r.warnings.assign(4, std::string(160, 'x'));
  const PageOne page = page_one(r);
  EXPECT_TRUE(page.figures.empty());  // no room: the picture stands among the others
  EXPECT_THAT(page.html, HasSubstr("class=\"room\""));
}

TEST(PageOne, WithoutChecksShowsTheFirstResults) {
  Result r = taut_test::made_result();
  r.checks.clear();
  EXPECT_THAT(page_one(r).html, HasSubstr("resultant on the skyline block"));
  r.values[0].detail = true;
  EXPECT_THAT(page_one(r).html, Not(HasSubstr("resultant on the skyline block")));
}

TEST(PageOne, ABadDeckShowsItsMistakes) {
  Result r;
  r.status = Status::bad_deck;
  for (int i = 0; i < 20; ++i) r.errors.push_back({"deck.yaml", {.line = i + 1, .column = 3}, "mistake", "  here", 4});
  const std::string html = page_one(r).html;
  EXPECT_THAT(html, HasSubstr("The deck has 20 mistakes"));
  EXPECT_THAT(html, HasSubstr("deck.yaml:8:3"));
  EXPECT_THAT(html, Not(HasSubstr("deck.yaml:9:3")));
  EXPECT_THAT(html, HasSubstr("12 more below"));
}

}  // namespace taut::report::page_one_test
