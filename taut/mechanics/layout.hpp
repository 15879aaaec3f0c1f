#pragma once
#include <optional>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/model.hpp"
#include "taut/machine/prescribed.hpp"
#include "taut/machine/state.hpp"

namespace taut::mechanics {

/// Which unknown and which equation is where. Unknowns: the freedoms of the bodies, the unstretched length of each
/// branch, the open load of a rope, the hold of a prescribed carriage. Equations: the balance of each freedom, then for
/// each rope the law of each contact or drive or the place of each clamp or load and what is given of the rope, last
/// the prescribed coordinate.
struct Layout {
  struct Dof {
    int body = 0;
    machine::Freedom way;
  };
  /// A branch between two touched nodes; its length is unknown `unknown`. Of a rope that hardly stretches its force is
  /// one too, from `force` on, and so are the rows that close it (stiff_branch.hpp); empty: the force follows from the
  /// length.
  struct Branch {
    int reeving = 0, from = 0, to = 0, unknown = 0;
    std::optional<int> force = std::nullopt;
  };
  /// A touched node between two branches. No `row`: a drive, which takes what comes. `flow`: of a contact's loss, and
  /// the sense along the path of a load's force.
  struct Turn {
    int reeving = 0, node = 0, before = 0, after = 0;
    std::optional<int> row;
    int flow = 0;
    int runs = 0;  ///< the sense in which the rope runs here, of a drive too: +1 along the path, 0 at rest
  };
  /// A whole rope: branches first .. first + count - 1, turns first_turn .. + turn_count - 1; its given quantity.
  struct Rope {
    int first = 0, count = 0, first_turn = 0, turn_count = 0, row = 0;
    std::optional<int> drive;      ///< turn of its drive
    std::optional<int> open_load;  ///< unknown force of its open load
  };

  /// A piece of a beam. Unknowns: the force at its start, then the moment there; at a hinged start the torque and a
  /// turn of the section. Rows: place and turn of its end (at a ball joint the moment), at a hinged start the twist.
  struct Piece {
    int beam = 0, piece = 0, unknown = 0;
    bool hinged = false;  ///< at its start
    int count() const { return hinged ? 7 : 6; }
  };
  /// The force that holds a prescribed carriage: its unknown, the first and last turn along whose track it pulls.
  struct Hold {
    int unknown = 0, first_turn = 0, last_turn = 0;
  };

  Array<Dof> dofs;       ///< unknown and row i
  Array<int> first_dof;  ///< of body b: first_dof[b] .. first_dof[b + 1] - 1
  Array<Branch> branches;
  Array<Turn> turns;
  Array<Rope> ropes;
  Array<Piece> pieces;  ///< the last unknowns and rows
  int size = 0;
  /// Where x of the carriage is prescribed: a rope's or a clamp's row, or one of its own.
  std::optional<int> coordinate_row;
  int coordinate_body = machine::ground;
  Vector3 coordinate_along = Vector3::UnitX();  ///< along which the coordinate is measured
  std::optional<int> height_row;                ///< where its height is prescribed: its rope's row
  double height = 0;                            ///< m
  std::optional<Hold> hold;
  double heaviest = 0;         ///< largest weight or load, N: a scale
  double length = 0;           ///< longest span, m: a scale
  double extent = 0;           ///< diagonal of the box around the ends of all spans, at least the longest one, m
  double stiffest = 0;         ///< largest finite EA of a rope, N
  double slack_stiffness = 0;  ///< EA by which a slack rope whose force is an unknown shares its slack out, N
};

/// `touched` as in the state; `flow` [reeving][node], +1, -1 or 0.
Layout layout(const machine::Model& model, const machine::State& state,
              const std::optional<machine::Prescribed>& prescribed, const Array<Array<int>>& flow);

}  // namespace taut::mechanics
