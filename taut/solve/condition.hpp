#pragma once
#include <optional>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/solve/equilibrium.hpp"

namespace taut::solve {

/// A required result, in place of the given quantity of one rope. The length of that rope (or its tension, where it is
/// given by tension) then follows. The modes of a line: pull of a winch, length of the loop, sag, free carriage.
struct Condition {
  enum class Kind {
    tension_at_start,  ///< `value` N at the start of the path of this rope; its length follows
    tension_at_end,    ///< the same at the end
    length,            ///< `value` m, unstretched length of this rope at the reference temperature
    sag_at_carriage,  ///< `value` m: sag of the prescribed carriage below the straight line between the far ends of the
                      ///< two branches beside it
    sag_of_span,      ///< `value` m: sag of the free branch `span` below its chord, at half its horizontal length
    tension_of,       ///< `value` N at one end of rope of[0]: a winch pulls there, and the length of this rope follows
    length_of,        ///< `value` m: unstretched length of all ropes in `of` together, a loop of several ropes
    free_running  ///< the prescribed carriage, rolling and without mainline, is in equilibrium there without another
                  ///< force
  };
  Kind kind = Kind::length;
  int reeving = 0;  ///< the rope whose length or tension follows
  double value = 0;
  int span = 0;  ///< of sag_of_span: index among the branches of this rope
  // NOLINTNEXTLINE(readability-redundant-member-init): keeps it optional in a list of initial values
  Array<int> of = {};   ///< of tension_of and length_of: reevings
  bool at_end = false;  ///< of tension_of: true: at the end of the path; false: at its start
};

/// A machine that fulfils a condition.
struct Conditioned {
  machine::Model model;  ///< with the quantity found in the rope's `given` and `value`
  EquilibriumResult result;
};

/// The equilibrium under a condition. Conditions other than a tension or length of the rope itself are solved by a
/// bracketed root search in the length of the rope (given by tension: in the logarithm of the tension). It begins from
/// the rope's length in `start`, else from the given value: of several solutions it finds one near there. Infeasible
/// when the search finds none; the message says what stopped it. Throws ContractViolation for a condition at a carriage
/// when `options.prescribed` is empty.
Conditioned equilibrium_under(const machine::Model& model, const Condition& condition,
                              const EquilibriumOptions& options = {},
                              const std::optional<machine::State>& start = std::nullopt);

/// Sag of a span below its chord, at half its horizontal length, m.
double sag_at_middle(const BranchResult& branch);

/// Sag of a carriage: its depth below the straight line between the far ends of the two branches beside it, m.
double sag_of_carriage(const machine::Model& model, const EquilibriumResult& result, int carriage);

/// A copy of the machine with the length of each rope given as it is in `result`: guys are put up by tension, then the
/// machine is loaded.
machine::Model installed(const machine::Model& model, const EquilibriumResult& result);

}  // namespace taut::solve
