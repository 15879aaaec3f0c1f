#pragma once
#include <map>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/checks/checked_deck.hpp"
#include "taut/checks/rope/lasting_tension.hpp"
#include "taut/machine/signals_in.hpp"
#include "taut/rope/rope_use.hpp"
#include "taut/solve/drives.hpp"

namespace taut::checks {

/// What a round that is no drum is to a rope: a sheave turns with it, over a saddle it slides.
rope::BendKind kind_of(const machine::Node& node);

/// The free rope beside a drum: its directions at the drum and at the next round, away from the drum.
struct BesideDrum {
  Vector3 leaves = Vector3::Zero(), arrives = Vector3::Zero();
  double length = 0;  ///< straight, m
  int next = 0;       ///< node
};

/// How each rope of a machine is used, over all states that are shown to it: the largest tension of the whole rope, at
/// each end, sheave and drum. A bend is known by its name and how often the path has met it before, as a carriage may
/// stand in another span. At rest the band between both directions of motion counts.
class RopeUses {
 public:
  RopeUses(const CheckedDeck& deck, const machine::Model& model);

  /// `words`: which state it is, "load path, in, x = 130 m".
  void take(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  /// Of a model of some of the ropes, known by their names: forces and bends, not what lies on drums.
  void take_empty(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  /// A moment of a calculated motion after so many steps: how far ropes go round what bends them, what lies on drums,
  /// and tensions that last. `at_rest`: it counts as a state at rest, with the tensions of all ends and rounds.
  void take_moment(const machine::Model& model, const solve::TransientFrame& frame, long steps, bool at_rest);
  /// Of a calculated motion as a whole: its tension at rest and its peak. `slowly`: all its steps are at rest. `then`:
  /// what goes on where it ends.
  void take_motion(int reeving, const solve::RopeExtreme& extreme, bool slowly, const machine::GoesOn& then,
                   const std::string& words);

  /// Motions that end while a tension grows: the rope, and all in words.
  const std::vector<std::pair<std::string, std::string>>& growing() const { return growing_; }

  /// As in the model. Each round and end has no less than a tension of its rope that lasts in a motion.
  std::vector<rope::RopeUse> all() const;
  /// Of one rope, without its bends.
  const rope::RopeUse& of(std::size_t reeving) const { return uses_[reeving]; }

 private:
  struct Met {
    rope::Bend bend;
    int side = 0;  ///< of the first state that bends it there, about the round's own axis
    int order = 0;
  };
  /// A round in one state, and how it turns the rope there.
  struct Turned {
    rope::Bend* bend;
    Vector3 about;
  };
  Met& bend_at(std::size_t reeving, const machine::Node& node, int times, const Vector3& axis);
  /// Notes which rounds of a path turn the rope back from the one before: two on bodies that turn against each other do
  /// so in some states only. `along`: those between the drums of its ends.
  void compare_neighbours(const machine::Reeving& rope, const machine::State& state, std::size_t own,
                          std::vector<Turned> along);
  /// Notes a tension that still grows where a motion ends. `rest`: what it has at rest, N.
  void take_growth(int reeving, const solve::Extreme& T, const machine::GoesOn& then, bool slowly,
                   const std::string& words, double rest);
  void add_end(std::size_t reeving, const machine::Model& model, bool at_end);
  void take_forces(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  /// Of each rope of the model; -1: it is not asked for.
  Array<int> uses_in(const machine::Model& model) const;
  void raise_end(std::size_t reeving, const machine::Node& node, bool at_end, double T);
  rope::DrumEnd& drum_end(const machine::Model& model, const solve::DrumResult& d);
  void take_drum(const machine::Model& model, const machine::State& state, const solve::DrumResult& d,
                 const BesideDrum& beside);

  Array<rope::RopeUse> uses_;                                     // without bends
  Array<LastingTension> lasting_;                                 // of motions
  std::map<std::pair<int, bool>, LastingTension> lasting_hauls_;  // [reeving, its end]
  Array<std::map<std::string, Met>> bends_;                       // [reeving], by name and occurrence
  std::vector<std::pair<std::string, std::string>> growing_;
};

/// The rope of a description with the deck's own figures over those of the catalogue: a breaking force of the deck
/// counts as verified, as its user answers for it.
catalogue::RopeRow row_of(const machine::description::Rope& given);

/// The row of a rope of the deck, of a design the one it has put in; empty where there is no such rope.
catalogue::RopeRow row_in(const CheckedDeck& deck, const std::string& rope);

/// The name of the rope that a reeving or guy of the model is made of.
const std::string& rope_name_of(const machine::Machine& machine, std::size_t reeving);

}  // namespace taut::checks
