#include <algorithm>
#include <cmath>

#include "taut/math/index.hpp"
#include "taut/solve/motion/run/run.hpp"

/// The joints of a rope in segments are fixed to it, so they run with it to the rounds and drums at the ends of their
/// chain. Before one gets there they are laid out anew, at equal distances along the rope.
namespace taut::solve::dynamics {
namespace {

/// The rope within a chain, from one end to the other, by the unstretched length from its start: piecewise cubics
/// through its ends and joints, with the slopes of parabolas through three neighbours. A hanging rope is nearly a
/// parabola, so its segments keep their strain.
struct Shape {
  Array<double> s;      ///< of the ends and the joints, m
  Array<Vector3> x, v;  ///< their places, m, and the velocities of the rope there, m/s
};

Vector3 slope_at(const Shape& shape, const Array<Vector3>& of, std::size_t k) {
  const std::size_t middle = std::clamp<std::size_t>(k, 1, of.size() - 2);
  const double before = shape.s[middle] - shape.s[middle - 1], behind = shape.s[middle + 1] - shape.s[middle];
  const Vector3 first = (of[middle] - of[middle - 1]) / before, second = (of[middle + 1] - of[middle]) / behind;
  const Vector3 curvature = (second - first) / (before + behind);
  return (first * behind + second * before) / (before + behind) + 2 * (shape.s[k] - shape.s[middle]) * curvature;
}

/// The cubic of Hermite in the piece k at the share u of its length.
Vector3 value_at(const Shape& shape, const Array<Vector3>& of, std::size_t k, double u) {
  const double h = shape.s[k + 1] - shape.s[k], r = 1 - u;
  const Vector3 chord = of[k + 1] - of[k];
  const Vector3 first = h * slope_at(shape, of, k) - chord, second = h * slope_at(shape, of, k + 1) - chord;
  return of[k] + u * chord + u * r * (r * first - u * second);
}

double rope_in(const Chain& chain, const Values& v) {
  double rope = 0;
  for (int i = chain.first; i < chain.first + chain.count; ++i) rope += free_rope(v.lines[i]);
  return rope;
}

/// Whether a segment at an end has become half of the mean one, or half longer than that. A chain that is broken stays
/// as it is.
bool runs_up(const Chain& chain, const Values& v) {
  constexpr double shortest = 0.5, longest = 1.5;
  const auto broken = [](const LineValues& line) { return line.gone < 1; };
  const auto begin = v.lines.begin() + chain.first;
  if (std::any_of(begin, begin + chain.count, broken)) return false;
  const double mean = rope_in(chain, v) / chain.count;
  const auto off = [&](int i) {
    const double rope = free_rope(v.lines[i]);
    return rope < shortest * mean || rope > longest * mean;
  };
  return off(chain.first) || off(chain.first + chain.count - 1);
}

/// Velocity of the rope at an end of a chain: where it runs over a contact it moves along itself too.
Vector3 velocity_at(const Mechanism& m, const Values& v, int i, std::size_t end) {
  const Line& line = m.lines[i];
  const LineValues& is = v.lines[i];
  Vector3 velocity = Vector3::Zero();
  if (line.body[end] >= 0) {
    const Motion3& body = v.bodies[line.body[end]];
    velocity = body.v + body.w.cross(is.touch[end] - body.x);
  }
  if (line.contact[end] >= 0) velocity += (1 + is.e) * v.contacts[line.contact[end]].flow * is.t;
  return velocity;
}

Shape shape_of(const Mechanism& m, const Values& v, const Chain& chain) {
  Shape shape;
  shape.s.push_back(0);
  shape.x.push_back(v.lines[chain.first].touch[0]);
  shape.v.push_back(velocity_at(m, v, chain.first, 0));
  for (int i = chain.first; i < chain.first + chain.count; ++i) {
    shape.s.push_back(shape.s.back() + free_rope(v.lines[i]));
    shape.x.push_back(v.lines[i].touch[1]);
    shape.v.push_back(velocity_at(m, v, i, 1));
  }
  return shape;
}

/// A line whose joints have moved, of the strain e. Where it meets a round in another direction now, its rope goes with
/// the place where it does: by R delta^2/2 less or more, delta the turn. Its tension is kept, not this rope.
void place_anew(const Mechanism& m, int i, double e, Values& v) {
  const Line& line = m.lines[i];
  LineValues& is = v.lines[i];
  const LineValues was = is;
  if (!place_line(line, v.bodies, was, is)) return;  // as it was: the next step says why
  lay_on_rounds(line, was, is);
  is.e = e;
  is.L = path_of(line, is) / (1 + e);
  pull(line, is);
  for (const std::size_t end : {0U, 1U}) {
    if (line.contact[end] < 0) continue;
    v.contacts[line.contact[end]].wrap += (end == 0 ? 1 : -1) * (is.angle[end] - was.angle[end]);
  }
}

/// Of a quantity that is summed up along the rope to `sum[k]` at `s[k]`, what lies in each of `count` equal parts.
Array<double> in_equal_parts(const Array<double>& s, const Array<double>& sum, int count) {
  Array<double> parts;
  double before = 0;
  std::size_t k = 0;
  for (int j = 1; j <= count; ++j) {
    const double at = s.back() * j / count;
    while (k + 2 < s.size() && at > s[k + 1]) ++k;
    const double until = sum[k] + (sum[k + 1] - sum[k]) * (at - s[k]) / (s[k + 1] - s[k]);
    parts.push_back(until - before);
    before = until;
  }
  return parts;
}

/// The joints of a chain between its two ends, which stay.
class Joints {
 public:
  Joints(const Shape& shape, int count) : x(as_size(count) + 1), v(x), shape_(shape), count_(count) {
    x.front() = shape.x.front(), x.back() = shape.x.back();
    v.front() = shape.v.front(), v.back() = shape.v.back();
    std::size_t k = 0;
    for (int j = 1; j < count; ++j) {
      const double s = shape.s.back() * j / count;
      while (k + 2 < shape.s.size() && s > shape.s[k + 1]) ++k;
      const double u = (s - shape.s[k]) / (shape.s[k + 1] - shape.s[k]);
      x[j] = value_at(shape, shape.x, k, u);
      v[j] = value_at(shape, shape.v, k, u);
    }
  }

