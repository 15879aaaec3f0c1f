#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/compile/given.hpp"
#include "taut/machine/links/links.hpp"

namespace taut::machine {

/// What a guide with `holds: ahead_of` says: the carriage's index, and its element of the path for complaints.
struct AheadOf {
  int carriage = 0;
  std::string path;
};

/// One node of a path with what is needed until its side is known.
struct Stop {
  Node node;
  Vector3 axis = Vector3::UnitY();  ///< of the round in the ground frame, of the machine as it is described
  description::Side side = description::Side::automatic;
  std::optional<int> carriage;  ///< index among the carriages
  int roller = 0;               ///< of a carriage with several: which one
  bool grip = false;            ///< where a rope that the carriage does not ride on is fixed to it
  bool saddle = false;
  bool drives = false;     ///< has a motor
  bool by_torque = false;  ///< that has a given torque
  bool axis_open = false;  ///< the deck does not say how its axis lies, and its path may
  std::optional<AheadOf> ahead_of = std::nullopt;
};

/// The nodes of a reeving's path, an endless one from its drive on, tackles written out: between two sheaves of a
/// tackle of n parts the rope runs n times. Where the element before is one of the two, it counts as the beginning of
/// the first part. Sides are not set. On a drum the rope lies in its layer.
Array<Stop> stops_of(const Machine& machine, const Links& links, const DescribedReeving& described,
                     std::vector<Complaint>& complaints);

/// Lays the axes that the deck leaves open horizontally across the path in plan: by the directions of unit length from
/// the round to its neighbours, whose parts in plan, h and k, are halved by h - k where the rope passes and by h + k
/// where it turns back. Where it does neither (within 45 degrees of a right angle) the longer of the two counts if it
/// is twice as long as the other one, as of the leg down a mast; else the axis stays [0, 1, 0]. Of the two senses it
/// has that with y > 0, along y that with x < 0. `places`: as for set_sides, to be called before it.
void set_axes(Array<Stop>& stops, const Array<Vector3>& places, bool closed);

/// Sets the side of every round. As the deck says; else a saddle carries the rope on its upper side, a sheave lies on
/// the inner side of the bend that the straight path makes there, a sheave that turns the rope back beside
/// itself, within its own width, is run round in the sense of the one before or behind it, and a drum is wound from
/// above. Where those do not say either, the branch with a carriage is the upper one (the one on which it rolls before
/// one to which it is fixed); without one the bend decides, however small; without a bend the branch that arrives is
/// the upper one. All that does not depend on the axis' sense, and but for the last not on the path's.
/// `places`: of the stops, in the ground frame, in which their `axis` is too.
void set_sides(Array<Stop>& stops, const Array<Vector3>& places, bool closed);

}  // namespace taut::machine
