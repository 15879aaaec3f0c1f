#include "taut/io/deck/deck.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "taut/io/deck/include.hpp"
#include "taut/io/deck/override.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/io/deck/sample_test.hpp"
#include "taut/io/file.hpp"

namespace taut::io::deck_test {

namespace fs = std::filesystem;

const std::vector<std::string> methods = {"mast_section", "closed_loop"};
const std::string good = "taut: 1\nmethod: closed_loop\ninput:\n  span: 1 m\n  rope: {diameter: 2 mm}\n";

struct Reading {
  std::optional<Deck> deck;
  Sample sample;
  std::string text;
  std::size_t mistakes = 0;
};

Reading read_all(const std::string& text, const std::vector<std::string>& set = {},
                 const std::string& name = "deck.yaml") {
  Reading t;
  Diagnostics mistakes;
  t.deck = read_deck(text, name, set, methods, mistakes);
  if (t.deck) read(t.deck->input, Sample::describe(), &t.sample, t.deck->method, mistakes);
  t.text = to_text(mistakes);
  t.mistakes = mistakes.size();
  return t;
}

TEST(Deck, ReadsItsHead) {
  const Reading t = read_all("title: A loop\ndisplay: {force: kgf}\n" + good);
  ASSERT_TRUE(t.deck && t.mistakes == 0) << t.text;
  EXPECT_EQ(t.deck->title, "A loop");
  EXPECT_EQ(t.deck->method, "closed_loop");
  EXPECT_EQ(t.deck->display.quantity(9.80665, si::N), "1 kgf");
  EXPECT_DOUBLE_EQ(t.sample.span, 1);
}

TEST(Deck, ReadsTheProject) {
  const Reading t = read_all(good + "project: {number: 12, author: A. Meier, revision: B}\n");
  ASSERT_EQ(t.text, "");
  EXPECT_EQ(t.deck->project.number, "12");
  EXPECT_EQ(t.deck->project.author, "A. Meier");
  EXPECT_EQ(t.deck->project.revision, "B");
  EXPECT_EQ(t.deck->project.checked_by, "");
  EXPECT_THAT(read_all(good + "project: {nummer: 12}\n").text,
              testing::HasSubstr("'nummer' is not a field of project; did you mean 'number'?"));
}

TEST(Deck, AMachineComesWithItsAnalyses) {
  const Reading t = read_all("taut: 1\nmachine: {gravity: 1}\nanalyses: []\n");
  ASSERT_TRUE(t.deck);
  EXPECT_TRUE(t.deck->is_machine);
  ASSERT_EQ(t.deck->input.entries.size(), 2U);
  EXPECT_EQ(follow(t.deck->input, "machine.gravity").node->text, "1");
  for (const char* text : {"taut: 1\nmachine: {}\nmethod: closed_loop\n", "taut: 1\nmachine: {}\ninput: {}\n"}) {
    EXPECT_NE(read_all(text).text.find("belongs to a published method; this deck has a machine"), std::string::npos);
  }
  EXPECT_NE(read_all("analyses: []\n" + good).text.find("'analyses' belong to a machine"), std::string::npos);
}

TEST(Deck, TellsWhatIsWrongAroundTheInput) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"method: closed_loop\ninput: {}\n", "deck.yaml:1:1: error: the deck lacks 'taut: 1'"},
      {"taut: 2\nmethod: closed_loop\n", "deck.yaml:1:7: error: taut: the format of a deck is 1"},
      {"taut: '1'\nmethod: closed_loop\n", "write 'taut: 1'"},
      {"taut: 1\ninput: {}\n", "the deck lacks 'method', one of mast_section, closed_loop"},
      {"taut: 1\nmethod: closed_lop\n",
       "deck.yaml:2:9: error: there is no method 'closed_lop'; did you mean 'closed_loop'?"},
      {"taut: 1\nmethod: tackle\n", "the methods are mast_section, closed_loop"},
      {"taut: 1\nmethod: [closed_loop]\n", "not a list"},
      {"taut: 1\nmethod:\n", "method: one of"},
      {"taut: 1\nmethdo: closed_loop\n", "'methdo' is not a key of a deck; did you mean 'method'?"},
      {"taut: 1\nmethod: closed_loop\n", "closed_loop lacks 'span'"},
      {"taut: 1\nmethod: closed_loop\ninput:\n", "deck.yaml:3:1: error: closed_loop lacks 'span'"},
      {"taut: 1\nmethod: closed_loop\ninput: 5\n", "closed_loop: a map of fields is expected"},
      {"taut: 1\ntitle: {a: b}\n", "title: a text is expected"},
      {"display: {forse: kN}\n" + good,
       "deck.yaml:1:11: error: display: 'forse' is not a kind of quantity; did you mean"},
      {"display: {force: mm}\n" + good, "deck.yaml:1:18: error: display: 'mm' is a unit of length"},
      {"display: {angle: '%'}\n" + good,
       "deck.yaml:1:18: error: display: '%' shows slopes, and most angles are none: angles are shown in deg, rad"},
      {"display: {force: [kN]}\n" + good, "a unit is expected, not a list"},
      {"display: kN\n" + good, "display: a map of kinds and units"},
      {"- taut: 1\n", "a deck is a map, beginning with 'taut: 1'; this is a list"},
      {"hello", "this is a text"},
  };
  for (const auto& [text, expected] : rows) {
    const Reading t = read_all(text);
    EXPECT_NE(t.text.find(expected), std::string::npos) << text << "\n-> " << t.text;
  }
}

