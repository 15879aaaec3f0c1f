#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <unsupported/Eigen/AutoDiff>
#include <vector>

#include "test/witness/guyed_mast.hpp"

/// A hand model that shares nothing with the solver but the input: the mast as a chain of bars with bending springs at
/// their joints, the guys as chains of bars with lumped weights, all degrees of freedom positions; the minimum of the
/// potential energy by Newton with second derivatives from automatic differentiation. Round sections, no torsion.
namespace taut_test::witness {

using Inner = Eigen::AutoDiffScalar<Eigen::Matrix<double, 9, 1>>;
using Outer = Eigen::AutoDiffScalar<Eigen::Matrix<Inner, 9, 1>>;
template <class T>
using V3 = Eigen::Matrix<T, 3, 1>;

/// Bending energy of the joint between a - b - c: EI/(2 l) |2 tan(phi/2)|^2.
template <class T>
T joint(const V3<T>& a, const V3<T>& b, const V3<T>& c, double EI, double length) {
  const V3<T> e = b - a, f = c - b;
  const T le = sqrt(e.squaredNorm()), lf = sqrt(f.squaredNorm());
  const V3<T> cross = e.cross(f);
  const T half = le * lf + e.dot(f);
  return T(2 * EI / length) * cross.squaredNorm() / (half * half);
}

template <class T>
T bar(const V3<T>& a, const V3<T>& b, double EA, double length) {
  const V3<T> e = b - a;
  const T strain = sqrt(e.squaredNorm()) / T(length) - T(1);
  return T(EA * length / 2) * strain * strain;
}

class Model {
 public:
  int add_node(const Vector3& at, bool fixed) {
    places_.push_back(at);
    forces_.emplace_back(Vector3::Zero());
    fixed_.push_back(fixed);
    return static_cast<int>(places_.size()) - 1;
  }
  void add_bar(int a, int b, double EA, double length) { parts_.push_back({{a, b, b}, EA, length, false}); }
  void add_joint(int a, int b, int c, double EI, double length) { parts_.push_back({{a, b, c}, EI, length, true}); }
  void add_force(int node, const Vector3& F) { forces_[static_cast<std::size_t>(node)] += F; }
  const Vector3& at(int node) const { return places_[static_cast<std::size_t>(node)]; }

  /// Newton with a growing diagonal where the energy is not convex; true when the forces vanish.
  bool settle() {
    double mu = 0;
    for (int i = 0; i < 400; ++i) {
      double energy = 0;
      derivatives(energy);
      if (g_.norm() < 1e-3) return true;  // N, of hundreds of kN
      for (int tries = 0; tries < 60; ++tries) {
        Eigen::MatrixXd H = H_;
        H.diagonal().array() += mu;
        const Eigen::LLT<Eigen::MatrixXd> factor(H);
        if (factor.info() == Eigen::Success) {
          const auto before = places_;
          move(-factor.solve(g_));
          const double now = this->energy();
          if (now <= energy + 1e-11 * std::abs(energy)) {
            mu = mu > 1 ? mu / 30 : 0;
            break;
          }
          places_ = before;
        }
        mu = mu > 0 ? mu * 4 : 1;
      }
    }
    return false;
  }

 private:
  struct Part {
    std::array<int, 3> nodes;
    double stiffness, length;
    bool bends;
  };

