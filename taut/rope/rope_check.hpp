#pragma once
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/calc/sheet.hpp"
#include "taut/rope/rope_use.hpp"

namespace taut::rope {

/// A number that a check measures against, with its rule in words and the trust of it: "verified", "derived", "user",
/// "UNVERIFIED: recalled".
struct Limit {
  double value = 0;  ///< SI
  std::string rule;
  std::string trust;
  bool covers_bending = false;  ///< of a safety factor: the bending on sheaves is in it (cranes, ropeways)
  bool covers_ends = false;     ///< of a safety factor: it holds whatever the terminations (cranes, least_termination)
};

/// Which limits hold for one rope. What is empty is not checked.
struct RopeRules {
  std::vector<Limit> safety_factors;  ///< least F_min/T, static
  bool bending_asked = false;         ///< the weakening on sheaves is asked for, by no field but by the deck
  double dynamic_factor = 1;          ///< on the static tension
  std::string dynamic_words;          ///< where it comes from, with its trust
  std::string dynamic_trust = "user";
  std::optional<Limit> dynamic_safety;     ///< least F_min/(phi T)
  std::optional<Limit> elastic_share;      ///< of F_min that the peak may reach
  bool own_elastic_share = false;          ///< it is the deck's: a limit of the strength
  std::optional<Limit> termination;        ///< efficiency of the ends
  bool no_saddles = false;                 ///< a crane's rope, or one that is said to run, has to run over sheaves
  std::string termination_refused;         ///< why these ends must not be used; empty: may
  std::optional<Limit> least_termination;  ///< what a factor that covers the ends asks
  std::optional<double> temperature;       ///< the rope's, K
  std::optional<Limit> hottest;            ///< K
  std::optional<Limit> hottest_end;        ///< K, by the termination
  std::optional<Limit> heat_strength;      ///< share of the strength at its temperature
  std::string no_strength;                 ///< why no strength is known at its temperature; empty: it is
  std::vector<Limit> sheave_ratios, compensating_ratios, drum_ratios;  ///< least D/d
  bool runs = false;                ///< a D/d is expected: where no rule has one, that is reported
  std::string group;                ///< class of the mechanism, "M5"; empty: none
  bool ratio_asked = false;         ///< a D/d by the deck's own number or class, or because it says that the rope runs
  std::optional<Limit> resistance;  ///< EN 13001-3-2, static: F_min gamma_rb; value not used
  std::optional<double> fatigue_history;  ///< s_r of EN 13001-3-2
  double fatigue_factor = 1;              ///< f_f
  std::optional<Limit> groove_pressure;   ///< Pa
  std::optional<Limit> wire;              ///< delta/d of the outer wire
  double bending_modulus = 82.7e9;        ///< Pa
  std::optional<Limit> fleet_angle;       ///< rad
  std::optional<Limit> layers;            ///< on a drum, at most
  std::optional<double> rated_pull;       ///< of the winch in its first layer, N
};

/// The checks of one rope, each with its value, limit, rule and trust; `part` is the rope's name. A check of which the
/// rope's data are not known (no diameter, no breaking force) is left out, and `left_out` names it.
struct RopeChecks {
  std::vector<Check> checks;
  std::vector<std::string> left_out;  ///< asked for, and not made
  /// Of those that are left out because no load case loads something: what that is, "rope r".
  std::map<std::string, std::string> no_load;
  std::set<std::string> loaded;      ///< what load cases load of that
  std::vector<std::string> remarks;  ///< nobody asked, and a designer would expect it
};
RopeChecks check_rope(const RopeUse& use, const RopeRules& rules);

/// The strengths behind the checks as lines of a calculation note, those of bending at the sharpest bend.
void write_rope(Sheet<Num>& s, const RopeUse& use, const RopeRules& rules);

/// A rope that only touches a round is not weakened there, rad.
inline constexpr double least_wrap = 1e-3;

/// The share of its breaking force that a rope has at its temperature; NaN where none is known.
double heat_share(const RopeRules& rules);

/// Adds an unverified number to the doubts of a check.
void add_doubt(const std::string& trust, const std::string& source, std::vector<Doubt>& doubts);
/// The same of the rope's own breaking force.
void add_doubt_of_rope(const catalogue::RopeRow& rope, std::vector<Doubt>& doubts);

/// What a limit in which several numbers have a part is trusted: as the first that is doubted, else as the limit.
std::string trust_with(const std::string& limit, const std::vector<Doubt>& doubts);

/// Whether rules for the tension at rest can be applied to the largest one of the states at rest. A load that is put on
/// an elastic rope at once gives it twice its tension at rest. Where a calculated motion gives it more than that, it
/// takes loads that no state at rest has. So it may where it ends with more than the tension at rest, or has more on
/// average for some seconds.
bool rest_is_known(const RopeUse& use);

/// Where it is not: why, "the motion reaches 64 kN, more than twice the tension at rest, 15 kN".
std::string why_rest_is_unknown(const RopeUse& use);

/// What then helps. A peak beyond twice what an analysis at rest has found stays there with any further analysis of the
/// same load.
std::string how_to_know_rest(const RopeUse& use);

/// Whether a tension with which a motion ends is more than friction and small swings make of that at rest, N.
bool goes_beyond_rest(double tension, double at_rest);

/// The same rope with the peak of the calculated motions in place of all tensions at rest, which are not more.
RopeUse at_peak(RopeUse use);

/// Factor of the dynamic check: the peak of calculated motions, or the static tension times the dynamic factor.
double peak_tension(const RopeUse& use, const RopeRules& rules);

}  // namespace taut::rope
