#include "taut/catalogue/lookup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "taut/base/suggest.hpp"

namespace taut::catalogue {
namespace {

constexpr std::size_t longest_name = 120;  // longer than any id: not worth the quadratic comparison

// What people type for the sign between two dimensions, and for a dash.
constexpr std::array<std::pair<std::string_view, char>, 6> look_alikes{
    {{"\u00d7", 'x'}, {"\u0445", 'x'}, {"\u0425", 'x'}, {"\u2013", '-'}, {"\u2212", '-'}, {"\u00a0", ' '}}};

/// Takes the next byte of a normalised name from the front of `name`; none at its end.
std::optional<char> take_character(std::string_view& name) {
  while (!name.empty()) {
    char c = name.front();
    std::size_t length = 1;
    // only what is not ASCII can look like something that is
    if (static_cast<unsigned char>(c) >= 0x80) {
      for (const auto& [sign, plain] : look_alikes) {
        if (!name.starts_with(sign)) continue;
        c = plain;
        length = sign.size();
        break;
      }
    }
    name.remove_prefix(length);
    if (c == ' ' || c == '\t') continue;
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return std::nullopt;
}

}  // namespace

std::string normalised(std::string_view name) {
  std::string out;
  out.reserve(name.size());
  while (const auto c = take_character(name)) out += *c;
  return out;
}

bool is_named(std::string_view name, std::string_view wanted) {
  std::size_t i = 0;
  while (const auto c = take_character(name)) {
    if (i == wanted.size() || wanted[i] != *c) return false;
    ++i;
  }
  return i == wanted.size();
}

std::vector<std::string> nearest_names(std::string_view word, const std::vector<std::string>& names,
                                       std::size_t count) {
  const std::string wanted = normalised(word);
  if (wanted.empty() || wanted.size() > longest_name) return {};
  std::vector<std::pair<int, std::size_t>> ranking;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = normalised(names[i]);
    if (name.size() > longest_name) continue;
    const int distance = edit_distance(wanted, name);
    if (2 * distance <= static_cast<int>(std::max(wanted.size(), name.size()))) ranking.emplace_back(distance, i);
  }
  const std::size_t kept = std::min(count, ranking.size());
  std::partial_sort(ranking.begin(), ranking.begin() + static_cast<std::ptrdiff_t>(kept), ranking.end());
  std::vector<std::string> out;
  out.reserve(kept);
  for (std::size_t i = 0; i < kept; ++i) out.push_back(names[ranking[i].second]);
  return out;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t most = 60;
  std::size_t end = std::min(most, text.size());
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  std::string shown(text.substr(0, end));
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20U; }, '?');
  return fmt::format("'{}{}'", shown, end < text.size() ? "..." : "");
}

std::string short_number(double value) { return fmt::format("{:.6g}", value); }

std::string listed(const std::vector<std::string>& texts, std::size_t count) {
  const std::size_t shown = std::min(count, texts.size());
  std::string out =
      fmt::format("{}", fmt::join(texts.begin(), texts.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  if (shown < texts.size()) out += fmt::format(" and {} more", texts.size() - shown);
  return out;
}

tl::unexpected<LookupError> failure(std::string message, std::vector<std::string> candidates) {
  return tl::unexpected(LookupError{.message = std::move(message), .candidates = std::move(candidates)});
}

std::string to_text(const LookupError& error) {
  if (error.candidates.empty()) return error.message;
  constexpr std::size_t most = 3;
  std::vector<std::string> shown;
  for (const std::string& candidate : error.candidates) {
    if (shown.size() < most) shown.push_back(in_quotes(candidate));
  }
  return fmt::format("{}; did you mean {}?", error.message, fmt::join(shown, " or "));
}

}  // namespace taut::catalogue
