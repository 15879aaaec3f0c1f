#pragma once
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "taut/checks/check_state.hpp"
#include "taut/checks/checked_deck.hpp"
#include "taut/checks/mast/mast_checks.hpp"

/// `checks: masts:` of a machine: its beams, and masts that the deck gives beside it.
namespace taut::checks {

/// The least critical factor for forces of first order, EN 1993-1-1, 5.2.1 (3).
inline constexpr double first_order_factor = 10;

/// The beams of a mast in one state.
struct BeamState {
  std::string words, analysis;
  std::vector<solve::BeamResult> beams;  ///< of the mast, from its base
  /// Critical factor of all beams of the machine together, where they buckle before the weakest of them would with the
  /// others as they are; infinite: they do not press each other.
  double together = std::numeric_limits<double>::infinity();
  /// No other beam of the machine presses: what buckles under growing forces is this mast, and `together` is the factor
  /// of all as found.
  bool alone = false;
};

/// A mast over all states that were shown.
struct MastStates {
  const MastCheckRequest* request = nullptr;
  std::vector<std::size_t> beams;  ///< of the machine; none: it stands in the deck
  std::vector<BeamState> states;
  double guy_stiffness = HUGE_VAL;  ///< least of the guys at its top in their weakest direction, N/m
  std::string where_stiffness;      ///< empty: no guy ever held it
  std::vector<CarriedState> carried;
};
std::vector<MastStates> mast_states(const std::vector<MastCheckRequest>& masts, const CheckedDeck& deck,
                                    const machine::Model& model);
void take(const CheckState& state, const CheckedDeck& deck, MastStates& mast);

/// The direction of a beam's imperfection across its axis: `towards` of the deck, or the strong way; a unit vector.
Vector3 imperfection_sense(const machine::description::Beam& given, const machine::Beam& built);

/// Names of the beams of a mast, from its base.
std::vector<std::string> beams_of(const MastCheckRequest& request);
const machine::description::Beam* beam_named(const CheckedDeck& deck, const std::string& name);

// The guys of a mast: mast_guys.cpp.
/// The least horizontal stiffness of all guys at the top of a beam, in a state, N/m; none: no guy is there.
std::optional<double> guy_stiffness(const CheckedDeck& deck, const CheckState& state, std::size_t beam);
/// `bending`: least E I of the mast, N m2.
void add_top_check(const MastStates& mast, double bending, const machine::Model& model, Result& r);
void add_plate_checks(const MastStates& mast, const CheckedDeck& deck, const machine::Model& model, Result& r);

void complain_of_masts(const std::vector<MastCheckRequest>& masts, const CheckedDeck& deck, const machine::Model& model,
                       std::vector<Complaint>& complaints);
void add_machine_masts(const std::vector<MastStates>& masts, const CheckedDeck& deck, const machine::Model& model,
                       Result& r);

}  // namespace taut::checks
