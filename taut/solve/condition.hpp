#pragma once
#include <optional>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/solve/equilibrium.hpp"

namespace taut::solve {

/// What is asked of a machine in place of what one rope has given: that rope's length, or where it is given by its
/// tension that tension, follows. The modes of a line: a winch's pull, the length of the loop, a sag, or a carriage
/// that runs free.
struct Condition {
  enum class Kind {
    tension_at_start,  ///< `value` N at the start of its path: the length follows
    tension_at_end,    ///< the same at its end
    length,            ///< `value` m, unstretched, at the reference temperature
    sag_at_carriage,   ///< `value` m: the carriage that is prescribed hangs so far below the straight line between the
                       ///< two ends of the free rope on both sides of it
    sag_of_span,       ///< `value` m: free span `span` sags so much below its chord, at half its horizontal length
    tension_of,        ///< `value` N at one end of rope of[0]: a winch pulls there while this rope's length follows
    length_of,         ///< `value` m, unstretched: all ropes in `of` together, a loop of several
    free_running       ///< the prescribed carriage, rolling and without mainline, stands there by itself
  };
  Kind kind = Kind::length;
  int reeving = 0;  ///< what follows is of this rope
  double value = 0;
  int span = 0;  ///< of sag_of_span: index among the free spans of this rope
  // NOLINTNEXTLINE(readability-redundant-member-init): keeps it optional in a list of initial values
  Array<int> of = {};   ///< of tension_of and length_of: reevings
  bool at_end = false;  ///< of tension_of: at the end of its path, else at its start
};

/// A machine that meets a condition.
struct Conditioned {
  machine::Model model;  ///< with what follows in the rope's `given` and `value`
  EquilibriumResult result;
};

/// The equilibrium under a condition. A sag, and the place of a free carriage, are found by a bracketed root in the
/// rope's length (in the logarithm of its tension), from the given one on: the one nearest to it where there are
/// several. Infeasible with the sags that there are when none fits.
Conditioned equilibrium_under(const machine::Model& model, const Condition& condition,
                              const EquilibriumOptions& options = {},
                              const std::optional<machine::State>& start = std::nullopt);

/// Sag of a span below its chord, at half its horizontal length, m.
double sag_at_middle(const SpanResult& span);

/// How far a carriage hangs below the straight line between the far ends of the two spans beside it, m.
double sag_of_carriage(const machine::Model& model, const EquilibriumResult& result, int carriage);

}  // namespace taut::solve