TEST(Override, PutsValuesOverThoseOfTheDeck) {
  const Reading t = read_all(
      good + "  cases: [{name: a}, {name: b}]\n",
      {"input.span=200 m", "input.cases[1].falls=6", "input.cases.0.falls=8", "input.second_rope.diameter=3 mm",
       "input.positions=[1 m, 2 m]", "input.cases[2].name=c", "input.note=a=b", "title=T"});
  ASSERT_EQ(t.mistakes, 0U) << t.text;
  EXPECT_DOUBLE_EQ(t.sample.span, 200);
  ASSERT_EQ(t.sample.cases.size(), 3U);
  EXPECT_EQ(t.sample.cases[0].falls, 8);
  EXPECT_EQ(t.sample.cases[1].falls, 6);
  EXPECT_EQ(t.sample.cases[2].name, "c");
  ASSERT_TRUE(t.sample.second_rope.has_value());
  EXPECT_DOUBLE_EQ(t.sample.second_rope->diameter, 0.003);
  EXPECT_EQ(t.sample.positions.size(), 2U);
  EXPECT_EQ(t.sample.note, "a=b");
  EXPECT_EQ(t.deck->title, "T");
}

TEST(Override, RefusesANameThatFitsTwoEntries) {
  auto d = parse(
      "taut: 1\nmachine:\n  loads: [{at: car, mass: 1 t}, {at: hook, mass: 1 t}, {at: car, mass: 2 t}]\n"
      "  reevings: [{rope: r, name: one, length: 3 m}, {rope: r, name: two, length: 4 m}]\n",
      "deck.yaml");
  const auto refused = [&](const std::string& set) {
    Diagnostics mistakes;
    override_value(*d, set, {"taut", "machine"}, mistakes);
    return to_text(mistakes);
  };
  const std::string loads = refused("loads.car.mass=7 t");
  EXPECT_NE(loads.find("--set:1:7: error: 'car' is the 'at' of 2 entries: write the index of one, [0], [2]"),
            std::string::npos)
      << loads;
  EXPECT_NE(refused("reevings.r.length=7 m").find("'r' is the 'rope' of 2 entries: write the index of one, [0], [1]"),
            std::string::npos);
  EXPECT_EQ(follow(d->root, "machine.loads[0].mass").node->text, "1 t");
  EXPECT_EQ(refused("reevings.two.length=7 m"), "");
  EXPECT_EQ(follow(d->root, "machine.reevings[1].length").node->text, "7 m");
}

TEST(Override, NullTakesABlockOut) {
  auto d = parse("taut: 1\nmachine: {points: {a: [0 m, 1 m, 2 m]}}\ndesign: {seek: least}\n", "deck.yaml");
  const auto set = [&](const std::string& text) {
    Diagnostics mistakes;
    override_value(*d, text, {"taut", "machine", "design", "study"}, mistakes);
    return to_text(mistakes);
  };
  EXPECT_EQ(set("design= null "), "");
  EXPECT_EQ(d->root.find("design"), nullptr);
  EXPECT_EQ(set("study=null"), "") << "it has none";
  for (const char* part : {"machine.points=null", "points=null"})
    EXPECT_NE(set(part).find("takes a whole block out"), std::string::npos) << part;
}

