#include "taut/solve/motion/step/downhill.hpp"

#include <cmath>
#include <limits>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/motion/step/step.hpp"

namespace taut::solve::dynamics {
namespace {

/// Of the forces out of balance along the step, by its share, J: against it what the energy gains. A contact that rolls
/// moves its rope with its rim, whose moment has the ropes in it.
double work_along(const StepAt& at, const Array<double>& step) {
  const Array<double>& force = at.w.residual;
  double of_bodies = 0, of_ropes = 0;
  for (std::size_t c = 0; c < as_size(at.m.body_columns); ++c) of_bodies += force[c] * step[c];
  for (const Spin& spin : at.m.spins) of_bodies += force[spin.column] * step[spin.column];
  for (std::size_t i = 0; i < at.m.contacts.size(); ++i) {
    const Contact& contact = at.m.contacts[i];
    if (at.now.contacts[i].grip == Grip::stuck || loose(contact, at.now)) continue;
    const double along = contact.out < 0 ? 1 : -1;  // a pull on a drum, or the difference of tensions, out less in
    of_ropes += along * contact.copies * force[contact.column] * step[contact.column];
  }
  return -(at.s.reach * at.s.reach * of_bodies + of_ropes);
}

}  // namespace

void apply(const Mechanism& m, const Array<double>& step, double share, double of_flows, Values& now) {
  for (std::size_t c = 0; c < as_size(m.body_columns); ++c) now.rate[c] -= share * step[c];
  for (const Contact& contact : m.contacts) now.q[contact.column] -= share * of_flows * step[contact.column];
  for (const Spin& spin : m.spins) now.rate[spin.column] -= share * step[spin.column];
}

double go_downhill(const StepAt& at, const Array<double>& step, double most) {
  struct End {
    double share = 0, work = 0;
  };
  const double first = work_along(at, step);
  End is{.share = 0, .work = first};
  const auto go = [&](double share) {
    apply(at.m, step, share - is.share, 1, at.now);
    is = {.share = share, .work = std::numeric_limits<double>::infinity()};
    if (!follow(at.m, at.s, at.before, at.w, at.t, at.now)) return;
    decide(at.m, at.s, at.before, at.now);
    at.w.tangent = false;
    assemble(at.m, at.s, at.before, at.now, at.w);
    at.w.tangent = true;
    is.work = work_along(at, step);
  };
  go(1);
  if (!(first < 0)) return 1;
  End low{.share = 0, .work = first}, high{};
  while (is.work < first / 2 && 2 * is.share <= most) {
    low = is;
    go(2 * is.share);
  }
  // by the secant and by halves in turn: at a kink the secant alone comes near from one side only
  for (bool halves = false; !(std::abs(is.work) <= -first_contraction * first); halves = !halves) {
    (is.work > 0 ? high : low) = is;
    if (high.share == 0) break;
    const bool known = std::isfinite(high.work) && !halves;
    const double part = known ? low.work / (low.work - high.work) : 0.5;
    const double next = low.share + part * (high.share - low.share);
    if (!(low.share < next && next < high.share)) break;
    go(next);
  }
  return is.share;
}

}  // namespace taut::solve::dynamics
