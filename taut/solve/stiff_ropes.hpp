#pragma once
#include <optional>

#include "taut/calc/outcome.hpp"
#include "taut/solve/equilibrium.hpp"
#include "taut/solve/rest/newton.hpp"

namespace taut::solve {

/// The largest weight, load or given tension, N: what the stiffness of the ropes is measured by. Without any of them
/// forces come from stretch alone: what the stiffest rope bears at a strain of 1e-3.
double force_scale(const machine::Model& model, const mechanics::Layout& layout);

/// Whether a rope stretches so little that its machine is found with softer ropes first.
bool has_stiff_ropes(const machine::Model& model, double force);

/// The machine with no rope stiffer than `most`, N.
machine::Model softened(machine::Model model, double most);

/// A state of a machine for the same one with other stiffnesses: its branches as long as they stretch to now.
machine::State with_stiffness(machine::State state, const machine::Model& before, const machine::Model& after);

/// An answer with softer ropes, by their lengths alone: places and tensions are the same.
struct Softer {
  machine::Model model;
  mechanics::Layout layout;
  mechanics::Configuration c;
};

/// EA, over the largest force, up to which ropes are found by their lengths.
inline constexpr double found_by_length = 1e6;

/// The answer with no rope stiffer than `stiffest` times its largest force: whether it is one to stay in
/// is a question of matrices, in which a rope that hardly stretches leaves rounding alone, and one that does not
/// stretch no number. Empty where there is no such rope.
std::optional<Softer> with_softer_ropes(const mechanics::System& system, const mechanics::Configuration& c,
                                        double stiffest);

/// Whether the balance, or a tension given, is open by more than 1e-9.
bool is_rough(const mechanics::System& system, const mechanics::Evaluation& e);

/// An answer found by the lengths of all ropes, perhaps of softer ones.
struct StiffAnswer {
  Outcome outcome;  ///< not ok: why the forces of the ropes as they are could not be found
  mechanics::Layout layout;
  mechanics::Configuration c;
  mechanics::Evaluation e;
  int steps = 0;
};

/// The answer beside it with the forces of stiff ropes as unknowns: docs/theory/equilibrium-search.md.
/// `coordinate`: as of a System; `softest`: EA of the ropes in `near`, N; infinite: as in the model.
StiffAnswer with_stiff_ropes(const machine::Model& model, const StiffAnswer& near, double coordinate, double softest,
                             const EquilibriumOptions& options);

}  // namespace taut::solve
