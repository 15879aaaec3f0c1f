#include "taut/machine/compile/terrain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "taut/base/array.hpp"

namespace taut::machine {
namespace {

/// A survey's row seen from the line.
struct Surveyed {
  int row = 0;          ///< from 1 on
  double chainage = 0;  ///< m
  double height = 0;    ///< m
  double off = 0;       ///< distance from the line in plan, m
};

class TerrainBuilder {
 public:
  TerrainBuilder(const description::Terrain& given, const Links& links, Model& model,
                 std::vector<Complaint>& complaints)
      : given_(given), links_(links), model_(model), complaints_(complaints) {}

  void build() {
    const std::size_t before = complaints_.size();
    check_lists();
    if (complaints_.size() > before) return;
    set_line();
    if (complaints_.size() > before) return;
    if (given_.y.empty()) {
      add_profile();
    } else {
      add_survey();
    }
  }

 private:
  void complain(const std::string& key, std::string message) {
    complaints_.push_back({key.empty() ? "terrain" : "terrain." + key, std::move(message)});
  }

  void check_lists() {
    const auto& [file, x, z, from, along, y, between, corridor] = given_;
    if (!from.empty() && from.size() != 2) complain("from", "two coordinates [x, y] are expected");
    if (!along.empty() && (along.size() != 2 || std::hypot(along[0], along[1]) == 0)) {
      complain("along", "a horizontal direction [x, y] is expected, not zero");
    }
    if (!between.empty() && between.size() != 2) complain("between", "the names of two points are expected");
    if (!between.empty() && !(from.empty() && along.empty())) {
      complain("between", "gives the line already; leave 'from' and 'along' out");
    }
    if (x.size() != z.size()) complain("z", fmt::format("{} heights for {} places", z.size(), x.size()));
    if (!y.empty() && y.size() != x.size()) {
      complain("y", fmt::format("{} values of y for {} of x: a survey has both in every row", y.size(), x.size()));
    }
    if (std::min(x.size(), z.size()) < 2 && !(file && x.empty())) {
      complain("", "needs a 'file', or two places 'x' with their 'z'");
    }
  }

  /// In plan.
  Vector3 point(const std::string& name) {
    const Target* t = links_.find(name, {Thing::point}, "terrain.between", complaints_);
    if (t == nullptr) return Vector3::Zero();
    if (t->place.body != ground) {
      complain("between", fmt::format("'{}' is on a body that may move: name a point of the ground frame", name));
    }
    return {t->place.at.x(), t->place.at.y(), 0};
  }

  void set_line() {
    Vector3 from = Vector3::Zero(), way = Vector3::UnitX();
    const bool own = !given_.from.empty() || !given_.along.empty();
    if (!given_.between.empty()) {
      from = point(given_.between[0]);
      way = point(given_.between[1]) - from;
    } else if (own || given_.y.empty()) {
      if (!given_.from.empty()) from = {given_.from[0], given_.from[1], 0};
      if (!given_.along.empty()) way = {given_.along[0], given_.along[1], 0};
    } else {
      from = {given_.x.front(), given_.y.front(), 0};
      way = Vector3(given_.x.back(), given_.y.back(), 0) - from;
    }
    if (way.norm() == 0) {
      complain(given_.between.empty() ? "" : "between",
               "the line has no length in plan: name two points that lie apart in 'between'");
      return;
    }
    model_.terrain_from = from;
    model_.terrain_along = way.normalized();
  }

  void add_profile() {
    for (std::size_t i = 0; i < given_.x.size(); ++i) {
      if (i > 0 && given_.x[i] <= given_.x[i - 1]) {
        complain(given_.file ? "file" : fmt::format("x[{}]", i), "x has to grow from place to place");
        return;
      }
      model_.terrain.push_back({given_.x[i], given_.z[i]});
    }
  }

  void add_survey() {
    const Vector3& along = model_.terrain_along;
    Array<Surveyed> rows;
    for (std::size_t i = 0; i < given_.x.size(); ++i) {
      const Vector3 place = Vector3(given_.x[i], given_.y[i], 0) - model_.terrain_from;
      rows.push_back({static_cast<int>(i) + 1, along.dot(place), given_.z[i],
                      std::abs(along.x() * place.y() - along.y() * place.x())});
    }
    for (const Surveyed& row : rows) note(row);
    std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.chainage < b.chainage; });
    const double rounding = 1e-9 * std::max(1.0, rows.back().chainage - rows.front().chainage);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i > 0 && !(rows[i].chainage > rows[i - 1].chainage + rounding)) {
        complain(given_.file ? "file" : "x",
                 fmt::format("rows {} and {} of the survey lie at one place of the line, {:.4g} m along it, {:.3g} m "
                             "and {:.3g} m off it: leave the one out that is not on the line",
                             rows[i - 1].row, rows[i].row, rows[i].chainage, rows[i - 1].off, rows[i].off));
        return;
      }
      model_.terrain.push_back({rows[i].chainage, rows[i].height});
    }
  }

  void note(const Surveyed& row) {
    OffLine& off = model_.terrain_off_line;
    if (row.off <= given_.corridor) return;
    ++off.rows;
    if (row.off <= off.distance) return;
    off.farthest = row.row;
    off.distance = row.off;
    off.chainage = row.chainage;
  }

  const description::Terrain& given_;
  const Links& links_;
  Model& model_;
  std::vector<Complaint>& complaints_;
};

}  // namespace

void add_terrain(const description::Terrain& given, const Links& links, Model& model,
                 std::vector<Complaint>& complaints) {
  TerrainBuilder(given, links, model, complaints).build();
}

}  // namespace taut::machine
