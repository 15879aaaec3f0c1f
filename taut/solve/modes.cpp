#include "taut/solve/modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <set>

#include "taut/base/array.hpp"
#include "taut/math/eigen_general.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/motion/run/still.hpp"

namespace taut::solve::dynamics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Complex = std::complex<double>;

constexpr double eigen_shift = 0.1;       ///< 1/s, near which eigenvalues are looked for
constexpr double no_frequency = 1e-3;     ///< of the shift: below it a mode has none
constexpr double imaginary_share = 1e-6;  ///< imaginary part that counts, of |lambda|
constexpr double drawn_share = 1.0 / 12;  ///< of the machine's size: displacement that is drawn
constexpr int most_halved = 20;           ///< times that it is halved until it can be drawn

/// Nothing is driven: the machine stands as it is at the start.
machine::Model at_rest(const machine::Model& model) {
  machine::Model still = model;
  for (machine::Body& body : still.bodies) body.driven.clear();
  const auto hold = [](machine::Drive& drive) {
    if (drive.kind == machine::DriveKind::speed) drive.kind = machine::DriveKind::held;
  };
  for (machine::Drum& drum : still.drums) hold(drum.drive);
  for (machine::Motor& motor : still.motors) hold(motor.drive);
  still.events.clear();
  still.observed.clear();
  still.measures.clear();
  return still;
}

/// Mass, damping and stiffness by all columns, and which columns stay where they are.
struct VibrationMatrices {
  MatrixXd M, C, K;
  Array<Index> moving, massless;
};

/// The step's step_tangent is M + r C + r^2 K in the accelerations, r its reach; the rope passed at a contact is an
/// unknown by itself, r^2 times what would be an acceleration.
MatrixXd step_tangent(Run& run, Values& now, double reach) {
  Scheme s = run.scheme;
  s.h = s.reach = reach;
  s.slip_now = 1 / reach;
  s.slip_before = 0;
  assemble(run.m, s, run.before, now, run.w);
  const Array<double> dense = run.m.solver.dense();
  const Index n = run.m.size;
  MatrixXd J =
      Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(dense.data(), n, n);
  for (const Contact& contact : run.m.contacts) J.col(contact.column) *= reach * reach;
  return J;
}

VibrationMatrices matrices_of(Run& run, Values& now) {
  const double unit = 1 / std::max(highest_frequency(run.m, run.before), 1.0);
  const MatrixXd one = step_tangent(run, now, unit), two = step_tangent(run, now, 2 * unit),
                 three = step_tangent(run, now, 3 * unit);
  VibrationMatrices a;
  const MatrixXd K = (one - 2 * two + three) / 2;
  const MatrixXd C = two - one - 3 * K;
  a.M = one - C - K;
  a.C = C / unit;
  a.K = K / (unit * unit);
  const auto zero_small = [](MatrixXd& part, double of) {
    part = part.unaryExpr([of](double x) { return std::abs(x) < of ? 0 : x; });
  };
  // what the differences leave of nothing
  const double largest = std::max({one.cwiseAbs().maxCoeff(), two.cwiseAbs().maxCoeff(), three.cwiseAbs().maxCoeff()});
  zero_small(a.M, 1e-13 * largest);
  zero_small(a.C, 1e-13 * largest / unit);
  Array<char> fixed(as_size(run.m.size), 0), of_contact(as_size(run.m.size), 0);
  for (std::size_t i = 0; i < run.m.spins.size(); ++i) {
    const Spin& spin = run.m.spins[i];
    const bool held = spin.inertia <= 0 || prescribed(run.m, spin, now, now.when) || now.spins[i].capacity > 0;
    fixed[spin.column] = held ? 1 : 0;
  }
  for (const Contact& contact : run.m.contacts) of_contact[contact.column] = 1;
  for (int c = 0; c < run.m.size; ++c) {
    if (fixed[c] == 0) (of_contact[c] != 0 ? a.massless : a.moving).push_back(c);
  }
  return a;
}

/// lambda E y = F y for y = (x of what moves, x of what has no mass, velocities of what moves).
struct VibrationPencil {
  MatrixXd F, E;
};
VibrationPencil pencil_of(const VibrationMatrices& a) {
  const auto n = static_cast<Index>(a.moving.size()), p = static_cast<Index>(a.massless.size());
  VibrationPencil q{.F = MatrixXd::Zero(2 * n + p, 2 * n + p), .E = MatrixXd::Zero(2 * n + p, 2 * n + p)};
  q.E.topLeftCorner(n, n).setIdentity();
  q.F.topRightCorner(n, n).setIdentity();
  q.E.block(n, n, p, p) = a.C(a.massless, a.massless);
  q.F.block(n, 0, p, n) = -a.K(a.massless, a.moving);
  q.F.block(n, n, p, p) = -a.K(a.massless, a.massless);
  q.F.block(n, n + p, p, n) = -a.C(a.massless, a.moving);
  q.E.block(n + p, n, n, p) = a.C(a.moving, a.massless);
  q.E.block(n + p, n + p, n, n) = a.M(a.moving, a.moving);
  q.F.block(n + p, 0, n, n) = -a.K(a.moving, a.moving);
  q.F.block(n + p, n, n, p) = -a.K(a.moving, a.massless);
  q.F.block(n + p, n + p, n, n) = -a.C(a.moving, a.moving);
  return q;
}

