#pragma once
#include <functional>
#include <string>
#include <vector>

#include "taut/calc/progress.hpp"
#include "taut/calc/result.hpp"
#include "taut/solve/motion/transient.hpp"
#include "taut/study/requests/transient_deck.hpp"
#include "taut/study/transient_record.hpp"

namespace taut::checks {
struct CheckedParts;
}

namespace taut::results {

/// One motion: what was asked, and the answer.
struct TransientRun {
  std::string ending;  ///< of its tables' and files' names: "", "_2", "_stop"
  std::string envelope =
      "envelope";  ///< name of that table: another one where the deck has the analysis `envelope` too
  study::TransientRequest request;
  std::vector<solve::Slid> slid;  ///< of a sliding start
  solve::TransientOptions options;
  machine::Model model;
  study::TransientRecord record;            ///< what was taken as it went
  solve::TransientResult result;            ///< with the frames that pictures show
  std::vector<std::string> strength_trust;  ///< by reeving: of its breaking force
};

/// Where a deck lets a motion begin.
solve::Start start_of(study::TransientRequest::Start start);

/// How it has free ropes.
solve::Branches branches_of(study::TransientRequest::Branches branches);

/// The motion, with its options from the request. `checked` is shown every output step, then the motion as a whole.
void solve(TransientRun& run, const std::function<bool(const Progress&)>& progress,
           checks::CheckedParts* checked = nullptr);

/// The share of the energy exchanged that the energy ledger may leave open: the tolerance. Where the deck gives none
/// and the steps do not follow each error (a given step, Verlet): a thousandth.
double energy_tolerance(const TransientRun& run);

/// "transient, stop": for messages.
std::string words_of(const TransientRun& run);

/// Its tables, values, checks, series, figures, scene, state and warnings.
void add_transient(const TransientRun& run, Result& r);

}  // namespace taut::results
