#include "taut/solve/motion/step/step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/couple.hpp"
#include "taut/solve/motion/step/downhill.hpp"

namespace taut::solve::dynamics {
namespace {

constexpr double step_rounding = 1e-14;
constexpr int halves_from = 8;
constexpr int reversals_from = 4;      ///< iterations
constexpr int turns_until = 15;        ///< of contacts that stick and slide in turn at their very limit
constexpr double moment = 1e-6;        ///< s, in which slip is looked for at an unchanged time
constexpr double small_change = 1e-2;  ///< of tensions: the factors of the first iteration do for the next
constexpr int most_trusted = 15;       ///< steps until it is looked at again
constexpr double least_contraction = 1e-7, caution = 8;
constexpr double small_misfit = 1e-4;  ///< of the largest tension: of the laws of contacts that slip
constexpr int most_put_back = 4;       ///< times that loose rope is put back where it lay, in one step
constexpr int most_retreats = 8;       ///< halvings of an iteration that goes where there is no rope, of growing losses

/// The flow of a contact in the step, if it goes on as before: what slips between taut branches with the change of its
/// rate.
double flow_ahead(const Scheme& s, const Contact& contact, const ContactValues& was, const Values& before) {
  const double more = s.h > 0 ? -s.slip_before : 0;
  const auto taut = [&](int line) { return line >= 0 && before.lines[line].T > 0; };
  if (s.creeps) return was.flow;
  if (more >= 1 || !taut(contact.in) || !taut(contact.out)) return loose_flow(contact, was, before);
  return was.flow + more / (1 - more) * (was.slip_rate - was.slip_mean);
}

/// Rope passed at each contact, as it went on before.
void guess_flows(const Mechanism& m, const Scheme& s, const Values& before, const Work& w, Values& now) {
  const auto kept = [&](std::size_t i) {
    return m.contacts[i].in >= 0 && m.contacts[i].out >= 0 && loose(m.contacts[i], before);
  };
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    const ContactValues& was = before.contacts[i];
    const std::size_t c = as_size(m.contacts[i].column);
    now.contacts[i].grip = was.grip;
    const double reach = s.creeps ? s.elapsed : s.reach, h = s.creeps ? s.elapsed : s.h;
    now.q[c] = was.grip == Grip::stuck ? was.slipped + w.q_star[c] + reach * was.roll_rate
               : s.fresh && kept(i)    ? before.q[c]
                                       : before.q[c] + h * flow_ahead(s, m.contacts[i], was, before);
  }
}

/// Two branches that are slack and taut in turn: half a step finds the place between.
double share_of_flows(const Newton& newton, int i) { return !newton.rough && i >= halves_from ? 0.5 : 1; }

/// Without masses nothing but friction holds what slides: points that slid one way and by the last iteration slide the
/// other way are brought back to where the first of them sticks, or both would go on in turn. False where that is no
/// place.
bool slides_in_turn_stick(Mechanism& m, const Scheme& s, const Values& before, double t, int i, const Newton& newton,
                          Work& w, Values& now) {
  const auto beyond = [&](std::size_t k) {
    const FaceValues& is = now.faces[k];
    const double size = is.pull.norm(), more = size - is.limit;
    if (is.sticks || !(is.limit > 0 && more > 0)) return Vector3(Vector3::Zero());
    return Vector3(more / (size * m.model->contacts[k].tangential_stiffness) * is.pull);
  };
  w.slid.resize(now.faces.size(), Vector3::Zero());
  double share = 1;
  for (std::size_t k = 0; k < now.faces.size(); ++k) {
    const Vector3 slid = beyond(k);
    const double bristle = now.faces[k].limit / m.model->contacts[k].tangential_stiffness;
    const double was = w.slid[k].norm() + bristle, is = slid.norm() + bristle;
    if (i >= reversals_from && w.slid[k].dot(slid) < 0) share = std::min(share, was / (was + is));
    w.slid[k] = slid;
  }
  if (share == 1) return true;
  apply(m, w.residual, share - 1, share_of_flows(newton, i - 1), now);
  if (!follow(m, s, before, w, t, now)) return false;
  for (std::size_t k = 0; k < now.faces.size(); ++k) w.slid[k] = beyond(k);
  return true;
}

/// Of the last iteration: its share and that of its flows that have been taken; after retreats it is no answer yet.
struct Taken {
  double share = 0, of_flows = 1;
  int retreats = 0, put_back = 0;
};

/// Takes half of the last iteration back: it went too far, rounds inside each other, or more rope passed on than there
/// is. False: that has been done often enough.
bool retreat(const Mechanism& m, const Array<double>& step, Taken& taken, Values& now) {
  if (taken.share == 0 || ++taken.retreats > most_retreats) return false;
  taken.share /= 2;
  apply(m, step, -taken.share, taken.of_flows, now);
  return true;
}

/// Puts loose rope back where it lay; drums and rims at its ends have to answer that by one more iteration.
bool puts_back(const Mechanism& m, const Scheme& s, const Values& before, double t, const Work& w, Taken& taken,
               Values& now) {
  if (taken.put_back >= most_put_back || !put_loose_back(m, before, now)) return false;
  ++taken.put_back;
  if (!follow(m, s, before, w, t, now)) return false;
  decide(m, s, before, now);
  return true;
}

/// Largest move of a freedom and of a contact's rope by the step.
double move_of(const Mechanism& m, const Scheme& s, const Array<double>& step) {
  double largest = 0;
  for (std::size_t c = 0; c < as_size(m.body_columns); ++c) largest = std::max(largest, std::abs(step[c]));
  largest *= s.reach * s.reach;
  for (const Contact& contact : m.contacts) largest = std::max(largest, std::abs(step[contact.column]));
  return largest;
}

/// Remembers what the first iteration of a step left, so that the next steps need no second one to be sure of the
/// first. Now and then it is seen anew; where laws have changed, nothing is taken for granted.
void learn(Newton& newton, int iterations, bool laws_changed, double contraction) {
  if (iterations == 1 && ++newton.trusted <= most_trusted) return;
  newton.trusted = 0;
  const bool seen = iterations == 2 && !laws_changed;
  newton.contraction =
      seen ? std::clamp(caution * contraction, least_contraction, first_contraction) : first_contraction;
}

/// What rounding leaves of a tension, N.
double rounding_of_tensions(const Mechanism& m, const Scheme& s, bool rough) {
  double floor = step_rounding * m.stiffest;
  if (!rough) return floor;
  // a rate is the difference of two nearly equal lengths over a short time
  for (const Line& line : m.lines) floor = std::max(floor, step_rounding * line.stiffness * line.damping * s.slip_now);
  return floor;
}

/// The largest change since the last iteration, N; whether a line has become slack or taut.
double change_of_tensions(const Values& now, Work& w, Newton& newton, bool& turned) {
  double change = 0;
  for (std::size_t k = 0; k < now.lines.size(); ++k) {
    const double T = now.lines[k].T;
    change = std::max(change, std::abs(T - w.tension[k]));
    turned = turned || (T > 0) != (w.tension[k] > 0);
    w.tension[k] = T;
    newton.largest = std::max(newton.largest, T);
  }
  return change;
}

bool has_loops(const Mechanism& m) {
  const auto& ropes = m.model->reevings;
  return std::any_of(ropes.begin(), ropes.end(), [](const machine::Reeving& rope) { return rope.closed; });
}

/// The iteration from `now` on.
StepEnd iterations(Mechanism& m, const Scheme& s, const Values& before, double t, Values& now, Work& w,
                   Newton& newton) {
  w.tension.resize(m.lines.size());
  double last_change = std::numeric_limits<double>::infinity(), change_before = 0, moved = 0;
  bool laws_changed = false;
  Taken taken;
  const bool moves = s.h > 0 && !s.at_rest, loops = has_loops(m), downhill = s.losses == 0;
  for (int i = 0; i <= newton.most; ++i) {
    if (!follow(m, s, before, w, t, now)) {
      if (!retreat(m, w.residual, taken, now)) return StepEnd::no_place;
      continue;
    }
    if (s.creeps && !slides_in_turn_stick(m, s, before, t, i, newton, w, now)) return StepEnd::no_place;
    const bool changed = decide(m, s, before, now);
    bool turned = changed;  // a contact or a line follows another law now
    double change = change_of_tensions(now, w, newton, turned);
    const CoupleChange pushed = change_of_couples(w, now);
    change = std::max(change, pushed.force);
    newton.largest = std::max(newton.largest, pushed.largest);
    turned = turned || pushed.turned;
    if (!std::isfinite(change)) return StepEnd::not_converged;
    // without masses what has begun to slide may go far: its own tangent has to say so
    const bool begins = s.creeps && pushed.turned && i < turns_until;
    const bool at_its_limit = (s.creeps || s.h > 0) && i >= turns_until;
    if (i > 0 && taken.retreats == 0 && (!changed || at_its_limit) && !begins) {
      const double floor = rounding_of_tensions(m, s, newton.rough);
      const double expected = moves && !turned && !newton.rough ? newton.contraction : first_contraction;
      const double contraction = std::isinf(last_change) ? expected : std::min(1.0, change / last_change);
      const bool close = change * contraction <= std::max(newton.tolerance * newton.largest, 4 * floor);
      const bool holds = !close || !(moves || (loops && !s.at_rest)) || laws_hold(m, now, small_misfit, 4 * floor);
      // after one that went far, as a body does that nothing holds, a small change says nothing of the next
      const bool far = s.creeps && moved > small_change * m.size_of_machine;
      const bool there = close && holds && !far && taken.share >= 1 &&
                         moved * contraction <= std::max(newton.tolerance, step_rounding) * m.size_of_machine;
      const bool again = there && puts_back(m, s, before, t, w, taken, now);
      turned = turned || again;
      if (there && !again) {
        newton.used += i;
        if (moves) learn(newton, i, laws_changed || turned, contraction);
        return StepEnd::ok;
      }
      last_change = again ? std::numeric_limits<double>::infinity() : change;
    }
    if (i == newton.most) break;
    laws_changed = laws_changed || (i > 0 && turned);
    const double small = i == 1 ? small_change * newton.largest : first_contraction * change_before;
    w.tangent = i == 0 || turned || change > small || s.losses < 1;
    change_before = change;
    m.solver.hold(!w.tangent);
    if (moves && s.losses == 1) decide_runs(m, before, now);
    assemble(m, s, before, now, w);
    if (w.tangent && !m.solver.factor()) return StepEnd::singular;
    const Array<double> out_of_balance = downhill ? w.residual : Array<double>();
    m.solver.solve(w.residual);
    if (loops) hold_circulation(m, s, before, now, w.residual);
    moved = move_of(m, s, w.residual);
    taken = {.share = 1, .of_flows = share_of_flows(newton, i), .put_back = taken.put_back};
    if (!downhill || moved <= step_rounding * m.size_of_machine) {
      apply(m, w.residual, 1, taken.of_flows, now);
      continue;
    }
    const Array<double> step = w.residual;
    w.residual = out_of_balance;
    taken.share = go_downhill({m, s, before, t, now, w}, step, m.size_of_machine / moved);
    w.residual = step;
  }
  newton.used += newton.most;
  return StepEnd::not_converged;
}

}  // namespace

