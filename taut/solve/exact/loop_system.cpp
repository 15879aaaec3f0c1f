#include "taut/solve/exact/loop_system.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "taut/math/dense_lu.hpp"

namespace taut::solve {
namespace {

constexpr int most_loop_iterations = 60;
constexpr int most_loop_halvings = 8;    // a step of 1/256 that gains nothing: the equilibrium is not near
constexpr double loop_settled = 1e-12;   // step in logarithms of tensions, angles and parts of the span; at small sags
constexpr double loop_rounding = 1e-14;  // this times span/sag, which is what rounded coordinates leave of a tension
constexpr double short_step = 1e-8;      // a shorter one that gains nothing meets rounding: it is not halved
constexpr double balances = 1e-10;       // of the largest tension; coordinates: of the span
constexpr double longest_log_step = 1.0;
constexpr double longest_loop_turn = 0.3;
constexpr double longest_loop_move = 0.2;  // of the span

/// Order of the unknowns; a single carriage has the first seven. Places count in spans.
enum Unknown { lower_A, lower_B, upper_A, upper_B, lean, x1, z1, between, x2, z2, most_unknowns };
constexpr int unknowns_of_single = between;

using Gradient = Eigen::Matrix<double, most_unknowns, 1>;
using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_unknowns, 1>;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_unknowns, most_unknowns>;

/// A number and its derivatives by the unknowns.
struct Rated {
  double v = 0;
  Gradient d = Gradient::Zero();
};
Rated operator+(const Rated& a, const Rated& b) { return {.v = a.v + b.v, .d = a.d + b.d}; }
Rated operator-(const Rated& a, const Rated& b) { return {.v = a.v - b.v, .d = a.d - b.d}; }
Rated operator*(const Rated& a, const Rated& b) { return {.v = a.v * b.v, .d = a.d * b.v + b.d * a.v}; }
Rated constant(double v) { return {.v = v, .d = Gradient::Zero()}; }
Rated chain(double v, double slope, const Rated& by) { return {.v = v, .d = slope * by.d}; }
Rated sine(const Rated& a) { return chain(std::sin(a.v), std::cos(a.v), a); }
Rated cosine(const Rated& a) { return chain(std::cos(a.v), -std::sin(a.v), a); }
Rated length(const Rated& a, const Rated& b) {
  const double r = std::hypot(a.v, b.v);
  return {.v = r, .d = (a.v * a.d + b.v * b.d) / r};
}

struct Node {
  Rated x, z;
};

struct RatedSpan {
  LoopSpan plain;
  Rated H, V_start, V_end, L;
  Rated T_start() const { return length(H, V_start); }
  Rated T_end() const { return length(H, V_end); }
};

/// A loop with its residuals: forces in units of the load, lengths in units of the span. Rows have such signs that the
/// determinant of their derivatives is positive for taut ropes. The law of the free roller is
/// geometric: the link stands across the mean direction of the two rope ends, which have the same tension, so that
/// their resultant lies along it. (That the resultant has no part across the link would also hold for a link of any
/// lean that touches the rope without force: a second answer, at which the roller carries nothing.)
class LoopSystem {
 public:
  LoopSystem(const RunningLoop& loop, const LoopPlace& place)
      : loop_(loop), place_(place), load_(std::hypot(loop.pull_x, loop.pull_z) + loop.carriage_weight) {}

  int size() const { return loop_.second ? most_unknowns : unknowns_of_single; }

  Vector vector_of(const LoopUnknowns& u) const {
    Vector v(size());
    const double l = loop_.span;
    v.head(unknowns_of_single) << std::log(u.H[0]), std::log(u.H[2]), std::log(u.H[3]), std::log(u.H[4]), u.lean,
        u.first.x / l, u.first.z / l;
    if (loop_.second) v.tail(3) << std::log(u.H[1]), u.second.x / l, u.second.z / l;
    return v;
  }

  /// Spans, residual and its derivatives; false when a span does not exist.
  bool evaluate(const Vector& v);

  /// Largest unbalanced force, N, and the largest misplacement, m.
  double unbalanced() const;
  double misplaced() const { return (residual - forces_only()).cwiseAbs().maxCoeff() * loop_.span; }
  double largest_tension() const {
    double T = std::max({a_.plain.T_start, a_.plain.T_end, b_.plain.T_start, b_.plain.T_end});
    return std::max({T, u_.plain.T_start, u_.plain.T_end, w_.plain.T_start, w_.plain.T_end});
  }
  void write(LoopState& s) const;

  Vector residual;
  Matrix jacobian;

