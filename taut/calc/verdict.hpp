#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "taut/calc/result.hpp"
#include "taut/units/display.hpp"

namespace taut {

/// What a person reads first. In the order of precedence: the first kind that applies is the verdict.
enum class VerdictKind { fails, no_answer, not_judged, passes_with_warnings, passes };

struct Verdict {
  VerdictKind kind = VerdictKind::not_judged;
  std::string verdict_class;  ///< of not_judged: "unmade", "unverified" or "unasked"; else empty
  std::string reason;         ///< one sentence that names the worst thing
};

/// The verdict of a result; none of a deck with mistakes.
///
/// - fails: a check fails, a limit or a fact (breaking force, yield, ground).
/// - no_answer: the result's status is not ok.
/// - not_judged: `unmade` (a check that was asked for has no number, or states are missing), `unverified` (a check was
///   refused because its limit is unverified), `unasked` (a part in scope has no limit, or nothing is checked).
/// - passes_with_warnings: everything passes, but an unsafe warning stands, an unverified limit decides (utilisation of
///   0.5 or more), or an answer follows a published value that is unsafe.
/// - passes: all of it.
std::optional<Verdict> verdict_of(const Result& r);

/// "load path, in: no equilibrium at 3 of 96 places, x = 12 m to x = 14 m (2 states); x = 20 m; the first: the rope
/// does not reach".
std::string missing_words(const MissingStates& m);

/// "fails", "no_answer", "not_judged", "passes_with_warnings", "passes": as in result.json.
std::string_view to_text(VerdictKind kind);

/// "Passes, with warnings": for people.
std::string_view headline(VerdictKind kind);

/// True when the limit's trust says that nobody has compared it with its source.
bool is_unverified(std::string_view trust);

/// "790.7 kN, limit at most 279.1 kN (sweep, loads[0].mass = 40 t): minimum breaking force of the rope". Value and
/// limit have more digits where they would read the same.
std::string against_limit(const Check& c, const Display& display);

/// What keeps a result that passes from passing without warnings, each one sentence; empty: nothing.
std::vector<std::string> unsafe_of(const Result& r);

/// An unverified limit that decides: its utilisation is 0.5 or more.
bool decides(const Check& c);

/// How bad a check is, for an order: its utilisation to nine decimals, so that limits which are reached together stay
/// in the deck's order whatever their last digits; of two such the one that fails is worse. One without an utilisation
/// is worse than any where it fails, and nothing where it passes.
double severity(const Check& c);

/// Whether `a` is worse than `b`, a check of the same limit in another state or at another place: what fails is worse
/// than what passes, then the larger utilisation, without one the larger excess.
bool worse_state(const Check& a, const Check& b);

}  // namespace taut
