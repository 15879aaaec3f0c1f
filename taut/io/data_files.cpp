#include "taut/io/data_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "taut/calc/comparison.hpp"

namespace taut::io {
namespace {

/// Bytes of the longest name: file systems take 255, with an ending and what tells two names apart.
constexpr std::size_t longest = 200;

/// What parts folders, stands for other files or ends the path of a link.
bool is_harmless(char c) {
  return static_cast<unsigned char>(c) >= 0x20 && c != 0x7f &&
         std::string_view("/\\:*?\"<>|#%").find(c) == std::string::npos;
}

/// A name that becomes one of a file, and what is put behind it where it is taken.
struct FileName {
  std::string* name = nullptr;
  const char* behind = "";
};

/// The name of a figure whose numbers are written; none where they are not.
std::string* name_of_data(Figure& f) {
  if (auto* plot = std::get_if<Plot>(&f)) return plot->name.empty() ? nullptr : &plot->name;
  if (auto* profile = std::get_if<Profile>(&f)) return &profile->name;
  return nullptr;
}

std::vector<FileName> names_in(Result& r) {
  std::vector<FileName> all;
  all.reserve(r.tables.size() + r.series.size() + r.figures.size());
  for (Table& t : r.tables) all.push_back({.name = &t.name});
  for (Table& t : r.series) all.push_back({.name = &t.name});
  for (Figure& f : r.figures) {
    if (std::string* name = name_of_data(f)) all.push_back({.name = name, .behind = "_plot"});
  }
  return all;
}

/// Names that are given before any other.
std::set<std::string> reserved_in(const Result& r) {
  if (r.comparisons.empty()) return {};
  return {comparison_table(r.comparisons).name};
}

std::string free_name(const FileName& one, const std::set<std::string>& taken) {
  std::string name = *one.name + one.behind;
  for (int number = 2; taken.contains(name); ++number) name = fmt::format("{}{}_{}", *one.name, one.behind, number);
  return name;
}

}  // namespace

std::string name_of_file(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !is_harmless(c); }, '_');
  if (name.starts_with('.')) name.front() = '_';  // a hidden file, or a folder
  if (name.size() <= longest) return name;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) --end;  // no half of a letter
  name.resize(end);
  return name;
}

bool named_apart(const Result& r) {
  std::set<std::string> taken = reserved_in(r);
  const auto is_new = [&](const std::string& name) { return name == name_of_file(name) && taken.insert(name).second; };
  for (const Scene& scene : r.scenes) {
    if (scene.name != name_of_file(scene.name)) return false;
  }
  for (const std::vector<Table>* tables : {&r.tables, &r.series}) {
    for (const Table& t : *tables) {
      if (!is_new(t.name)) return false;
    }
  }
  for (const Figure& f : r.figures) {
    const auto* plot = std::get_if<Plot>(&f);
    const auto* profile = std::get_if<Profile>(&f);
    const std::string& name = plot != nullptr ? plot->name : profile != nullptr ? profile->name : std::string{};
    if (!name.empty() && !is_new(name)) return false;
  }
  return true;
}

void name_apart(Result& r) {
  // the picture of page 1 is the first of its name, which the result goes on to name
  std::string* key = nullptr;
  for (Figure& f : r.figures) {
    std::string& name = std::visit([](auto& own) -> std::string& { return own.name; }, f);
    if (key == nullptr && !r.key_figure.empty() && name == r.key_figure) key = &name;
  }
  std::set<std::string> taken = reserved_in(r);
  std::vector<FileName> again;
  for (const FileName& one : names_in(r)) {
    *one.name = name_of_file(std::move(*one.name));
    if (!taken.insert(*one.name).second) again.push_back(one);
  }
  for (const FileName& one : again) {
    *one.name = free_name(one, taken);
    taken.insert(*one.name);
  }
  for (Scene& scene : r.scenes) scene.name = name_of_file(std::move(scene.name));
  if (key != nullptr) r.key_figure = *key;
}

}  // namespace taut::io
