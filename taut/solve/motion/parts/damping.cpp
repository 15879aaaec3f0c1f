#include "taut/solve/motion/parts/damping.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"

namespace taut::solve::dynamics {
namespace {

constexpr std::size_t most_lines = 250;
constexpr double stretches = 0.01;  ///< of a mode's strain energy
constexpr int most_sweeps = 30;

void rotate(Array<double>& a, Array<double>& vectors, std::size_t n, std::size_t p, std::size_t q) {
  const double off = a[p * n + q];
  if (off == 0) return;
  const double theta = (a[q * n + q] - a[p * n + p]) / (2 * off);
  const double t = (theta >= 0 ? 1 : -1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
  const double c = 1 / std::sqrt(t * t + 1), s = t * c;
  for (std::size_t k = 0; k < n; ++k) {
    const double x = a[k * n + p], y = a[k * n + q];
    a[k * n + p] = c * x - s * y;
    a[k * n + q] = s * x + c * y;
  }
  for (std::size_t k = 0; k < n; ++k) {
    const double x = a[p * n + k], y = a[q * n + k];
    a[p * n + k] = c * x - s * y;
    a[q * n + k] = s * x + c * y;
    const double u = vectors[k * n + p], v = vectors[k * n + q];
    vectors[k * n + p] = c * u - s * v;
    vectors[k * n + q] = s * u + c * v;
  }
}

/// How a line's strain length follows every column, its rope stuck on its rounds.
Array<double> gradient(const Mechanism& m, const Values& v, std::size_t i, Work& w) {
  Array<double> b(as_size(m.size), 0.0);
  const Line& line = m.lines[i];
  line_columns(line, m.bodies, v.bodies, v.lines[i], w.columns);
  for (int k = 0; k < line.freedoms[0] + line.freedoms[1]; ++k) {
    const double sign = k < line.freedoms[0] ? -1 : 1;
    b[line.column[as_size(k)]] += sign * line.share * v.lines[i].t.dot(w.columns[as_size(k)].velocity);
  }
  for (const std::size_t end : {0U, 1U}) {
    if (line.contact[end] < 0) continue;
    const Contact& contact = m.contacts[line.contact[end]];
    if (contact.spin < 0) continue;
    const Spin& spin = m.spins[contact.spin];
    if (!(spin.inertia > 0) || prescribed(m, spin, v, v.when)) continue;
    b[spin.column] += (end == 0 ? -1 : 1) * contact.sense * working_radius(m, contact, v);
  }
  return b;
}

/// What the tensions resist as branches swing in a motion, N/m by the square of its unit: T/l of each way across.
double stiffness_across(const Mechanism& m, const Values& v, const Array<double>& motion, Work& w) {
  double sum = 0;
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    const Line& line = m.lines[i];
    const LineValues& is = v.lines[i];
    if (!(is.T > 0) || !(is.l > 0)) continue;
    line_columns(line, m.bodies, v.bodies, is, w.columns);
    Vector3 apart = Vector3::Zero();
    for (int k = 0; k < line.freedoms[0] + line.freedoms[1]; ++k) {
      const double sign = k < line.freedoms[0] ? -1 : 1;
      apart += sign * line.share * motion[line.column[as_size(k)]] * w.columns[as_size(k)].velocity;
    }
    sum += line.copies * is.T / is.l * (apart - apart.dot(is.t) * is.t).squaredNorm();
  }
  return sum;
}

}  // namespace

Symmetric eigen_of(Array<double> a, std::size_t n) {
  Symmetric e;
  e.vectors.assign(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) e.vectors[i * n + i] = 1;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double off = 0, all = 0;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) (i == j ? all : off) += a[i * n + j] * a[i * n + j];
    }
    if (off <= 1e-26 * all) break;
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t q = p + 1; q < n; ++q) rotate(a, e.vectors, n, p, q);
    }
  }
  for (std::size_t i = 0; i < n; ++i) e.values.push_back(a[i * n + i]);
  return e;
}

Array<double> stretching_frequencies(Mechanism& m, const Values& v, Work& w) {
  Array<double> found(m.first_line.size(), 0.0);
  const std::size_t n = m.lines.size();
  if (n > most_lines) {
    std::fill(found.begin(), found.end(), highest_frequency(m, v));
    return found;
  }
  Scheme still;
  assemble(m, still, v, v, w);
  if (!m.solver.factor()) return found;
  Array<Array<double>> gradients, moved;
  Array<double> root;
  for (std::size_t i = 0; i < n; ++i) {
    gradients.push_back(gradient(m, v, i, w));
    moved.push_back(gradients.back());
    m.solver.solve(moved.back());
    root.push_back(std::sqrt(m.lines[i].copies * m.lines[i].stiffness / v.lines[i].L));
  }
  Array<double> a(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      double sum = 0;
      for (std::size_t c = 0; c < gradients[i].size(); ++c) sum += gradients[i][c] * moved[j][c];
      a[i * n + j] = root[i] * sum * root[j];
    }
  }
  const Symmetric e = eigen_of(a, n);
  const double largest = e.values.empty() ? 0 : *std::max_element(e.values.begin(), e.values.end());
  Array<double> swinging = found;
  for (std::size_t k = 0; k < n; ++k) {
    if (!(e.values[k] > 1e-10 * largest)) continue;
    Array<double> motion(as_size(m.size), 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t c = 0; c < motion.size(); ++c) motion[c] += root[i] * e.vectors[i * n + k] * moved[i][c];
    }
    // the motion's elastic stiffness is the square of the eigenvalue: one that tensions resist more is a swing
    const bool swings = stiffness_across(m, v, motion, w) > e.values[k] * e.values[k];
    for (std::size_t r = 0; r < found.size(); ++r) {
      double share = 0;
      for (int i = m.first_line[r].first; i < m.first_line[r].first + m.first_line[r].second; ++i) {
        share += e.vectors[as_size(i) * n + k] * e.vectors[as_size(i) * n + k];
      }
      double& lowest = (swings ? swinging : found)[r];
      const double omega = std::sqrt(e.values[k]);
      if (share >= stretches && (lowest == 0 || omega < lowest)) lowest = omega;
    }
  }
  for (std::size_t r = 0; r < found.size(); ++r) {
    if (found[r] == 0) found[r] = swinging[r];
  }
  return found;
}

}  // namespace taut::solve::dynamics
