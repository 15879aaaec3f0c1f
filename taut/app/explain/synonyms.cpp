#include "taut/app/explain/synonyms.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace taut::app {
namespace {

/// The word of the field; the key, part or analysis of a deck.
constexpr std::pair<std::string_view, std::string_view> table[] = {
    {"anchorage", "anchors"},
    {"bearing", "efficiency"},
    {"block", "sheaves"},
    {"bobbin", "drums"},
    {"cable", "ropes"},
    {"capstan", "friction"},
    {"counterweight", "take_up"},
    {"crossarm", "bodies"},
    {"cylinder", "actuators"},
    {"deadman", "anchors"},
    {"deflection", "sag"},
    {"dip", "sag"},
    {"eigenfrequency", "modes"},
    {"eta", "efficiency"},
    {"frequency", "modes"},
    {"ground", "terrain"},
    {"guyline", "guys"},
    {"jack", "supports"},
    {"jib", "bodies"},
    {"logs", "loads"},
    {"mast", "beams"},
    {"pole", "beams"},
    {"profile", "terrain"},
    {"pulley", "sheaves"},
    {"ram", "actuators"},
    {"saddle", "supports"},
    {"shoe", "supports"},
    {"skyline", "reevings"},
    {"spar", "beams"},
    {"stay", "guys"},
    {"strut", "beams"},
    {"stump", "anchors"},
    {"survey", "terrain"},
    {"tackle", "reevings"},
    {"tensioning", "pretension"},
    {"trackrope", "reevings"},
    {"tree", "anchors"},
    {"trolley", "carriages"},
    {"vibration", "modes"},
    {"weight", "loads"},
    {"winch", "drums"},
    {"wire", "ropes"},
};

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

}  // namespace

std::string deck_word(std::string_view word) {
  const std::string wanted = lower(word);
  for (const auto& [other, own] : table) {
    if (other == wanted || std::string(other) + "s" == wanted) return std::string(own);
  }
  return {};
}

std::vector<std::string> field_words() {
  std::vector<std::string> all;
  for (const auto& [other, own] : table) all.emplace_back(other);
  return all;
}

}  // namespace taut::app
