#include "taut/app/job.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "taut/io/file_reader.hpp"
#include "test/paths.hpp"

namespace taut::app::job_test {

const std::string mast =
    "taut: 1\ntitle: case A\nmethod: mast_section\ndisplay: {force: N}\ninput:\n  skyline_force: 100 kN\n  "
    "mainline_force: 40 kN\n"
    "  skyline_block_height: 8 m\n  branch_angle: 12 deg\n  wrap: paper\n  allowable_stress: 160 MPa\n";

TEST(Job, RunsADeck) {
  const Result r = run(Job{.text = mast, .name = "mast.yaml", .set = {}});
  ASSERT_EQ(r.status, Status::ok) << to_text(r.errors);
  EXPECT_EQ(r.title, "case A");
  EXPECT_EQ(r.deck_name, "mast.yaml");
  EXPECT_EQ(r.display.at("force"), "N");
  EXPECT_NEAR(r.find_value("N")->value, 162638.979, 1e-3);
}

// --set analyses=[...] leaves out the deck's own analyses and their checks. A warning names those that are gone.
TEST(Job, AnalysesThatArePutAsideAreNamed) {
  const std::string deck =
      "taut: 1\nmachine:\n  points: {top: [0 m, 0 m, 9 m]}\n  ropes: {r: {mass: 0 kg/m, stiffness: 10 MN}}\n"
      "  bodies: {hook: {mass: 1 t, at: [0 m, 0 m, 4 m], free: [x, z]}}\n"
      "  reevings: [{rope: r, path: [{anchor: top}, {anchor: hook}], length: 5 m}]\n"
      "analyses:\n  - equilibrium: {}\n"
      "  - sweep: {name: more, parameter: 'bodies.hook.mass', from: 1 t, to: 2 t, steps: 2}\n";
  const auto warnings = [&](const std::vector<std::string>& set) {
    const Result r = run(Job{.text = deck, .name = "d", .set = set});
    EXPECT_EQ(r.status, Status::ok) << r.message << to_text(r.errors);
    return fmt::format("{}", fmt::join(r.warnings, "; "));
  };
  EXPECT_EQ(warnings({}).find("do not count here"), std::string::npos);
  const std::string told = warnings({"analyses=[{equilibrium: {}}]"});
  EXPECT_NE(told.find("do not count here, and their checks are not made: sweep 'more'"), std::string::npos) << told;
}

TEST(Job, HashFollowsTextAndOverrides) {
  const std::string plain = run(Job{.text = mast, .name = "a", .set = {}}).deck_hash;
  EXPECT_EQ(plain, run(Job{mast, "b", {}}).deck_hash);
  EXPECT_NE(plain, run(Job{mast + "# x\n", "a", {}}).deck_hash);
  EXPECT_NE(plain, run(Job{mast, "a", {"input.branch_angle=13 deg"}}).deck_hash);
}

TEST(Job, FindsMistakesOfHeadFieldsAndRulesInOneGo) {
  const Diagnostics mistakes =
      check(Job{.text = mast + "  span: {length: 200 m}\ncolour: red\n", .name = "m", .set = {}});
  EXPECT_GE(mistakes.size(), 2U);
  EXPECT_TRUE(check(Job{mast, "m", {}}).empty());
}

TEST(Job, AMissingIncludeIsAMistake) {
  // a deck that includes nothing readable is a mistake, not an exception; what its part may hold is not missed too
  const Result r = run(
      Job{.text = "taut: 1\ninclude: nowhere.part.yaml\nmethod: mast_section\ninput: {}\n", .name = "m", .set = {}});
  EXPECT_EQ(r.status, Status::bad_deck);
  EXPECT_EQ(r.errors.size(), 1U) << to_text(r.errors);
}

/// A field whose expression has no value is given: it is not missed too.
TEST(Job, AFailedExpressionIsOneMistake) {
  const std::string deck = R"(taut: 1
parameters: {F: 3 kN}
machine:
  points: {top: [0 m, 0 m, 20 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 50 MN, breaking_force: 200 kN}}
  bodies: {b: {mass: 1 t, at: [0 m, 0 m, 0 m], free: [z]}}
  reevings: [{rope: r, path: [{anchor: top}, {anchor: b}], length: 20 m}]
  loads: [{at: b, force: [0 kN, 0 kN, = min(F - 3)]}]
)";
  const Diagnostics mistakes = check(Job{.text = deck, .name = "d", .set = {}});
  ASSERT_EQ(mistakes.size(), 1U) << to_text(mistakes);
  EXPECT_NE(mistakes[0].message.find("the left side is in kg m s^-2"), std::string::npos) << mistakes[0].message;
}

