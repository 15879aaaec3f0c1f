#pragma once
#include <array>
#include <cmath>
#include <cstddef>

// An independent solution of the closed loop for the tests: inextensible catenaries, equilibrium of every node, Newton
// on the whole. It shares nothing with the library. Branch distance 0, in-haul.

namespace taut_test {

/// Forces N, lengths m, angles rad; gamma from the vertical.
struct LoopCase {
  double l = 200, m = 0, x = 100, f = 10, S = 3000, gamma = 0.5235987755982988, q_b = 1, q_T = 1.5, eta = 0.9, W_c = 0;
  double d = 0;           ///< two sections when positive: x and f belong to the first
  bool vertical = false;  ///< roller force vertical instead of normal to the rope
};

struct LoopForces {
  bool converged = false;
  double P_v = 0, P_b = 0, T_uA = 0, T_uB = 0, T_lA = 0, T_lB = 0, T_lLB = 0, y2 = 0;
};

/// Slopes at the ends of an inextensible catenary over (dx, dy).
struct Catenary {
  double H, left, right;
  Catenary(double H_, double q, double dx, double dy) : H(H_) {
    const double k = q * dx / (2 * H);
    const double mean = std::asinh(q * dy / (2 * H * std::sinh(k)));
    left = std::sinh(mean - k);
    right = std::sinh(mean + k);
  }
  double T_left() const { return H * std::sqrt(1 + left * left); }
  double T_right() const { return H * std::sqrt(1 + right * right); }
};

template <std::size_t N>
double size_of(const std::array<double, N>& r) {
  double s = 0;
  for (double v : r) s += v * v;
  return std::sqrt(s);
}

/// A square system with its right side as last column.
template <std::size_t N>
using Augmented = std::array<std::array<double, N + 1>, N>;

/// Derivatives of f by central differences, and -r.
template <std::size_t N, class F>
Augmented<N> linearised(const F& f, const std::array<double, N>& z, const std::array<double, N>& r) {
  Augmented<N> a{};
  for (std::size_t j = 0; j < N; ++j) {
    auto up = z;
    auto down = z;
    up[j] += 1e-6;
    down[j] -= 1e-6;
    const auto r_up = f(up);
    const auto r_down = f(down);
    for (std::size_t i = 0; i < N; ++i) a[i][j] = (r_up[i] - r_down[i]) / 2e-6;
  }
  for (std::size_t i = 0; i < N; ++i) a[i][N] = -r[i];
  return a;
}

/// Gauss and Jordan with pivots of columns.
template <std::size_t N>
std::array<double, N> solved(Augmented<N> a) {
  for (std::size_t c = 0; c < N; ++c) {
    std::size_t pivot = c;
    for (std::size_t i = c; i < N; ++i) pivot = std::abs(a[i][c]) > std::abs(a[pivot][c]) ? i : pivot;
    std::swap(a[c], a[pivot]);
    for (std::size_t i = 0; i < N; ++i) {
      if (i == c) continue;
      const double factor = a[i][c] / a[c][c];
      for (std::size_t k = c; k <= N; ++k) a[i][k] -= factor * a[c][k];
    }
  }
  std::array<double, N> x{};
  for (std::size_t i = 0; i < N; ++i) x[i] = a[i][N] / a[i][i];
  return x;
}

/// Newton with a difference Jacobian and step halving; f maps N unknowns to N residuals of order 1.
template <std::size_t N, class F>
bool newton(const F& f, std::array<double, N>& z) {
  auto r = f(z);
  for (int step = 0; step < 60; ++step) {
    if (!(size_of(r) < 1e300)) return false;
    if (size_of(r) < 1e-12) return true;
    const std::array<double, N> way = solved<N>(linearised(f, z, r));
    double t = 1;
    auto next = z;
    for (int halving = 0; halving < 30; ++halving, t /= 2) {
      for (std::size_t i = 0; i < N; ++i) next[i] = z[i] + t * way[i];
      const auto r_next = f(next);
      if (size_of(r_next) < size_of(r)) {
        z = next;
        r = r_next;
        break;
      }
      if (halving == 29) return size_of(r) < 1e-9;
    }
  }
  return size_of(r) < 1e-9;
}

/// Forces of a loop from its spans: lower ones at A and B, upper ones at A and B.
inline void tell(const LoopCase& c, const Catenary& l1, const Catenary& l2, const Catenary& u3, const Catenary& u4,
                 LoopForces& out) {
  out.P_v = u4.H * u4.left - u3.H * u3.right;
  out.P_b = out.P_v + c.m * (u3.H - u4.H);
  out.T_uA = u3.T_left();
  out.T_uB = u4.T_right();
  out.T_lA = l1.T_left();
  out.T_lB = l2.T_right();
  out.T_lLB = l2.T_left();
}

/// Start: horizontal tensions of the lower branch left and right of the carriage, of the upper branch left and right.
inline LoopForces solve_loop(const LoopCase& c, std::array<double, 4> H) {
  const double y = c.m * c.x - c.f;
  const double right = c.l - c.x;
  const auto state = [&](const std::array<double, 4>& z) {
    return std::array{Catenary(std::exp(z[0]), c.q_T, c.x, y), Catenary(std::exp(z[1]), c.q_b, right, c.l * c.m - y),
                      Catenary(std::exp(z[2]), c.q_b, c.x, y), Catenary(std::exp(z[3]), c.q_b, right, c.l * c.m - y)};
  };
  const auto residual = [&](const std::array<double, 4>& z) {
    const auto [l1, l2, u3, u4] = state(z);
    const double R_x = u4.H - u3.H;  // of the upper rope on the roller
    const double R_y = u4.H * u4.left - u3.H * u3.right;
    return std::array<double, 4>{(l2.H - l1.H + c.S * std::sin(c.gamma) + R_x) / c.S,
                                 (l2.H * l2.left - l1.H * l1.right - c.S * std::cos(c.gamma) - c.W_c + R_y) / c.S,
                                 c.vertical ? R_x / c.S : (u4.T_left() - u3.T_right()) / c.S,
                                 (u4.T_right() - c.eta * l2.T_right()) / c.S};
  };
  std::array<double, 4> z;
  for (std::size_t i = 0; i < 4; ++i) z[i] = std::log(H[i]);
  LoopForces out;
  out.converged = newton<4>(residual, z);
  const auto [l1, l2, u3, u4] = state(z);
  tell(c, l1, l2, u3, u4, out);
  return out;
}

/// Two sections; `y2` starts at the height of section 2. H: A-L1, L1-L2, L2-B, A-U, U-B.
inline LoopForces solve_two_sections(const LoopCase& c, std::array<double, 5> H, double y2) {
  const double y1 = c.m * c.x - c.f;
  const double x2 = c.x + c.d;
  const double top = c.l * c.m;
  const auto state = [&](const std::array<double, 6>& z) {
    return std::array{Catenary(std::exp(z[0]), c.q_T, c.x, y1), Catenary(std::exp(z[1]), c.q_b, c.d, z[5] - y1),
                      Catenary(std::exp(z[2]), c.q_b, c.l - x2, top - z[5]), Catenary(std::exp(z[3]), c.q_b, c.x, y1),
                      Catenary(std::exp(z[4]), c.q_b, c.l - c.x, top - y1)};
  };
  const auto residual = [&](const std::array<double, 6>& z) {
    const auto [l1, l12, l2, u3, u4] = state(z);
    const double R_x = u4.H - u3.H;
    const double R_y = u4.H * u4.left - u3.H * u3.right;
    return std::array<double, 6>{(l12.H - l1.H + R_x) / c.S,
                                 (l12.H * l12.left - l1.H * l1.right - c.W_c + R_y) / c.S,
                                 (l2.H - l12.H + c.S * std::sin(c.gamma)) / c.S,
                                 (l2.H * l2.left - l12.H * l12.right - c.S * std::cos(c.gamma)) / c.S,
                                 c.vertical ? R_x / c.S : (u4.T_left() - u3.T_right()) / c.S,
                                 (u4.T_right() - c.eta * l2.T_right()) / c.S};
  };
  std::array<double, 6> z;
  for (std::size_t i = 0; i < 5; ++i) z[i] = std::log(H[i]);
  z[5] = y2;
  LoopForces out;
  out.converged = newton<6>(residual, z);
  const auto [l1, l12, l2, u3, u4] = state(z);
  tell(c, l1, l2, u3, u4, out);
  out.y2 = z[5];
  return out;
}

}  // namespace taut_test
