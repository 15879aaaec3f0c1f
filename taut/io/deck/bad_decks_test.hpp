#pragma once
// Two hundred and more decks that people, editors and disks get wrong.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace taut::io {

inline const std::string head = "taut: 1\ntitle: A test\nmethod: sample\n";
inline const std::string good = head +
                                "display: {force: kN}\n"
                                "input:\n"
                                "  span: 200 m\n"
                                "  friction: 0.15\n"
                                "  positions: [1 m, 50 m]\n"
                                "  stiffness: 2.7 MN/m\n"
                                "  uphill: false\n"
                                "  direction: inhaul\n"
                                "  note: on the hill\n"
                                "  sheaves: 3\n"
                                "  rope: {diameter: 12 mm, strength: 63 kN}\n"
                                "  cases:\n"
                                "    - {name: a, angle: 30 deg, falls: 2}\n"
                                "    - name: b\n"
                                "      angle: 12 %\n";

/// The good deck with one text replaced by another.
inline std::string with(const std::string& old_text, const std::string& new_text) {
  std::string text = good;
  const std::size_t at = text.find(old_text);
  EXPECT_NE(at, std::string::npos) << old_text;
  return text.replace(at, old_text.size(), new_text);
}

inline std::string repeated(std::string_view piece, std::size_t times) {
  std::string text;
  for (std::size_t i = 0; i < times; ++i) text += piece;
  return text;
}

// NOLINTNEXTLINE(readability-function-size): a list
inline void add_wrong_values(std::vector<std::string>& decks) {
  // a length where one is expected
  for (const char* value : {"200",
                            "0",
                            "-5 m",
                            "0 m",
                            "-0 m",
                            "200 kN",
                            "200 deg",
                            "200 kg",
                            "200 s",
                            "200 MPa",
                            "200 ton",
                            "200 M",
                            "200 mN",
                            "200 meter",
                            "200 metre",
                            "200 mm2",
                            "200 m/s",
                            "200 %",
                            "nan",
                            ".nan",
                            "NaN",
                            ".inf",
                            "-.inf",
                            ".inf m",
                            "inf",
                            "1e999 m",
                            "-1e999 m",
                            "1e-999 m",
                            "1e999",
                            "0x10 m",
                            "1_000 m",
                            "1,5 m",
                            "1.000,5 m",
                            "1 000 m",
                            "m",
                            "m 200",
                            "two hundred m",
                            "200m200",
                            "200 m m m",
                            "200 m^5",
                            "200 m^",
                            "200 m/",
                            "200 /m",
                            "200 *",
                            "200 m**",
                            "++200 m",
                            "+-200 m",
                            "--200 m",
                            "200 m # 2\n  span: 3 m",
                            "200 lbs",
                            "200 kn",
                            "200 \"",
                            "200 '",
                            "1/0 m",
                            "200 + 5 m",
                            "200 m 5 cm",
                            "~",
                            "null",
                            "",
                            "true",
                            "false",
                            "yes",
                            "[200 m]",
                            "{value: 200, unit: m}",
                            "\"\"",
                            "''",
                            "'200'",
                            "\" \"",
                            "|\n    200 m\n    300 m",
                            "!!float 200",
                            "!length 200 m",
                            "&l 200 m",
                            "*l",
                            "２００ m",
                            "200\\u00a0m",
                            "\"200\\0 m\"",
                            "@200 m",
                            "`200 m`",
                            "%200 m",
                            "200: m",
                            "- 200 m",
                            "1.2.3 m",
                            "1e m",
                            "e5 m",
                            ". m",
                            "1e+ m"}) {
    decks.push_back(with("200 m", value));
  }
  for (const char* value : {"0.15 m", "1", "1.5", "-0.1", "150 %", "0,15", ".15.", "15 % %", "abc", "[0.15]", "{}", "~",
                            "1e999", "nan", "0x1", "15%%", "0.15 rad", "fifteen", "''"}) {
    decks.push_back(with("0.15", value));
  }
  for (const char* value : {"[]", "[1 m, 50]", "[1 m, [2 m]]", "[1 m, {a: b}]", "[1 m,, 2 m]", "[1 m 2 m", "[1 m, ~]",
                            "[-1 m]", "[1 kN]", "{1 m, 2 m}", "[1 m, 2 m]]", "1 m, 2 m", "[1; 2]", "[nan]", "[.inf]"}) {
    decks.push_back(with("[1 m, 50 m]", value));
  }
  for (const char* value :
       {"-2.7 MN/m", "0 N/m", "2.7 MN", "2.7 MN/m/m", "2.7 MN/mm2", "2.7", "-.inf", "2.7 N/m/s", "2.7 m/N"}) {
    decks.push_back(with("2.7 MN/m", value));
  }
  for (const char* value :
       {"no", "yes", "off", "0", "'false'", "falsch", "[false]", "{}", "~", "n", "FALSCH", "tRuE"}) {
    decks.push_back(with("uphill: false", fmt::format("uphill: {}", value)));
  }
  for (const char* value : {"inhual", "Inhaul", "in", "''", "[inhaul]", "1", "~", "inhaul outhaul"}) {
    decks.push_back(with("direction: inhaul", fmt::format("direction: {}", value)));
  }
  for (const char* value : {"-1", "21", "2.5", "3 m", "1e9", "1e99", "three", "0x3", "[3]", "~", "3 %"}) {
    decks.push_back(with("sheaves: 3", fmt::format("sheaves: {}", value)));
  }
  for (const char* value :
       {"86 deg", "-1 deg", "30", "30 m", "2 rad", "30 degrees", "30 grad", "1e5 %", "-1 %", "30 d"}) {
    decks.push_back(with("30 deg", value));
  }
  for (const char* value : {"[a, b]", "{a: b}", "~", "*a", "\"a\\x07\"", "\"a", "'a", "a: b", "@a"}) {
    decks.push_back(with("on the hill", value));
  }
}

