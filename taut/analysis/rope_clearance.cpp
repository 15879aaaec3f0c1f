#include "taut/analysis/rope_clearance.hpp"

#include <cmath>
#include <vector>

#include "taut/analysis/load_path.hpp"
#include "taut/math/index.hpp"

namespace taut::analysis {
namespace {

constexpr double near = 1e-9;  ///< of a span's length

bool moves(const model::Model& model, const SpanResult& span, int node) {
  const model::Place& place = model.reevings[at(span.reeving)].nodes[at(node)].at;
  return place.body != model::ground && !model.bodies[at(place.body)].free.empty();
}

/// The ground under a span, seen from its start: at the horizontal distance h from there the terrain's x is from + rate
/// h.
struct Under {
  double from = 0, rate = 0;
  double length = 0;  ///< of the span in plan, m
};

class ClearanceSearch {
 public:
  ClearanceSearch(const model::Model& model, const SpanResult& span)
      : model_(model), span_(span), ground_(model.terrain) {
    under_.from = terrain_x(model, span.start);
    under_.rate = model.terrain_along.dot(span.shape.along);
    under_.length = std::hypot(span.shape.chord.x(), span.shape.chord.y());
  }

  RopeClearance least() {
    if (moves(model_, span_, span_.from)) take(0, span_.start, true);
    if (moves(model_, span_, span_.to)) take(under_.length, span_.end, true);
    for (std::size_t k = 0; k + 1 < ground_.size(); ++k) parallel(ground_[k], ground_[k + 1]);
    for (std::size_t k = 1; k + 1 < ground_.size(); ++k) hilltop(k);
    return found_;
  }

 private:
  double x_at(double h) const { return under_.from + under_.rate * h; }

  /// Compares the rope's place at the distance h with the ground below it.
  void take(double h, const Vector3& place, bool is_end = false) {
    // at a fixed end, but for rounding
    if (!is_end && !(h > near * under_.length && h < (1 - near) * under_.length)) return;
    const double height = place.z() - ground_height(ground_, x_at(h));
    if (std::isnan(height) || height >= found_.height) return;
    found_ = {height, place};
  }

  /// Where the rope is parallel to a piece of ground: at slope m, V = m H.
  void parallel(const model::GroundPoint& a, const model::GroundPoint& b) {
    const rope::CatenaryRope& rope = span_.shape.rope;
    if (!(rope.weight > 0)) return;
    const double slope = under_.rate * (b.z - a.z) / (b.x - a.x);
    const double s = rope.length / 2 + (slope * span_.shape.force.H - span_.shape.force.V) / rope.weight;
    if (!(s > 0 && s < rope.length)) return;
    const Vector3 place = rope::point_at(span_.shape, s);
    const double h = place.dot(span_.shape.along), x = x_at(h);
    if (x >= a.x && x <= b.x) take(h, span_.start + place);
  }

  void hilltop(std::size_t k) {
    if (under_.rate == 0) return;
    const model::GroundPoint &a = ground_[k - 1], &b = ground_[k], &c = ground_[k + 1];
    if ((b.z - a.z) * (c.x - b.x) <= (c.z - b.z) * (b.x - a.x)) return;
    const double h = (b.x - under_.from) / under_.rate;
    if (!(h > 0 && h < under_.length)) return;
    const Vector3 below(0, 0, -rope::sag_at(span_.shape, h));
    take(h, span_.start + h / under_.length * span_.shape.chord + below);
  }

  const model::Model& model_;
  const SpanResult& span_;
  const std::vector<model::GroundPoint>& ground_;
  Under under_;
  RopeClearance found_{std::numeric_limits<double>::infinity(), Vector3::Zero()};
};

}  // namespace

RopeClearance rope_clearance(const model::Model& model, const SpanResult& span) {
  if (model.terrain.empty() || span.slack) return {};
  const RopeClearance found = ClearanceSearch(model, span).least();
  return std::isfinite(found.height) ? found : RopeClearance{};
}

RopeClearance rope_clearance(const model::Model& model, const EquilibriumResult& result) {
  RopeClearance least;
  for (const SpanResult& span : result.spans) {
    const RopeClearance own = rope_clearance(model, span);
    if (!(own.height >= least.height) && !std::isnan(own.height)) least = own;
  }
  return least;
}

}  // namespace taut::analysis