Work work_for(const Mechanism& m) {
  Work w;
  const Array<double> zero(as_size(m.size), 0.0);
  w.q_star = w.nu_star = w.q_mean = w.nu_mean = w.residual = zero;
  w.tangents.resize(m.lines.size());
  w.hangs.assign(as_size(m.sagging), 0);
  return w;
}

StepEnd solve_step(Mechanism& m, const Scheme& s, const Values& before, double t, Values& now, Work& w,
                   Newton& newton) {
  begin_step(m, s, before, w);
  return iterate(m, s, before, t, now, w, newton);
}

namespace {

/// Whether a loss would change anything: contacts have one, and ropes a tension.
bool loses(const Mechanism& m, const Scheme& s, const Values& now) {
  const double nothing = rounding_of_tensions(m, s, true) / rough_slack_share;
  const auto pulls = [&](const LineValues& line) { return line.T > nothing; };
  const auto rubs = [](const Contact& contact) { return std::min(contact.bearing_log, contact.friction) > 0; };
  return std::any_of(now.lines.begin(), now.lines.end(), pulls) &&
         std::any_of(m.contacts.begin(), m.contacts.end(), rubs);
}

/// Begins where the machine without losses would be, which is where its energy is least, and lets the losses grow from
/// there.
StepEnd iterate_from_no_losses(Mechanism& m, const Scheme& s, const Values& before, double t, Values& now, Work& w,
                               Newton& newton) {
  Scheme part = s;
  part.losses = 0;
  Newton downhill = newton;
  downhill.most = 2 * 2 * newton.most;
  now.rate = before.rate;
  guess_flows(m, part, before, w, now);
  StepEnd end = iterations(m, part, before, t, now, w, downhill);
  newton.largest = downhill.largest;
  newton.used = downhill.used;
  if (end != StepEnd::ok) return end;
  if (!loses(m, s, now)) return follow(m, s, before, w, t, now) ? end : StepEnd::no_place;
  Values from = now;
  const double least = std::exp2(-most_retreats);
  double reached = 0;
  for (double more = 1; reached < 1 && more >= least;) {
    part.losses = std::min(1.0, reached + more);
    now = from;
    end = iterations(m, part, before, t, now, w, newton);
    if (end != StepEnd::ok) {
      more /= 2;
      continue;
    }
    from = now;
    reached = part.losses;
    more *= 2;
  }
  return end;
}

}  // namespace

