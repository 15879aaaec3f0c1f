#include "taut/math/static_lu.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/math/index.hpp"

namespace taut {
namespace {

void add_sorted(Array<int>& set, int value) {
  const auto place = std::lower_bound(set.begin(), set.end(), value);
  if (place == set.end() || *place != value) set.insert(place, value);
}

}  // namespace

StaticLu::StaticLu(int size, const Array<Array<int>>& cliques) : size_(size) {
  Array<Array<int>> neighbours(as_size(size));
  for (const auto& clique : cliques) {
    for (const int i : clique) {
      for (const int j : clique) {
        if (i != j) add_sorted(neighbours[i], j);
      }
    }
  }
  order(neighbours);
  // beside each pivot its row, then its column: what an operation reads lies side by side
  int count = 0;
  places_.resize(as_size(size));
  for (int k = 0; k < size; ++k) {
    const int p = order_[k];
    const int beside = static_cast<int>(upper_[k].size());
    places_[p].emplace_back(p, count);
    for (int i = 0; i < beside; ++i) {
      const int u = upper_[k][i];
      places_[p].emplace_back(u, count + 1 + i);
      places_[u].emplace_back(p, count + 1 + beside + i);
    }
    count += 1 + 2 * beside;
  }
  for (auto& row : places_) std::sort(row.begin(), row.end());
  values_.assign(as_size(count), 0.0);
  list_operations();
}

/// Least degree first; of equals the one that rested longest, so that the ends of chains are worked on in turn and
/// no operation waits for the one before. Elimination joins the neighbours.
void StaticLu::order(Array<Array<int>>& neighbours) {
  Array<bool> gone(as_size(size_), false);
  Array<std::optional<int>> touched(as_size(size_));
  const auto rank = [&](int i) { return std::pair{neighbours[i].size(), touched[i]}; };
  for (int k = 0; k < size_; ++k) {
    std::optional<int> found;
    for (int i = 0; i < size_; ++i) {
      if (gone[i]) continue;
      if (!found || rank(i) < rank(*found)) found = i;
    }
    const int best = *found;
    gone[best] = true;
    order_.push_back(best);
    upper_.push_back(neighbours[best]);
    for (const int i : upper_.back()) {
      auto& of = neighbours[i];
      touched[i] = k;
      of.erase(std::lower_bound(of.begin(), of.end(), best));
      for (const int j : upper_.back()) {
        if (i != j) add_sorted(of, j);
      }
    }
  }
}

void StaticLu::list_operations() {
  Array<int> rank(as_size(size_), 0);
  for (int k = 0; k < size_; ++k) rank[order_[k]] = k;
  for (int k = 0; k < size_; ++k) {
    const int p = order_[k];
    const auto& row = upper_[k];
    pivots_.push_back({place(p, p), static_cast<int>(unknowns_.size()), static_cast<int>(row.size()),
                       static_cast<int>(targets_.size())});
    for (const int u : row) unknowns_.push_back(rank[u]);
    for (const int i : row) {
      for (const int j : row) targets_.push_back(place(i, j));
    }
  }
  ordered_.assign(as_size(size_), 0.0);
}

int StaticLu::place(int row, int column) const {
  const auto& of = places_[row];
  const auto found = std::lower_bound(of.begin(), of.end(), std::pair{column, -1});
  expects(found != of.end() && found->first == column, "an entry of the pattern");
  return found->second;
}

Array<double> StaticLu::dense() const {
  Array<double> full(as_size(size_) * as_size(size_), 0.0);
  for (int row = 0; row < size_; ++row) {
    for (const auto& [column, place] : places_[row])
      full[as_size(row) * as_size(size_) + as_size(column)] = values_[place];
  }
  return full;
}

void StaticLu::set_zero() {
  if (!held_) std::fill(values_.begin(), values_.end(), 0.0);
}

void StaticLu::hold(bool factors) {
  held_ = factors;
  if (held_) spare_.resize(values_.size(), 0.0);
}

bool StaticLu::factor() {
  double* const v = values_.data();
  for (const Pivot& pivot : pivots_) {
    const double d = v[pivot.diagonal];
    if (d == 0 || !std::isfinite(d)) return false;
    const double inverse = 1 / d;
    v[pivot.diagonal] = inverse;
    const double* const right = v + pivot.diagonal + 1;
    double* const below = v + pivot.diagonal + 1 + pivot.count;
    const int* target = targets_.data() + pivot.operations;
    for (int i = 0; i < pivot.count; ++i, target += pivot.count) {
      const double factor = below[i] *= inverse;
      if (factor == 0) continue;
      for (int j = 0; j < pivot.count; ++j) v[target[j]] -= factor * right[j];
    }
  }
  return true;
}

void StaticLu::solve(Array<double>& x) {
  const double* const v = values_.data();
  double* const y = ordered_.data();
  const std::size_t n = pivots_.size();
  for (std::size_t k = 0; k < n; ++k) y[k] = x[order_[k]];
  for (std::size_t k = 0; k < n; ++k) {
    const Pivot& pivot = pivots_[k];
    const double value = y[k];
    const double* const below = v + pivot.diagonal + 1 + pivot.count;
    const int* const unknown = unknowns_.data() + pivot.first;
    for (int i = 0; i < pivot.count; ++i) y[unknown[i]] -= below[i] * value;
  }
  for (std::size_t k = n; k-- > 0;) {
    const Pivot& pivot = pivots_[k];
    double value = y[k];
    const double* const right = v + pivot.diagonal + 1;
    const int* const unknown = unknowns_.data() + pivot.first;
    for (int i = 0; i < pivot.count; ++i) value -= right[i] * y[unknown[i]];
    y[k] = value * v[pivot.diagonal];
    x[order_[k]] = y[k];
  }
}

}  // namespace taut
