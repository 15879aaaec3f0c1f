#include "taut/catalogue/forestry/tree.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "taut/base/expects.hpp"
#include "taut/catalogue/csv.hpp"
#include "taut/catalogue/embedded/anchor_trees_csv.hpp"
#include "taut/catalogue/embedded/support_trees_csv.hpp"

namespace taut::catalogue {
namespace {

constexpr double degree_of_tree = std::numbers::pi / 180;
constexpr double taper = 0.01;         // m of diameter per m of height
constexpr double breast_height = 1.5;  // m: as the source of the table counts it

/// A force or a height that is equal to that of a row but for the last digit belongs to it.
bool reaches(double row, double value) { return row >= value * (1 - 1e-9); }

std::vector<AnchorTreeRow> read_anchor_trees() {
  CsvReader csv(embedded::anchor_trees_csv, "data/trees/anchor_trees.csv",
                {{.name = "angle_below_deg"},
                 {.name = "force_kN"},
                 {.name = "diameter_cm"},
                 {.name = "trust"},
                 {.name = "trust_text"}});
  std::vector<AnchorTreeRow> rows;
  while (csv.next()) {
    rows.push_back({.angle_below = csv.positive("angle_below_deg") * degree_of_tree,
                    .force = csv.positive("force_kN"),
                    .diameter = csv.positive("diameter_cm"),
                    .trust = csv.trust("trust"),
                    .trust_text = csv.text("trust_text")});
  }
  expects(!csv.failed(), csv.failed() ? to_text(csv.take_diagnostics()) : "");
  return rows;
}

std::vector<SupportTreeRow> read_support_trees() {
  CsvReader csv(
      embedded::support_trees_csv, "data/trees/support_trees.csv",
      {{.name = "force_kN"}, {.name = "height_m"}, {.name = "diameter_cm"}, {.name = "trust"}, {.name = "trust_text"}});
  std::vector<SupportTreeRow> rows;
  while (csv.next()) {
    rows.push_back({.force = csv.positive("force_kN"),
                    .height = csv.positive("height_m"),
                    .diameter = csv.positive("diameter_cm"),
                    .trust = csv.trust("trust"),
                    .trust_text = csv.text("trust_text")});
  }
  expects(!csv.failed(), csv.failed() ? to_text(csv.take_diagnostics()) : "");
  return rows;
}

}  // namespace

const std::vector<AnchorTreeRow>& anchor_trees() {
  static const std::vector<AnchorTreeRow> rows = read_anchor_trees();
  return rows;
}

std::vector<AnchorTreeRow> anchor_trees_at(double angle) {
  const auto& all = anchor_trees();
  const auto first = std::find_if(all.begin(), all.end(), [&](const auto& row) { return angle < row.angle_below; });
  std::vector<AnchorTreeRow> rows;
  if (first == all.end()) return rows;
  std::copy_if(first, all.end(), std::back_inserter(rows),
               [&](const auto& row) { return row.angle_below == first->angle_below; });
  return rows;
}

std::optional<double> anchor_tree_diameter(double force, double angle) {
  const std::vector<AnchorTreeRow> rows = anchor_trees_at(angle);
  const auto above = std::find_if(rows.begin(), rows.end(), [&](const auto& row) { return reaches(row.force, force); });
  if (above == rows.end()) return std::nullopt;
  if (above == rows.begin() || force >= above->force) return above->diameter;
  const AnchorTreeRow& below = *std::prev(above);
  const double share = (force - below.force) / (above->force - below.force);
  const double low = below.diameter * below.diameter, high = above->diameter * above->diameter;
  return std::sqrt(low + share * (high - low));
}

const std::vector<SupportTreeRow>& support_trees() {
  static const std::vector<SupportTreeRow> rows = read_support_trees();
  return rows;
}

std::optional<double> support_tree_diameter(double force, double height) {
  const auto& all = support_trees();
  const auto row = std::find_if(all.begin(), all.end(), [&](const auto& one) { return reaches(one.force, force); });
  if (row == all.end()) return std::nullopt;
  const auto found = std::find_if(
      row, all.end(), [&](const auto& one) { return one.force == row->force && reaches(one.height, height); });
  if (found == all.end()) return std::nullopt;
  return found->diameter;
}

double breast_height_diameter(double at_lashing, double height) {
  return at_lashing + taper * std::max(0.0, height - breast_height);
}

}  // namespace taut::catalogue
