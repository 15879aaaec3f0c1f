#pragma once
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/checks/anchor/footing.hpp"
#include "taut/checks/check_state.hpp"
#include "taut/checks/checked_deck.hpp"
#include "taut/checks/off_groove.hpp"
#include "taut/checks/two_blocked.hpp"
#include "taut/solve/equilibrium.hpp"
#include "taut/solve/motion/transient.hpp"
#include "taut/study/line/rope_clearance.hpp"

namespace taut::checks {

inline constexpr double rough = 0.1;  ///< m; a terrain is not surveyed better

inline constexpr double fallen_angle = std::numbers::pi / 3;  ///< rad: what leans by more has fallen over

/// A quantity at its worst, and the state where it is.
struct WorstOf {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN: no state has it
  std::string when;

  /// `least`: whether less is worse.
  void take(double x, const std::string& words, bool least = false);
};

/// What a beam bears over all states that are judged.
struct BeamWorst {
  WorstOf M, N, stress;      ///< largest, N m, N, Pa
  WorstOf stress_in_corner;  ///< largest, with the corner of a box that stands anyhow, Pa
  WorstOf torsion_left_out;  ///< largest that the stresses don't contain, N m; NaN: they contain all
  WorstOf top_displacement;  ///< m
  WorstOf N_cr, alpha_cr;    ///< least, N, 1
  WorstOf swings;            ///< least swing factor of the machine; NaN: it swings away in no state
};

/// Least and largest of a length over several states, m; NaN: no state has it.
struct LengthRange {
  double least = std::numeric_limits<double>::quiet_NaN(), most = std::numeric_limits<double>::quiet_NaN();

  void take(double length) {
    least = std::fmin(least, length);  // fmin and fmax pass over NaN
    most = std::fmax(most, length);
  }
};

/// Unstretched lengths of one rope while the machine works.
struct RopeLengthsSeen {
  LengthRange free;   ///< between its ends
  LengthRange whole;  ///< with what lies on its drums, of states in which that is known

  void take(const machine::Model& model, const solve::EquilibriumResult& state, int reeving);
};

/// One rope over all states that are judged.
struct RopeSeen {
  std::string name;
  double T = 0;       ///< largest tension at rest, N
  std::string where;  ///< the state that has it
  RopeLengthsSeen lengths = {};
};

/// What the verdict keeps of every state of every judged analysis: the largest tension of each rope, what is below the
/// ground, beams at their worst, and what makes a state unsafe. The deck outlives it.
class Judge {
 public:
  Judge(const CheckedDeck& deck, const machine::Model& model);