/// Turned so that its largest component is real.
Eigen::VectorXd real_shape(const Eigen::VectorXcd& y) {
  Index largest = 0;
  y.cwiseAbs().maxCoeff(&largest);
  const Complex turn =
      y.size() > 0 && std::abs(y[largest]) > 0 ? std::conj(y[largest]) / std::abs(y[largest]) : Complex(1);
  return (y * turn).real();
}

/// Whether every sagging rope still has a length to hang with.
bool can_be_drawn(const Mechanism& m, const Values& v) {
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    if (!sags(m.lines[i], v.lines[i])) continue;
    const SagValues& is = v.sags[m.lines[i].sag];
    if (!(v.lines[i].L > 0) || !std::isfinite(is.H + is.V + v.lines[i].l)) return false;
  }
  return true;
}

/// The machine moved by a shape, less far where a rope would be longer or shorter than it can be drawn.
Values drawn_by(Run& run, Eigen::VectorXd x, const Values& rest) {
  for (int halved = 0; halved < most_halved; ++halved, x /= 2) {
    Values moved = displaced_by(run, x, rest);
    if (can_be_drawn(run.m, moved)) return moved;
  }
  return rest;
}

/// How large the machine is as it is drawn, m: the diagonal of the box round its ropes.
double drawn_size(const Values& v) {
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const LineValues& line : v.lines) {
    for (const Vector3& end : line.touch) {
      low = low.cwiseMin(end);
      high = high.cwiseMax(end);
    }
  }
  return v.lines.empty() ? 1 : (high - low).norm();
}

/// Shifts, turns, who moves most, the drawing.
void fill_shape(Run& run, const VibrationMatrices& a, const Values& rest, Eigen::VectorXd x, Mode& mode) {
  const Mechanism& m = run.m;
  const auto motion_of = [&](const Body& body) {
    Mode::Motion motion;
    for (int f = 0; f < body.count; ++f) {
      motion.shift += x[body.first + f] * body.along[as_size(f)];
      if (body.turns) motion.turn += x[body.first + f] * body.about[as_size(f)];
    }
    return motion;
  };
  const double machine = drawn_size(rest);
  double shifted = 0, turned = 0, most = 0, of_ropes = 0;
  for (const Body& body : m.bodies) {
    const Mode::Motion motion = motion_of(body);
    shifted = std::max(shifted, motion.shift.norm());
    turned = std::max(turned, motion.turn.norm());
  }
  const double size = std::max(shifted, turned * machine);
  const double unit = shifted > 1e-9 * size ? shifted : turned;
  if (unit > 0) x /= unit;
  mode.bodies.assign(m.model->bodies.size(), {});
  for (const Body& body : m.bodies) {
    if (body.model >= 0) mode.bodies[body.model] = motion_of(body);
    const Eigen::VectorXd own = x.segment(body.first, body.count);
    const double energy = own.dot(a.M.block(body.first, body.first, body.count, body.count) * own);
    if (body.model < 0) {
      of_ropes += energy;
    } else if (energy > most) {
      most = energy;
      mode.largest = body.model;
    }
  }
  if (of_ropes > most) mode.largest.reset();
  if (unit > 0) mode.shape = frame_of(m, drawn_by(run, x * (drawn_share * machine * unit / size), rest));
}

Mode mode_of(Complex lambda) {
  Mode mode;
  const double size = std::abs(lambda);
  mode.frequency = size / (2 * std::numbers::pi);
  if (size < no_frequency * eigen_shift) {
    mode.kind = ModeKind::free;
    mode.frequency = 0;
    return mode;
  }
  mode.damping = -lambda.real() / size;
  const bool swings = std::abs(lambda.imag()) > imaginary_share * size;
  mode.damped = swings ? std::abs(lambda.imag()) / (2 * std::numbers::pi) : 0;
  mode.kind = mode.damping < -imaginary_share ? ModeKind::unstable : swings ? ModeKind::swings : ModeKind::creeps;
  if (mode.kind == ModeKind::unstable && !swings) mode.frequency = 0;  // it goes away and does not come back
  if (std::abs(mode.damping) < imaginary_share * imaginary_share) mode.damping = 0;
  return mode;
}