StepEnd iterate(Mechanism& m, const Scheme& s, const Values& before, double t, Values& now, Work& w, Newton& newton) {
  guess_flows(m, s, before, w, now);
  StepEnd end = iterations(m, s, before, t, now, w, newton);
  if (end != StepEnd::ok && end != StepEnd::interrupted && newton.rough) {
    const StepEnd anew = iterate_from_no_losses(m, s, before, t, now, w, newton);
    if (anew == StepEnd::ok || anew == StepEnd::interrupted) end = anew;
  }
  m.solver.hold(false);
  w.tangent = true;
  if (end != StepEnd::ok) newton.forget();
  return end;
}

StepEnd restart(Mechanism& m, Scheme s, Values& before, Values& now, Work& w, Newton& newton) {
  s.h = s.reach = 0;
  // with dampers the tension of a slipping rope follows from its speed: the speed is found, by the slip of a moment
  s.slip_now = 1 / moment;
  s.slip_before = 1;
  now.rate = before.rate;
  s.only_rates = true;
  s.only_rates = std::any_of(m.contacts.begin(), m.contacts.end(),
                             [&](const Contact& contact) { return slips_later(m, s, contact); });
  const StepEnd end = solve_step(m, s, before, before.t, now, w, newton);
  if (end != StepEnd::ok) return end;
  for (LineValues& line : now.lines) {
    if (s.only_rates && line.T < 0) line.T = line.end_T[0] = line.end_T[1] = 0;  // rounding
  }
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    if (!slips_later(m, s, m.contacts[i])) continue;
    now.q[m.contacts[i].column] = before.q[m.contacts[i].column];
    now.contacts[i].slipped = before.contacts[i].slipped;
  }
  w.mean_step = 0;
  w.q_mean = now.nu;
  w.nu_mean = now.rate;
  std::swap(before, now);
  return end;
}