TEST(Override, FindsWhatASweepsParameterFinds) {
  const auto document = [](const std::string& set) {
    Diagnostics mistakes;
    auto d = parse(
        "taut: 1\nmachine:\n  points: {head: [0 m, 1 m, 2 m], eye: {body: hook, at: [3 m, 4 m, 5 m]}}\n"
        "  faces: {s1.low: {body: a}}\n"
        "  loads: [{at: car, mass: 1 t}, {name: wind, at: mast.top, force: [1 kN, 0 N, 0 N]}]\n"
        "  reevings: [{rope: skyline, length: 3 m}, {name: main, rope: skyline, length: 4 m}]\n"
        "analyses: [{transient: {duration: 1 s}}]\n",
        "deck.yaml");
    override_value(*d, set, {"taut", "machine", "analyses", "input"}, mistakes);
    EXPECT_TRUE(mistakes.empty()) << to_text(mistakes);
    return d->root;
  };
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"loads[0].mass", "machine.loads[0].mass"},
      {"loads.car.mass", "machine.loads[0].mass"},
      {"loads[car].mass", "machine.loads[0].mass"},
      {"loads.wind.force.x", "machine.loads[1].force[0]"},
      {"loads.mast.top.force[1]", "machine.loads[1].force[1]"},
      {"reevings.skyline.length", "machine.reevings[0].length"},
      {"reevings.main.length", "machine.reevings[1].length"},
      {"points.head.z", "machine.points.head[2]"},
      {"points.head.at.z", "machine.points.head[2]"},
      {"points.eye.y", "machine.points.eye.at[1]"},
      {"points.eye[2]", "machine.points.eye.at[2]"},
      {"points.eye.at[2]", "machine.points.eye.at[2]"},
      {"faces.s1.low.body", "machine.faces.s1.low.body"},
      {"temperature", "machine.temperature"},
  };
  for (const auto& [path, place] : rows) {
    for (const char* begin : {"", "machine."}) {
      const Node root = document(begin + path + "=7");
      const Node* machine = root.find("machine");
      ASSERT_NE(machine, nullptr);
      const Found found = path.starts_with("faces")
                              ? Found{.node = &machine->find("faces")->find("s1.low")->find("body")[0], .all = true}
                              : follow(root, place);
      ASSERT_TRUE(found.all) << path;
      EXPECT_EQ(found.node->text, "7") << begin << path;
    }
  }
  const Node root = document("analyses[0].transient.duration=7");
  EXPECT_EQ(follow(root, "analyses[0].transient.duration").node->text, "7");
}

TEST(Override, TellsMistakesInItsOwnText) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"input.span=12 kN", "--set:1:15: error: span: 'kN' is a unit of force"},
      {"input.spam=12 m", "--set:1:7: error: 'spam' is not a field of closed_loop; did you mean 'span'?"},
      {"input.span", "--set:1:1: error: write path=value"},
      {"", "--set:1:1: error: write path=value"},
      {"=3", "--set:1:1: error: a key is missing"},
      {"input..span=3 m", "--set:1:7: error: a key is missing"},
      {"input.=3 m", "a key is missing"},
      {"input.span.x=3", "--set:1:12: error: 'x' is asked of a text"},
      {"input.span=", "--set:1:11: error: there is no value"},
      {"input.cases[x]=3", "--set:1:12: error: cases: a list is expected"},
      {"input.cases[]=3", "--set:1:12: error: an index"},
      {"input.cases[0=3", "an index"},
      {"input.cases[0]x=3", "'.' or '[' is expected"},
      {"input.rope[1]=3", "this is a map, not a list"},
      {"input.positions=[1 m, 2", "--set:1:"},
      {"input.note=&a b", "--set:1:12: error: anchors"},
      {"input.note='open", "--set:1:12: error: a quoted text that is never closed"},
      {"input.note=\x01", "--set:1:12: error: control character"},
      {std::string(300, 'a') + "=1", "is not a field of closed_loop"},
      {"inputs.span=1 m", "--set:1:1: error: 'inputs' is not a key of a deck; did you mean 'input'?"},
  };
  for (const auto& [set, expected] : rows) {
    const Reading t = read_all(good, {set});
    EXPECT_NE(t.text.find(expected), std::string::npos) << set << "\n-> " << t.text;
  }
  std::string deep = "a";
  for (int i = 0; i < 100; ++i) deep += ".a";
  EXPECT_NE(read_all(good, {deep + "=1"}).text.find("nested deeper than 64"), std::string::npos);
  const Reading t = read_all(good + "  cases: [{name: a}]\n", {"input.cases[2].falls=1"});
  EXPECT_NE(t.text.find("--set:1:12: error: the list has 1 entries, the first is [0]"), std::string::npos) << t.text;
}

