#include "taut/solve/beam_stability.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"
#include "taut/mechanics/beam_piece.hpp"
#include "taut/solve/definite.hpp"
#include "taut/solve/rest/places_stiffness.hpp"
#include "taut/solve/stability.hpp"

namespace taut::solve {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

constexpr int elements = 16;  ///< of a whole beam at least
constexpr double largest_factor = 1000;
constexpr double factor_precision = 1e-5;
constexpr double hardly_less = 1 - factor_precision;  ///< than the forces as they are
constexpr double ritz_precision = 1e-10;
constexpr Eigen::Index directions = 3;
constexpr int most_iterations = 60;
constexpr double hardly_any = 1e-6;  ///< a factor; below it rounding decides
constexpr std::optional<int> every;  ///< beam

/// How a cross-section moves: its displacement and turn by each coordinate that moves it.
using SectionMotion = Array<std::pair<int, Vector6>>;

/// A straight element: its stiffness without force, and what a unit of its factor adds.
struct Element {
  int beam = 0;
  SectionMotion from, to;
  Matrix12 elastic, geometric;
};

/// The forces on a body at which beams end, with their arms about its origin: turning the body turns the arms. Each sum
/// is of arm force^T, N m. All of them grow with the beams' forces, as they are in balance with them: then it does not
/// matter where on the body its origin is.
struct BodyArms {
  int body = machine::ground;
  Array<int> beams;  ///< that end there; none: the forces are those of ropes and weights alone
  Matrix3 of_beams = Matrix3::Zero(), of_others = Matrix3::Zero();
};

/// What happens to the tensions of ropes while the forces of beams grow.
enum class RopeForces { stay, grow };

/// The stiffness against the turns a and b of such a sum S, of (a x arm) x force: (a.b) tr S - a S b, its symmetric
/// part.
double against_turns(const Vector3& a, const Vector3& b, const Matrix3& S) {
  return a.dot(b) * S.trace() - (a.dot(S * b) + b.dot(S * a)) / 2;
}

/// Bending in one plane: displacement along the local axis a, slope sign * turn about the axis r.
void add_plane(Matrix12& K, int a, int r, double sign, const Eigen::Matrix4d& plane) {
  const std::array<int, 4> index = {a, 3 + r, 6 + a, 9 + r};
  const std::array<double, 4> factor = {1, sign, 1, sign};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      K(index[i], index[j]) += factor[i] * factor[j] * plane(static_cast<int>(i), static_cast<int>(j));
    }
  }
}

Eigen::Matrix4d bending(double EI, double l) {
  Eigen::Matrix4d K;
  K << 12, 6 * l, -12, 6 * l, 6 * l, 4 * l * l, -6 * l, 2 * l * l, -12, -6 * l, 12, -6 * l, 6 * l, 2 * l * l, -6 * l,
      4 * l * l;
  return EI / (l * l * l) * K;
}

Eigen::Matrix4d tightening(double N, double l) {
  Eigen::Matrix4d K;
  K << 36, 3 * l, -36, 3 * l, 3 * l, 4 * l * l, -3 * l, -l * l, -36, -3 * l, 36, -3 * l, 3 * l, -l * l, -3 * l,
      4 * l * l;
  return N / (30 * l) * K;
}

void add_bar(Matrix12& K, int i, double stiffness) {
  K(i, i) += stiffness;
  K(6 + i, 6 + i) += stiffness;
  K(i, 6 + i) -= stiffness;
  K(6 + i, i) -= stiffness;
}

