#include "taut/structure/column_mast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "taut/base/expects.hpp"
#include "taut/structure/hollow_section.hpp"

namespace taut::structure {
namespace {

using catalogue::SectionRow;

constexpr int parts_of_taper = 8;
constexpr double least_slice = 1e-3;       // of the height
constexpr double rounding = 1e-12;         // of a critical factor; nearer to 1 a shape need not exist
constexpr std::size_t section_every = 12;  // of the 96 steps of a column's piece

enum class Plane { y, z };

/// Between two heights where something begins: a prismatic length, or one of the parts of a tapered piece.
struct Slice {
  double from = 0, to = 0;
  SectionRow section;    ///< of its weaker end
  SectionRow low, high;  ///< of its ends
  std::size_t piece = 0;
};

SectionRow between(const SectionRow& a, const SectionRow& b, double x) {
  const auto mix = [&](double SectionRow::*of) { return a.*of + (b.*of - a.*of) * x; };
  return hollow_section({.shape = a.shape,
                         .forming = a.forming,
                         .height = mix(&SectionRow::height),
                         .width = mix(&SectionRow::width),
                         .wall = mix(&SectionRow::thickness),
                         .outer_radius = mix(&SectionRow::outer_radius),
                         .inner_radius = mix(&SectionRow::inner_radius)});
}

/// The base, and where pieces and the parts of tapered ones end.
std::vector<double> ends_of_pieces(const ColumnMast& m) {
  std::vector<double> ends = {0};
  for (const MastPiece& p : m.pieces) {
    const double x = ends.back();
    const int n = p.top ? parts_of_taper : 1;
    for (int k = 1; k <= n; ++k) ends.push_back(x + p.length * k / n);
  }
  return ends;
}

/// Loads that stand nearly at one place stand there, with the moment of the rest: slices have a length that one can
/// reckon with.
ColumnMast gathered(ColumnMast m) {
  std::vector<double> places = ends_of_pieces(m);
  const double height = places.back(), near = least_slice * height;
  for (MastCombination& c : m.combinations) {
    for (MastLoad& l : c.loads) {
      expects(l.height >= 0 && l.height <= height * (1 + 1e-12), "loads act on the mast");
      const auto place = std::min_element(places.begin(), places.end(), [&](double a, double b) {
        return std::abs(a - l.height) < std::abs(b - l.height);
      });
      if (std::abs(*place - l.height) > near) {
        places.push_back(l.height);
        continue;
      }
      if (*place == 0) continue;  // on the base itself
      l.moment_y += l.across_y * (l.height - *place);
      l.moment_z += l.across_z * (l.height - *place);
      l.height = *place;
    }
  }
  return m;
}

std::vector<double> heights_of(const ColumnMast& m) {
  std::vector<double> cuts = ends_of_pieces(m);
  const double x = cuts.back();
  for (const MastCombination& c : m.combinations) {
    for (const MastLoad& l : c.loads) cuts.push_back(l.height);
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<double> apart = {0};
  for (const double cut : cuts) {
    if (cut > apart.back() + 1e-6 * x) apart.push_back(std::min(cut, x));
  }
  return apart;
}

std::vector<Slice> slices_of(const ColumnMast& m) {
  const std::vector<double> cuts = heights_of(m);
  std::vector<Slice> all;
  std::size_t piece = 0;
  double base = 0;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    while (piece + 1 < m.pieces.size() && (cuts[i - 1] + cuts[i]) / 2 > base + m.pieces[piece].length) {
      base += m.pieces[piece++].length;
    }
    const MastPiece& p = m.pieces[piece];
    Slice s{
        .from = cuts[i - 1], .to = cuts[i], .section = p.section, .low = p.section, .high = p.section, .piece = piece};
    if (p.top) {
      s.low = between(p.section, *p.top, (s.from - base) / p.length);
      s.high = between(p.section, *p.top, (s.to - base) / p.length);
      s.section = s.low.W_pl_y <= s.high.W_pl_y ? s.low : s.high;
      s.section.name = fmt::format("{} to {}", p.section.name, p.top->name);
    }
    all.push_back(std::move(s));
  }
  return all;
}

double stiffness(const ColumnMast& m, const SectionRow& r, Plane plane) {
  return m.E * (plane == Plane::y ? r.I_y : r.I_z);
}

/// The mast as a column in one plane; `factored`: with factors, and pressed.
Column column_of(const ColumnMast& m, const std::vector<Slice>& slices, const MastCombination& c, Plane plane,
                 bool factored, bool pressed) {
  Column column;
  column.clamped_base = m.clamped_base;
  column.top_stiffness = m.top_stiffness;
  for (const Slice& s : slices) {
    const double mass = (s.low.mass_per_length + s.high.mass_per_length) / 2;
    const double weight = m.own_weight && pressed ? mass * m.gravity * (factored ? c.weight_factor : 1) : 0;
    column.pieces.push_back({s.to - s.from, stiffness(m, s.low, plane), stiffness(m, s.high, plane), weight});
  }
  for (std::size_t i = 0; i < c.loads.size(); ++i) {
    const MastLoad& l = c.loads[i];
    const double k = factored ? c.factors[i] : 1;
    if (l.height <= slices.front().from) continue;  // on the base itself
    std::size_t slice = 0;
    while (slice + 1 < slices.size() && slices[slice].to < l.height * (1 - 1e-9)) ++slice;
    column.loads.push_back({slice, pressed ? k * l.down : 0, k * (plane == Plane::y ? l.across_y : l.across_z),
                            k * (plane == Plane::y ? l.moment_y : l.moment_z)});
  }
  return column;
}

double compression_at(const ColumnMast& m, const std::vector<Slice>& slices, const MastCombination& c, double height,
                      bool factored) {
  double N = 0;
  for (std::size_t i = 0; i < c.loads.size(); ++i) {
    if (c.loads[i].height > height + 1e-9) N += c.loads[i].down * (factored ? c.factors[i] : 1);
  }
  for (const Slice& s : slices) {
    if (!m.own_weight) break;
    const double above = std::max(0.0, s.to - std::max(height, s.from));
    N += above * (s.low.mass_per_length + s.high.mass_per_length) / 2 * m.gravity * (factored ? c.weight_factor : 1);
  }
  return N;
}

/// About the straight axis: the foot holds what turns the mast above.
double torsion_at(const MastCombination& c, double height, bool factored) {
  double T = 0;
  for (std::size_t i = 0; i < c.loads.size(); ++i) {
    if (c.loads[i].height > height) T += c.loads[i].torsion * (factored ? c.factors[i] : 1);
  }
  return T;
}

/// The largest compression with factors, N (0: pulled everywhere), and the lowest slice that has it. In a slice the
/// lower end has most: only its weight adds to it.
struct MostPressed {
  double N = 0;
  std::size_t slice = 0;
};
MostPressed most_pressed(const ColumnMast& m, const std::vector<Slice>& slices, const MastCombination& c) {
  MostPressed most;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const double N = compression_at(m, slices, c, slices[i].from, true);
    if (N > most.N) most = {.N = N, .slice = i};
  }
  return most;
}

double most_bent(const std::vector<ColumnPoint>& points) {
  double M = 0;
  for (const ColumnPoint& p : points) M = std::max(M, std::abs(p.M));
  return M;
}

/// Indices that become stations: of each slice its ends, some between, and where it is bent most either way.
std::vector<std::size_t> reported_points(const std::vector<ColumnPoint>& y, const std::vector<ColumnPoint>& z,
                                         std::size_t of_slice) {
  std::vector<std::size_t> reported;
  for (std::size_t first = 0; first < y.size(); first += of_slice) {
    std::size_t most_y = first, most_z = first;
    for (std::size_t i = first; i < first + of_slice; ++i) {
      if (std::abs(y[i].M) > std::abs(y[most_y].M)) most_y = i;
      if (std::abs(z[i].M) > std::abs(z[most_z].M)) most_z = i;
    }
    for (std::size_t i = first; i < first + of_slice; ++i) {
      const bool end = i + 1 == first + of_slice;
      if (end || (i - first) % section_every == 0 || i == most_y || i == most_z) reported.push_back(i);
    }
  }
  return reported;
}

/// In the direction of the imperfection that bends it more.
std::vector<ColumnPoint> worse_way(Column column) {
  std::vector<ColumnPoint> one = *bent_shape(column);
  if (column.sway == 0 && column.bow == 0) return one;
  column.sway = -column.sway;
  column.bow = -column.bow;
  std::vector<ColumnPoint> other = *bent_shape(column);
  return most_bent(other) > most_bent(one) ? other : one;
}

/// Everything of one combination.
class Combination {
 public:
  Combination(const ColumnMast& m, const std::vector<Slice>& slices, const MastCombination& c, ColumnMastResult& r)
      : m_(m), slices_(slices), c_(c), r_(r), most_pressed_(most_pressed(m, slices, c)) {
    expects(c.factors.size() == c.loads.size(), "each load has its factor");
    critical_y_ = critical_factor(column_of(m, slices, c, Plane::y, true, true));
    critical_z_ = critical_factor(column_of(m, slices, c, Plane::z, true, true));
  }

