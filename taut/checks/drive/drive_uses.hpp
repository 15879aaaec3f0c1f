#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/result.hpp"
#include "taut/checks/drive/dragged.hpp"
#include "taut/checks/drive/shown_loads.hpp"
#include "taut/checks/rope/lasting_tension.hpp"
#include "taut/solve/drives.hpp"
#include "taut/solve/equilibrium.hpp"

namespace taut::checks {

inline constexpr double standing_drum = 1e-6;  ///< m/s; a drum that is slower stands

/// What the driven sheaves and drums of a machine have to bear, over all states that are shown to it: whether friction
/// holds the rope, whether a motor's torque is enough where it is a limit, whether the drum takes its rope.
/// docs/theory/drives.md.
class DriveUses {
 public:
  explicit DriveUses(Display display = {}) : display_(display), dragged_(std::move(display)) {}

  /// `words`: which state it is, "sweep, drive.friction = 0.2".
  void take(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  /// One of the bounds of a running machine, for the senses in which ropes may creep over their supports: the grip and
  /// torque of its driven sheaves. (At rest friction may take any part of a torque.)
  void take_bound(const machine::Model& model, const solve::EquilibriumResult& bound, const std::string& words);
  /// A moment of a motion: the grip of its driven sheaves, what lies on its drums, what their brakes have to hold where
  /// they stand without a brake that is set, cylinders at their limits.
  /// `steps`: so many steps of the motion before it. `slowly`: they are at rest.
  void take_moment(const machine::Model& model, const solve::TransientFrame& frame, long steps, bool slowly,
                   const std::string& words);
  /// A motion as a whole, with at least one frame: how far the rope slips on each contact, whether brakes hold and have
  /// stopped their drums.
  void take(const machine::Model& model, const solve::TransientResult& motion, const std::string& words);

  /// Each check at its worst; a rope that slips in a motion, which fails too, a brake that does not hold, a cylinder
  /// that gives way, and too few turns on a drum are unsafe warnings.
  void add_checks(Result& r) const;
  /// Where a verdict is asked for. A sheave without a friction holds its rope whatever it pulls, which shows nothing of
  /// the grip of a driven one.
  void take_grips(const machine::Model& model);
  /// A limit of this rope is for what it bears at rest, which a motion that only lowers does not show.
  void ask_at_rest(const std::string& rope) { at_rest_.insert(rope); }

 private:
  void keep(std::vector<Check> made, const std::string& words);
  void take_set_brakes(const machine::Model& model, const solve::TransientFrame& rest, const std::string& words);
  void take_slips(const machine::Model& model, const solve::TransientFrame& frame, double time,
                  const std::string& words);
  void keep_slip(const machine::Node& node, double slipped, double limit, const std::string& share,
                 const std::string& words);
  void take_turning(const machine::Model& model, const solve::TransientFrame& frame, int drum, long steps);
  void take_way(const Array<solve::DrumResult>& drums, double time);
  void take_hauled(const machine::Model& model, const std::string& words);
  void take_brakes(const machine::Model& model, const solve::TransientResult& motion, const std::string& words);
  void keep_turns(const machine::Model& model, const solve::DrumResult& drum, const std::string& words);
  void keep_winding(const machine::Model& m, const Array<solve::DrumResult>& ends, Array<Array<int>> flow);
  void take_winding(const machine::Model& m, Array<solve::DrumResult> ends);
  void keep_sense(const machine::Model& m, const machine::Reeving& rope, int sense, const std::string& words);
  void keep_runs(const machine::Model& m, const solve::EquilibriumResult& state, const std::string& words);
  void keep_senses(const machine::Model& m, const Array<solve::DrumResult>& ends, const solve::EquilibriumResult& state,
                   const std::string& words);
  void keep_free(const machine::Drum& drum, double torque, const std::string& words);
  void keep_layer(const machine::Model& m, const solve::DrumResult& d, const std::string& words);
  void keep_flange(const machine::Model& m, const solve::DrumResult& d);

  Display display_;
  std::map<std::pair<std::string, PartKind>, Check> worst_;     // by name and kind of part
  std::map<std::pair<Part, std::string>, std::string> unmade_;  // checks that lack a number, by part and name: why
  struct Slip {
    double slipped = 0, limit = 0;  ///< m
    std::string words, where = {};
  };
  std::map<Part, Slip> slips_;  // the largest of each sheave
  struct Slide {
    double way = 0, speed = 0;  ///< m, so far in the motion that is shown now; m/s, at its last moment
  };
  std::vector<Slide> slides_;             // by contact
  Dragged dragged_;                       // what gives way to its load in it
  std::optional<double> last_moment_;     // s, of that motion; none: it has not begun
  std::map<Part, std::string> unbraked_;  // drums whose brake does not hold; drives that give way
  struct Turning {
    LastingTension least, most;  ///< N m, see BorneAtRest
  };
  std::map<int, Turning> turning_;               // drums that turn, with a brake, in the motion that is shown now
  ShownLoads brakes_;                            // drums: by their brake, or as they turn, or bear nothing
  std::map<std::string, std::string> paid_out_;  // ropes that a state shows as they run off their drum, with losses
  std::set<std::string> hauled_;                 // ropes that a state shows otherwise
  struct Haul {
    double in = 0, out = 0;  ///< m, of the loaded rope
    int drum = 0;
  };
  struct Runs {
    bool as_driven = false;  ///< a state shows its rope as the motor's speed says
    std::string words;       ///< what the first other one lacks
  };
  std::map<std::string, Runs> runs_;      // of driven sheaves with a speed
  std::map<int, Haul> hauls_;             // by reeving, so far in the motion that is shown now
  std::set<std::string> at_rest_;         // ropes with a limit at rest
  std::map<Part, std::string> layers_;    // drums with more layers than they are calculated with
  std::map<Part, std::string> yielding_;  // cylinders at their force limit
  struct Turns {
    double left = 0;
    std::string words;
  };
  std::map<std::string, Turns> turns_;  // of each drum, the least
};

}  // namespace taut::checks