  template <class T>
  T energy_of(const Part& p, const std::array<V3<T>, 3>& x) const {
    return p.bends ? joint<T>(x[0], x[1], x[2], p.stiffness, p.length) : bar<T>(x[0], x[1], p.stiffness, p.length);
  }
  double energy() const {
    double E = 0;
    for (const Part& p : parts_) E += energy_of<double>(p, {at(p.nodes[0]), at(p.nodes[1]), at(p.nodes[2])});
    for (std::size_t i = 0; i < places_.size(); ++i) E -= forces_[i].dot(places_[i]);
    return E;
  }
  void number() {
    first_.assign(places_.size(), -1);
    size_ = 0;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (!fixed_[i]) first_[i] = size_, size_ += 3;
    }
  }
  void move(const Eigen::VectorXd& d) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (first_[i] >= 0) places_[i] += d.segment<3>(first_[i]);
    }
  }
  void derivatives(double& energy) {
    number();
    energy = this->energy();
    g_ = Eigen::VectorXd::Zero(size_);
    H_ = Eigen::MatrixXd::Zero(size_, size_);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (first_[i] >= 0) g_.segment<3>(first_[i]) -= forces_[i];
    }
    for (const Part& p : parts_) add_part(p);
  }
  void add_part(const Part& p) {
    const int corners = p.bends ? 3 : 2;
    std::array<V3<Outer>, 3> x;
    for (int n = 0; n < 3; ++n) {
      for (int k = 0; k < 3; ++k) {
        const int index = 3 * n + k;
        Inner v(at(p.nodes[static_cast<std::size_t>(n)])[k], Eigen::Matrix<double, 9, 1>::Unit(index));
        Eigen::Matrix<Inner, 9, 1> d;
        for (int m = 0; m < 9; ++m) d[m] = Inner(m == index ? 1.0 : 0.0, Eigen::Matrix<double, 9, 1>::Zero());
        x[static_cast<std::size_t>(n)][k] = Outer(v, d);
      }
    }
    const auto E = energy_of<Outer>(p, x);
    for (int a = 0; a < 3 * corners; ++a) {
      const int row = dof(p, a);
      if (row < 0) continue;
      g_[row] += E.derivatives()[a].value();
      for (int b = 0; b < 3 * corners; ++b) {
        if (dof(p, b) >= 0) H_(row, dof(p, b)) += E.derivatives()[a].derivatives()[b];
      }
    }
  }
  int dof(const Part& p, int k) const {
    const int first = first_[static_cast<std::size_t>(p.nodes[static_cast<std::size_t>(k / 3)])];
    return first < 0 ? -1 : first + k % 3;
  }

  std::vector<Vector3> places_, forces_;
  std::vector<bool> fixed_;
  std::vector<int> first_;
  std::vector<Part> parts_;
  int size_ = 0;
  Eigen::VectorXd g_;
  Eigen::MatrixXd H_;
};

struct Answer {
  bool settled = false;
  Vector3 top = Vector3::Zero();
  std::vector<double> tension_top;  ///< of the uppermost bar of each guy, N
  double foot_moment = 0;           ///< of the spring at the clamp, N m
};

/// The mast in `elements` bars (all heights multiples of height/elements), each guy in `links` bars.
inline Answer solve(const GuyedMast& mast, int elements, int links) {
  Model model;
  const double h = mast.height / elements, EI = mast.section.EI_x;
  std::vector<int> nodes;
  for (int i = 0; i <= elements; ++i) nodes.push_back(model.add_node(Vector3(0, 0, i * h), i == 0));
  const auto node = [&](double height) { return nodes[static_cast<std::size_t>(std::lround(height / h))]; };
  for (int i = 0; i < elements; ++i) {
    const auto k = static_cast<std::size_t>(i);
    model.add_bar(nodes[k], nodes[k + 1], mast.section.EA, h);
    if (i > 0) model.add_joint(nodes[k - 1], nodes[k], nodes[k + 1], EI, h);
  }
  if (mast.base == MastBase::clamped) {
    const int below = model.add_node(Vector3(0, 0, -h), true);
    model.add_joint(below, nodes[0], nodes[1], EI, h / 2);
  }
  for (const MastLoad& load : mast.loads) model.add_force(node(load.height), load.force);
  std::vector<std::pair<int, int>> last;
  std::vector<double> links_length;
  for (const Guy& guy : mast.guys) {
    const double length = *installed_length(guy) / links;
    links_length.push_back(length);
    const Vector3 top(0, 0, guy.height);
    int before = model.add_node(guy.anchor, true);
    model.add_force(node(guy.height), -guy.weight * length / 2 * taut::up());
    for (int i = 1; i <= links; ++i) {
      const double t = static_cast<double>(i) / links;
      const Vector3 at = guy.anchor + t * (top - guy.anchor) - 0.2 * t * (1 - t) * taut::up();
      const int next = i == links ? node(guy.height) : model.add_node(at, false);
      if (i < links) model.add_force(next, -guy.weight * length * taut::up());
      model.add_bar(before, next, guy.stiffness, length);
      if (i == links) last.emplace_back(before, next);
      before = next;
    }
  }
  Answer a;
  a.settled = model.settle();
  a.top = model.at(nodes.back()) - Vector3(0, 0, mast.height);
  for (std::size_t i = 0; i < last.size(); ++i) {
    const double l = (model.at(last[i].second) - model.at(last[i].first)).norm();
    const double T = mast.guys[i].stiffness * (l / links_length[i] - 1);
    a.tension_top.push_back(T);
  }
  const Vector3 first = (model.at(nodes[1]) - model.at(nodes[0])).normalized();
  if (mast.base == MastBase::clamped) {
    const double turn = std::acos(first.z());
    a.foot_moment = EI * 2 * std::tan(turn / 2) / (h / 2);
  }
  return a;
}

}  // namespace taut_test::witness
