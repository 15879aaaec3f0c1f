#include "taut/io/deck/schema.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "taut/io/deck/deck.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/io/deck/sample_test.hpp"
#include "taut/units/names.hpp"
#include "taut/units/parse.hpp"
#include "test/paths.hpp"

namespace taut::io::schema_test {

namespace fs = std::filesystem;

const std::vector<SchemaMethod> methods = {{.name = "sample", .title = "A sample", .input = &Sample::describe()},
                                           {.name = "rope", .title = "A rope", .input = &SampleRope::describe()}};

TEST(Schema, AQuantitysPatternAgreesWithItsReader) {
  std::vector<std::string> units = {"m/s2", "m/s^2", "kN m", "kN*m",   "kN·m",   "N/mm2", "N/mm²", "1/s",
                                    "kg/m", "MN/m",  "mm^4", "J/kg/K", "kN s/m", "ton",   "kn",    "",
                                    "xyz",  "m2",    "m s",  "mm/kN",  "m 2",    "5 m"};
  for (const NameRow& r : name_rows()) units.emplace_back(r.name);
  for (const Unit& u : {si::m, si::N, si::Pa, si::rad, si::s, si::kg, si::m_per_s2, si::N_per_m, si::N_m, si::m4}) {
    const std::regex pattern(quantity_pattern(u), std::regex::ECMAScript);
    for (const std::string& unit : units) {
      for (const char* number : {"12", "-1.5e3 ", ".5  ", "+2."}) {
        const std::string text = number + unit;
        const bool matches = std::regex_match(text, pattern);
        const bool read = parse_quantity(text, u).has_value();
        EXPECT_TRUE(matches || !read) << text << " as " << u.kind;
        // products of units are accepted without knowing their dimension; single names are not
        const bool single =
            unit.find_first_of("/*^ 1234") == std::string::npos && unit.find('\xC2') == std::string::npos;
        EXPECT_TRUE(!single || matches == read) << text << " as " << u.kind;
      }
    }
  }
}

TEST(Schema, NamesVectorsShortFormsAndGroups) {
  const auto j = nlohmann::ordered_json::parse(
      deck_schema({{.name = "machine", .title = "A machine", .input = &SampleMachine::describe()}}));
  const auto& machine = j["definitions"]["machine"]["properties"];
  const auto& pin = machine["pins"]["additionalProperties"]["anyOf"];
  EXPECT_EQ(pin[0]["properties"]["at"]["minItems"], 3);
  EXPECT_EQ(pin[0]["required"].dump(), R"(["at"])");
  EXPECT_EQ(pin[1]["maxItems"], 3);
  EXPECT_EQ(pin[0]["properties"]["free"]["anyOf"][1]["items"].dump(), R"({"enum":["x","y","z"]})");
  EXPECT_EQ(machine["path"]["items"]["allOf"][0].dump(),
            R"({"oneOf":[{"required":["over"]},{"required":["anchor"]}]})");
  EXPECT_EQ(machine["motion"]["anyOf"].size(), 2U);
}

TEST(Schema, SaysUnitsRangesAndDefaults) {
  const auto j = nlohmann::ordered_json::parse(deck_schema(methods));
  const auto& sample = j["definitions"]["sample"];
  EXPECT_EQ(sample["title"], "A sample");
  EXPECT_EQ(sample["required"].dump(), R"(["span"])");
  EXPECT_EQ(sample["additionalProperties"], false);
  EXPECT_EQ(sample["properties"]["span"]["description"], "horizontal span; l [m]; above 0 m");
  EXPECT_EQ(sample["properties"]["friction"]["anyOf"][0].dump(),
            R"({"type":"number","minimum":0.0,"exclusiveMaximum":1.0})");
  EXPECT_EQ(sample["properties"]["friction"]["default"], 0.1);
  EXPECT_EQ(sample["properties"]["stiffness"]["default"], "1 MN/m");
  EXPECT_EQ(sample["properties"]["uphill"]["default"], false);
  EXPECT_EQ(sample["properties"]["direction"]["enum"].dump(), R"(["inhaul","outhaul"])");
  EXPECT_FALSE(j["definitions"]["sample.part"].contains("required"));
  EXPECT_EQ(j["properties"]["method"]["enum"].dump(), R"(["sample","rope"])");
}

/// Runs the script that also checks the examples, with the schema of the sample.
class SchemaScript : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();  // tests run at the same time
    folder_ = fs::path(testing::TempDir()) / fmt::format("taut_schema_{}", info->name());
    fs::create_directories(folder_);
    std::ofstream(folder_ / "schema.json") << deck_schema(methods);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Whether the script accepts every one of the decks.
  bool accepts(const std::vector<std::string>& decks, const std::string& ending = ".yaml") {
    std::string files;
    for (std::size_t i = 0; i < decks.size(); ++i) {
      const fs::path file = folder_ / fmt::format("{}{}", i, ending);
      std::ofstream(file) << decks[i];
      files += fmt::format(" '{}'", file.string());
    }
    const fs::path script = taut_test::source_dir() / "test/schema/validate.py";
    return std::system(fmt::format("/usr/bin/python3 '{}' '{}'{} > '{}' 2>&1", script.string(),
                                   (folder_ / "schema.json").string(), files, (folder_ / "log").string())
                           .c_str()) == 0;
  }
  std::string log() {
    std::ifstream file(folder_ / "log");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  fs::path folder_;
};

bool reads(const std::string& text) {
  Diagnostics mistakes;
  const auto deck = read_deck(text, "deck.yaml", {}, {"sample", "rope"}, mistakes);
  if (!deck) return false;
  Sample s;
  read(deck->input, Sample::describe(), &s, "sample", mistakes);
  return mistakes.empty();
}

const std::string head = "taut: 1\nmethod: sample\n";
const std::string rope = "  rope: {diameter: 12 mm}\n";

TEST_F(SchemaScript, AcceptsWhatTheReaderReads) {
  const std::vector<std::string> decks = {
      head + "input:\n  span: 200 m\n" + rope,
      head +
          "title: 12\ndisplay: {force: kgf, angle: gon, section modulus: mm^3, compliance: mm/kN}\ninput:\n  span: 2e2 "
          "m\n" +
          rope,
      head +
          "input:\n  span: 1 ft\n  positions: [1 m, 50 cm]\n  friction: 12 %\n  stiffness: .inf\n  uphill: true\n"
          "  direction: outhaul\n  note: on\n  sheaves: 3\n" +
          rope + "  second_rope: {diameter: 1 in, strength: 6e3 kgf}\n  cases: [{name: a, angle: 12 %, falls: 3}]\n",
      head + "input:\n  span: 1 m\n  positions: 5 m\n  friction: 1e-3\n  stiffness: 2.7 kN/mm\n" + rope,
      "taut: 1\nmethod: rope\ninput: {diameter: 3 mm}\n",
      "include: other.yaml\n",
      "include: [other.yaml]\nmethod: sample\ninput: {friction: 0.2, rope: {}}\n",
  };
  for (std::size_t i = 0; i < 4; ++i) EXPECT_TRUE(reads(decks[i])) << decks[i];
  EXPECT_TRUE(accepts(decks)) << log();
  EXPECT_TRUE(accepts({"not: a deck\n"}, ".part.yaml")) << "parts do not stand alone";
}

TEST_F(SchemaScript, RefusesEachOfThese) {
  std::vector<std::string> decks;
  const std::vector<std::string> inputs = {
      "span: 200",
      "span: 200 kN",
      "span: 1 ton",
      "spann: 1 m",
      "friction: 1",
      "friction: 1 m",
      "uphill: yes",
      "direction: up",
      "sheaves: 2.5",
      "sheaves: 21",
      "positions: []",
      "positions: [1]",
      "stiffness: 5",
      "rope: {}",
      "rope: {diameter: 1 mm, x: 1}",
      "cases: []",
      "cases: [{falls: 1}]",
      "cases: [{name: a, angle: 1 m}]",
      "note: {a: b}",
      "cases: {name: a}",
      "span: ~",
      "span: [1 m]",
      "positions: [1 m, ~]",
      "stiffness: 1 N",
      "cases: [{name: ''}]",
  };
  for (const std::string& one : inputs) {
    std::string text = fmt::format("{}input:\n  {}\n", head, one);
    if (one.substr(0, 5) != "span:") text += "  span: 1 m\n";
    if (one.substr(0, 5) != "rope:") text += rope;
    decks.push_back(text);
  }
  const std::string input = "input:\n  span: 1 m\n" + rope;
  for (const char* no_head :
       {"taut: 2\nmethod: sample\n", "method: sample\n", "taut: 1\n", "taut: 1\nmethod: other\n"}) {
    decks.push_back(no_head + input);
  }
  decks.push_back(head);
  for (const char* wrong : {"x: 1\n", "display: {force: mm}\n", "display: {forse: N}\n"}) {
    decks.push_back(fmt::format("{}{}{}", head, wrong, input));
  }
  EXPECT_FALSE(accepts(decks));
  const std::string reported = log();
  for (std::size_t i = 0; i < decks.size(); ++i) {
    EXPECT_FALSE(reads(decks[i])) << decks[i];
    EXPECT_NE(reported.find(fmt::format("/{}.yaml: ", i)), std::string::npos) << decks[i];
  }
}

}  // namespace taut::io::schema_test