Outcome find_modes(Run& run, const Values& rest, int most, ModeSet& set) {
  Values now = rest;
  const std::set<std::string> held = set_grips(run.m, set.sheaves == Sheaves::stuck, now);
  set.held.assign(held.begin(), held.end());
  if (run.m.size == 0) return {};
  const VibrationMatrices a = matrices_of(run, now);
  if (a.moving.empty()) return {};
  const VibrationPencil pencil = pencil_of(a);
  const auto found = shifted_eigen(pencil.F, pencil.E, eigen_shift);
  if (!found) {
    return not_converged("the vibrations can't be found: a rope that carries nothing leaves a part without place");
  }
  const auto n = static_cast<Index>(a.moving.size()), p = static_cast<Index>(a.massless.size());
  int free_ones = 0;
  for (std::size_t k = 0; k < found->values.size(); ++k) {
    const Complex mu = found->values[k];
    if (std::abs(mu) < 1e-14 * std::abs(found->values.front())) break;  // lambda is infinite
    const Complex lambda = 1.0 / mu + eigen_shift;
    Mode mode = mode_of(lambda);
    // of a pair one; a free one stands there twice
    if (mode.kind != ModeKind::free && lambda.imag() < 0) continue;
    if (mode.kind == ModeKind::free && free_ones++ % 2 == 1) continue;
    // a machine that does not stay where it is has to say so, however few modes are asked for
    if (static_cast<int>(set.modes.size()) >= most && mode.kind != ModeKind::unstable) continue;
    const Eigen::VectorXd shape = real_shape(found->vectors.col(static_cast<Index>(k)).head(n + p));
    Eigen::VectorXd x = Eigen::VectorXd::Zero(run.m.size);
    x(a.moving) = shape.head(n);
    x(a.massless) = shape.tail(p);
    fill_shape(run, a, rest, x, mode);
    set.modes.push_back(std::move(mode));
  }
  std::stable_sort(set.modes.begin(), set.modes.end(),
                   [](const Mode& one, const Mode& other) { return one.frequency < other.frequency; });
  return {};
}

}  // namespace
}  // namespace taut::solve::dynamics

namespace taut::solve {
namespace {

TransientOptions options_of(const ModesOptions& options) {
  TransientOptions o;
  o.duration = 1;
  o.start = options.start;
  o.damping_ratio = options.damping_ratio;
  o.rope_mass = options.rope_mass;
  o.branches = options.branches;
  return o;
}

/// The state at rest with everything that a step leaves behind it.
dynamics::Values at_rest(dynamics::Run& run) {
  std::fill(run.before.nu.begin(), run.before.nu.end(), 0.0);
  std::fill(run.before.rate.begin(), run.before.rate.end(), 0.0);
  return dynamics::displaced_by(run, Eigen::VectorXd::Zero(run.m.size), run.before);
}

}  // namespace

std::optional<TransientFrame> rest_of_modes(const machine::Model& model, const ModesOptions& options) {
  const machine::Model still = dynamics::ready_to_move(dynamics::at_rest(model), options.start);
  const TransientOptions o = options_of(options);
  dynamics::Run run{.model = still, .options = o};
  if (!dynamics::open_run(run)) return std::nullopt;
  return dynamics::frame_of(run.m, at_rest(run));
}

ModesResult modes(const machine::Model& model, const ModesOptions& options) {
  machine::Model still = dynamics::ready_to_move(dynamics::at_rest(model), options.start);
  const TransientOptions o = options_of(options);
  dynamics::Run run{.model = still, .options = o};
  ModesResult result;
  const bool opened = dynamics::open_run(run);
  result.outcome = run.result.outcome;
  if (!opened) return result;
  result.damping_time = run.result.damping_time;
  int freedoms = 0;
  for (const dynamics::Body& body : run.m.bodies) freedoms += body.count;
  if (freedoms > most_mode_freedoms) {
    result.outcome = infeasible(fmt::format(
        "the machine has {} freedoms, more than {}: give its ropes fewer 'segments'", freedoms, most_mode_freedoms));
    return result;
  }
  dynamics::Values rest = at_rest(run);
  result.rest = dynamics::frame_of(run.m, rest);
  std::vector<std::string> pads;
  for (std::size_t i = 0; i < result.rest.faces.size(); ++i) {
    if (result.rest.faces[i].closed && still.contacts[i].static_friction > 0) pads.push_back(still.contacts[i].name);
  }
  for (const Sheaves sheaves : {Sheaves::stuck, Sheaves::released}) {
    ModeSet set;
    set.sheaves = sheaves;
    if (sheaves == Sheaves::released && !pads.empty()) {
      for (machine::FaceContact& contact : still.contacts) contact.static_friction = contact.kinetic_friction = 0;
      rest = at_rest(run);
    }
    result.outcome = dynamics::find_modes(run, rest, options.most, set);
    if (!result.outcome.ok()) return result;
    set.held.insert(set.held.end(), pads.begin(), pads.end());
    const bool same = set.held.empty();
    result.sets.push_back(std::move(set));
    if (same) break;  // no sheave has a loss
  }
  if (std::all_of(result.sets.begin(), result.sets.end(), [](const ModeSet& set) { return set.modes.empty(); })) {
    result.outcome = infeasible("nothing that can move has inertia, so that nothing swings: give a rope 'segments'");
  }
  return result;
}

}  // namespace taut::solve