// What `check` refuses a run refuses, and the other way round. Of a study of other analyses nothing is said.
TEST(Job, AMistakeOfABlockThatARunLeavesOutIsOneOfTheDeck) {
  const auto job = [](const std::string& blocks, const std::vector<std::string>& set) {
    return Job{.text = R"(taut: 1
machine:
  points: {top: [0 m, 0 m, 20 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 50 MN, breaking_force: 200 kN}}
  bodies: {b: {mass: 1 t, at: [0 m, 0 m, 0 m], free: [z]}}
  reevings: [{rope: r, path: [{anchor: top}, {anchor: b}], length: 20 m}]
analyses: [{transient: {duration: 0.01 s}}]
)" + blocks,
               .name = "d",
               .set = set};
  };
  const std::string good =
      "study: {vary: {'analyses[0].transient.duration': {normal: {mean: 0.01 s, cov: 0.1}}}, of: [transient.T_max]}\n";
  const std::string bad =
      "study: {vary: {machine.bodies.b.mass: {normal: {mean: 2 m, cov: 0.1}}}, of: [transient.T_max]}\n";
  const std::string lost = "calibrate: {free: {machine.bodies.b.mass: {}}, measured: {file: nowhere.csv}}\n";
  const std::vector<std::string> none, other = {"analyses=[{equilibrium: {}}]"};
  EXPECT_EQ(run(job(good, none)).status, Status::ok) << to_text(run(job(good, none)).errors);
  EXPECT_EQ(run(job(good, other)).status, Status::ok) << to_text(run(job(good, other)).errors);
  for (const std::string& blocks : {bad, lost}) {
    const Result r = run(job(blocks, none));
    EXPECT_EQ(r.status, Status::bad_deck) << blocks;
    EXPECT_EQ(to_text(r.errors), to_text(check(job(blocks, none))));
    EXPECT_EQ(r.errors.size(), 1U) << to_text(r.errors);
  }
}

/// Gives the files of a map, and notes what it was asked for.
struct Given {
  std::map<std::string, std::string> files;
  std::vector<std::string> asked = {};
  io::FileReader reader() {
    return [this](const std::string& path) -> tl::expected<std::string, io::Unreadable> {
      asked.push_back(path);
      const auto found = files.find(path);
      if (found == files.end()) return tl::unexpected(io::Unreadable{.message = "not given", .missing = true});
      return found->second;
    };
  }
};

/// An empty file is no state to go on from: the motion must not begin anew in its place.
TEST(Job, AnEmptyFileIsNoSavedState) {
  Given given{.files = {{"empty.state", ""}}};
  const Result r = run(Job{.text = R"(taut: 1
machine:
  points: {top: [0 m, 0 m, 20 m]}
  ropes: {r: {mass: 0 kg/m, stiffness: 50 MN, breaking_force: 200 kN}}
  bodies: {load: {mass: 1 t, at: [0 m, 0 m, 0 m], free: [z]}}
  reevings: [{rope: r, path: [{anchor: top}, {anchor: load}], length: 20 m}]
analyses: [{transient: {duration: 0.1 s, restart: empty.state}}]
)",
                           .name = "deck.yaml",
                           .set = {},
                           .progress = {},
                           .read = given.reader()});
  EXPECT_EQ(r.status, Status::infeasible) << to_text(r.errors);
  EXPECT_NE(r.message.find("'empty.state': it is no saved state of a transient"), std::string::npos) << r.message;
}

TEST(Job, FilesThatADeckNamesComeFromItsReader) {
  Given given{.files = {{"decks/mast.part.yaml", mast}}};
  const Result r = run(Job{
      .text = "include: mast.part.yaml\n", .name = "decks/a.yaml", .set = {}, .progress = {}, .read = given.reader()});
  EXPECT_EQ(r.status, Status::ok) << to_text(r.errors);
  EXPECT_EQ(given.asked, std::vector<std::string>{"decks/mast.part.yaml"});
  EXPECT_EQ(r.deck_hash, run(Job{.text = "include: mast.part.yaml\n",
                                 .name = "decks/a.yaml",
                                 .set = {},
                                 .progress = {},
                                 .read = given.reader()})
                             .deck_hash);
}

TEST(Job, NoDeckReachesTheDiskPastItsReader) {
  // included decks, terrain, states, also those that --set names
  const std::string place = (taut_test::source_dir() / "LICENSE").string();
  const std::string machine =
      fmt::format("taut: 1\nmachine:\n  terrain: {{file: {}}}\nanalyses:\n  - {{type: equilibrium}}\n", place);
  for (const auto& [text, set] : std::vector<std::pair<std::string, std::string>>{
           {fmt::format("{}include: {}\n", mast, place), "title=b"},
           {machine, "title=b"},
           {"taut: 1\nmachine: {}\nanalyses: []\n", fmt::format("machine.terrain={{file: {}}}", place)}}) {
    Given given;
    const Result r = run(Job{.text = text, .name = "a.yaml", .set = {set}, .progress = {}, .read = given.reader()});
    EXPECT_EQ(r.status, Status::bad_deck);
    EXPECT_EQ(given.asked, std::vector<std::string>{place}) << text;
    EXPECT_NE(to_text(r.errors).find("not given"), std::string::npos) << to_text(r.errors);
  }
}

TEST(Job, MissingFileIsAFileError) { EXPECT_FALSE(read_job("/nowhere/at/all.yaml").has_value()); }

}  // namespace taut::app::job_test