namespace {

/// Whether no tension has changed by more than its rounding: that of its length, and of the places of its ends.
bool tensions_stay(const Mechanism& m, const Values& before, const Values& now) {
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const LineValues& is = now.lines[i];
    const double far = std::max({is.L, is.touch[0].norm(), is.touch[1].norm()}) / is.L;
    const double rounding = 2 * 2 * 2 * std::numeric_limits<double>::epsilon() * far * m.lines[i].stiffness;
    if (!(std::abs(now.lines[i].T - before.lines[i].T) <= rounding)) return false;
  }
  return true;
}

/// The farthest that a step has moved a part of the machine, m, or turned it, rad.
double gone(const Mechanism& m, const Values& before, const Values& now) {
  double most = 0;
  for (const Body& body : m.bodies) {
    for (int c = body.first; c < body.first + body.count; ++c) most = std::max(most, std::abs(now.q[c] - before.q[c]));
  }
  for (std::size_t k = 0; k < now.contacts.size(); ++k) {
    const int c = m.contacts[k].column;
    most = std::max(most, std::abs(now.q[c] - before.q[c]));
  }
  return most;
}

}  // namespace

StepEnd settle(Mechanism& m, Values& before, Values& now, Work& w, Newton& newton) {
  Scheme s;
  s.lossless = s.at_rest = true;
  const double t = before.t;
  double h = 1 / std::max(highest_frequency(m, before), 1e-3);
  constexpr int most = 400;
  StepEnd end = StepEnd::ok;
  double last = std::numeric_limits<double>::infinity();  // way of the step before
  int quiet = 0;
  for (int i = 0; i < most; ++i) {
    if (newton.ask && i % 8 == 0 && !newton.ask(t)) return StepEnd::interrupted;
    s.h = s.reach = h;
    std::fill(before.nu.begin(), before.nu.end(), 0.0);
    std::fill(now.rate.begin(), now.rate.end(), 0.0);
    end = solve_step(m, s, before, t, now, w, newton);
    if (end != StepEnd::ok) {
      h /= 8;
      quiet = 0;
      if (h < 1e-12) return end;
      continue;
    }
    const double moved = gone(m, before, now), still = 1e-13 * m.size_of_machine;
    const bool is_long = h > 1e3;
    // what is left is rounding, which moves what hangs softly, and turns a body about an axis that all of its ropes
    // meet
    const bool by_rounding = is_long && moved >= last / 2 && tensions_stay(m, before, now);
    last = moved;
    std::swap(before, now);
    quiet = moved < still || by_rounding ? quiet + 1 : 0;
    if (quiet >= 2 && is_long) break;
    if (!(moved < 1e3 * m.size_of_machine)) return StepEnd::singular;
    if (moved < 0.1 * m.size_of_machine) h = std::min(h * 4, 1e6);
  }
  std::fill(before.nu.begin(), before.nu.end(), 0.0);
  std::fill(before.rate.begin(), before.rate.end(), 0.0);
  return quiet >= 2 ? StepEnd::ok : StepEnd::not_converged;
}

