#include "taut/catalogue/construction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "taut/catalogue/lookup.hpp"

namespace taut::catalogue {
namespace {

using Names = std::pair<std::string_view, std::string_view>;

// Other spellings of a lay, without the K of compacted strands.
constexpr std::array<Names, 10> lay_names{{{"", ""},
                                           {"s", "s"},
                                           {"w", "w"},
                                           {"f", "f"},
                                           {"fi", "f"},
                                           {"fw", "f"},
                                           {"ws", "ws"},
                                           {"sws", "ws"},
                                           {"m", "m"},
                                           {"standard", "m"}}};

constexpr std::array<Names, 5> lay_of_layers{
    {{"1+9+9", "s"}, {"1+6+6/6", "w"}, {"1+6;6+12", "f"}, {"1+6+6f+12", "f"}, {"1+7+7/7+14", "ws"}}};

constexpr std::array<Names, 11> core_names{{{"fc", "FC"},
                                            {"nfc", "FC"},
                                            {"sfc", "FC"},
                                            {"hc", "FC"},
                                            {"fibre", "FC"},
                                            {"fiber", "FC"},
                                            {"o.c.", "FC"},
                                            {"1o.c.", "FC"},
                                            {"iwrc", "IWRC"},
                                            {"7x7", "IWRC"},
                                            {"wsc", "WSC"}}};

template <std::size_t n>
std::optional<std::string> translated(const std::array<Names, n>& table, std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const Names& row) { return row.first == name; });
  if (found == table.end()) return std::nullopt;
  return std::string(found->second);
}

/// Takes a number from the front of `rest`; 0 when there is none.
int take_number(std::string_view& rest) {
  int value = 0;
  const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error != std::errc()) return 0;
  rest.remove_prefix(static_cast<std::size_t>(stop - rest.data()));
  return value;
}

std::optional<std::string> parse_lay(std::string_view letters) {
  const bool compacted = letters.starts_with('k');
  if (compacted) letters.remove_prefix(1);
  auto lay = translated(lay_names, letters);
  if (lay && compacted) lay = fmt::format("k{}", *lay);
  return lay;
}

bool needs_naming(std::string_view lay) { return lay.starts_with('k') || lay == "m"; }

}  // namespace

std::optional<std::string> parse_core(std::string_view name) { return translated(core_names, normalised(name)); }

std::optional<Construction> parse_construction(std::string_view name) {
  const std::string plain = normalised(name);
  std::string_view rest = plain;
  Construction out;
  out.strands = take_number(rest);
  if (out.strands <= 0 || !(rest.starts_with('x') || rest.starts_with('*'))) return std::nullopt;
  rest.remove_prefix(1);
  out.wires = take_number(rest);
  if (out.wires <= 0) return std::nullopt;

  const std::size_t letters = std::min(rest.find_first_of("(-+"), rest.size());
  const auto lay = parse_lay(rest.substr(0, letters));
  if (!lay) return std::nullopt;
  out.lay = *lay;
  rest.remove_prefix(letters);

  if (rest.starts_with('(')) {
    const std::size_t close = rest.find(')');
    if (close == std::string_view::npos) return std::nullopt;
    out.layers = std::string(rest.substr(1, close - 1));
    if (out.lay.empty()) out.lay = translated(lay_of_layers, out.layers).value_or("");
    rest.remove_prefix(close + 1);
  }
  if (rest.empty()) return out;
  const auto core = parse_core(rest.substr(1));
  if (!core) return std::nullopt;
  out.core = *core;
  return out;
}

std::string construction_class(std::string_view name) {
  const auto known = parse_construction(name);
  if (!known) return {};
  if (known->strands >= 10) return "18x7";
  if (known->strands != 6 && known->strands != 8) return {};
  const int n = known->wires;
  const char* const wires = n >= 5 && n <= 9 ? "7" : n >= 15 && n <= 26 ? "19" : n >= 27 && n <= 49 ? "36" : nullptr;
  return wires == nullptr ? std::string{} : fmt::format("{}x{}", known->strands, wires);
}

bool matches_construction(std::string_view asked, std::string_view listed) {
  const std::string asked_plain = normalised(asked);
  const std::string listed_plain = normalised(listed);
  if (asked_plain == listed_plain) return true;
  const auto a = parse_construction(asked_plain);
  const auto b = parse_construction(listed_plain);
  if (!a || !b) return !a && !b && !asked_plain.empty() && listed_plain.starts_with(asked_plain);
  if (a->strands != b->strands || a->wires != b->wires) return false;
  if (!a->layers.empty() && !b->layers.empty() && a->layers != b->layers) return false;
  if (a->lay == b->lay) return true;
  if (needs_naming(a->lay) || needs_naming(b->lay)) return false;
  return a->lay.empty() || b->lay.empty();
}

}  // namespace taut::catalogue
