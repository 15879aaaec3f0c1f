#include "taut/app/cases/study_deck.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "taut/io/deck/document.hpp"
#include "taut/io/deck/read.hpp"

namespace taut::app::study_deck_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A block as a deck has it, and what is wrong with it.
template <class Request>
std::pair<Request, std::string> read(const std::string& yaml) {
  Request request;
  Diagnostics mistakes;
  const auto document = io::parse(yaml, "deck.yaml");
  if (!document) return {request, to_text(document.error())};
  io::read(document->root, Request::describe(), &request, "the block", mistakes);
  return {request, to_text(mistakes)};
}

std::string mistakes_of(const std::string& yaml) { return read<StudyRequest>(yaml).second; }

/// A study whose one input has this law, on the second line from the 12th column on.
std::string mistakes_of_law(const std::string& law) { return mistakes_of("of: [y]\nvary: {x: {" + law + "}}\n"); }

TEST(StudyDeck, AStudyNeedsNoMoreThanWhatVariesAndWhatIsAsked) {
  const auto [study, mistakes] = read<StudyRequest>("vary: {'a.b[0].c': {uniform: {low: 1 t, high: 2 t}}}\nof: [y]\n");
  ASSERT_THAT(mistakes, IsEmpty());
  ASSERT_EQ(study.vary.size(), 1U);
  EXPECT_EQ(study.vary[0].name, "a.b[0].c");
  EXPECT_EQ(study.vary[0].uniform->high, "2 t") << "the unit is that of a number which is not known here";
  EXPECT_EQ(study.points, StudyPoints::sobol);
  EXPECT_EQ(study.samples, 10000);
  EXPECT_EQ(study.seed, 1);
  EXPECT_EQ(study.confidence, 0.95);
  EXPECT_THAT(study.answer, ElementsAre("quantiles"));
  EXPECT_THAT(mistakes_of("of: [y]\n"), HasSubstr("'vary'"));
  EXPECT_THAT(mistakes_of("vary: {x: {list: [1, 2]}}\n"), HasSubstr("'of'"));
}

TEST(StudyDeck, EachKeyStandsForItself) {
  const auto [study, mistakes] = read<StudyRequest>(
      "vary:\n"
      "  x: {normal: {mean: 1 t, cov: 5 %}, truncate: [0.9 t, 1.1 t]}\n"
      "  z: {list: [1, 2, 3], weights: [0, 2, 1]}\n"
      "correlate: [[x, w, 0.5], {pair: [w, z, -0.25]}]\n"
      "of: [y, w]\n"
      "limit: {y: {at_most: 3 kN, allowed: 1e-3}}\n"
      "points: lhs\n"
      "answer: [quantiles, indices, tornado, form, sorm, importance]\n"
      "samples: 16\nseed: 0\nconfidence: 0.99\n");
  ASSERT_THAT(mistakes, IsEmpty());
  EXPECT_EQ(study.vary.at(0).normal->cov, "5 %");
  EXPECT_FALSE(study.vary.at(0).normal->sd.has_value());
  EXPECT_THAT(study.vary.at(0).truncate, ElementsAre("0.9 t", "1.1 t"));
  EXPECT_THAT(study.vary.at(1).weights, ElementsAre(0, 2, 1));
  ASSERT_EQ(study.correlate.size(), 2U);
  EXPECT_THAT(study.correlate[0].pair, ElementsAre("x", "w", "0.5"));
  EXPECT_THAT(study.correlate[1].pair, ElementsAre("w", "z", "-0.25"));
  EXPECT_EQ(study.limit.at(0).at_most, "3 kN");
  EXPECT_EQ(study.limit.at(0).allowed, 1e-3);
  EXPECT_EQ(study.points, StudyPoints::latin);
  EXPECT_EQ(study.answer.size(), 6U);
  EXPECT_EQ(study.samples, 16);
}