  void add() {
    const double critical = std::min(critical_y_, critical_z_);
    r_.critical_factor = std::min(r_.critical_factor, critical);
    if (critical <= 1 + rounding) {
      if (r_.refused.empty()) {
        r_.refused = m_.clamped_base || m_.top_stiffness > 0
                         ? fmt::format(
                               "{}: the mast buckles at {:.4g} times its load; choose a stiffer section, "
                               "shorten it, or hold its top",
                               c_.words, critical)
                         : fmt::format(
                               "{}: the mast stands on a hinge and nothing holds its top: it falls over; give "
                               "the stiffness of its guys, or clamp its base",
                               c_.words);
      }
      return;
    }
    r_.pressed = r_.pressed || most_pressed_.N > 0;
    // what the deck gives is how it stands; the rule's sway is of what is pressed
    const bool crooked = most_pressed_.N > 0 || m_.sway.value_or(0) > 0;
    add_case(Plane::y, crooked);
    if (crooked) add_case(Plane::z, true);
  }

 private:
  double height() const { return slices_.back().to; }

  /// The largest offset of the bow, m; 0 where (5.8) lets it be left out, and where nothing is pressed, which has no
  /// buckling length. By the slice that is pressed most: the foot may be pulled below loads that press.
  double bow(Plane plane) const {
    const double N = most_pressed_.N;
    if (N <= 0) return 0;
    const Slice& slice = slices_[most_pressed_.slice];
    const SectionRow& r = slice.section;
    const double yield = m_.pieces[slice.piece].yield, EI = stiffness(m_, slice.low, plane);
    const double slenderness = std::sqrt(r.area * yield / euler_load(m_.E, EI / m_.E, height()));
    const double length = buckling_length(EI, plane == Plane::y ? critical_y_ : critical_z_, N);
    if (m_.bow) return *m_.bow * length;
    if (m_.clamped_base && !needs_bow(slenderness, r.area * yield, N)) return 0;
    return bow_share(m_.curve.value_or(curve_of(r, yield)), true) * length;
  }

