#include "taut/solve/motion/run/still.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "taut/math/index.hpp"
#include "taut/math/sparse_rows.hpp"
#include "taut/solve/stability.hpp"

namespace taut::solve::dynamics {
namespace {

/// s; a machine that needs longer to go e times as far from its equilibrium is not told from one that may stand
/// anywhere: the inertia of so long a time counts as what holds.
constexpr double slowest = 100;
/// Share of the accelerations, and of the speeds, of a fall from the machine's height: below it the machine rests.
constexpr double resting = 1.0 / 1000;

/// How a rope is on its contact in a set of modes; whether the two sets differ there.
bool set_grip(const Contact& contact, bool stuck, ContactValues& is) {
  if (contact.in < 0 || contact.out < 0) return false;  // drums keep their law
  const bool grips = contact.spin >= 0 && std::isinf(contact.friction);
  const bool loses =
      contact.spin >= 0 ? !grips : contact.friction * std::max(0.0, is.wrap) > 0 && contact.efficiency < 1;
  is.log_ratio = is.log_by_wrap = 0;
  is.grip = grips || (stuck && loses) ? Grip::stuck : Grip::equal;
  return loses;
}

/// The derivatives of the rows of rest by the ways, those of ropes over contacts first, then what turns, then bodies:
/// ropes follow the bodies.
struct Stiffness {
  SparseRows matrix;
  Array<int> columns;  ///< of the mechanism, by row
};

/// A brake that acts holds its drum. Where a torque turns something, its rope pulls the same wherever it is: that is no
/// fall, and neither is it one in statics.
void hold_drives(const Mechanism& m, Values& v) {
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    const Spin& spin = m.spins[i];
    const double brake = brake_torque(m, spin, v, v.when);
    const bool driven = spin.drum >= 0 || spin.motor >= 0;
    const bool by_torque = driven && v.drive(spin).kind == machine::DriveKind::torque;
    if (spin.inertia <= 0 || !(brake > 0 || by_torque)) continue;
    v.spins[i].turns = 0;
    v.spins[i].capacity += brake + (by_torque ? 1 : 0);
  }
}

Stiffness stiffness_now(Run& run, bool stuck) {
  Mechanism& m = run.m;
  Values now = displaced_by(run, Eigen::VectorXd::Zero(m.size), run.before);
  set_grips(m, stuck, now);
  hold_drives(m, now);
  Scheme s;
  s.at_rest = true;
  s.h = s.reach = slowest;
  s.slip_now = 1 / slowest;
  assemble(m, s, run.before, now, run.w);
  Array<char> of_contact(as_size(m.size), 0);
  for (const Contact& contact : m.contacts) of_contact[contact.column] = 1;
  Stiffness found;
  for (int c = 0; c < m.size; ++c) {
    if (of_contact[c] != 0) found.columns.push_back(c);
  }
  for (int c = m.body_columns; c < m.size; ++c) {
    if (of_contact[c] == 0) found.columns.push_back(c);
  }
  for (int c = 0; c < m.body_columns; ++c) found.columns.push_back(c);
  Array<int> row(as_size(m.size), 0);
  for (int i = 0; i < m.size; ++i) row[found.columns[i]] = i;
  const Array<double>& values = m.solver.values();
  Array<Eigen::Triplet<double, int>> entries;
  for (int c = 0; c < m.size; ++c) {
    // the law of a contact is a force against its rope's way or with it, as its row has it
    const double sign = of_contact[c] != 0 && values[m.solver.place(c, c)] < 0 ? -1 : 1;
    for (const auto& [column, place] : m.solver.row(c)) {
      const double unit = of_contact[column] != 0 ? 1 : 1 / (slowest * slowest);
      if (values[place] != 0) entries.emplace_back(row[c], row[column], sign * unit * values[place]);
    }
  }
  found.matrix = {m.size, entries};
  return found;
}

std::string_view axis_name(const Vector3& d) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(d[i]) > 1 - resting * resting) return std::string_view("xyz").substr(as_size(i), 1);
  }
  return {};
}

std::string words_of(const Run& run, const Body& body, int freedom) {
  const bool turns = body.about[as_size(freedom)] != Vector3::Zero();
  const Vector3 d = (turns ? body.about : body.along)[as_size(freedom)];
  const std::string_view name = axis_name(d);
  const std::string where =
      name.empty() ? fmt::format("({:.3g}, {:.3g}, {:.3g})", d.x(), d.y(), d.z()) : std::string(name);
  return fmt::format("body '{}' {} {}", run.model.bodies[body.model].name,
                     turns ? "turns over about" : "moves away along", where);
}