TEST(StudyDeck, ANumberHasExactlyOneLaw) {
  const std::string normal = "normal: {mean: 1, sd: 1}", list = "list: [1, 2]";
  EXPECT_THAT(mistakes_of_law(normal), IsEmpty());
  EXPECT_THAT(mistakes_of_law(list), IsEmpty());
  EXPECT_THAT(mistakes_of_law("from: 1, to: 2, steps: 4"), IsEmpty());
  EXPECT_THAT(mistakes_of_law(normal + ", " + list), HasSubstr("deck.yaml:2:"));
  EXPECT_THAT(mistakes_of_law("truncate: [1, 2]"), HasSubstr("normal")) << "the laws that there are";
  EXPECT_THAT(mistakes_of_law("normal: {mean: 1}"), HasSubstr("sd"));
  EXPECT_THAT(mistakes_of_law("normal: {mean: 1, sd: 1, cov: 1 %}"), HasSubstr("cov"));
  EXPECT_THAT(mistakes_of_law("norml: {mean: 1, sd: 1}"), HasSubstr("did you mean 'normal'"));
  EXPECT_THAT(mistakes_of_law("gumbel: {mode: 1}"), HasSubstr("'scale'"));
  EXPECT_THAT(mistakes_of("of: [y]\nvary: {x: {list: [1]}}\nlimit: {y: {allowed: 0.1}}\n"), HasSubstr("at_least"));
}

TEST(StudyDeck, ANumberOutsideItsRangeIsToldWhereItStands) {
  const std::string rest = "of: [y]\nvary: {x: {list: [1]}}\n";
  const auto refused = [&](const std::string& line) {
    EXPECT_THAT(mistakes_of(rest + line + "\n"), HasSubstr("deck.yaml:3:" + std::to_string(line.find(':') + 3)))
        << line;
  };
  refused("samples: 15");
  refused("samples: 100000001");
  refused("seed: -1");
  refused("confidence: 0.5");
  refused("confidence: 1");
  refused("points: halton");
  EXPECT_THAT(mistakes_of(rest + "samples: 100000000\nconfidence: 0.501\n"), IsEmpty());
  const std::string limit = "limit: {y: {at_most: 1, allowed: ";
  EXPECT_THAT(mistakes_of(rest + limit + "0}}\n"), HasSubstr("deck.yaml:3:34"));
  EXPECT_THAT(mistakes_of(rest + limit + "1}}\n"), HasSubstr("deck.yaml:3:34"));
  EXPECT_THAT(mistakes_of(rest + limit + "1e-12}}\n"), IsEmpty());
  EXPECT_THAT(mistakes_of_law("from: 1, to: 2, steps: 0"), HasSubstr("deck.yaml:2:35"));
  EXPECT_THAT(mistakes_of_law("weibull: {shape: 0, scale: 1}"), HasSubstr("deck.yaml:2:29"));
  EXPECT_THAT(mistakes_of_law("list: [1, 2], weights: [1, -1]"), HasSubstr("deck.yaml:2:"));
}

TEST(CalibrateDeck, BoundsAndFileMayStandWithoutTheirKeys) {
  const auto [brief, none] = read<CalibrateRequest>("free: {a.b: [1 m, 2 m]}\nmeasured: line.csv\n");
  const auto [whole, nothing] =
      read<CalibrateRequest>("free: {a.b: {range: [1 m, 2 m]}}\nmeasured: {file: line.csv}\n");
  ASSERT_THAT(none + nothing, IsEmpty());
  for (const CalibrateRequest& one : {brief, whole}) {
    ASSERT_EQ(one.free.size(), 1U);
    EXPECT_EQ(one.free[0].name, "a.b");
    EXPECT_THAT(one.free[0].range, ElementsAre("1 m", "2 m"));
    EXPECT_EQ(one.measured.file, "line.csv");
  }
  EXPECT_THAT(read<CalibrateRequest>("free: {a: [1, 2]}\n").second, HasSubstr("'measured'"));
  EXPECT_THAT(read<CalibrateRequest>("measured: line.csv\n").second, HasSubstr("'free'"));
}

}  // namespace taut::app::study_deck_test