double highest_frequency(const Mechanism& m, const Values& v) {
  // each mass is shared by the lines at it in proportion to their stiffness
  Array<double> share(m.bodies.size(), 0.0);
  const auto stiffness = [&](std::size_t i) {
    return m.lines[i].copies * m.lines[i].stiffness * v.lines[i].gone / v.lines[i].L;
  };
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    for (const int body : m.lines[i].body) {
      if (body >= 0) share[body] += stiffness(i);
    }
  }
  double largest = 0;
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    double square = 0;
    for (const int body : m.lines[i].body) {
      if (body < 0 || m.bodies[body].count == 0) continue;
      if (m.bodies[body].mass > 0) square += share[body] / m.bodies[body].mass;
    }
    largest = std::max(largest, square);
  }
  for (const Spin& spin : m.spins) {
    if (!(spin.inertia > 0)) continue;
    double k = 0;
    for (const auto& one : spin.contacts) {
      const Contact& contact = m.contacts[one.first];
      for (const int line : {contact.in, contact.out}) {
        if (line >= 0) k += stiffness(as_size(line)) * contact.radius * contact.radius;
      }
    }
    largest = std::max(largest, 2 * k / spin.inertia);
  }
  return std::sqrt(largest + bounds_of_couples(m, v).square);
}

}  // namespace taut::solve::dynamics
