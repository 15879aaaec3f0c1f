#pragma once
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "taut/app/cases/study/study.hpp"
#include "taut/app/cases/study/study_folder.hpp"

namespace taut::app {

struct SlurmOptions {
  std::string program = "taut";         ///< the program as the nodes of the cluster call it
  int throttle = 64;                    ///< shards at work at the same time, at most
  std::vector<std::string> lines = {};  ///< more of the batch files' options: "--partition=long"
};

/// What was written, for the user's eyes.
struct SlurmFiles {
  std::string submit;  ///< the script that submits both
  std::uint64_t shards = 0;
  double seconds = 0;  ///< expected of one shard, on a machine like this one
};

/// Writes into `folder`/slurm a job array over shards of about a quarter of an hour, the merge that follows it
/// (afterok), and the script that submits both. A shard that is requeued calculates only the parts that are missing.
/// The time of a case is measured on a few of them.
tl::expected<SlurmFiles, FileError> write_slurm(const Study& study, const StudyFolder& cases, const std::string& folder,
                                                const SlurmOptions& options);

}  // namespace taut::app
