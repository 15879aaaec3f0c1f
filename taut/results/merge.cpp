#include "taut/results/merge.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace taut::results {
namespace {

template <class T>
void move_behind(std::vector<T>& from, std::vector<T>& to) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// What one state has largest is no second value beside that of another.
void append_values(std::vector<Value>& from, std::vector<Value>& to) {
  for (Value& v : from) {
    const auto known = std::find_if(to.begin(), to.end(), [&](const Value& one) { return one.name == v.name; });
    if (known == to.end()) {
      to.push_back(std::move(v));
    } else if (v.value > known->value) {
      *known = std::move(v);
    }
  }
}

}  // namespace

void append(Result& from, Result& to) {
  append_values(from.values, to.values);
  move_behind(from.tables, to.tables);
  move_behind(from.checks, to.checks);
  move_behind(from.figures, to.figures);
  move_behind(from.series, to.series);
  move_behind(from.scenes, to.scenes);
  move_behind(from.attachments, to.attachments);
  move_behind(from.assumptions, to.assumptions);
  move_behind(from.warnings, to.warnings);
  move_behind(from.unsafe, to.unsafe);
  move_behind(from.missing, to.missing);
  move_behind(from.unmade, to.unmade);
  move_behind(from.unjudged, to.unjudged);
  to.about.merge(from.about);
  to.loaded.merge(from.loaded);
  move_behind(from.exempt, to.exempt);
  move_behind(from.left_out, to.left_out);
  move_behind(from.beside, to.beside);
  move_behind(from.answers, to.answers);
  to.preface += from.preface;
  if (to.headline.empty()) to.headline = from.headline;
}

}  // namespace taut::results
