#pragma once
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "taut/calc/quantity.hpp"
#include "taut/calc/result.hpp"
#include "taut/checks/anchor/anchor_tree.hpp"
#include "taut/checks/anchor/footing.hpp"
#include "taut/checks/check_state.hpp"
#include "taut/checks/checked_deck.hpp"
#include "taut/checks/guy/guy_checks_deck.hpp"
#include "taut/study/line/rope_clearance.hpp"

/// `checks: guys:`, `anchors:`, `lines:` of a machine.
namespace taut::checks {

/// A guy over all states that were shown. Tensions at rest times the dynamic factor, those of motions as they are.
struct GuyStates {
  const GuyCheckRequest* request = nullptr;
  int reeving = 0;
  double T_max = 0;                 ///< N
  std::string where_max;            ///< "at rest, times 1.2"
  double reserve = HUGE_VAL;        ///< least of mean tension over that of a slack guy
  double T_least = 0, T_slack = 0;  ///< there, N
  std::string where_least;
  /// What `pretension` analyses have left it at the end at which it is put up, and what it has as the machine stands on
  /// its guys alone, unloaded, N; and which of these.
  std::vector<std::pair<double, std::string>> pulled;
  Display display = {};  ///< units of the sentences
};
std::vector<GuyStates> guy_states(const std::vector<GuyCheckRequest>& guys, const CheckedDeck& deck,
                                  const machine::Model& model);
void take(const CheckState& state, GuyStates& guy);
/// The guy of this name as it is put up: its largest tension alone.
void take_put_up(const CheckState& state, const std::string& name, GuyStates& guy);
/// Of a whole motion, at all its steps; `begins`: its first output step, a state at rest; `slowly`: all of them are.
void take_motion(const CheckState& begins, const solve::TransientResult& motion, const std::string& words, bool slowly,
                 GuyStates& guy);

/// A place at which ropes end, or on which a part of the machine stands, over all states that were shown. As above.
/// What stands there counts where it pulls the place up.
struct AnchorStates {
  const AnchorCheckRequest* request = nullptr;
  std::optional<Footing> footing;
  double force = 0, uplift = -HUGE_VAL, angle = -HUGE_VAL;  ///< N, N, rad
  Vector3 pull = Vector3::Zero();                           ///< where the force is largest, without a factor, N
  double factor = 1;                                        ///< in `force`: the dynamic factor of a state at rest
  std::string where, where_uplift, where_angle;
  AnchorTree tree;
  double strongest_rope = 0;     ///< breaking forces of its ropes, all copies, as far as they pull together, N
  std::set<std::string> strong;  ///< the ropes of these forces, by name
  bool strength_unknown = false;
  double thickest_rope = 0;  ///< m; 0: not known
  bool ropes = false;        ///< ropes pull at it
  std::string unknown;       ///< the first moment of a motion, which does not know the force of a body on its joint
};
std::vector<AnchorStates> anchor_states(const std::vector<AnchorCheckRequest>& anchors,
                                        const machine::Machine& described, const machine::Model& model);
void take(const CheckState& state, AnchorStates& anchor);

/// One value over all states.
struct LineExtreme {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string where;
  void largest(double x, const std::string& words) {
    if (!(x <= value)) *this = {.value = x, .where = words};
  }
  void least(double x, const std::string& words) {
    if (!(x >= value)) *this = {.value = x, .where = words};
  }
};

/// A line over its supports, over all states that were shown.
struct LineStates {
  const LineCheckRequest* request = nullptr;
  int reeving = 0;
  LineExtreme tail_angle, off_line;  ///< rad
  bool seen_empty = false;           ///< in a state at rest without a carriage on it
  LineExtreme clearance;             ///< over the ground, m
  LineExtreme deepest;               ///< the same of parts that a motion has straight, where they hang deepest
  std::string slack;                 ///< the first state at rest in which a part of it is slack: it hangs anywhere
  study::TerrainGap gap;             ///< of the line in plan, the largest over all states
  struct Bend {
    std::string support;
    LineExtreme most, least;  ///< rad; negative: lifted by so much
  };
  std::vector<Bend> bends;
  Display display = {};  ///< units of the sentences
};
std::vector<LineStates> line_states(const std::vector<LineCheckRequest>& lines, const machine::Model& model);
void take(const CheckState& state, LineStates& line);

void complain_of_guys(const std::vector<GuyCheckRequest>& guys, const CheckedDeck& deck, const machine::Model& model,
                      std::vector<Complaint>& complaints);
void add_guy_checks(const std::vector<GuyStates>& guys, const CheckedDeck& deck, const machine::Model& model,
                    Result& r);

void complain_of_anchors(const std::vector<AnchorCheckRequest>& anchors, const machine::Machine& described,
                         const machine::Model& model, std::vector<Complaint>& complaints);
void add_anchor_checks(const std::vector<AnchorStates>& anchors, const CheckedDeck& deck, Result& r);
/// The table `anchor_forces` as described.
TableWords anchor_words();

void complain_of_lines(const std::vector<LineCheckRequest>& lines, const machine::Model& model,
                       std::vector<Complaint>& complaints);
void add_line_checks(const std::vector<LineStates>& lines, const CheckedDeck& deck, const machine::Model& model,
                     Result& r);

/// A limit of the catalogue's rules with its words and trust.
struct RuleLimit {
  double value = 0;
  std::string words, trust;
};
/// `safe_end`: of a range the high end (what must be reached) or the low one.
RuleLimit rule_limit(const std::string& id, bool high_end);

/// A bound with all that is doubted in its check: its limit, whose source that is, and numbers beside it.
Bound with_doubts(Bound bound, const std::string& source, const std::vector<Doubt>& others);

/// "load path, in, x = 40 m, times 1.2": of a state at rest with the dynamic factor that its forces are raised by.
std::string with_factor(const std::string& words, double factor);

/// A check of a part by anything else than its strength: it can fail, and the part needs another one to be judged.
void add_part_check(const std::string& part, const std::string& name, double value, const Unit& unit, Bound bound,
                    Result& r);

/// The check that judges a guy, a rope or a beam: force or stress against strength.
void add_strength_check(const std::string& part, const std::string& name, double value, const Unit& unit, Bound bound,
                        Result& r);

}  // namespace taut::checks