void fill_matrices(Element& e, const structure::BeamSection& b, const structure::RodState& from,
                   const structure::RodState& to) {
  const Vector3 chord = to.place - from.place;
  const double l = chord.norm();
  Matrix3 axes;
  axes.col(2) = chord / l;
  axes.col(0) = (from.axes.col(0) - axes.col(2) * axes.col(2).dot(from.axes.col(0))).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  const double N = (from.force + to.force).dot(axes.col(2)) / 2;
  Matrix12 K = Matrix12::Zero(), G = Matrix12::Zero(), T = Matrix12::Zero();
  add_plane(K, 0, 1, 1, bending(b.EI_x, l));
  add_plane(K, 1, 0, -1, bending(b.EI_y, l));
  add_bar(K, 2, b.EA / l);
  add_bar(K, 5, b.GJ / l);
  add_plane(G, 0, 1, 1, tightening(N, l));
  add_plane(G, 1, 0, -1, tightening(N, l));
  for (int k = 0; k < 4; ++k) T.block<3, 3>(Eigen::Index{3} * k, Eigen::Index{3} * k) = axes.transpose();
  e.elastic = T.transpose() * K * T;
  e.geometric = T.transpose() * G * T;
}

/// The machine in pieces: coordinates of the sections within the beams first, then those of the bodies.
class StiffnessAssembly {
 public:
  StiffnessAssembly(const mechanics::System& s, const mechanics::Configuration& c, const mechanics::Evaluation& e,
                    const Eigen::MatrixXd& rest, Array<std::optional<int>> coordinates)
      : s_(s), c_(c), rest_(rest), coordinates_(std::move(coordinates)) {
    // coordinates of the bodies are negative until the number of the others is known
    for (std::size_t k = 0; k < s.layout.pieces.size(); ++k) add_piece(k);
    add_dead_forces();
    add_ropes(e);
    collect();
  }

  /// What is multiplied: the forces of one beam, or of `every` one, and the tensions of ropes with them or not.
  struct Growing {
    std::optional<int> beam;
    RopeForces ropes = RopeForces::stay;
  };

  /// Factors of the stiffness with those multiplied; empty where it gives way.
  std::optional<SkylineFactors> factors(const Growing& of, double factor) const {
    SkylineMatrix K(first_);
    // neutral ways stay so while tensions grow: hardly more of them, so that rounding does not make them ways to swing
    const double more = factor / hardly_less;
    for (const Term& t : terms_) {
      K.add(t.row, t.column, t.elastic + (!scales(t, of) ? 1 : t.tension ? more : factor) * t.geometric);
    }
    return K.factors();
  }

  bool definite(const Growing& of, double factor) const { return factors(of, factor).has_value(); }

  /// What a unit of the factor takes from the stiffness, along each column.
  Eigen::MatrixXd softening(const Growing& of, const Eigen::MatrixXd& X) const {
    return taken([&](const Term& t) { return scales(t, of); }, X);
  }

  /// Whether the tensions of ropes hold more of a way than all that is elastic, where a `factor` on the forces of the
  /// beams takes all of its stiffness: the machine swings there, as a pendulum does.
  bool swings(std::optional<int> beam, double factor, const Eigen::VectorXd& way) const {
    const double held = -way.dot(taken([](const Term& t) { return t.tension; }, way).col(0));
    return 2 * held > factor * way.dot(softening({.beam = beam}, way).col(0));
  }

  Eigen::Index size() const { return static_cast<Eigen::Index>(first_.size()); }

 private:
  /// What an entry of the stiffness is made of.
  struct Term {
    int row = 0, column = 0;
    double elastic = 0, geometric = 0;
    std::optional<int> beam = std::nullopt;
    std::optional<std::size_t> arms = std::nullopt;
    bool tension = false;
  };

  /// A branch: its tension, of all copies, over its length, N/m, its direction, how its ends move.
  struct Rope {
    double across = 0;
    Vector3 direction;
    SectionMotion from, to;
  };

  bool scales(const Term& t, const Growing& of) const {
    if (t.tension) return of.ropes == RopeForces::grow;
    if (!t.arms) return of.beam ? t.beam == of.beam : t.beam.has_value();
    const Array<int>& beams = arms_[*t.arms].beams;
    if (beams.empty()) return of.ropes == RopeForces::grow;
    return !of.beam || std::find(beams.begin(), beams.end(), *of.beam) != beams.end();
  }

