#include "taut/app/explain/starters.hpp"

#include <algorithm>
#include <utility>

#include "taut/app/embedded/machine_examples.hpp"

namespace taut::app {
namespace {

/// What an engineer asks for, where no name or more than one has it as a part.
constexpr std::pair<std::string_view, std::string_view> short_names[] = {
    {"machine", "clamped_load"}, {"skyline", "clamped_load"}, {"tackle", "six_part_tackle"}};

std::string title_of(std::string_view text) {
  constexpr std::string_view key = "\ntitle: ";
  const std::size_t at = text.find(key);
  if (at == std::string_view::npos) return {};
  const std::size_t from = at + key.size();
  return std::string(text.substr(from, text.find('\n', from) - from));
}

/// A deck whose terrain lies in a file, or that includes another one, does not run alone.
bool stands_alone(std::string_view text) {
  return text.find("file:") == std::string_view::npos && text.find("include:") == std::string_view::npos;
}

const Starter* named(std::string_view name) {
  const auto& all = starters();
  const auto at = std::find_if(all.begin(), all.end(), [&](const Starter& one) { return one.name == name; });
  return at == all.end() ? nullptr : &*at;
}

}  // namespace

const std::vector<Starter>& starters() {
  static const std::vector<Starter> all = [] {
    std::vector<Starter> found;
    for (const auto& [file, text] : embedded::machine_examples) {
      if (stands_alone(text)) found.push_back({std::string(file.substr(0, file.rfind('.'))), title_of(text), text});
    }
    std::sort(found.begin(), found.end(), [](const Starter& a, const Starter& b) { return a.name < b.name; });
    return found;
  }();
  return all;
}

const Starter* find_starter(std::string_view name) {
  if (const Starter* own = named(name)) return own;
  for (const auto& [word, meant] : short_names) {
    if (word == name) return named(meant);
  }
  const Starter* found = nullptr;
  for (const Starter& one : starters()) {
    if (name.empty() || one.name.find(name) == std::string::npos) continue;
    if (found != nullptr) return nullptr;
    found = &one;
  }
  return found;
}

std::string starter_deck(std::string_view text) {
  return "# yaml-language-server: $schema=taut.schema.json\n" + std::string(text);
}

std::vector<std::string> starter_names() {
  std::vector<std::string> names;
  for (const Starter& one : starters()) names.push_back(one.name);
  return names;
}

}  // namespace taut::app