/// Files in a folder of their own.
class Include : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("taut_include_") + info->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "parts");
  }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  Reading run(const std::string& text) { return read_all(text, {}, (folder_ / "deck.yaml").string()); }

  fs::path folder_;
};

TEST_F(Include, TheIncludingDeckWins) {
  write("parts/base.part.yaml",
        "taut: 1\nmethod: mast_section\ninput:\n  span: 7 m\n  friction: 0.2\n  rope: {diameter: 9 mm, strength: 5 "
        "kN}\n");
  const Reading t =
      run("include: parts/base.part.yaml\nmethod: closed_loop\ninput:\n  span: 1 m\n  rope: {diameter: 2 mm}\n");
  ASSERT_EQ(t.mistakes, 0U) << t.text;
  EXPECT_EQ(t.deck->method, "closed_loop");
  EXPECT_DOUBLE_EQ(t.sample.span, 1);
  EXPECT_DOUBLE_EQ(t.sample.friction, 0.2);
  EXPECT_DOUBLE_EQ(t.sample.rope.diameter, 0.002);
  EXPECT_DOUBLE_EQ(t.sample.rope.strength.value(), 5000);
}

TEST_F(Include, ALaterOneWinsOverAnEarlierOneAndEachLooksBesideItself) {
  write("a.yaml", "taut: 1\ninput: {span: 1 m, friction: 0.3}\n");
  write("parts/b.yaml", "include: c.yaml\ninput: {span: 2 m}\n");
  write("parts/c.yaml", "method: closed_loop\ninput: {span: 3 m, rope: {diameter: 4 mm}}\n");
  const Reading t = run("include: [a.yaml, parts/b.yaml]\n");
  ASSERT_EQ(t.mistakes, 0U) << t.text;
  EXPECT_DOUBLE_EQ(t.sample.span, 2);
  EXPECT_DOUBLE_EQ(t.sample.friction, 0.3);
  EXPECT_DOUBLE_EQ(t.sample.rope.diameter, 0.004);
}

TEST_F(Include, AKeyWithAPlusAddsToTheListBelow) {
  write("a.yaml", "taut: 1\nmethod: closed_loop\ninput:\n  span: 1 m\n  positions: [1 m]\n  rope: {diameter: 4 mm}\n");
  write("b.yaml", "include: a.yaml\ninput: {positions+: [2 m, 3 m]}\n");
  write("c.yaml", "input: {positions+: [4 m], cases+: [{name: one}]}\n");
  const Reading t = run("include: [b.yaml, c.yaml]\ninput: {cases+: [{name: two}]}\n");
  ASSERT_EQ(t.mistakes, 0U) << t.text;
  EXPECT_EQ(t.sample.positions, (std::vector<double>{1, 2, 3, 4}));
  ASSERT_EQ(t.sample.cases.size(), 2U);
  EXPECT_EQ(t.sample.cases[1].name, "two");
  EXPECT_EQ(run("include: b.yaml\ninput: {positions: [7 m]}\n").sample.positions, std::vector<double>{7});
  // one value without brackets below is a list of one
  write("d.yaml", "taut: 1\nmethod: closed_loop\ninput:\n  span: 1 m\n  positions: 5 m\n  rope: {diameter: 4 mm}\n");
  EXPECT_EQ(run("include: d.yaml\ninput: {positions+: [6 m]}\n").sample.positions, (std::vector<double>{5, 6}));
}