  template <typename Which>
  Eigen::MatrixXd taken(const Which& which, const Eigen::MatrixXd& X) const {
    Eigen::MatrixXd Y = Eigen::MatrixXd::Zero(X.rows(), X.cols());
    for (const Term& t : terms_) {
      if (!which(t)) continue;
      Y.row(t.row) -= t.geometric * X.row(t.column);
      if (t.row != t.column) Y.row(t.column) -= t.geometric * X.row(t.row);
    }
    return Y;
  }

  int index(int i) const { return i < 0 ? inner_ - 1 - i : i; }

  void collect() {
    for (int i = 0; i < rest_.rows(); ++i) {
      for (int j = 0; j <= i; ++j) terms_.push_back({inner_ + i, inner_ + j, (rest_(i, j) + rest_(j, i)) / 2, 0});
    }
    for (const Element& e : elements_) add_terms(e);
    for (std::size_t k = 0; k < arms_.size(); ++k) add_arm_terms(k);
    for (const Rope& rope : ropes_) add_tension_terms(rope);
    first_.resize(as_size(inner_ + static_cast<int>(rest_.rows())));
    std::iota(first_.begin(), first_.end(), 0);
    for (const Term& t : terms_) {
      if (t.elastic != 0 || t.geometric != 0) first_[t.row] = std::min(first_[t.row], t.column);
    }
    std::erase_if(terms_, [](const Term& t) { return t.elastic == 0 && t.geometric == 0; });
  }

  void add_terms(const Element& e) {
    Array<std::pair<int, Vector12>> all;
    for (const auto& [i, m] : e.from) all.emplace_back(index(i), (Vector12() << m, Vector6::Zero()).finished());
    for (const auto& [i, m] : e.to) all.emplace_back(index(i), (Vector12() << Vector6::Zero(), m).finished());
    for (const auto& [i, a] : all) {
      const Vector12 elastic = e.elastic * a, geometric = e.geometric * a;
      for (const auto& [j, b] : all) {
        if (j <= i) terms_.push_back({i, j, b.dot(elastic), b.dot(geometric), e.beam});
      }
    }
  }

  /// The stiffness of the rest has the arms of the other forces once, whatever the factor.
  void add_arm_terms(std::size_t k) {
    const BodyArms& arms = arms_[k];
    const SectionMotion body = body_motion(arms.body, Vector3::Zero());
    for (const auto& [i, a] : body) {
      for (const auto& [j, b] : body) {
        if (index(j) > index(i)) continue;
        const double beams = against_turns(a.tail<3>(), b.tail<3>(), arms.of_beams);
        const double others = against_turns(a.tail<3>(), b.tail<3>(), arms.of_others);
        terms_.push_back({index(i), index(j), -others, beams + others, std::nullopt, k});
      }
    }
  }

  /// The stiffness of the rest has the tension of a rope once, whatever the factor. Its length keeps it: where its ends
  /// part by u across it, it pulls them back with T/l u.
  void add_tension_terms(const Rope& rope) {
    Array<std::pair<int, Vector3>> apart;
    const auto across = [&](const Vector3& u) { return Vector3(u - rope.direction * rope.direction.dot(u)); };
    for (const auto& [i, v] : rope.from) apart.emplace_back(index(i), across(-v.head<3>()));
    for (const auto& [i, v] : rope.to) apart.emplace_back(index(i), across(v.head<3>()));
    for (const auto& [i, a] : apart) {
      for (const auto& [j, b] : apart) {
        const double holds = rope.across * a.dot(b);
        if (j > i || holds == 0) continue;
        terms_.push_back({.row = i, .column = j, .elastic = -holds, .geometric = holds, .tension = true});
      }
    }
  }

  SectionMotion body_motion(int body, const Vector3& arm) const {
    SectionMotion m;
    if (body == machine::ground) return m;
    for (int i = s_.layout.first_dof[body]; i < s_.layout.first_dof[as_size(body) + 1]; ++i) {
      if (!coordinates_[i]) continue;
      const machine::Freedom& way = s_.layout.dofs[i].way;
      Vector6 v;
      v << way.along + way.about.cross(arm), way.about;
      m.emplace_back(-1 - *coordinates_[i], v);
    }
    return m;
  }

