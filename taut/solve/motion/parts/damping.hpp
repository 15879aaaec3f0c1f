#pragma once
#include "taut/base/array.hpp"
#include "taut/solve/motion/step/step.hpp"

namespace taut::solve::dynamics {

/// By reeving: the lowest frequency of a mode in which the rope stretches (has a hundredth of the strain energy or
/// more), with ropes stuck on their sheaves, at these values, rad/s; 0 where it moves nothing. From the eigenvalues of
/// K^1/2 B' M^-1 B K^1/2, B the lines' gradients: modes that stretch nothing are not among them. Modes against which
/// the tensions across the branches are stiffer than their stretch are swings (of a block on nearly parallel falls)
/// and count only for a rope that has no others.
Array<double> stretching_frequencies(Mechanism& m, const Values& v, Work& w);

/// Eigenvalues and, as columns, eigenvectors of a symmetric matrix of size n, row by row, by Jacobi's rotations.
struct Symmetric {
  Array<double> values, vectors;
};
Symmetric eigen_of(Array<double> a, std::size_t n);

}  // namespace taut::solve::dynamics
