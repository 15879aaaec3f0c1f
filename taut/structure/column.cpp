#include "taut/structure/column.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "taut/base/expects.hpp"

namespace taut::structure {
namespace {

using std::numbers::pi;

/// w, its slope, M and the transverse force S that keeps its direction: M' = S - N (w' + built'), S' = 0.
using ColumnLine = std::array<double, 4>;

ColumnLine sum(const ColumnLine& a, double k, const ColumnLine& b) {
  ColumnLine c{};
  for (std::size_t i = 0; i < 4; ++i) c.at(i) = a.at(i) + k * b.at(i);
  return c;
}

constexpr int steps_of_piece = 96;  // Runge-Kutta's error is below 1e-9 for any piece that does not buckle by itself

/// One way through the column from given values at its base.
class March {
 public:
  March(const Column& c, double factor, bool loaded) : c_(c), factor_(factor), loaded_(loaded) {}

  ColumnLine operator()(ColumnLine at, std::vector<ColumnPoint>* points = nullptr) const {
    double N = 0, x = 0;
    for (const ColumnLoad& load : c_.loads) N += load.down * factor_;
    for (const ColumnPiece& p : c_.pieces) N += p.weight * p.length * factor_;
    for (std::size_t i = 0; i < c_.pieces.size(); ++i) {
      const ColumnPiece& p = c_.pieces[i];
      const double dx = p.length / steps_of_piece, dN = p.weight * factor_ * dx;
      if (points != nullptr) points->push_back(point(at, x, N));
      for (int k = 0; k < steps_of_piece; ++k) {
        const auto slope = [&](const ColumnLine& l, double part) {
          const double xi = (k + part) / steps_of_piece;
          const double EI = p.EI + (p.EI_top.value_or(p.EI) - p.EI) * xi;
          return ColumnLine{l[1], l[2] / EI, l[3] - (N - part * dN) * (l[1] + built_slope(x + part * dx)), 0};
        };
        const ColumnLine a = slope(at, 0), b = slope(sum(at, dx / 2, a), 0.5), c = slope(sum(at, dx / 2, b), 0.5);
        const ColumnLine d = slope(sum(at, dx, c), 1);
        for (std::size_t j = 0; j < 4; ++j) at.at(j) += dx / 6 * (a.at(j) + 2 * b.at(j) + 2 * c.at(j) + d.at(j));
        x += dx;
        N -= dN;
        if (points != nullptr) points->push_back(point(at, x, N));
      }
      pass_loads(i, at, N);
    }
    return at;
  }

 private:
  double built_slope(double x) const {
    if (!loaded_) return 0;
    const double h = c_.height();
    const bool free_top = c_.top_stiffness == 0;
    const double wave =
        free_top ? c_.bow * pi / (2 * h) * std::sin(pi * x / (2 * h)) : c_.bow * pi / h * std::cos(pi * x / h);
    return c_.sway + wave;
  }
  /// Above a load neither its force nor its moment is carried any more.
  void pass_loads(std::size_t piece, ColumnLine& at, double& N) const {
    for (const ColumnLoad& load : c_.loads) {
      if (load.piece != piece) continue;
      N -= load.down * factor_;
      if (!loaded_) continue;
      at[2] -= load.moment * factor_;
      at[3] += load.across * factor_;
    }
  }
  ColumnPoint point(const ColumnLine& l, double x, double N) const {
    return {.x = x, .w = l[0], .turn = l[1], .N = N, .V = N * (l[1] + built_slope(x)) - l[3], .M = l[2]};
  }

