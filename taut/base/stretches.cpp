#include "taut/base/stretches.hpp"

#include <fmt/format.h>

#include <string_view>

namespace taut {

void Stretches::take(const std::string& why, const std::string& words, const std::string& analysis) {
  const bool goes_on = open_ && analysis == analysis_;
  open_ = !why.empty();
  analysis_ = analysis;
  if (!open_) return;
  if (all_.empty()) why_ = why;
  if (!goes_on) all_.push_back({.from = words, .to = words});
  all_.back().to = words;
  ++all_.back().states;
}

namespace {

/// The words of a state without the parts, between commas, that those of another begin with too.
std::string without_common(const std::string& words, const std::string& other) {
  const std::string_view between = ", ";
  std::size_t common = 0;
  for (std::size_t end = words.find(between); end != std::string::npos; end = words.find(between, common)) {
    const std::size_t next = end + between.size();
    if (words.compare(common, next - common, other, common, next - common) != 0) break;
    common = next;
  }
  return words.substr(common);
}

}  // namespace

std::string Stretches::Stretch::words(const std::string& other) const {
  const std::string first = without_common(from, other);
  return states == 1 ? first : fmt::format("{} to {} ({} states)", first, without_common(to, from), states);
}

std::string Stretches::places() const {
  std::string text = all_.front().words({});
  for (std::size_t i = 1; i < all_.size(); ++i) text += "; " + all_[i].words(all_[i - 1].from);
  return text;
}

std::string Stretches::few_places() const {
  constexpr std::size_t few = 4;
  if (all_.size() <= few) return places();
  return fmt::format("{}; and on {} more stretches, the last {}", all_.front().words({}), all_.size() - 1,
                     all_.back().words(all_.front().from));
}

std::string Stretches::words() const { return fmt::format("{}: {}", places(), why_); }

std::string Stretches::words_of_first() const {
  const std::size_t more = all_.size() - 1;
  if (more == 0) return words();
  return fmt::format("{} and on {} more stretch{}: {}", all_.front().words({}), more, more == 1 ? "" : "es", why_);
}

}  // namespace taut
