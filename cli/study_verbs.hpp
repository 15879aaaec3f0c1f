#pragma once
#include <string>
#include <vector>

#include "cli/verbs.hpp"

namespace taut::cli {

/// `taut study ACTION WHAT`: the cases of a deck's `study:`.
struct StudyVerbOptions {
  std::string action;               ///< run, resume, merge, status, slurm, calibrate
  RunOptions run;                   ///< `deck`: the deck, or the folder of a study that was begun
  int threads = 0;                  ///< 0: all
  std::string shard;                ///< "2/7"
  int throttle = 64;                ///< shards at work at the same time on a cluster
  std::vector<std::string> sbatch;  ///< more options of its batch files
};

/// The exit code.
int study(StudyVerbOptions options);

}  // namespace taut::cli