  const Column& c_;
  double factor_;
  bool loaded_;
};

/// What has to vanish at the top: moment, and the force that nothing takes (or, of a fixed top, the way).
std::array<double, 2> left_open(const Column& c, const ColumnLine& top) {
  const bool fixed = std::isinf(c.top_stiffness);
  // S is against the forces across above; the spring pulls the top back
  return {top[2], fixed ? top[0] : top[3] - c.top_stiffness * top[0]};
}

/// The two values at the base that are not known: turn or moment, and force across.
ColumnLine base(const Column& c, double first, double force) {
  return c.clamped_base ? ColumnLine{0, 0, first, force} : ColumnLine{0, first, 0, force};
}

struct Shot {
  std::array<double, 2> first, second;  ///< left open per unit of each unknown
  double determinant() const { return first[0] * second[1] - first[1] * second[0]; }
};

/// Scales that keep both columns comparable.
Shot shoot(const Column& c, double factor) {
  const March march(c, factor, false);
  const double h = c.height(), EI = c.pieces.front().EI;
  return {.first = left_open(c, march(base(c, c.clamped_base ? EI / h : 1, 0))),
          .second = left_open(c, march(base(c, 0, EI / (h * h))))};
}

void expect_column(const Column& c) {
  expects(!c.pieces.empty(), "a column has pieces");
  for (const ColumnPiece& p : c.pieces) {
    expects(p.length > 0 && p.EI > 0 && p.EI_top.value_or(1) > 0, "pieces have length and stiffness");
  }
  for (const ColumnLoad& l : c.loads) expects(l.piece < c.pieces.size(), "loads act at the top of a piece");
}

double largest_compression(const Column& c) {
  double N = 0, most = 0;
  for (std::size_t i = c.pieces.size(); i-- > 0;) {
    for (const ColumnLoad& l : c.loads) N += l.piece == i ? l.down : 0;
    most = std::max(most, N);
    N += c.pieces[i].weight * c.pieces[i].length;
    most = std::max(most, N);
  }
  return most;
}

// Whether it stays: the tangent stiffness of short elements (cubic between their ends, so that the first critical load
// comes out to 1e-6) is positive. Unlike a determinant's sign this sees two critical loads that coincide.

constexpr int elements_of_column = 64;
constexpr int most_elements = 32;  // of a piece
constexpr double least_length = 1e-4;

/// Elements of a piece. Very short ones would be so stiff that rounding drowns the axial force: a piece that is no
/// longer than a ten thousandth of the column has none, what it carries acts at its ends.
int elements_of(double length, double height) {
  if (length < least_length * height) return 0;
  return std::min(most_elements, static_cast<int>(std::ceil(elements_of_column * length / height)));
}

using Element = std::array<std::array<double, 4>, 4>;

/// Of an element between w, slope at both ends: bending, less the axial force's part.
Element tangent(double length, double EI_low, double EI_high, double N_low, double N_high) {
  Element K{};
  constexpr std::array<double, 3> at = {-0.7745966692414834, 0, 0.7745966692414834};
  constexpr std::array<double, 3> weight = {5.0 / 9, 8.0 / 9, 5.0 / 9};
  for (std::size_t g = 0; g < 3; ++g) {
    const double x = (1 + at.at(g)) / 2, l = length;
    const std::array<double, 4> bend = {(12 * x - 6) / (l * l), (6 * x - 4) / l, (6 - 12 * x) / (l * l),
                                        (6 * x - 2) / l};
    const std::array<double, 4> slope = {(6 * x * x - 6 * x) / l, 3 * x * x - 4 * x + 1, (6 * x - 6 * x * x) / l,
                                         3 * x * x - 2 * x};
    const double EI = EI_low + (EI_high - EI_low) * x, N = N_low + (N_high - N_low) * x;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        K.at(i).at(j) += weight.at(g) * l / 2 * (EI * bend.at(i) * bend.at(j) - N * slope.at(i) * slope.at(j));
      }
    }
  }
  return K;
}

/// Symmetric with three side diagonals, by rows: K[i][k] is the entry (i, i + k).
using Band = std::vector<std::array<double, 4>>;

bool positive(Band K) {
  for (std::size_t i = 0; i < K.size(); ++i) {
    if (!(K[i][0] > 0)) return false;
    for (std::size_t k = 1; k < 4 && i + k < K.size(); ++k) {
      for (std::size_t m = k; m < 4 && i + m < K.size(); ++m) K[i + k].at(m - k) -= K[i].at(k) * K[i].at(m) / K[i][0];
    }
  }
  return true;
}