  /// `words`: which state it is, "sweep, loads[0].mass = 40 t". The model may be another one of the same machine, with
  /// the same ropes or some of them, known by their names.
  void take(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  /// A line in a model of its own, with all beams of the machine: its tension, height, slack, supports, and beams.
  void take_empty(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  /// Ropes and beams alone: what is put up may lie on the ground, on bodies and supports that are not the machine's.
  void take_put_up(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  /// A moment of a motion: heights of carriages and ropes, ropes out of their grooves or off their supports, blocks
  /// that run into each other, carriages beside their spans. Of a rope that the deck breaks, up to its break. `free`:
  /// its free ropes, of a machine over terrain.
  void take_moment(const machine::Model& model, const solve::TransientResult& so_far,
                   const solve::TransientFrame& moment, const std::vector<FreeRope>& free, const std::string& words);
  /// The place of rest about which a machine vibrates, as a motion of one moment: its tensions.
  void take_rest(const machine::Model& model, const solve::TransientResult& still, const std::string& words);
  /// A tension at rest, N, that counts for the safety factor of a rope alone.
  void take_share(const machine::Reeving& rope, double T, const std::string& words);
  /// The motions from now on are pieces of one, which goes on from each to the next; `end_pieces` ends it.
  void begin_pieces();
  void end_pieces(const std::string& words);
  /// A motion as a whole: which ropes bear tension, what goes slack.
  void take(const machine::Model& model, const solve::TransientResult& motion, const std::string& words);

  const std::vector<BeamWorst>& beams() const { return beams_; }
  /// Ropes that the deck has broken so far in the motion that is shown now.
  const std::set<std::string>& broken() const { return broken_; }
  /// Ropes that a state was shown of, in the order of the model.
  std::vector<RopeSeen> ropes() const;

  /// The values T_max, NAME.T_max, clearance_min, rope_clearance_min over all states, NAME.safety_factor over those at
  /// rest, the checks that can only fail (breaking force, ground), and the warnings of states.
  void add_values(Result& r) const;

  /// Of these T_max, NAME.T_max, NAME.safety_factor and the checks of breaking force alone.
  void add_tensions(Result& r) const;

  /// What the verdict speaks of, once all checks are there: parts without a limit, parts that the deck exempts, parts
  /// beside the verdict; checks at their very limit by a payload pass.
  void add_scope(Result& r) const;

 private:
  struct RopeWorst {
    double T = 0;  ///< at rest, N
    std::string where;
    double peak = 0;  ///< of motions, at all their steps, N
    std::string where_of_peak;
    double breaking_force = 0;  ///< of the state in which T is the largest share of it, N; 0: not known
    double T_of_share = 0;      ///< at rest, N
    RopeLengthsSeen lengths;
    std::string where_of_share;
    bool seen = false;
    bool carries = false;
  };
  struct Height {
    double value = std::numeric_limits<double>::infinity();  ///< over the ground, m
    double x = 0;                                            ///< along the terrain, m
    std::string part, where;                                 ///< "skyline between head and car", "load path, x = 12 m"
  };
  /// Where a rope, or a carriage on it, has been farthest off the line of the terrain in plan.
  struct OffLine {
    double distance = 0, x = 0;  ///< m; m along the terrain
    std::string where;
  };
  struct Warned {
    std::string text;
    bool unsafe = false;
    double size = 0;
    Part part;
  };
  /// What a warning is of, whatever the state: a part, or none, and what of it.
  struct Once {
    Part part = {};
    std::string what;
    bool operator==(const Once&) const = default;
  };

  RopeWorst& take_tension(const machine::Reeving& rope, double T, const std::string& words);
  void take_ropes(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  void take_peaks(const machine::Model& model, const solve::TransientResult& motion, const std::string& words);
  void take_height(const std::string& part, const std::string& words, double height, double x, const std::string& where,
                   std::map<std::string, Height>& all);
  void take_heights(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  void take_carriage(const machine::Model& model, const machine::Carriage& car, const Vector3& place,
                     const std::string& where);
  void take_free(const machine::Model& m, const FreeRope& one, const std::string& when);
  void take_gap(const std::string& rope, const study::TerrainGap& gap);
  void add_gaps(Result& r) const;
  /// Whether a rope should be over the line of the terrain: it carries a carriage, or its clearance is asked for.
  bool is_over_line(const machine::Model& model, int reeving, const Array<Vector3>& places, const Vector3& lowest);
  bool needs_corridor(const machine::Model& model, int reeving) const;
  void take_off_line(const machine::Model& model, int reeving, const Vector3& place, const std::string& where);
  void add_off_line(Result& r) const;
  void warn_of_buried(const machine::Model& model, const std::string& words);
  void warn_of_sunk(const machine::Model& m, const machine::State& state, const std::string& words);
  void take_beams(const solve::EquilibriumResult& state, const std::string& words);
  void take_footings(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  bool holds_uplift(const std::string& anchor) const;
  /// Of several states the one with the largest `size`, else the first.
  void warn(const Once& once, const std::string& text, bool unsafe, double size = 0);
  void take_contacts(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  void warn_of_pulled(const machine::Model& model, const machine::Node& node, const Vector3& force,
                      const std::string& words);
  void take_uplift(const machine::Model& model, const solve::TransientFrame& moment, const std::string& words);
  [[nodiscard]] std::map<int, std::vector<std::size_t>> standing(const machine::Model& model) const;
  bool is_anchor(const machine::Model& model, int body) const;
  std::vector<std::size_t> meant_to_stand(const machine::Model& model, std::vector<std::size_t> feet) const;
  void take_stand(const machine::Model& model, const solve::TransientFrame& moment, const std::string& words);
  void take_lifted(const machine::Model& model, const solve::TransientFrame& moment,
                   const std::vector<std::size_t>& feet, bool is_load, const std::string& words);
  void take_feet(const machine::Model& model, const std::string& words);
  void take_ways_of_feet(const machine::Model& model, const solve::TransientFrame& moment,
                         const std::vector<std::size_t>& feet, const std::string& words);
  void take_lean(const machine::Model& model, const solve::TransientFrame& moment, std::size_t body,
                 const std::string& words);
  void take_stop(const solve::TransientResult& motion, const std::string& words);
  void take_spans(const machine::Model& model, const machine::State& state, const std::set<std::string>& broken,
                  const std::string& words);
  void take_slack(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  void begin_motion(const machine::Model& model, const solve::TransientFrame& first);
  void keep_slack(const std::vector<Once>& branches);
  void warn_of_hanging(const std::string& words);
  [[nodiscard]] std::string break_words() const;
  /// Branches of ropes that may not be slack, and are.
  [[nodiscard]] std::vector<Once> slack_branches(const machine::Model& model,
                                                 const solve::TransientFrame& moment) const;
  void take_places(const machine::Model& model, const solve::EquilibriumResult& state, const std::string& words);
  std::string strength_trust(std::size_t reeving) const;
  bool may_slack(const std::string& reeving) const;
  void add_strength(std::size_t reeving, const RopeWorst& own, Result& r) const;
  void add_heights(Result& r) const;
  void add_scope_of(const Part& part, const std::vector<Part>& exempt, Result& r) const;

  std::shared_ptr<const CheckedDeck> deck_;
  const machine::Model* model_;
  std::map<std::string, RopeWorst> ropes_;  ///< by the name of a reeving or guy
  std::map<std::string, Height> carriages_, rope_heights_;
  std::set<std::string> off_ground_;                 ///< ropes of which a part leaves the corridor of the terrain
  std::set<std::string> slack_over_ground_;          ///< ropes of which is not known how low they hang: slack ones, and
                                                     ///< straight ones whose tension lets them into the ground
  std::map<std::string, study::TerrainGap> beyond_;  ///< how far carriages have stood from the ends of the terrain
  std::map<std::string, OffLine> off_line_;          ///< ropes
  std::map<std::string, study::TerrainGap> gaps_;    ///< of ropes, the largest of one state
  std::vector<BeamWorst> beams_;
  std::vector<Footing> footings_;
  OffGroove off_groove_;
  TwoBlocked two_blocked_;
  std::vector<Warned> warned_;
  std::map<std::pair<Part, std::string>, std::size_t> known_;  ///< where in `warned_` the warning of a thing stands
  std::map<double, std::vector<std::string>> breaks_;          ///< ropes that the deck breaks, by time, s
  std::size_t events_seen_ = 0;                                ///< of the motion that is shown now
  std::set<std::string> broken_;                               ///< its ropes that the deck has broken so far
  std::set<std::size_t> stood_;                                ///< its contacts with faces that have been closed so far
  std::map<std::size_t, std::string> lifted_;  ///< warnings of feet that were lifted, unless their body is a load
  std::set<int> picked_up_;                    ///< bodies that are loads: upright, on no foot
  std::map<std::size_t, Vector3> footprints_;  ///< where feet were when all of their body stood, m
  std::vector<Once> hangs_;                    ///< its branches that have been slack so far, from its beginning on
  std::optional<int> in_pieces_;               ///< how many motions of one that is shown in pieces have begun
};

}  // namespace taut::checks
