#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/model.hpp"
#include "taut/machine/state.hpp"
#include "taut/solve/equilibrium.hpp"
#include "taut/solve/motion/transient.hpp"
#include "taut/study/line/rope_clearance.hpp"
#include "taut/units/display.hpp"

namespace taut::checks {

/// A free branch of a rope.
struct CheckBranch {
  int reeving = 0, from = 0, to = 0;                             ///< nodes
  double T = 0;                                                  ///< the largest, the band at rest included, N
  double mean = 0;                                               ///< of its ends' tensions, N
  double chord = 0, unstretched = 0;                             ///< m; at the reference temperature
  Vector3 start = Vector3::Zero(), end = Vector3::Zero();        ///< where the free rope begins and ends, m
  Vector3 on_start = Vector3::Zero(), on_end = Vector3::Zero();  ///< pull of one copy on what is there, N
};

/// What a rope does at a node between its ends.
struct CheckContact {
  int reeving = 0, node = 0;
  double wrap = 0;                  ///< rad
  bool lifts = false;               ///< it hangs free or pulls the wrong way
  Vector3 place = Vector3::Zero();  ///< middle of the round, m
  Vector3 force = Vector3::Zero();  ///< of one copy on it, N
};

/// A free rope of a motion as it hangs there. A branch that sags is the motion's own catenary. A part that the motion
/// has straight, with its weight at its ends, hangs between two catenaries: that of its length, where no rope comes
/// after, and that in the least tension that it has, or was given, where a weight or a pull draws rope in or out until
/// it has that tension. Of a rope in segments each one hangs between
/// its joints as a parabola by its own weight and tension; where waves have slackened it, it turns by no more than the
/// rope does at both its joints.
struct FreeRope {
  int reeving = 0, from = 0, to = 0;  ///< nodes
  Array<study::RopePiece> pieces;     ///< from end to end, by its length
  Array<study::RopePiece> deeper;     ///< the same in its tension; empty: `pieces` are as it hangs

  /// Its ends and joints, m: in plan it lies between them.
  Array<Vector3> places() const;
};

/// Where the bodies are at a moment of a motion; nothing more.
machine::State places_of(const solve::TransientFrame& moment);

/// All of them at a moment of a motion.
std::vector<FreeRope> free_ropes(const machine::Model& model, const solve::TransientResult& motion,
                                 const solve::TransientFrame& moment);

/// Whether a branch is slack and straight at a moment of a motion; of a broken rope none is.
bool has_no_shape(const machine::Model& model, const solve::TransientFrame& moment,
                  const solve::TransientFrame::Branch& branch);

/// Over the terrain.
study::RopeClearance clearance_of(const machine::Model& model, const FreeRope& rope);
/// The same where it hangs deepest.
study::RopeClearance least_clearance_of(const machine::Model& model, const FreeRope& rope);

/// What lets a straight rope hang as it does.
inline constexpr const char* lets_hang = "use 'branches: catenary', or give the rope 'segments'";

/// One state of a machine as the checks of its parts see it: an equilibrium, one of its bounds, or a moment of a
/// calculated motion.
struct CheckState {
  const machine::Model* model = nullptr;
  std::vector<CheckBranch> branches;
  std::vector<CheckContact> contacts;
  const solve::EquilibriumResult* rest = nullptr;  ///< what it is of; a motion has none, and no beams
  bool moves = false;                              ///< a moment of a motion that is not at rest there
  std::optional<double> t;                         ///< of a motion, s
  std::vector<FreeRope> ropes;                     ///< of a motion over terrain, where they are asked for
  std::vector<int> slack;   ///< of a motion: reevings with a branch whose rope hangs nobody knows how
  std::vector<int> broken;  ///< of a motion: reevings that the deck has broken; they are judged up to then
  std::string words;        ///< "envelope, in, x = 40 m", "transient, drop, t = 1.2 s"
  std::string analysis;     ///< its name in the deck, or its kind
};

CheckState state_of(const machine::Model& model, const solve::EquilibriumResult& state, std::string words,
                    std::string analysis);

/// At a moment of a motion. A branch that is straight there has half of its weight hanging at each of its ends
/// (`mass_lumped`). Of a rope in segments the first and the last one pull at the ends.
CheckState state_of(const machine::Model& model, const solve::TransientResult& motion,
                    const solve::TransientFrame& moment, std::string words, std::string analysis);

/// The analysis of states while lines and guys are put up and screws are set, which no analysis of the deck asks for.
inline constexpr std::string_view put_up_analysis = "installation";

/// "skyline between head and car".
std::string span_words(const machine::Model& model, int reeving, int from, int to);

/// A place on the ground, by its chainage: "x = 12 m" where that is x, else "chainage 12 m".
std::string ground_words(const machine::Model& model, double chainage, const Display& display);

/// Why a clearance that is asked for is not judged everywhere: "skyline: its clearance is not judged on 12 m ...".
std::string gap_words(const std::string& what, const study::TerrainGap& gap, const Display& display);

/// Behind an answer of an analysis with `judge: false`.
inline constexpr const char* not_judged_words = "left out of the verdict";

/// Why a clearance that is asked for is not judged of a rope without mass that is slack there.
std::string slack_words(const std::string& rope, const std::string& where);

/// The name of an analysis by the ending of its tables: "_drop" is "drop"; "" and "_2" have no name of their own, but
/// `kind`.
std::string analysis_name(const std::string& ending, const char* kind);

/// The same for people: "drop"; "load path", "load path 2".
std::string analysis_words(const std::string& ending, const char* kind);

}  // namespace taut::checks