// NOLINTNEXTLINE(readability-function-size): a list
inline void add_wrong_keys(std::vector<std::string>& decks) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"taut: 1\n", ""},
      {"taut: 1", "taut: 2"},
      {"taut: 1", "taut: 1.0"},
      {"taut: 1", "taut: '1'"},
      {"taut: 1", "taut: [1]"},
      {"taut: 1", "taut:"},
      {"taut: 1", "Taut: 1"},
      {"taut: 1", "taut: one"},
      {"taut: 1", "taut: -1"},
      {"taut: 1", "taut 1"},
      {"taut: 1", "taut:1"},
      {"method: sample\n", ""},
      {"method: sample", "method: smaple"},
      {"method: sample", "method: [sample]"},
      {"method: sample", "method:"},
      {"method: sample", "method: Sample"},
      {"method: sample", "methods: sample"},
      {"method: sample", "machine: sample"},
      {"title: A test", "title: [A, test]"},
      {"title: A test", "title: {A: test}"},
      {"title: A test", "title: A: test"},
      {"title: A test", "tittle: A test"},
      {"title: A test", "title: A test\ntitle: B"},
      {"display: {force: kN}", "display: kN"},
      {"display: {force: kN}", "display: [kN]"},
      {"display: {force: kN}", "display: {forse: kN}"},
      {"display: {force: kN}", "display: {force: mm}"},
      {"display: {force: kN}", "display: {force: [kN]}"},
      {"display: {force: kN}", "display: {force: 5}"},
      {"display: {force: kN}", "display: {force: kN, force: N}"},
      {"display: {force: kN}", "display: {number: '%'}"},
      {"display: {force: kN}", "display: {force: ''}"},
      {"display: {force: kN}", "display: {force: }"},
      {"input:\n", "imput:\n"},
      {"input:\n", "input: 5\nx:\n"},
      {"input:\n", "input: []\nx:\n"},
      {"span: 200 m", "spam: 200 m"},
      {"span: 200 m", "Span: 200 m"},
      {"span: 200 m", "span : 200 kN"},
      {"span: 200 m", "span 200 m"},
      {"span: 200 m", "span:200 m"},
      {"span: 200 m", "span = 200 m"},
      {"  span: 200 m\n", ""},
      {"  span: 200 m", "   span: 200 m"},
      {"  span: 200 m", " span: 200 m"},
      {"  span: 200 m", "\tspan: 200 m"},
      {"  span: 200 m", "  \tspan: 200 m"},
      {"  span: 200 m", "span: 200 m"},
      {"  span: 200 m", "  ? span: 200 m"},
      {"  span: 200 m", "  [span]: 200 m"},
      {"  span: 200 m", "  {span: x}: 200 m"},
      {"  span: 200 m", "  : 200 m"},
      {"  span: 200 m", "  ~: 200 m"},
      {"  span: 200 m", "  span: 200 m\n  span: 200 m"},
      {"  span: 200 m", "  span: 200 m\n  \"span\": 200 m"},
      {"  span: 200 m", "  span: 200 m\n  'span': 1 m"},
      {"  span: 200 m", "  <<: *base\n  span: 200 m"},
      {"  span: 200 m", "  <<: {span: 200 m}"},
      {"  span: 200 m", "  - span: 200 m"},
      {"  span: 200 m", "  \"span: 200 m"},
      {"diameter: 12 mm", "diamter: 12 mm"},
      {"diameter: 12 mm", "diameter: 12"},
      {"diameter: 12 mm", "diameter: -12 mm"},
      {"diameter: 12 mm, ", ""},
      {"diameter: 12 mm,", "diameter: 12 mm, diameter: 13 mm,"},
      {"strength: 63 kN}", "strength: 63 kN"},
      {"strength: 63 kN}", "strength: 63 kN]"},
      {"strength: 63 kN}", "strength: 63 kN}}"},
      {"63 kN", "63 kg"},
      {"63 kN", "63 t"},
      {"63 kN", "63 ton"},
      {"63 kN", "63"},
      {"{name: a,", "{nane: a,"},
      {"{name: a,", "{"},
      {"{name: a,", "{name: ,"},
      {"{name: a,", "{name: '',"},
      {"falls: 2", "falls: 0"},
      {"falls: 2", "falls: two"},
      {"falls: 2", "falls: 2.0001"},
      {"falls: 2", "falls: 2, falls: 3"},
      {"    - name: b", "    name: b"},
      {"    - name: b", "     - name: b"},
      {"    - name: b", "   - name: b"},
      {"    - name: b", "    -name: b"},
      {"      angle: 12 %", "    angle: 12 %"},
      {"      angle: 12 %", "     angle: 12 %"},
      {"      angle: 12 %", "      angel: 12 %"},
      {"  rope: {", "  rope: 12 mm\n  x: {"},
      {"  rope: {", "  rope:\n  x: {"},
      {"  cases:\n", "  cases: {}\n  x:\n"},
      {"  cases:\n", "  cases: []\n  x:\n"},
  };
  for (const auto& [old_text, new_text] : rows) decks.push_back(with(old_text, new_text));
}

