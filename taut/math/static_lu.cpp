#include "taut/math/static_lu.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/expects.hpp"
#include "taut/math/index.hpp"

namespace taut {
namespace {

void add_sorted(std::vector<int>& set, int value) {
  const auto place = std::lower_bound(set.begin(), set.end(), value);
  if (place == set.end() || *place != value) set.insert(place, value);
}

}  // namespace

StaticLu::StaticLu(int size, const std::vector<std::vector<int>>& cliques) : size_(size) {
  std::vector<std::vector<int>> neighbours(at(size));
  for (const auto& clique : cliques) {
    for (const int i : clique) {
      for (const int j : clique) {
        if (i != j) add_sorted(neighbours[at(i)], j);
      }
    }
  }
  order(neighbours);
  // beside each pivot its row, then its column: what an operation reads lies side by side
  int count = 0;
  places_.resize(at(size));
  for (int k = 0; k < size; ++k) {
    const int p = order_[at(k)];
    const int beside = static_cast<int>(upper_[at(k)].size());
    places_[at(p)].emplace_back(p, count);
    for (int i = 0; i < beside; ++i) {
      const int u = upper_[at(k)][at(i)];
      places_[at(p)].emplace_back(u, count + 1 + i);
      places_[at(u)].emplace_back(p, count + 1 + beside + i);
    }
    count += 1 + 2 * beside;
  }
  for (auto& row : places_) std::sort(row.begin(), row.end());
  values_.assign(at(count), 0.0);
  list_operations();
}

/// Least degree first; of equals the one that rested longest, so that the ends of chains are worked on in turn and
/// no operation waits for the one before. Elimination joins the neighbours.
void StaticLu::order(std::vector<std::vector<int>>& neighbours) {
  std::vector<bool> gone(at(size_), false);
  std::vector<int> touched(at(size_), -1);
  const auto rank = [&](int i) { return std::pair{neighbours[at(i)].size(), touched[at(i)]}; };
  for (int k = 0; k < size_; ++k) {
    int best = -1;
    for (int i = 0; i < size_; ++i) {
      if (gone[at(i)]) continue;
      if (best < 0 || rank(i) < rank(best)) best = i;
    }
    gone[at(best)] = true;
    order_.push_back(best);
    upper_.push_back(neighbours[at(best)]);
    for (const int i : upper_.back()) {
      auto& of = neighbours[at(i)];
      touched[at(i)] = k;
      of.erase(std::lower_bound(of.begin(), of.end(), best));
      for (const int j : upper_.back()) {
        if (i != j) add_sorted(of, j);
      }
    }
  }
}

void StaticLu::list_operations() {
  std::vector<int> rank(at(size_), 0);
  for (int k = 0; k < size_; ++k) rank[at(order_[at(k)])] = k;
  for (int k = 0; k < size_; ++k) {
    const int p = order_[at(k)];
    const auto& row = upper_[at(k)];
    pivots_.push_back({place(p, p), static_cast<int>(unknowns_.size()), static_cast<int>(row.size()),
                       static_cast<int>(targets_.size())});
    for (const int u : row) unknowns_.push_back(rank[at(u)]);
    for (const int i : row) {
      for (const int j : row) targets_.push_back(place(i, j));
    }
  }
  ordered_.assign(at(size_), 0.0);
}

int StaticLu::place(int row, int column) const {
  const auto& of = places_[at(row)];
  const auto found = std::lower_bound(of.begin(), of.end(), std::pair{column, -1});
  expects(found != of.end() && found->first == column, "an entry of the pattern");
  return found->second;
}

std::vector<double> StaticLu::dense() const {
  std::vector<double> full(at(size_) * at(size_), 0.0);
  for (int row = 0; row < size_; ++row) {
    for (const auto& [column, place] : places_[at(row)]) full[at(row) * at(size_) + at(column)] = values_[at(place)];
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

void StaticLu::solve(std::vector<double>& x) {
  const double* const v = values_.data();
  double* const y = ordered_.data();
  const std::size_t n = pivots_.size();
  for (std::size_t k = 0; k < n; ++k) y[k] = x[at(order_[k])];
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
    x[at(order_[k])] = y[k];
  }
}

}  // namespace taut