 private:
  Rated unknown(const Vector& v, int i) const {
    Rated r = constant(v[i]);
    r.d[i] = 1;
    return r;
  }
  Rated tension(const Vector& v, int i) const {
    const double H = std::exp(v[i]);
    return chain(H, H, unknown(v, i));
  }
  Rated place(const Vector& v, int i) const { return chain(v[i] * loop_.span, loop_.span, unknown(v, i)); }
  bool span_of(RatedSpan& s, const LoopRope& rope, const Rated& H, const Node& from, const Node& to) const;
  bool is_force(int row) const { return row < 5 || row == 7 || row == 8; }
  Vector forces_only() const {
    Vector f = residual;
    for (int i = 0; i < f.size(); ++i) f[i] = is_force(i) ? f[i] : 0;
    return f;
  }
  void put(int row, const Rated& r, double scale) {
    residual[row] = r.v / scale;
    jacobian.row(row) = r.d.head(size()).transpose() / scale;
  }
  void put_place(const Node& first, const Node& second);
  void put_second(const Node& first, const Node& second);

  const RunningLoop& loop_;
  LoopPlace place_;
  double load_;
  RatedSpan a_, b_, u_, w_, t_;  // lower at A, lower at B, upper at A, upper at B, between the sections
  Node first_, second_, roller_;
  Rated R_x_, R_z_, lean_;
};

bool LoopSystem::span_of(RatedSpan& s, const LoopRope& rope, const Rated& H, const Node& from, const Node& to) const {
  const Rated x = to.x - from.x;
  const Rated z = to.z - from.z;
  const auto plain = span_at_tension(rope.weight, rope.stiffness, H.v, x.v, z.v);
  if (!plain) return false;
  const LoopSpanRates r = rates_of(*plain);
  s.plain = *plain;
  s.H = H;
  s.V_start = {.v = plain->V_start, .d = r.V_start_H * H.d + r.V_start_x * x.d + r.V_start_z * z.d};
  s.V_end = {.v = plain->V_end, .d = r.V_end_H * H.d + r.V_end_x * x.d + r.V_end_z * z.d};
  s.L = {.v = plain->rope.length, .d = r.L_H * H.d + r.L_x * x.d + r.L_z * z.d};
  return true;
}

void LoopSystem::put_place(const Node& first, const Node& second) {
  const bool at_second = loop_.second && loop_.second->place_is_of_second;
  const bool sag_of_second = loop_.second && loop_.second->sag_is_of_second;
  const Node& hung = sag_of_second ? second : first;
  put(5, (at_second ? second.x : first.x) - constant(place_.x), loop_.span);
  put(6, hung.z - constant(loop_.rise / loop_.span) * hung.x + constant(place_.sag), loop_.span);
}

void LoopSystem::put_second(const Node& first, const Node& second) {
  put(7, b_.H - t_.H + constant(loop_.pull_x), load_);
  put(8, b_.V_start - t_.V_end + constant(loop_.pull_z), load_);
  const Rated distance = loop_.second->along_rope ? t_.L : second.x - first.x;
  put(9, constant(loop_.second->distance) - distance, loop_.span);
}

bool LoopSystem::evaluate(const Vector& v) {
  const bool two = loop_.second.has_value();
  const double c = loop_.branch_distance;
  lean_ = unknown(v, lean);
  first_ = {.x = place(v, x1), .z = place(v, z1)};
  second_ = two ? Node{.x = place(v, x2), .z = place(v, z2)} : first_;
  roller_ = {.x = first_.x - constant(c) * sine(lean_), .z = first_.z + constant(c) * cosine(lean_)};
  const LoopNode up = upper_offset(loop_);
  const Node A{.x = constant(0), .z = constant(0)};
  const Node B{.x = constant(loop_.span), .z = constant(loop_.rise)};
  const Node A_up{.x = constant(up.x), .z = constant(up.z)};
  const Node B_up{.x = constant(loop_.span + up.x), .z = constant(loop_.rise + up.z)};
  if (!span_of(a_, loop_.traction_rope, tension(v, lower_A), A, first_)) return false;
  if (!span_of(b_, loop_.return_rope, tension(v, lower_B), second_, B)) return false;
  if (!span_of(u_, loop_.return_rope, tension(v, upper_A), A_up, roller_)) return false;
  if (!span_of(w_, loop_.return_rope, tension(v, upper_B), roller_, B_up)) return false;
  const LoopRope link{.weight = loop_.return_rope.weight, .stiffness = std::numeric_limits<double>::infinity()};
  if (two && !span_of(t_, link, tension(v, between), first_, second_)) return false;

  residual.resize(size());
  jacobian.resize(size(), size());
  R_x_ = w_.H - u_.H;
  R_z_ = w_.V_start - u_.V_end;
  const RatedSpan& right = two ? t_ : b_;
  const double pull_x = two ? 0 : loop_.pull_x;
  const double pull_z = two ? 0 : loop_.pull_z;
  put(0, right.H - a_.H + R_x_ + constant(pull_x), load_);
  put(1, right.V_start - a_.V_end + R_z_ + constant(pull_z - loop_.carriage_weight), load_);
  if (loop_.roller == RollerLaw::free) {
    put(2, w_.T_start() - u_.T_end(), load_);
    put(3, (w_.V_start + u_.V_end) * cosine(lean_) - (w_.H + u_.H) * sine(lean_), load_);
  } else {
    put(2, R_x_, load_);
    put(3, constant(0) - lean_, 1);
  }
  put(4, w_.T_end() - constant(loop_.efficiency) * b_.T_end(), load_);
  put_place(first_, second_);
  if (two) put_second(first_, second_);
  return residual.allFinite() && jacobian.allFinite();
}

double LoopSystem::unbalanced() const { return forces_only().cwiseAbs().maxCoeff() * load_; }

void LoopSystem::write(LoopState& s) const {
  const auto node = [](const Node& n) { return LoopNode{.x = n.x.v, .z = n.z.v}; };
  s.lower_A = a_.plain;
  s.lower_B = b_.plain;
  s.upper_A = u_.plain;
  s.upper_B = w_.plain;
  s.between = loop_.second ? t_.plain : LoopSpan{};
  s.first = node(first_);
  s.second = node(second_);
  s.roller = node(roller_);
  s.R_x = R_x_.v;
  s.R_z = R_z_.v;
  s.lean = lean_.v;
  s.traction_length = a_.plain.rope.length;
  s.return_length = b_.plain.rope.length + u_.plain.rope.length + w_.plain.rope.length + s.between.rope.length;
  const LoopNode up = upper_offset(loop_);
  s.upper_sag = up.z + loop_.rise / loop_.span * (s.roller.x - up.x) - s.roller.z;
  const double to_B = (loop_.rise - s.first.z) / (loop_.span - s.first.x);
  s.delta_sag = loop_.second ? s.first.z + to_B * (s.second.x - s.first.x) - s.second.z : 0;
  s.residual = unbalanced();
  s.closure = std::max({a_.plain.closure, b_.plain.closure, u_.plain.closure, w_.plain.closure, s.between.closure});
}

/// The Newton step; rows scaled by their largest entry, so that tensions far above the load do no harm.
Vector step_of(const LoopSystem& system) {
  Matrix J = system.jacobian;
  Vector r = -system.residual;
  for (int i = 0; i < J.rows(); ++i) {
    const double size = J.row(i).cwiseAbs().maxCoeff();
    if (!(size > 0)) continue;
    J.row(i) /= size;
    r[i] /= size;
  }
  return DenseLu(J).solve(r);
}

/// The part of the step that changes no unknown more than its shape allows.
double part_of(const Vector& step) {
  double part = 1;
  for (int i = 0; i < step.size(); ++i) {
    const bool is_log = i <= upper_B || i == between;
    const double most = is_log ? longest_log_step : i == lean ? longest_loop_turn : longest_loop_move;
    if (std::abs(step[i]) > most) part = std::min(part, most / std::abs(step[i]));
  }
  return part;
}

/// Halves the step until the residual falls. False when it does not.
bool descend(LoopSystem& system, Vector& v, const Vector& step) {
  const double before = system.residual.norm();
  double part = part_of(step);
  for (int k = 0; k < most_loop_halvings; ++k, part /= 2) {
    const Vector next = v + part * step;
    if (system.evaluate(next) && system.residual.norm() < before) {
      v = next;
      return true;
    }
    if (step.cwiseAbs().maxCoeff() < short_step) break;
  }
  system.evaluate(v);
  return false;
}

/// The same equations hold for a link that stands on its head, and for ropes so deep that their own weight pulls like
/// the taut ones: neither is stable. Where the taut answer meets a deep one the determinant passes through zero.
bool is_taut(const LoopSystem& system, double lean) {
  return std::cos(lean) > 0 && DenseLu(system.jacobian).determinant_sign() > 0;
}

}  // namespace

LoopNode upper_offset(const RunningLoop& loop) {
  const double c = loop.branch_distance;
  if (loop.offset_is_vertical) return {.x = 0, .z = c};
  const double chord = std::hypot(loop.span, loop.rise);
  return {.x = -c * loop.rise / chord, .z = c * loop.span / chord};
}

bool newton(const RunningLoop& loop, const LoopPlace& place, const LoopUnknowns& start, LoopState& state) {
  LoopSystem system(loop, place);
  Vector v = system.vector_of(start);
  if (!v.allFinite() || !system.evaluate(v)) return false;
  const double enough = std::max(loop_settled, loop_rounding * loop.span / place.sag);
  int i = 0;
  for (; i < most_loop_iterations; ++i) {
    const Vector step = step_of(system);
    if (!step.allFinite()) return false;
    const bool small = step.cwiseAbs().maxCoeff() <= enough;
    if (!descend(system, v, step) || small) break;
  }
  system.write(state);
  state.iterations = i;
  return state.residual <= balances * system.largest_tension() && system.misplaced() <= balances * loop.span &&
         is_taut(system, state.lean);
}

}  // namespace taut::solve
