#include <algorithm>
#include <cmath>

#include "taut/solve/motion/run/ledger.hpp"

namespace taut::solve::dynamics {
namespace {

Vector3 axis_of(const Line& line, const Values& v, std::size_t end) {
  return to_ground(v.bodies, line.body[end], line.axis[end]);
}

/// 1 - cos of the angle at which a line leaves the plane of its round.
double out_of_plane(const Line& line, const Values& v, const Vector3& along, std::size_t end) {
  const double s = along.dot(axis_of(line, v, end));
  return s * s / (1 + std::sqrt(std::max(0.0, 1 - s * s)));
}

/// What the weight of a straight line gains as its touching point goes by `onto` along the round and `laid` of
/// unstretched rope is laid there, J, beyond that of the rope laid: the half of it that hangs there goes with the
/// point, and no body lifts it. Where the rope is as long as its line that is what the rope loses that comes from its
/// middle onto the round.
double carried_along(const Line& line, const LineValues& is, const Values& v, std::size_t end, double onto,
                     double laid) {
  if (line.weight == 0 || line.part || sags(line, is) || free_rope(is) == 0) return 0;
  const Vector3 axis = axis_of(line, v, end);
  const Vector3 groove = (is.t - is.t.dot(axis) * axis).normalized();
  return line.weight * (free_rope(is) * groove.z() * onto - is.l * is.t.z() * laid) / 2;
}

}  // namespace

void add_wound(const Mechanism& m, const Values& before, const Values& now, Ledger& ledger, bool at_end) {
  const double of_start = at_end ? 0 : 0.5, of_end = 1 - of_start;
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const Line& line = m.lines[i];
    for (std::size_t end = 0; end < 2; ++end) {
      if (line.contact[end] < 0 || now.lines[i].radius[end] == 0 || line.at_load[end]) continue;
      if (has_run_off(before.lines[i])) continue;
      const LineValues &a = before.lines[i], &b = now.lines[i];
      const double onto = (end == 0 ? 1 : -1) * a.radius[end] * (b.angle[end] - a.angle[end]);
      const double winding = before.contacts[line.contact[end]].winding;
      const auto unstretched = [&](const Values& values) {
        const LineValues& v = values.lines[i];
        if (sags(line, v)) return v.arc[end] / (1 + end_strain(m, values, static_cast<int>(i), end));
        return lies_on_round(v, end);
      };
      const double laid = line.arcs[end] ? unstretched(now) - unstretched(before) : onto / winding;  // m
      const auto tension = [&](const Values& values) {
        const LineValues& v = values.lines[i];
        return sags(line, v) ? v.end_T[end] : v.T;
      };
      // work of the tension on what leaves the line for a drum, less the strain energy that goes with it
      const auto left = [&](const Values& values) {
        if (line.arcs[end]) return 0.0;
        const LineValues& v = values.lines[i];
        const double e = end_strain(m, values, static_cast<int>(i), end);
        const double elastic = sags(line, v) ? line.stiffness * v.gone * e : elastic_tension(line, v);
        return tension(values) * (1 - (1 + e) / winding) + elastic * e / (2 * winding);
      };
      const auto height = [&](const Values& values) { return line.weight * values.lines[i].touch[end].z(); };
      const auto askew = [&](const Values& values) {
        return tension(values) * out_of_plane(line, values, direction(m, values, static_cast<int>(i), end), end);
      };
      const auto carried = [&](const Values& values) {
        return carried_along(line, values.lines[i], values, end, onto, laid);
      };
      const auto mean = [&](const auto& of) { return of_start * of(before) + of_end * of(now); };
      ledger.laid_by += line.copies * onto * mean(left);
      ledger.laid_at += line.copies * laid * mean(height);
      ledger.askew -= line.copies * onto * mean(askew);
      ledger.hung -= (end == 0 ? 1 : -1) * line.copies * mean(carried);
    }
  }
}

}  // namespace taut::solve::dynamics
