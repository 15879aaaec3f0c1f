#include "taut/app/swept_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "taut/checks/described.hpp"
#include "taut/results/merge.hpp"

namespace taut::app {
namespace {

/// One value of each name: the worse one.
void keep_worst(Value one, std::vector<Value>& values) {
  const auto known = std::find_if(values.begin(), values.end(), [&](const Value& v) { return v.name == one.name; });
  if (known == values.end()) {
    values.push_back(std::move(one));
  } else if (checks::worst_side(one.name) == Sense::at_least ? one.value < known->value : one.value > known->value) {
    *known = std::move(one);
  }
}

}  // namespace

bool SweptVerdict::is_new(const std::string& sentence) {
  std::string kind = sentence;
  std::erase_if(kind, [](unsigned char c) { return std::isdigit(c) != 0 || c == '.'; });
  return known_.insert(std::move(kind)).second;
}

void SweptVerdict::take(Result at, const std::string& words) {
  if (at.status != Status::ok) {
    std::string sentence = fmt::format("{}: its checks have no answer: {}", words, at.message);
    if (is_new("no answer")) all_.unmade.push_back(std::move(sentence));
    return;
  }
  for (Check& one : at.checks) {
    if (one.where.empty()) one.where = words;
    all_.checks.push_back(std::move(one));
  }
  for (Value& one : at.values) {
    if (!checks::worst_side(one.name)) continue;
    one.label += fmt::format(", {}", words);
    keep_worst(std::move(one), values_);
  }
  for (std::string& one : at.warnings) {
    const bool unsafe = std::find(at.unsafe.begin(), at.unsafe.end(), one) != at.unsafe.end();
    if (!is_new((unsafe ? "unsafe " : "warning ") + one)) continue;
    std::string sentence = fmt::format("{}: {}", words, one);
    unsafe ? warn_unsafe(all_, std::move(sentence)) : all_.warnings.push_back(std::move(sentence));
  }
  for (std::string& one : at.unmade) {
    if (is_new("unmade " + one)) all_.unmade.push_back(std::move(one));
  }
  for (std::string& one : at.unjudged) {
    if (is_new("unjudged " + one)) all_.unjudged.push_back(std::move(one));
  }
}

void SweptVerdict::put_into(Result& r) { results::append(all_, r); }

void SweptVerdict::put_values_into(Result& r) && {
  for (Value& one : values_) keep_worst(std::move(one), r.values);
}

}  // namespace taut::app