  /// A joint: the body's displacement, turns of its own about `own`, the body's turn about the rest.
  SectionMotion joint(SectionMotion body, const Array<Vector3>& own) {
    for (auto& [i, v] : body) {
      for (const Vector3& axis : own) v.tail<3>() -= axis * axis.dot(v.tail<3>());
    }
    for (const Vector3& axis : own) {
      Vector6 v;
      v << Vector3::Zero(), axis;
      body.emplace_back(inner_++, v);
    }
    return body;
  }

  SectionMotion free_section() {
    SectionMotion m;
    for (int i = 0; i < 6; ++i) m.emplace_back(inner_++, Vector6::Unit(i));
    return m;
  }

  Vector3 arm_of(const machine::Place& place) const {
    return place.body == machine::ground ? Vector3(Vector3::Zero())
                                         : Vector3(c_.bodies[place.body].orientation * place.at);
  }

  void add_piece(std::size_t k) {
    const mechanics::Layout::Piece& p = s_.layout.pieces[k];
    const machine::Beam& beam = s_.model.beams[p.beam];
    const machine::BeamPiece& piece = beam.pieces[p.piece];
    Array<structure::RodState> all = {mechanics::piece_start(s_, c_, k)};
    structure::RodPiece rod = piece.rod;
    const double share = (rod.to - rod.from) / beam.length;
    const int count = std::max(2, static_cast<int>(std::ceil(elements * share)));
    const int each = std::max(1, (rod.steps + count - 1) / count);
    rod.steps = count * each;
    along(rod, all.front(), &all);
    const Matrix3 axes = all.front().axes;
    SectionMotion from = body_motion(piece.start.body, arm_of(piece.start));
    add_arm(p.beam, piece.start, all.front().force);
    if (p.hinged) from = joint(from, {axes.col(0), axes.col(1)});
    for (int i = 1; i <= count; ++i) {
      Element e;
      e.beam = p.beam;
      e.from = from;
      if (i < count) {
        e.to = free_section();
      } else {
        e.to = body_motion(piece.end.body, arm_of(piece.end));
        if (piece.end_hold == machine::BeamHold::hinged) {
          e.to = joint(e.to, {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()});
        }
      }
      fill_matrices(e, piece.rod.section, all[(i - 1) * each], all[i * each]);
      from = e.to;
      elements_.push_back(std::move(e));
    }
    add_arm(p.beam, piece.end, -all.back().force);
  }

  void add_arm(int beam, const machine::Place& place, const Vector3& force) {
    if (place.body == machine::ground) return;
    BodyArms* arms = arms_of(place.body);
    if (arms == nullptr) arms = &arms_.emplace_back(BodyArms{.body = place.body, .beams = {}});
    arms->beams.push_back(beam);
    arms->of_beams += arm_of(place) * force.transpose();
  }

  BodyArms* arms_of(int body) {
    const auto found = std::find_if(arms_.begin(), arms_.end(), [&](const BodyArms& a) { return a.body == body; });
    return found == arms_.end() ? nullptr : &*found;
  }

  void add_dead_forces() {
    for (int body = 0; body < static_cast<int>(s_.model.bodies.size()); ++body) {
      if (arms_of(body) == nullptr) arms_.push_back({.body = body, .beams = {}});
    }
    for (BodyArms& arms : arms_) {
      const machine::Body& body = s_.model.bodies[arms.body];
      const Vector3 centre = c_.bodies[arms.body].orientation * body.centre;
      arms.of_others -= body.mass * s_.model.gravity * centre * Vector3::UnitZ().transpose();
    }
    for (const machine::Load& load : s_.model.loads) {
      if (BodyArms* arms = arms_of(load.at.body)) arms->of_others += arm_of(load.at) * load.force.transpose();
    }
  }

