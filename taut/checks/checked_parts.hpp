#pragma once
#include <memory>
#include <string>
#include <vector>

#include "taut/base/stretches.hpp"
#include "taut/checks/anchor/support_checks.hpp"
#include "taut/checks/checked_deck.hpp"
#include "taut/checks/drive/drive_uses.hpp"
#include "taut/checks/guy/guy_checks.hpp"
#include "taut/checks/judge.hpp"
#include "taut/checks/limits_of_payloads.hpp"
#include "taut/checks/mast/machine_masts.hpp"
#include "taut/checks/rope/rope_uses.hpp"
#include "taut/checks/yarder/carriage_checks.hpp"
#include "taut/checks/yarder/yarder_checks.hpp"

namespace taut::checks {

/// What kind of motion is shown.
struct MotionKind {
  bool slowly = false;    ///< it has no inertia, and all its steps are at rest
  bool complete = false;  ///< it ends where it is meant to, whatever its signals would do then: a pull, a place of rest
};

/// What verdict and checks keep of every state of every judged analysis: all positions, sweep values, temperatures,
/// times. The deck outlives it.
struct CheckedParts {
  CheckedParts(const CheckedDeck& given, const machine::Model& model);

  /// All bounds of a state count as the state does. `words`: which state it is; `analysis`: the name of its analysis,
  /// for load combinations.
  void take(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words,
            const std::string& analysis);
  /// The same for the values of the verdict alone: the checks of this state are made elsewhere.
  void take_values(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  /// A line that is empty, in a model without what hangs on it: its tension and bends, what holds and carries it, guys
  /// and masts, its angles and clearance. `put_up`: it is being put up, which its winch has to do; it may lie on the
  /// ground yet.
  void take_empty(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& line,
                  const std::string& words, const std::string& analysis, bool put_up = false);
  /// A moment while the machine is put up: the tensions of its ropes and guys, what they pull at, and its beams.
  void take_put_up(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  /// The tensions at both ends of all ropes, by reeving, N, that a `pretension` analysis leaves: of its guys they are
  /// pretensions.
  void take_pretension(const Array<double>& T_start, const Array<double>& T_end, const std::string& words);
  /// A motion at an output step or where a rope has a peak: forces and places. `slowly`: each is a state at rest.
  void take_moment(const machine::Model& model, const solve::TransientResult& so_far,
                   const solve::TransientFrame& moment, const std::string& words, const std::string& analysis,
                   bool slowly = false);
  /// The place of rest about which a machine vibrates. `rope_mass`: whether the mass of its ropes is counted.
  void take_rest(const machine::Model& model, const solve::TransientFrame& rest, bool rope_mass,
                 const std::string& words, const std::string& analysis);
  /// A motion as a whole: tensions at all its steps, and how far its ropes slipped.
  void take(const machine::Model& model, const solve::TransientResult& motion, const std::string& words,
            const MotionKind& kind = {});

  /// What friction may do to a state beyond what is judged. `words`, `analysis`: as in `take`.
  void take_friction(const solve::EquilibriumResult& state, const std::string& words, const std::string& analysis);
  /// Shows a state to the parts that are named in `checks:` or have a rating, to the guys those of rest alone.
  void show(const CheckState& seen);
  /// Shows the state, or a bound of one, to the parts that `take_empty` says.
  void show_empty(const CheckState& seen, const std::string& line, bool put_up);
  /// Whether there are any of them.
  bool any_shown() const;
  /// Whether a motion is judged by forces of several ropes together, which peak where none of them does.
  bool judges_sums(const machine::Model& model) const;

  std::shared_ptr<const CheckedDeck> deck;  ///< its own view: who made this one may have given a passing one
  std::vector<std::string> reevings;        ///< of the machine, by name
  /// By reeving, of the motion that is shown now: the largest tension in its moments, N.
  std::vector<double> T_in_moments;
  double shown_at = 0;  ///< the last of these moments, s
  Stretches unheld;     ///< states without equilibrium in a direction that friction may act in
  Stretches unbounded;  ///< states that friction may load with more than what is judged
  /// Peaks of motions that no moment has, where a check needed them: why it is not judged.
  std::vector<std::string> unseen;
  bool seen = false;        ///< whether the checks have been shown anything but such moments
  bool put_up = false;      ///< whether a moment while the machine is put up was shown
  bool seen_apart = false;  ///< whether states were shown for their values alone
  bool judged = true;       ///< false: the analysis that runs says `judge: false`, and its states do not count
  Judge judge;
  RopeUses ropes;
  DriveUses drives;
  LimitsOfPayloads payloads;
  std::vector<GuyStates> guys;
  std::vector<AnchorStates> anchors;
  std::vector<LineStates> lines;
  std::vector<SupportStates> supports;
  std::vector<YarderLineStates> yarders;
  std::vector<CarriageStates> carriages;
  std::vector<MastStates> masts;
};

}  // namespace taut::checks
