#include "taut/catalogue/rope_words.hpp"

#include <sstream>

#include "taut/catalogue/construction.hpp"
#include "taut/units/display.hpp"
#include "taut/units/parse.hpp"

namespace taut::catalogue {
namespace {

bool read_size(const std::string& text, RopeDescription& wanted) {
  if (const auto d = parse_quantity(text, si::m)) return wanted.diameter = *d, true;
  if (const auto grade = parse_quantity(text, si::Pa)) return wanted.grade = *grade, true;
  return false;
}

bool read_kind(const std::string& word, RopeDescription& wanted) {
  if (const auto core = parse_core(word)) return wanted.core = *core, true;
  const auto construction = parse_construction(word);
  if (!construction) return false;
  wanted.construction = word;
  if (!construction->core.empty()) wanted.core = construction->core;
  return true;
}

}  // namespace

RopeDescription describe_rope(const std::string& words) {
  std::istringstream stream(words);
  std::vector<std::string> all;
  for (std::string word; stream >> word;) all.push_back(word);
  RopeDescription wanted;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i + 1 < all.size() && read_size(all[i] + " " + all[i + 1], wanted)) {
      ++i;
    } else if (!read_size(all[i], wanted) && !read_kind(all[i], wanted)) {
      wanted.standard += (wanted.standard.empty() ? "" : " ") + all[i];
    }
  }
  return wanted;
}

std::string words_of_rope(const RopeRow& row) {
  const Display display;
  std::string text = row.standard + (row.standard.empty() ? "" : " ") + row.construction;
  if (!row.core.empty()) text += "-" + row.core;
  text += " " + display.quantity(row.diameter, si::m.in("mm"));
  if (row.grade) text += " " + display.quantity(*row.grade, si::Pa);
  return text;
}

Found<RopeRow> find_rope_in_words(const std::string& text, const std::vector<RopeRow>& table) {
  if (const RopeRow* row = rope_of_id(text, table)) return *row;
  const RopeDescription wanted = describe_rope(text);
  if (wanted.construction.empty() || wanted.diameter <= 0) return find_rope(text, table);  // fails with names like it
  return find_rope(wanted, table);
}

}  // namespace taut::catalogue
