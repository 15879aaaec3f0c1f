#include <algorithm>
#include <cmath>

#include "taut/analysis/transient_ledger.hpp"

namespace taut::analysis::dynamics {
namespace {

/// 1 - cos of the angle at which a line leaves the plane of its round.
double out_of_plane(const Line& line, const Values& v, const Vector3& along, std::size_t end) {
  const int body = line.body[end];
  const Vector3& axis = line.axis[end];
  const double s = along.dot(body < 0 ? axis : Vector3(v.bodies[at(body)].R * axis));
  return s * s / (1 + std::sqrt(std::max(0.0, 1 - s * s)));
}

}  // namespace

void add_wound(const Mechanism& m, const Values& before, const Values& now, Ledger& ledger) {
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const Line& line = m.lines[i];
    for (std::size_t end = 0; end < 2; ++end) {
      if (line.contact[end] < 0 || now.lines[i].radius[end] == 0 || line.at_load[end]) continue;
      const LineValues &a = before.lines[i], &b = now.lines[i];
      const double onto = (end == 0 ? 1 : -1) * a.radius[end] * (b.angle[end] - a.angle[end]);
      const double winding = before.contacts[at(line.contact[end])].winding;
      const auto tension = [&](const Values& values) {
        const LineValues& v = values.lines[i];
        return sags(line, v) ? v.end_T[end] : v.T;
      };
      const auto laid_by = [&](const Values& values) {
        const LineValues& v = values.lines[i];
        const double e = end_strain(m, values, static_cast<int>(i), end);
        const double elastic = sags(line, v) ? line.stiffness * v.gone * e : elastic_tension(line, v);
        return tension(values) * (1 - (1 + e) / winding) + elastic * e / (2 * winding) +
               line.weight * v.touch[end].z() / winding;
      };
      const auto askew = [&](const Values& values) {
        return tension(values) * out_of_plane(line, values, direction(m, values, static_cast<int>(i), end), end);
      };
      ledger.laid_by += line.copies * onto * (laid_by(before) + laid_by(now)) / 2;
      ledger.askew -= line.copies * onto * (askew(before) + askew(now)) / 2;
    }
  }
}

}  // namespace taut::analysis::dynamics
