#include "taut/app/swept_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "taut/results/merge.hpp"

namespace taut::app {

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
  for (std::string& one : at.warnings) {
    const bool unsafe = std::find(at.unsafe.begin(), at.unsafe.end(), one) != at.unsafe.end();
    if (!is_new((unsafe ? "unsafe " : "warning ") + one)) continue;
    std::string sentence = fmt::format("{}: {}", words, one);
    unsafe ? warn_unsafe(all_, std::move(sentence)) : all_.warnings.push_back(std::move(sentence));
  }
  for (std::string& one : at.unmade) {
    if (is_new("unmade " + one)) all_.unmade.push_back(std::move(one));
  }
}

void SweptVerdict::put_into(Result& r) && { results::append(all_, r); }

}  // namespace taut::app