TEST_F(Include, AKeyWithAPlusAddsToTheListBesideItInAnyOrder) {
  write("a.yaml", "taut: 1\nmethod: closed_loop\ninput:\n  span: 1 m\n  positions: [1 m]\n  rope: {diameter: 4 mm}\n");
  for (const char* keys : {"positions+: [3 m], positions: [2 m], cases+: [{name: two}], cases: [{name: one}]",
                           "positions: [2 m], positions+: [3 m], cases: [{name: one}], cases+: [{name: two}]"}) {
    const Reading t = run(std::string("include: a.yaml\ninput: {") + keys + "}\n");
    ASSERT_EQ(t.mistakes, 0U) << t.text;
    EXPECT_EQ(t.sample.positions, (std::vector<double>{2, 3})) << keys;
    ASSERT_EQ(t.sample.cases.size(), 2U) << "that the deck below has not";
    EXPECT_EQ(t.sample.cases[0].name, "one");
    EXPECT_EQ(t.sample.cases[1].name, "two");
  }
}

TEST_F(Include, ValuesKeepTheirOwnFileInMessages) {
  write("a.yaml", "taut: 1\ninput:\n  span: 1\n  spam: 2\n  spam: 3\n");
  const Reading t = run("include: a.yaml\nmethod: closed_loop\ninput: {rope: {diameter: 1}}\n");
  EXPECT_NE(t.text.find("a.yaml:3:9: error: span: a length needs"), std::string::npos) << t.text;
  EXPECT_NE(t.text.find("a.yaml:5:3: error: the key '...' stands here a second time"), std::string::npos) << t.text;
  EXPECT_NE(t.text.find("deck.yaml:3:26: error: diameter"), std::string::npos) << t.text;
}

TEST_F(Include, TellsWhatCanNotBeIncluded) {
  write("deck.yaml", "include: deck.yaml\n");
  write("a.yaml", "include: b.yaml\n");
  write("b.yaml", "include: [parts/../a.yaml]\n");
  write("list.yaml", "- 1\n");
  write("broken.yaml", "a: [1\n");
  write("deep.yaml", "");
  for (int i = 0; i < 20; ++i) write(fmt::format("n{}.yaml", i), fmt::format("include: n{}.yaml\n", i + 1));
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"include: nowhere.yaml", "deck.yaml:1:10: error: include: '"},
      {"include: nowhere.yaml", "can't be read: No such file or directory"},
      {"include: parts", "is a folder"},
      {"include: deck.yaml", "includes itself"},
      {"include: a.yaml", "b.yaml:1:11: error: include: "},
      {"include: [list.yaml]", "deck.yaml:1:11: error: include: "},
      {"include: broken.yaml", "broken.yaml:"},
      {"include: deep.yaml", "deep.yaml:1:1: error: there is nothing in it"},
      {"include: n0.yaml", "more than 16 decks inside each other"},
      {"include: {a: b}", "is expected, not a map"},
      {"include:", "is expected, not nothing"},
      {"include: ''", "is expected, not an empty text"},
      {"include: [a.yaml, [b.yaml]]", "is expected, not a list"},
  };
  for (const auto& [text, expected] : rows) {
    const Reading t = run(fmt::format("{}\n{}", text, good));
    EXPECT_NE(t.text.find(expected), std::string::npos) << text << "\n-> " << t.text;
    EXPECT_FALSE(t.deck) << text << ": without that part more would be missing";
  }
}

TEST_F(Include, ManyFilesThatIncludeEachOtherManyTimesEnd) {
  for (int i = 0; i < 12; ++i) {
    write(fmt::format("n{}.yaml", i), fmt::format("include: [n{0}.yaml, n{0}.yaml, n{0}.yaml]\n", i + 1));
  }
  write("n12.yaml", "a: 1\n");
  EXPECT_NE(run("include: n0.yaml\n" + good).text.find("more than 100 decks in all"), std::string::npos);
}

TEST_F(Include, AFileIsCutBehindTheLargestDeck) {
  write("big.yaml", std::string(18'000'000, '#'));
  const auto text = read_file((folder_ / "big.yaml").string());
  ASSERT_TRUE(text.has_value());
  EXPECT_EQ(text->size(), largest_deck + 1);
  EXPECT_NE(read_all(*text).text.find("larger than 16 MB"), std::string::npos);
  EXPECT_FALSE(read_file((folder_ / "nowhere").string()));
  EXPECT_FALSE(read_file(folder_.string()));
}

}  // namespace taut::io::deck_test
