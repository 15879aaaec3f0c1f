#include "taut/io/deck/write.hpp"

#include <gtest/gtest.h>

#include "taut/io/deck/document.hpp"

namespace taut::io::write_test {

/// Kinds, texts and quotes alike; places may differ.
void expect_same(const Node& a, const Node& b, const std::string& where) {
  ASSERT_EQ(a.kind, b.kind) << where;
  EXPECT_EQ(a.text, b.text) << where;
  ASSERT_EQ(a.items.size(), b.items.size()) << where;
  for (std::size_t i = 0; i < a.items.size(); ++i) expect_same(a.items[i], b.items[i], where + "[]");
  ASSERT_EQ(a.entries.size(), b.entries.size()) << where;
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    EXPECT_EQ(a.entries[i].key, b.entries[i].key) << where;
    expect_same(a.entries[i].value, b.entries[i].value, where + "." + a.entries[i].key);
  }
}

TEST(ToYaml, IsReadAsTheSameValues) {
  const char* const texts[] = {
      "a: 1\nb: [1 m, 2 m]\nc: {d: {e: x}, f: []}\n", "- {a: 1}\n- b\n- [1, [2, 3]]\n- [{a: {b: [c, {d: 1}]}}, 2]\n",
      "text: 'it''s: a # \"text\", [x] {y} & *z'\nlines: |\n  one\n  two\nnone: null\nempty: ''\n",
      "'machine.loads[0].mass': 1 t\nrope: \"EN 12385-4|6x36-IWRC|20|1960\"\nexpression: = 2 * travel\nminus: -1\n",
      "percent: 5 %\nstar: '*a'\ndash: '- b'\nslope: 12 %\nnumber: '12'\nunicode: mü\n"};
  for (const char* text : texts) {
    const auto before = parse(text, "before");
    ASSERT_TRUE(before.has_value());
    const std::string written = to_yaml(before->root);
    const auto after = parse(written, "after");
    ASSERT_TRUE(after.has_value()) << written << to_text(after.error());
    EXPECT_TRUE(after->mistakes.empty()) << written;
    expect_same(before->root, after->root, written);
  }
}

}  // namespace taut::io::write_test