  void add_ropes(const mechanics::Evaluation& e) {
    for (std::size_t k = 0; k < e.branches.size(); ++k) {
      const mechanics::Branch& b = e.branches[k];
      if (b.slack) continue;
      const mechanics::Layout::Branch& laid = s_.layout.branches[k];
      const machine::Reeving& rope = s_.model.reevings[laid.reeving];
      const auto add = [&](const machine::Node& node, const Vector3& offset, const Vector3& pull) {
        BodyArms* arms = arms_of(node.at.body);
        if (arms == nullptr) return;
        const Vector3 arm = mechanics::end_at(node, c_.bodies).centre + offset - c_.bodies[node.at.body].position;
        arms->of_others += rope.copies * arm * pull.transpose();
      };
      add(rope.nodes[laid.from], b.offset_from, b.pull_from);
      add(rope.nodes[laid.to], b.offset_to, -b.pull_to);
      ropes_.push_back(rope_between(rope, rope.nodes[laid.from], rope.nodes[laid.to], b));
    }
  }

  Rope rope_between(const machine::Reeving& rope, const machine::Node& from, const machine::Node& to,
                    const mechanics::Branch& b) const {
    const auto motion = [&](const machine::Node& node, const Vector3& place) {
      const int body = node.at.body;
      return body == machine::ground ? SectionMotion{} : body_motion(body, place - c_.bodies[body].position);
    };
    const Vector3 start = mechanics::end_at(from, c_.bodies).centre, end = mechanics::end_at(to, c_.bodies).centre;
    const Vector3 chord = end + b.offset_to - start - b.offset_from;
    const double l = chord.norm(), T = (b.pull_from + b.pull_to).dot(chord) / (2 * l);
    return {.across = rope.copies * T / l, .direction = chord / l, .from = motion(from, start), .to = motion(to, end)};
  }

  const mechanics::System& s_;
  const mechanics::Configuration& c_;
  const Eigen::MatrixXd& rest_;
  Array<std::optional<int>> coordinates_;  ///< by freedom: its index among those left, empty: prescribed
  Array<Element> elements_;
  Array<BodyArms> arms_;
  Array<Rope> ropes_;
  Array<Term> terms_;
  Array<int> first_;  ///< by row of the stiffness: the first column with something in it
  int inner_ = 0;
};

/// A factor at which a way loses its stiffness, and that way; empty where it is not known.
struct Root {
  double factor = std::numeric_limits<double>::infinity();
  Eigen::VectorXd way{};
};

/// The factor nearest above `from` at which a direction loses its stiffness, by inverse iteration on a few directions
/// at once, as a round mast buckles in two nearly alike: K(from) Y = S X, where S is what a unit of the factor takes,
/// and 1/(factor - from) the largest Ritz value of S in the space of Y. Infinite where it finds none.
Root nearest_root(const StiffnessAssembly& machine, const StiffnessAssembly::Growing& of, double from) {
  const std::optional<SkylineFactors> K = machine.factors(of, from);
  const Eigen::Index n = machine.size(), count = std::min(n, directions);
  if (!K || count == 0) return {};
  Eigen::MatrixXd Y(n, count);
  for (Eigen::Index k = 0; k < Y.size(); ++k) Y(k) = std::fmod(0.6180339887 * static_cast<double>(k + 1), 1.0) - 0.5;
  Root found;
  for (int i = 0; i < most_iterations; ++i) {
    const Eigen::MatrixXd pushed = machine.softening(of, Y);
    Y = pushed;
    for (Eigen::Index k = 0; k < count; ++k) K->solve(Y.col(k));
    const Eigen::MatrixXd energy = Y.transpose() * pushed, work = Y.transpose() * machine.softening(of, Y);
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> ritz((work + work.transpose()) / 2,
                                                                         (energy + energy.transpose()) / 2);
    if (ritz.info() != Eigen::Success || !(ritz.eigenvalues()[count - 1] > 0)) return {};
    const double before = std::exchange(found.factor, from + 1 / ritz.eigenvalues()[count - 1]);
    Y = (Y * ritz.eigenvectors()).eval();
    Y.colwise().normalize();
    found.way = Y.col(count - 1);
    if (std::abs(found.factor - before) <= ritz_precision * found.factor) return found;
  }
  return found;
}

