#include "taut/report/html.hpp"

#include <gtest/gtest.h>

#include "test/golden/made_result.hpp"

namespace html_test {

using namespace taut;

int count(const std::string& text, const std::string& what) {
  int n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

TEST(Html, IsOneLightSelfContainedFile) {
  const std::string page = report::to_html(taut_test::made_result());
  EXPECT_LT(page.size(), 500'000U);
  EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
  for (const char* outside : {"http://", "https://", "src=\"", "<link", "@import", "<script"}) {
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  }
}

TEST(Html, SameResultSameBytes) {
  EXPECT_EQ(report::to_html(taut_test::made_result()), report::to_html(taut_test::made_result()));
}

TEST(Html, EscapesWhatComesFromTheDeck) {
  Result r = taut_test::made_result();
  r.title = "</title></style><script>alert(1)</script>\" onload='x' \x01\x1b[31m\xff {{css}}";
  r.deck_name = "<img src=x>.yaml";
  r.project.author = "<em>A. Meier";
  r.given.push_back({"<b>", "<u>x", "<words>", si::m, {}, "<text>\"", false});
  const std::string page = report::to_html(r);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_NE(page.find("calculated by &lt;em&gt;A. Meier"), std::string::npos);
  EXPECT_EQ(page.find("<words>"), std::string::npos);
  EXPECT_EQ(page.find("<u>x"), std::string::npos);
  EXPECT_EQ(page.find('\x1b'), std::string::npos);
  EXPECT_EQ(page.find('\x01'), std::string::npos);
  EXPECT_EQ(count(page, "</style>"), 1);
  EXPECT_EQ(count(page, "</title>"), 1);
  EXPECT_NE(page.find("{{css}}"), std::string::npos);
}

TEST(Html, KeepsTheOrderThatAnEngineerReads) {
  Result r = taut_test::made_result();
  r.values.back().detail = true;
  const std::string page = report::to_html(r);
  std::size_t last = 0;
  for (const char* id : {"<nav>", "id=\"page-1\"", "<h1>", "class=\"verdict bad\"", "class=\"foot\"", "id=\"warnings\"",
                         "id=\"inputs\"", "id=\"checks\"", "id=\"comparison\"", "id=\"calculation\"", "id=\"results\"",
                         "id=\"assumptions\"", "id=\"pictures\"", "id=\"appendix\""}) {
    const std::size_t at = page.find(id);
    ASSERT_NE(at, std::string::npos) << id;
    EXPECT_GT(at, last) << id;
    last = at;
  }
  for (const char* id : {"page-1", "inputs", "appendix"}) {
    EXPECT_EQ(count(page, std::string("<a href=\"#") + id + "\""), 1) << id;
    EXPECT_EQ(count(page, std::string(" id=\"") + id + "\""), 1) << id;
  }
}

TEST(Html, TheAppendixIsFoldedAndPrintedOnlyWhenAskedFor) {
  Result r = taut_test::made_result();
  r.values.back().detail = true;
  const std::string without = report::to_html(r), with = report::to_html(r, {.appendix = true});
  const auto appendix = [](const std::string& page) { return page.substr(page.find("<section id=\"appendix\"")); };
  EXPECT_EQ(appendix(without).find("<details open"), std::string::npos);
  EXPECT_NE(appendix(with).find("<details open"), std::string::npos);
  EXPECT_NE(without.find("#appendix{display:none}"), std::string::npos);
  EXPECT_EQ(with.find("#appendix{display:none}"), std::string::npos);
  EXPECT_NE(without.find("compliance of the guyed head"), std::string::npos);
}

TEST(Html, HasPagesOfThePaper) {
  const Result r = taut_test::made_result();
  EXPECT_NE(report::to_html(r).find("@page{size:A4"), std::string::npos);
  EXPECT_NE(report::to_html(r, {.paper = report::Paper::a3}).find("@page{size:A3"), std::string::npos);
}

/// No table is set in a smaller size than another, none below 8 pt in print.
TEST(Html, HasNoSmallPrint) {
  const std::string page = report::to_html(taut_test::made_result());
  const std::string print = page.substr(page.find("@media print"));
  for (std::size_t at = print.find("pt;"); at != std::string::npos; at = print.find("pt;", at + 1)) {
    const std::size_t from = print.rfind(':', at) + 1;
    if (print.substr(from - 10, 10) != "font-size:") continue;
    EXPECT_GE(std::stod(print.substr(from)), 8) << print.substr(from, at - from);
  }
}

TEST(Html, LinksTheCsvFilesBesideIt) {
  const std::string page = report::to_html(taut_test::made_result());
  EXPECT_NE(page.find("all in <a href=\"positions.csv\">positions.csv</a>"), std::string::npos);
}

TEST(Html, IsCompleteForEveryStatusAndForNothing) {
  Result r;
  EXPECT_TRUE(report::to_html(r).find("Not judged") != std::string::npos);
  r.status = Status::infeasible;
  r.message = "no grip: raise the wrap angle";
  EXPECT_NE(report::to_html(r).find("no grip: raise the wrap angle"), std::string::npos);
  r.status = Status::bad_deck;
  r.errors.push_back(
      {"deck.yaml", {.line = 12, .column = 3}, "'diamter' is not a field of rope", "  diamter: 12 mm", 7});
  const std::string page = report::to_html(r);
  EXPECT_NE(page.find("deck.yaml:12:3"), std::string::npos);
  EXPECT_NE(page.find("^~~~~~"), std::string::npos);
}

}  // namespace html_test