/// The freedom of a body that goes farthest in a direction; of none a drum or the ropes.
std::string mover(const Run& run, const Eigen::VectorXd& x) {
  double most = 0;
  std::string words;
  for (const Body& body : run.m.bodies) {
    for (int f = 0; body.model >= 0 && f < body.count; ++f) {
      const bool turns = body.about[as_size(f)] != Vector3::Zero();
      const double way = std::abs(x[body.first + f]) * (turns ? run.m.size_of_machine : 1);
      if (!(way > most)) continue;
      most = way;
      words = words_of(run, body, f);
    }
  }
  if (!words.empty()) return words;
  for (const Spin& spin : run.m.spins) {
    if (spin.drum >= 0 && x[spin.column] != 0)
      return fmt::format("the drum '{}' turns away", run.model.drums[spin.drum].name);
  }
  return "rope runs over its sheaves";
}

/// Whether nothing moves, or begins to, beside a fall through the machine's size.
bool rests(const Run& run) {
  const double size = run.m.size_of_machine, g = run.model.gravity;
  const double speed = resting * std::sqrt(g * size), change = resting * g;
  const Values& v = run.before;
  for (const Body& body : run.m.bodies) {
    for (int f = 0; f < body.count; ++f) {
      const double unit = body.about[as_size(f)] != Vector3::Zero() ? size : 1;
      const std::size_t c = as_size(body.first + f);
      if (unit * std::abs(v.nu[c]) > speed || unit * std::abs(v.rate[c]) > change) return false;
    }
  }
  return std::all_of(run.m.contacts.begin(), run.m.contacts.end(), [&](const Contact& contact) {
    return std::abs(v.contacts[as_size(static_cast<int>(&contact - run.m.contacts.data()))].flow) <= speed;
  });
}

}  // namespace

std::set<std::string> set_grips(const Mechanism& m, bool stuck, Values& v) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    const Contact& contact = m.contacts[i];
    if (!set_grip(contact, stuck, v.contacts[i])) continue;
    names.insert(m.model->reevings[contact.reeving].nodes[contact.node].name);
  }
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    SpinValues& is = v.spins[i];
    is.turns = 0;
    is.capacity = 0;
    if (m.spins[i].inertia <= 0 || prescribed(m, m.spins[i], v, v.when)) continue;
    for (const auto& one : m.spins[i].contacts) {
      const Contact& contact = m.contacts[one.first];
      const double capacity = bearing_slope(m, contact, v, v).capacity;
      if (capacity > 0) names.insert(m.model->reevings[contact.reeving].nodes[contact.node].name);
      if (stuck) is.capacity += capacity;
    }
  }
  return names;
}

Values displaced_by(Run& run, const Eigen::VectorXd& x, const Values& from) {
  Values moved = from;
  Scheme s = run.scheme;
  s.h = s.reach = 1;
  s.at_rest = true;
  begin_step(run.m, s, run.before, run.w);
  std::fill(moved.rate.begin(), moved.rate.end(), 0.0);
  for (const Body& body : run.m.bodies) {
    for (int c = body.first; c < body.first + body.count; ++c) moved.rate[c] = x[c];
  }
  for (const Contact& contact : run.m.contacts)
    moved.q[contact.column] = run.before.q[contact.column] + x[contact.column];
  for (const Spin& spin : run.m.spins) moved.rate[spin.column] = x[spin.column];
  follow(run.m, s, run.before, run.w, run.before.t, moved);
  return moved;
}

std::string leaves_at_a_push(Run& run) {
  if (run.m.body_columns == 0) return {};
  // the weight of rope on rounds has no energy: a rope that sticks there may seem to push. One that gives way does not
  if (!negative_direction(stiffness_now(run, false).matrix)) return {};
  const Stiffness stiffness = stiffness_now(run, true);
  const auto direction = negative_direction(stiffness.matrix);
  if (!direction) return {};
  Eigen::VectorXd x = Eigen::VectorXd::Zero(run.m.size);
  for (int i = 0; i < run.m.size; ++i) x[stiffness.columns[i]] = (*direction)[i];
  return mover(run, x);
}

void note_unstable(Run& run) {
  if (run.unstable || (!run.options.quasi_static && !rests(run))) return;
  const std::string what = leaves_at_a_push(run);
  if (what.empty()) return;
  run.unstable = true;
  note(run, run.before.t, "unstable", what);
}

}  // namespace taut::solve::dynamics