Root critical_root(const StiffnessAssembly& machine, const StiffnessAssembly::Growing& of, bool stable) {
  double low = 0, high = 1;
  if (stable) {
    low = 1;
    for (high = 2; machine.definite(of, high); high *= 2) {
      if (high > largest_factor) return {};
      low = high;
    }
  } else if (!machine.definite(of, hardly_any)) {
    return {.factor = 0};
  }
  Root guess = nearest_root(machine, of, low == 1 ? hardly_less : std::max(low, hardly_any));
  const double below = guess.factor * (1 - factor_precision), above = guess.factor * (1 + factor_precision);
  const bool stands = low <= below && below < high && machine.definite(of, below);
  if (stands && !machine.definite(of, above)) return guess;
  while (high - low > factor_precision * high) {
    const double middle = (low + high) / 2;
    (machine.definite(of, middle) ? low : high) = middle;
  }
  const double found = (low + high) / 2;
  const bool known = std::abs(guess.factor - found) <= 2 * factor_precision * found;
  return {.factor = found, .way = known ? guess.way : Eigen::VectorXd()};
}

/// Critical factors of one beam, or of `every` one: that at which it buckles, and that at which the machine swings away
/// before.
struct Critical {
  double buckles = 0, swings = std::numeric_limits<double>::infinity();
};

Critical critical_factors(const StiffnessAssembly& machine, std::optional<int> beam, bool stable) {
  constexpr double none = std::numeric_limits<double>::infinity();
  const Root root = critical_root(machine, {.beam = beam}, stable);
  if (root.way.size() == 0 || !machine.swings(beam, root.factor, root.way)) return {.buckles = root.factor};
  const Root grown = critical_root(machine, {.beam = beam, .ropes = RopeForces::grow}, stable);
  // where the forces as they are hold it just so, it may stand anywhere along that way: as a hook may spin
  const bool neutral = stable && root.factor <= 1 + 2 * factor_precision;
  return {.buckles = grown.factor, .swings = neutral ? none : root.factor};
}

}  // namespace

std::optional<BeamStability> beam_stability(const mechanics::System& s, const mechanics::Configuration& c,
                                            bool factors) {
  mechanics::Evaluation e;
  std::optional<PlacesStiffness> all = places_stiffness(s, c, e);
  if (!all) return std::nullopt;
  // with forces along ropes stability() judges the rest, as in a machine without beams
  if (has_rope_loads(s)) {
    const Array<int> kept = rows_with_beams(s, *all);
    Array<int> freedoms;
    for (const int row : kept) freedoms.push_back(all->freedoms[row]);
    const std::vector<int> rows(kept.begin(), kept.end());
    all = PlacesStiffness{.freedoms = freedoms, .matrix = Eigen::MatrixXd(all->matrix(rows, rows))};
  }
  Array<std::optional<int>> coordinates(s.layout.dofs.size());
  for (std::size_t i = 0; i < all->freedoms.size(); ++i) coordinates[all->freedoms[i]] = static_cast<int>(i);
  const StiffnessAssembly machine(s, c, e, all->matrix, coordinates);
  BeamStability result;
  // what stands under hardly less is neutral, whatever rounding makes of it
  result.stable = machine.definite({.beam = every}, 1) || machine.definite({.beam = every}, hardly_less);
  if (!factors) return result;
  const int beams = static_cast<int>(s.model.beams.size());
  const bool one = beams == 1 && result.stable;
  const auto critical = [&](std::optional<int> beam) {
    const Critical found = critical_factors(machine, beam, result.stable);
    result.swings = std::min(result.swings, found.swings);
    return found.buckles;
  };
  if (!one) result.together = critical(every);
  for (int b = 0; b < beams; ++b) {
    const double own = critical(b);
    result.factors.push_back(own > 0 ? own : result.together);
  }
  if (one) result.together = result.factors.front();
  return result;
}

}  // namespace taut::solve