  std::vector<ColumnPoint> solved(Plane plane, bool factored, bool pressed, bool crooked) {
    Column column = column_of(m_, slices_, c_, plane, factored, pressed);
    if (crooked) {
      column.sway = m_.sway.value_or(sway_of(height()));
      column.bow = bow(plane);
      r_.sway = column.sway;
      r_.bow = std::max(r_.bow, column.bow);
    }
    std::vector<ColumnPoint> points = worse_way(std::move(column));
    if (pressed) r_.top_displacement = std::max(r_.top_displacement, std::abs(points.back().w));
    return points;
  }

  void add_case(Plane leans, bool crooked) {
    const auto y = solved(Plane::y, true, true, crooked && leans == Plane::y);
    const auto z = solved(Plane::z, true, true, crooked && leans == Plane::z);
    const auto first_y = solved(Plane::y, true, false, false), first_z = solved(Plane::z, true, false, false);
    const auto plain_y = solved(Plane::y, false, false, false), plain_z = solved(Plane::z, false, false, false);
    MastCase one;
    one.words = crooked ? fmt::format("{}, as built leaning {}", c_.words,
                                      leans == Plane::y ? "in the plane of the strong axis" : "across it")
                        : c_.words;
    const std::size_t of_slice = y.size() / slices_.size();
    for (const std::size_t i : reported_points(y, z, of_slice)) {
      const std::size_t slice = i / of_slice;
      // just above a slice's lower end, just below its upper one
      const double inside = i % of_slice == 0 ? 1e-6 * height() : -1e-6 * height();
      const double at = y[i].x + inside;
      const double N = compression_at(m_, slices_, c_, at, true);
      const double plain = compression_at(m_, slices_, c_, at, false);
      const double torsion = torsion_at(c_, at, true);
      one.stations.push_back(
          {y[i].x,
           slice,
           {.N = plain,
            .V_y = plain_z[i].V,
            .V_z = plain_y[i].V,
            .M_y = plain_y[i].M,
            .M_z = plain_z[i].M,
            .torsion = torsion_at(c_, at, false)},
           {.N = y[i].N, .V_y = z[i].V, .V_z = y[i].V, .M_y = y[i].M, .M_z = z[i].M, .torsion = torsion},
           {.N = N,
            .V_y = first_z[i].V,
            .V_z = first_y[i].V,
            .M_y = first_y[i].M,
            .M_z = first_z[i].M,
            .torsion = torsion}});
    }
    if (std::isfinite(std::max(critical_y_, critical_z_))) {
      for (const Slice& s : slices_) {
        const double compression = compression_at(m_, slices_, c_, s.from + 1e-6 * height(), true);
        one.critical_force.push_back({.y = critical_y_ * compression, .z = critical_z_ * compression});
      }
    }
    r_.cases.push_back(std::move(one));
  }

  const ColumnMast& m_;
  const std::vector<Slice>& slices_;
  const MastCombination& c_;
  ColumnMastResult& r_;
  MostPressed most_pressed_;
  /// alpha_cr of the column in each plane: it buckles in one of them, about a principal axis.
  double critical_y_ = 0, critical_z_ = 0;
};

}  // namespace

ColumnMastResult column_mast(const ColumnMast& given) {
  expects(!given.pieces.empty() && !given.combinations.empty(), "a mast has pieces and loads");
  const ColumnMast m = gathered(given);
  ColumnMastResult r;
  const std::vector<Slice> slices = slices_of(m);
  for (const Slice& s : slices) {
    const MastPiece& p = m.pieces[s.piece];
    MastPart part;
    part.member.steel = {.section = s.section, .yield = p.yield, .E = m.E, .gamma = m.gamma};
    part.member.curve = m.curve;
    part.member.y.C_m = part.member.z.C_m = m.C_m;
    part.allowable_stress = p.allowable_stress;
    if (p.top) part.stronger_end = s.section.W_pl_y == s.low.W_pl_y ? s.high : s.low;
    r.mast.parts.push_back(std::move(part));
  }
  for (const MastCombination& c : m.combinations) Combination(m, slices, c, r).add();
  return r;
}

}  // namespace taut::structure