  /// Moves them as little as it takes for each segment to have the length that its rope had in the segments before, so
  /// that no tension changes; and so with their velocities for the rates of these lengths.
  void keep_stretch() {
    constexpr int most_rounds = 20;
    constexpr double enough = 1e-15;
    lengths = parts_of([&](std::size_t k) { return (shape_.x[k + 1] - shape_.x[k]).norm(); });
    for (int round = 0; round < most_rounds; ++round) {
      set_directions();
      Array<double> lacks(lengths.size());
      double worst = 0;
      for (std::size_t j = 0; j < lengths.size(); ++j) {
        lacks[j] = lengths[j] - (x[j + 1] - x[j]).norm();
        worst = std::max(worst, std::abs(lacks[j]));
      }
      if (worst <= enough * shape_.s.back()) break;
      move_apart(lacks, x);
    }
    set_directions();
    Array<double> lacks = parts_of([&](std::size_t k) {
      const Vector3 along = shape_.x[k + 1] - shape_.x[k];
      return along.dot(shape_.v[k + 1] - shape_.v[k]) / along.norm();
    });
    for (std::size_t j = 0; j < lacks.size(); ++j) lacks[j] -= t_[j].dot(v[j + 1] - v[j]);
    move_apart(lacks, v);
  }

  Array<Vector3> x, v;    ///< from end to end, m, m/s
  Array<double> lengths;  ///< of the segments, m

 private:
  /// The sum of `of` over the segments before, by the equal parts of the rope.
  template <class Of>
  Array<double> parts_of(const Of& of) const {
    Array<double> sum = {0};
    for (std::size_t k = 0; k + 1 < shape_.s.size(); ++k) sum.push_back(sum.back() + of(k));
    return in_equal_parts(shape_.s, sum, count_);
  }

  void set_directions() {
    t_.clear();
    for (std::size_t j = 0; j + 1 < x.size(); ++j) t_.push_back((x[j + 1] - x[j]).normalized());
  }

  /// Least squares of all moves of the joints by which the parts grow by `lacks`, to the first order: forces along the
  /// segments, J J' f = lacks, with one row for each segment. A straight chain can't get longer: what is next to
  /// nothing in the pivots stays out.
  void move_apart(const Array<double>& lacks, Array<Vector3>& joints) const {
    constexpr double nothing = 1e-12;
    const std::size_t n = t_.size();
    Array<double> pivot(n), right = lacks, f(n, 0.0);
    for (std::size_t j = 0; j < n; ++j) {
      pivot[j] = (j > 0 ? 1.0 : 0.0) + (j + 1 < n ? 1.0 : 0.0);
      if (j == 0) continue;
      const double share = -t_[j - 1].dot(t_[j]) / pivot[j - 1];
      pivot[j] += share * t_[j - 1].dot(t_[j]);
      right[j] -= share * right[j - 1];
    }
    for (std::size_t j = n; j-- > 0;) {
      const double behind = j + 1 < n ? t_[j].dot(t_[j + 1]) * f[j + 1] : 0;
      f[j] = pivot[j] > nothing ? (right[j] + behind) / pivot[j] : 0;
    }
    for (std::size_t j = 1; j < n; ++j) joints[j] += f[j - 1] * t_[j - 1] - f[j] * t_[j];
  }

  const Shape& shape_;
  int count_;
  Array<Vector3> t_;  ///< directions of the segments
};

void lay_out(Run& run, Values& v, const Chain& chain) {
  Mechanism& m = run.m;
  const Shape shape = shape_of(m, v, chain);
  Joints joints(shape, chain.count);
  joints.keep_stretch();
  for (int j = 1; j < chain.count; ++j) {
    const int joint = m.lines[chain.first + j].body[0];
    Motion3& body = v.bodies[joint];
    body.x = joints.x[j];
    body.v = joints.v[j];
    for (int axis = 0; axis < 3; ++axis) v.nu[m.bodies[joint].first + axis] = body.v[axis];
  }
  const double each = shape.s.back() / chain.count;
  const int reeving = m.lines[chain.first].reeving;
  for (int i = chain.first; i < chain.first + chain.count; ++i) {
    place_anew(m, i, joints.lengths[i - chain.first] / each - 1, v);
    run.origin.ropes[reeving].lumped[i - m.first_line[reeving].first] = each;
  }
}

/// What sticks to the rope by a bristle goes on with the same force.
void keep_bristles(const Values& before, Values& v) {
  for (std::size_t i = 0; i < v.chain_loads.size(); ++i) {
    const int line = v.chain_loads[i].line;
    v.chain_loads[i].bristle *= v.lines[line].L / before.lines[line].L;
  }
}

}  // namespace

bool lay_out_joints(Run& run, Values& v) {
  bool any = false;
  Values before;
  for (const Chain& chain : run.m.chains) {
    if (!runs_up(chain, v)) continue;
    if (!any) before = v;
    any = true;
    lay_out(run, v, chain);
  }
  if (!any) return false;
  keep_bristles(before, v);
  lump_masses(run.m, run.origin);
  add_jump(run.m, v, run.ledger.numerical, run.ledger);
  return true;
}

}  // namespace taut::solve::dynamics