// NOLINTNEXTLINE(readability-function-size): a list
inline void add_no_decks(std::vector<std::string>& decks) {
  const std::vector<std::string> texts = {
      "",
      " ",
      "\n",
      "\n\n\n",
      "#",
      "# only\n# comments\n",
      "---",
      "---\n",
      "...",
      "---\n---\n",
      "--- |\n",
      "~",
      "null",
      "1",
      "hello",
      "'",
      "\"",
      "[]",
      "{}",
      "[",
      "{",
      "]",
      "}",
      ",",
      ":",
      "-",
      "?",
      "|",
      ">",
      "&",
      "*",
      "!",
      "%",
      "@",
      "`",
      "\\",
      "- - -",
      "a",
      "a:",
      ":a",
      "a b c",
      "{\"taut\": 1}",
      "{\"taut\": 1, \"method\": \"sample\", \"input\": {\"span\": 200}}",
      "{\"taut\": 1,}",
      "{'taut': 1, 'method': 'sample'",
      "[{\"taut\": 1}]",
      "<?xml version=\"1.0\"?><deck/>",
      "<html><body>404</body></html>",
      "[input]\nspan = 200 m\n",
      "span=200\n",
      "taut,method\n1,sample\n",
      "PK\x03\x04\x14",
      "\177ELF\x02\x01\x01",
      "%PDF-1.7\n%\xE2\xE3\xCF\xD3\n",
      "\x89PNG\r\n\x1a\n",
      "GIF89a\x01",
      "#!/bin/sh\nrm -rf x\n",
      "\xFF\xFEt\x01",
      "\xFE\xFFt\x01",
      "\xEF\xBB\xBF",
      "\xEF\xBB\xBF\xEF\xBB\xBFtaut: 1",
      "\xC3",
      "\xC3\x28",
      "\xED\xA0\x80",
      "\xF8\x88\x80\x80\x80",
      "\xF4\x90\x80\x80",
      "\xC0\x80",
      "taut: \x80",
      "taut: 1\x1b[31m",
      "taut: 1\x08",
      "taut: 1\x7f",
      "taut: \xC2\x85\xC2\x80",
      "taut: 1\rmethod: sample\r",
      "taut: \xEF\xBF\xBE",
      good + "---\n" + good,
      good + good,
      good + "...\nx: 1\n",
      good + "}\n",
      good + "\t\n x\n",
      good + "x\n",
      good + "  - x\n",
      "  " + good,
      "- " + good,
      "> " + good,
      "%YAML 3.0\n---\n" + good,
      "%YAML 1.2\n%YAML 1.2\n---\n" + good,
      "%TAG ! x\n",
      "%TAG ! x y\n%TAG ! x y\n---\n" + good,
      "!deck\n" + good,
      "&a\n" + good,
      head + "include: nowhere.yaml\n",
      head + "include: [\n",
      head + "include: /dev\n",
      head + "include: deck.yaml\n",
      head + "include: ''\n",
      head + "include: {a: b}\n",
      head + "include: [[a]]\n",
      head + "include: \"a\\0b\"\n",
      head + "include: ~\n",
      std::string("taut: 1\0", 8),
      std::string("\0\0\0\0", 4),
      std::string(5000, '\0'),
      std::string(17'000'000, ' '),
      std::string(17'000'000, 'x'),
      std::string(100000, '['),
      std::string(100000, '{'),
      repeated("- ", 100000),
      repeated("? ", 100000),
      repeated("[{", 50000),
      repeated("a: ", 1000),
      repeated("[", 70) + repeated("]", 70),
      "a: " + repeated("{b: ", 70) + repeated("}", 70),
      repeated("&a [", 100),
      repeated("!!seq [", 100),
      "a: &a [x, x]\nb: &b [*a, *a]\nc: &c [*b, *b]\nd: [*c, *c]\n",
      repeated("x: 1\n", 150000),
      repeated("- 1\n", 210000),
      repeated("'", 99999),
      repeated("\"", 99999),
      repeated("a\n", 99999),
      repeated(", ", 1000),
      std::string(2'000'000, '\n') + "[",
      std::string(60000, 'k') + ": 1\n",
  };
  decks.insert(decks.end(), texts.begin(), texts.end());
  std::string deep;
  for (std::size_t i = 0; i < 80; ++i) deep += std::string(i, ' ') + "a:\n";
  decks.push_back(deep);
}

}  // namespace taut::io
