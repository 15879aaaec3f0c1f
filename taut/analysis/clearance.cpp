#include "taut/analysis/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/analysis/load_path.hpp"

namespace taut::analysis {
namespace {

/// One span over the ground, by its unstretched length s from the start.
class Over {
 public:
  Over(const std::vector<model::GroundPoint>& terrain, const SpanResult& span, double from, double to, Lowest& lowest)
      : terrain_(terrain), span_(span), from_(from), to_(to), lowest_(lowest) {}

  void look() const {
    look_at(span_.start);
    look_at(span_.end);
    const double low = std::max(from_, std::min(span_.start.x(), span_.end.x()));
    const double high = std::min(to_, std::max(span_.start.x(), span_.end.x()));
    if (!(low < high)) return;
    look_at_x(low);
    look_at_x(high);
    for (std::size_t i = 0; i < terrain_.size(); ++i) {
      if (terrain_[i].x > low && terrain_[i].x < high) look_at_x(terrain_[i].x);
      if (i + 1 < terrain_.size() && terrain_[i].x < high && terrain_[i + 1].x > low) look_where_parallel(i);
    }
  }

 private:
  bool straight() const { return span_.slack || span_.shape.rope.weight <= 0 || span_.shape.force.H <= 0; }

  void look_at(const Vector3& point) const {
    if (point.x() < from_ || point.x() > to_) return;
    const double clearance = point.z() - ground_height(terrain_, point.x());
    if (clearance < lowest_.clearance) lowest_ = {clearance, point.x()};
  }

  /// The rope's point over x: by the sag under its chord.
  void look_at_x(double x) const {
    const Vector3 chord = span_.end - span_.start;
    const double part = (x - span_.start.x()) / chord.x();
    const double along = part * std::hypot(chord.x(), chord.y());
    look_at(span_.start + part * chord - (straight() ? 0 : rope::sag_at(span_.shape, along)) * up());
  }

  /// The rope falls and rises with V/H along its horizontal direction; the ground with its own slope times how fast x
  /// grows along that.
  void look_where_parallel(std::size_t i) const {
    if (straight()) return;
    const auto& [rope, chord, along, force, slack, closure, iterations] = span_.shape;
    const double slope = (terrain_[i + 1].z - terrain_[i].z) / (terrain_[i + 1].x - terrain_[i].x) * along.x();
    const double s = rope.length / 2 + (force.H * slope - force.V) / rope.weight;
    if (s <= 0 || s >= rope.length) return;
    const Vector3 point = span_.start + rope::point_at(span_.shape, s);
    if (point.x() >= terrain_[i].x && point.x() <= terrain_[i + 1].x) look_at(point);
  }

  const std::vector<model::GroundPoint>& terrain_;
  const SpanResult& span_;
  double from_, to_;
  Lowest& lowest_;
};

}  // namespace

Lowest rope_clearance(const std::vector<model::GroundPoint>& terrain, const std::vector<SpanResult>& spans, int reeving,
                      double from, double to) {
  Lowest lowest{std::numeric_limits<double>::infinity(), from};
  for (const SpanResult& span : spans) {
    if (span.reeving == reeving) Over(terrain, span, std::min(from, to), std::max(from, to), lowest).look();
  }
  return lowest;
}

}  // namespace taut::analysis
