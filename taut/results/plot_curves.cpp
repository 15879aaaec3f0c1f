#include "taut/results/plot_curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace taut::results {

void keep_largest(Plot& plot, std::size_t most) {
  const std::size_t all = plot.curves.size();
  if (all <= most) return;
  std::vector<double> size(all, 0);
  for (std::size_t i = 0; i < all; ++i) {
    for (const double y : plot.curves[i].y) size[i] = std::fmax(size[i], std::abs(y));
  }
  std::vector<std::size_t> order(all);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return size[a] > size[b]; });
  order.resize(most);
  std::sort(order.begin(), order.end());
  std::vector<Curve> kept;
  for (const std::size_t i : order) kept.push_back(std::move(plot.curves[i]));
  plot.curves = std::move(kept);
  plot.caption +=
      fmt::format("{}The {} curves with the largest values of {}.", plot.caption.empty() ? "" : " ", most, all);
}

}  // namespace taut::results
