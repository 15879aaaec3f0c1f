#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/solve/motion/parts/values.hpp"

// Lines between points of bodies that only shift: most of a chain, of a tackle drawn with points. The same laws as for
// any line, without what rounds and turning add.
namespace taut::solve::dynamics {
namespace {

using PlainColumns = std::array<PlainColumn, 12>;

void plain_columns(const Mechanism& m, const Line& line, const LineValues& now, PlainColumns& columns) {
  std::size_t k = 0;
  for (std::size_t end = 0; end < 2; ++end) {
    if (line.body[end] < 0) continue;
    const Body& shape = m.bodies[line.body[end]];
    for (std::size_t f = 0; f < as_size(shape.count); ++f, ++k) {
      PlainColumn& c = columns[k];
      c.along = &shape.along[f];
      c.sign = end == 1 ? 1 : -1;
      c.share = dot(now.t, shape.along[f]);
    }
  }
}

/// Derivatives of strain, tension and unstretched length by every local unknown.
void plain_slopes(const Scheme& s, const Line& line, const LineValues& now, const Array<ContactValues>& contacts,
                  const PlainColumns& columns, LineTangent& tangent, Work& w) {
  const double square = s.reach * s.reach, per = 1 / now.L;
  const double apart = now.T_rate == 0 ? 0 : dot(now.t, now.apart);
  for (std::size_t k = 0; k < as_size(line.freedoms[0] + line.freedoms[1]); ++k) {
    const PlainColumn& c = columns[k];
    const double e = square * c.sign * c.share * per;
    double T = now.T_e * e;
    if (now.T_rate != 0) {
      const double swing = c.sign * (dot(*c.along, now.apart) - c.share * apart) / now.l;
      T += now.T_rate * (s.reach * c.sign * c.share + square * swing) * per;
    }
    tangent.e[k] = e;
    w.T_slope[k] = T;
    w.L_slope[k] = 0;
  }
  for (std::size_t end = 0; end < 2; ++end) {
    if (line.flow[end] < 0) continue;
    const std::size_t k = as_size(line.flow[end]);
    const bool stuck = contacts[line.contact[end]].grip == Grip::stuck;
    const double by_flow = stuck ? (s.reach > 0 ? 1 / s.reach : 0) : s.slip_now;
    const double sign = end == 0 ? 1 : -1;
    tangent.e[k] = -sign * (1 + now.e) * per;
    const bool later = s.only_rates && now.T_rate > 0;  // slip has a rate there, and no way yet
    w.T_slope[k] = ((later ? 0 : now.T_e) + now.T_rate * by_flow) * tangent.e[k];
    w.L_slope[k] = later ? 0 : sign;
  }
}

void end_slopes_of_plain(const Scheme& s, const Line& line, const LineValues& now, const PlainColumns& columns,
                         const Work& w, LineTangent& tangent) {
  if (line.weight == 0) {
    for (std::size_t k = 0; k < as_size(line.columns); ++k) tangent.end_T[0][k] = tangent.end_T[1][k] = w.T_slope[k];
    return;
  }
  const int freedoms = line.freedoms[0] + line.freedoms[1];
  const double square = s.reach * s.reach, half = line.weight * now.L * now.t.z() / 2;
  const HungByTension share = hung_by_tension(half, now.T, s.fresh);
  for (std::size_t k = 0; k < as_size(line.columns); ++k) {
    double lifts = 0;  // of the line's steepness
    if (k < as_size(freedoms)) {
      const PlainColumn& c = columns[k];
      lifts = square * now.L * (c.sign * (c.along->z() - c.share * now.t.z()) / now.l);
    }
    const double weight = line.weight / 2 * (w.L_slope[k] * now.t.z() + lifts), T = w.T_slope[k];
    tangent.end_T[0][k] = T - (bears_half(line, 0) ? hung_slope(share[0], weight, T) : 0);
    tangent.end_T[1][k] = T + (bears_half(line, 1) ? hung_slope(share[1], weight, T) : 0);
  }
}

/// Tension and weight on the bodies at its ends.
void add_plain_pull(const Line& line, const LineValues& now, const PlainColumns& columns, Work& w) {
  const double half = line.copies * line.weight * now.L / 2;
  const std::array<double, 2> T{-line.copies * body_pull(now, 0), line.copies * body_pull(now, 1)};
  for (std::size_t k = 0; k < as_size(line.freedoms[0] + line.freedoms[1]); ++k) {
    const PlainColumn& c = columns[k];
    w.residual[line.column[k]] += T[k < as_size(line.freedoms[0]) ? 0 : 1] * c.share + half * c.along->z();
  }
}

}  // namespace

bool follow_plain(const Mechanism& m, std::size_t line, Values& now) {
  const Line& of = m.lines[line];
  LineValues& is = now.lines[line];
  for (std::size_t end = 0; end < 2; ++end) {
    is.touch[end] = of.offset[end];
    if (of.body[end] >= 0) is.touch[end] += now.bodies[of.body[end]].x;
  }
  const double x = is.touch[1][0] - is.touch[0][0], y = is.touch[1][1] - is.touch[0][1],
               z = is.touch[1][2] - is.touch[0][2];
  const double l = std::sqrt(x * x + y * y + z * z);
  is.l = l;
  if (!(l > 0)) return false;
  const double per = 1 / l;
  is.t[0] = x * per;
  is.t[1] = y * per;
  is.t[2] = z * per;
  return true;
}

void assemble_plain(Mechanism& m, const Scheme& s, std::size_t line_index, const Values& values_now, Work& w) {
  const Line& line = m.lines[line_index];
  const LineValues& now = values_now.lines[line_index];
  PlainColumns& plain = w.plain;
  plain_columns(m, line, now, plain);
  add_plain_pull(line, now, plain, w);
  if (!w.tangent) return;
  LineTangent& tangent = w.tangents[line_index];
  plain_slopes(s, line, now, values_now.contacts, plain, tangent, w);
  if (line.contact[0] >= 0 || line.contact[1] >= 0) end_slopes_of_plain(s, line, now, plain, w, tangent);
  double* const values = m.solver.values().data();
  const std::size_t columns = as_size(line.columns), freedoms = as_size(line.freedoms[0] + line.freedoms[1]);
  for (std::size_t r = 0; r < freedoms; ++r) {
    const PlainColumn& row = plain[r];
    const double T = body_pull(now, r < as_size(line.freedoms[0]) ? 0 : 1), sign = line.copies * row.sign;
    const double pulled = T == 0 ? 0 : sign * row.share, turned = sign * s.reach * s.reach * T / now.l;
    const double hangs = line.copies * line.weight / 2 * row.along->z();
    const int* const places = line.places.data() + r * columns;
    for (std::size_t k = 0; k < freedoms; ++k) {
      const PlainColumn& c = plain[k];
      const double turns = c.sign * turned * (dot(*c.along, *row.along) - c.share * row.share);
      values[places[k]] += pulled * w.T_slope[k] + turns;
    }
    for (std::size_t k = freedoms; k < columns; ++k) {
      values[places[k]] += pulled * w.T_slope[k] + hangs * w.L_slope[k];
    }
  }
}

}  // namespace taut::solve::dynamics
