#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/catalogue/rope.hpp"
#include "taut/math/vector.hpp"
#include "taut/units/display.hpp"

/// One rope as its machine or its method uses it: what the checks of a rope look at. SI.
namespace taut::rope {

/// What bends a rope.
enum class BendKind { sheave, compensating_sheave, drum, saddle };

/// A place where the rope is bent.
struct Bend {
  std::string name;
  BendKind kind = BendKind::sheave;
  double diameter = 0;  ///< pitch, m, > 0; of a drum in its first layer
  double tension = 0;   ///< the largest there, N
  double wrap = 0;      ///< the largest, rad
  /// Unit axis about which the rope turns right-handed along its path, where neighbours are compared; 0: not known.
  Vector3 about = Vector3::UnitY();
  bool both_ways = false;    ///< it turns one way in a state and the other way in another one
  bool turned_back = false;  ///< in some state it turns the rope back from the round before it along the path
};

/// An end that is fixed, not wound on a drum.
struct RopeEnd {
  std::string name;
  double tension = 0;  ///< the largest there, N
};

/// An end on a drum whose rope is known. Without what is not known.
struct DrumEnd {
  std::string name;
  double tension = 0;  ///< the largest there, N
  double haul = 0;  ///< the largest of all ropes together that are wound on it as this one, all copies, N; 0: unknown
  double haul_peak = 0;                             ///< the same in the moments of calculated motions, N
  std::optional<double> fleet_angle;                ///< largest over the face, rad
  std::optional<int> layers;                        ///< wound when the most rope lies on it
  std::optional<double> first_radius, last_radius;  ///< of the first and of the last of these layers, m
  std::vector<std::string> lacks = {};              ///< what its layers need and the deck has not: "'face_width'"
};

/// A rope over all load cases.
struct RopeUse {
  std::string name;
  catalogue::RopeRow rope;  ///< breaking force 0, area 0, diameter 0, no grade: not known
  double tension = 0;       ///< the largest anywhere, static, N
  std::string where;        ///< "load path, in, x = 130 m"
  bool lasts = false;       ///< it is one of a motion that lasts, and of no state at rest
  bool analysed = false;    ///< an analysis at rest has it or nearly as much, not only the start of a motion
  double peak = 0;          ///< the largest of calculated motions, N; 0: none
  std::string peak_where;
  double mean = 0;  ///< the largest over some seconds of calculated motions, N; 0: none
  std::string mean_where;
  double last = 0;  ///< on average at the end of calculated motions, the largest, N: what may go on from there; 0: none
  std::vector<Bend> bends;              ///< along its path
  std::vector<std::string> unmeasured;  ///< sheaves and drums that it bends on, of no known diameter
  bool measurable = false;  ///< the deck can give those diameters: that of a machine, of no published method
  std::vector<RopeEnd> ends;
  std::vector<DrumEnd> drums;
  int copies = 1;       ///< equal ropes side by side; all tensions are of one of them
  bool closed = false;  ///< endless: the last bend stands before the first
  bool chosen = false;  ///< the calculation chooses it: before that its row is what all candidates have alike
  /// The safety factor that the input of a method asks of it, and the method can't judge: it does not know the
  /// strength.
  std::optional<double> own_factor = {};
  Display display = {};  ///< units of the sentences
};

}  // namespace taut::rope