/// The stiffness of the column without its supports, by w and slope of each node.
Band tangent(const Column& c, double factor) {
  const double height = c.height();
  std::size_t nodes = 1;
  for (const ColumnPiece& p : c.pieces) nodes += static_cast<std::size_t>(elements_of(p.length, height));
  Band K(2 * nodes, std::array<double, 4>{});
  double N = 0;
  for (const ColumnLoad& load : c.loads) N += load.down * factor;
  for (const ColumnPiece& p : c.pieces) N += p.weight * p.length * factor;
  std::size_t node = 0;
  for (std::size_t i = 0; i < c.pieces.size(); ++i) {
    const ColumnPiece& p = c.pieces[i];
    const int elements = elements_of(p.length, height);
    const double l = p.length / std::max(elements, 1), dN = p.weight * factor * l;
    const double dEI = (p.EI_top.value_or(p.EI) - p.EI) / std::max(elements, 1);
    if (elements == 0) N -= dN;
    for (int k = 0; k < elements; ++k, ++node, N -= dN) {
      const Element e = tangent(l, p.EI + k * dEI, p.EI + (k + 1) * dEI, N, N - dN);
      for (std::size_t a = 0; a < 4; ++a) {
        for (std::size_t b = a; b < 4; ++b) K[2 * node + a].at(b - a) += e.at(a).at(b);
      }
    }
    for (const ColumnLoad& load : c.loads) N -= load.piece == i ? load.down * factor : 0;
  }
  return K;
}

/// Takes a coordinate out.
void hold(Band& K, std::size_t i) {
  for (std::size_t k = 1; k < 4; ++k) {
    K[i].at(k) = 0;
    if (i >= k) K[i - k].at(k) = 0;
  }
  K[i][0] = 1;
}

bool stays(const Column& c, double factor) {
  Band K = tangent(c, factor);
  const std::size_t top = K.size() - 2;
  hold(K, 0);
  if (c.clamped_base) hold(K, 1);
  if (std::isinf(c.top_stiffness)) {
    hold(K, top);
  } else {
    K[top][0] += c.top_stiffness;
  }
  return positive(std::move(K));
}

/// Whether the factor is below the critical one. K - factor K_N that is positive at 0 and at a factor is so between.
bool is_held(const Column& c, double factor) {
  if (!c.clamped_base && c.top_stiffness == 0) return false;
  return largest_compression(c) * factor <= 0 || stays(c, factor);
}

}  // namespace

double Column::height() const {
  double sum = 0;
  for (const ColumnPiece& p : pieces) sum += p.length;
  return sum;
}

std::optional<std::vector<ColumnPoint>> bent_shape(const Column& c, double factor) {
  expect_column(c);
  if (!is_held(c, factor)) return std::nullopt;
  const double h = c.height(), EI = c.pieces.front().EI;
  const Shot shot = shoot(c, factor);
  const std::array<double, 2> open = left_open(c, March(c, factor, true)(base(c, 0, 0)));
  const double det = shot.determinant();
  const double first = (-open[0] * shot.second[1] + open[1] * shot.second[0]) / det;
  const double second = (-open[1] * shot.first[0] + open[0] * shot.first[1]) / det;
  std::vector<ColumnPoint> points;
  March(c, factor, true)(base(c, first * (c.clamped_base ? EI / h : 1), second * EI / (h * h)), &points);
  return points;
}

double critical_factor(const Column& c) {
  expect_column(c);
  const double compression = largest_compression(c);
  if (!c.clamped_base && c.top_stiffness == 0) return 0;
  if (compression <= 0) return std::numeric_limits<double>::infinity();
  const double h = c.height();
  double low = 0, high = std::numbers::pi * std::numbers::pi * c.pieces.front().EI / (h * h) / compression;
  for (int i = 0; i < 200 && stays(c, high); ++i) {
    low = high;
    high *= 2;
  }
  for (int i = 0; i < 200 && high - low > 1e-13 * high; ++i) {
    const double middle = (low + high) / 2;
    (stays(c, middle) ? low : high) = middle;
  }
  return (low + high) / 2;
}

double buckling_length(double EI, double critical, double N) {
  expects(critical > 0 && N > 0, "only what is pressed buckles");
  return pi * std::sqrt(EI / (critical * N));
}

}  // namespace taut::structure
