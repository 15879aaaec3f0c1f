#include <algorithm>
#include <cmath>

#include "taut/analysis/transient_values.hpp"

// Lines between points of bodies that only shift: most of a chain, of a tackle drawn with points. The same laws as for
// any line, without what rounds and turning add.
namespace taut::analysis::dynamics {
namespace {

void plain_columns(const Mechanism& m, const Line& line, const LineValues& now, std::array<PlainColumn, 12>& columns) {
  std::size_t k = 0;
  for (const std::size_t end : {0U, 1U}) {
    if (line.body[end] < 0) continue;
    const Body& shape = m.bodies[at(line.body[end])];
    for (std::size_t f = 0; f < at(shape.count); ++f, ++k) {
      PlainColumn& c = columns[k];
      c.along = shape.along[f];
      c.sign = end == 1 ? 1 : -1;
      c.share = now.t.dot(c.along);
      c.lifts = c.sign * (c.along.z() - c.share * now.t.z()) / now.l;
    }
  }
}

/// Derivatives of strain, tension and unstretched length by every local unknown.
void plain_slopes(const Scheme& s, const Line& line, const LineValues& now, const std::vector<ContactValues>& contacts,
                  LineTangent& tangent, Work& w) {
  const double square = s.reach * s.reach, per = 1 / now.L;
  const double apart = now.T_rate == 0 ? 0 : now.t.dot(now.apart);
  for (std::size_t k = 0; k < at(line.freedoms[0] + line.freedoms[1]); ++k) {
    const PlainColumn& c = w.plain[k];
    const double e = square * c.sign * c.share * per;
    double T = now.T_e * e;
    if (now.T_rate != 0) {
      const double swing = c.sign * (c.along.dot(now.apart) - c.share * apart) / now.l;
      T += now.T_rate * (s.reach * c.sign * c.share + square * swing) * per;
    }
    tangent.e[k] = e;
    w.T_slope[k] = T;
    w.L_slope[k] = 0;
  }
  for (const std::size_t end : {0U, 1U}) {
    if (line.flow[end] < 0) continue;
    const std::size_t k = at(line.flow[end]);
    const bool stuck = contacts[at(line.contact[end])].grip == Grip::stuck;
    const double by_flow = stuck ? (s.reach > 0 ? 1 / s.reach : 0) : s.slip_now;
    const double sign = end == 0 ? 1 : -1;
    tangent.e[k] = -sign * (1 + now.e) * per;
    w.T_slope[k] = (now.T_e + now.T_rate * by_flow) * tangent.e[k];
    w.L_slope[k] = sign;
  }
}

void end_slopes_of_plain(const Scheme& s, const Line& line, const LineValues& now, const Work& w,
                         LineTangent& tangent) {
  const int freedoms = line.freedoms[0] + line.freedoms[1];
  const double square = s.reach * s.reach, half = line.weight * now.L * now.t.z() / 2;
  for (std::size_t k = 0; k < at(line.columns); ++k) {
    double weight = 0;
    if (line.weight > 0) {
      const double lifts = k < at(freedoms) ? square * now.L * w.plain[k].lifts : 0;
      weight = line.weight / 2 * (w.L_slope[k] * now.t.z() + lifts);
    }
    if (std::abs(half) >= now.T) weight = half > 0 ? w.T_slope[k] : -w.T_slope[k];
    tangent.end_T[0][k] = w.T_slope[k] - (bears_half(line, 0) ? weight : 0);
    tangent.end_T[1][k] = w.T_slope[k] + (bears_half(line, 1) ? weight : 0);
  }
}

/// Tension and weight on the bodies at its ends.
void add_plain_pull(const Mechanism& m, const Line& line, const LineValues& now, Work& w) {
  const double half = line.copies * line.weight * now.L / 2;
  for (const std::size_t end : {0U, 1U}) {
    if (line.body[end] < 0) continue;
    const Body& shape = m.bodies[at(line.body[end])];
    const double T = (end == 0 ? -1 : 1) * line.copies * body_pull(now, end);
    for (std::size_t f = 0; f < at(shape.count); ++f) {
      w.residual[at(shape.first) + f] += T * now.t.dot(shape.along[f]) + half * shape.along[f].z();
    }
  }
}

}  // namespace

bool follow_plain(const Mechanism& m, std::size_t line, Values& now) {
  const Line& of = m.lines[line];
  LineValues& is = now.lines[line];
  for (const std::size_t end : {0U, 1U}) {
    is.touch[end] = of.offset[end];
    if (of.body[end] >= 0) is.touch[end] += now.bodies[at(of.body[end])].x;
  }
  const Vector3 d = is.touch[1] - is.touch[0];
  is.l = std::sqrt(d.squaredNorm());
  if (!(is.l > 0)) return false;
  is.t = d * (1 / is.l);
  return true;
}

void assemble_plain(Mechanism& m, const Scheme& s, std::size_t line_index, const Values& values_now, Work& w) {
  const Line& line = m.lines[line_index];
  const LineValues& now = values_now.lines[line_index];
  LineTangent& tangent = w.tangents[line_index];
  add_plain_pull(m, line, now, w);
  if (!w.tangent) return;
  plain_columns(m, line, now, w.plain);
  plain_slopes(s, line, now, values_now.contacts, tangent, w);
  if (line.contact[0] >= 0 || line.contact[1] >= 0) end_slopes_of_plain(s, line, now, w, tangent);
  double* const values = m.solver.values().data();
  const std::size_t columns = at(line.columns), freedoms = at(line.freedoms[0] + line.freedoms[1]);
  for (std::size_t r = 0; r < freedoms; ++r) {
    const PlainColumn& row = w.plain[r];
    const double T = body_pull(now, r < at(line.freedoms[0]) ? 0 : 1), sign = line.copies * row.sign;
    const double pulled = T == 0 ? 0 : sign * row.share, turned = sign * s.reach * s.reach * T / now.l;
    const int* const places = line.places.data() + r * columns;
    for (std::size_t k = 0; k < columns; ++k) {
      double Q = pulled * w.T_slope[k];
      if (k < freedoms) {
        const PlainColumn& c = w.plain[k];
        Q += c.sign * turned * (c.along.dot(row.along) - c.share * row.share);
      } else {
        Q += line.copies * line.weight / 2 * w.L_slope[k] * row.along.z();
      }
      values[places[k]] += Q;
    }
  }
}

}  // namespace taut::analysis::dynamics
