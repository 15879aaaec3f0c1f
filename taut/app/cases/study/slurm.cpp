#include "taut/app/cases/study/slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "taut/app/cases/study/study_run.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

constexpr double shard_seconds = 900;  ///< of work: between a scheduler's overhead and what a node's failure loses
constexpr double spare = 3;            ///< times that work is the limit of time, as nodes differ
constexpr double least_minutes = 10;
constexpr std::uint64_t most_trials = 16;
constexpr double most_trial_seconds = 2;

/// Of a shell, whatever is in it.
std::string in_quotes(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

double seconds_per_case(const Study& study) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  double seconds = 0;
  std::uint64_t done = 0;
  while (done < std::min(most_trials, study.size()) && seconds < most_trial_seconds) {
    study.model.answer(study.values_at(done * study.size() / most_trials % study.size()));
    seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    ++done;
  }
  return seconds / static_cast<double>(done);
}

std::string batch_file(const std::string& name, const std::string& log, const std::vector<std::string>& options,
                       const std::string& command) {
  std::string text = "#!/bin/sh\n";
  text += fmt::format("#SBATCH --job-name={}\n#SBATCH --output=\"{}\"\n#SBATCH --open-mode=append\n", name, log);
  for (const std::string& line : options) text += fmt::format("#SBATCH {}\n", line);
  return text + "exec " + command + "\n";
}

tl::expected<void, FileError> write_text(const fs::path& path, const std::string& text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (file) return {};
  return tl::unexpected(FileError{fmt::format("'{}': can't be written: {}", path.string(), std::strerror(errno))});
}

}  // namespace

tl::expected<SlurmFiles, FileError> write_slurm(const Study& study, const StudyFolder& cases, const std::string& folder,
                                                const SlurmOptions& options) {
  std::error_code failed;
  const fs::path whole = fs::absolute(folder, failed), place = whole / "slurm";
  fs::create_directories(place, failed);
  if (failed) return tl::unexpected(FileError{fmt::format("'{}': {}", place.string(), failed.message())});
  const StudyState state = state_of(cases);
  const double work = seconds_per_case(study) * static_cast<double>(state.cases - state.cases_done);
  SlurmFiles made;
  made.shards = std::clamp<std::uint64_t>(static_cast<std::uint64_t>(std::ceil(work / shard_seconds)), 1, state.parts);
  made.seconds = work / static_cast<double>(made.shards);
  const int minutes = static_cast<int>(std::ceil(std::max(least_minutes, spare * made.seconds / 60)));
  std::vector<std::string> of_cases = {fmt::format("--array=1-{}%{}", made.shards, options.throttle), "--requeue",
                                       "--cpus-per-task=1", fmt::format("--time={}", minutes)};
  std::vector<std::string> of_merge = {"--cpus-per-task=1", "--requeue"};
  of_cases.insert(of_cases.end(), options.lines.begin(), options.lines.end());
  of_merge.insert(of_merge.end(), options.lines.begin(), options.lines.end());
  const std::string program = in_quotes(options.program), where = in_quotes(whole.string());
  const std::string shard = fmt::format("{} study resume {} --shard \"$SLURM_ARRAY_TASK_ID/{}\" --threads 1 --quiet",
                                        program, where, made.shards);
  const std::string merge = fmt::format("{} study merge {} --threads 1", program, where);
  const std::string cases_file = (place / "cases.sbatch").string(), merge_file = (place / "merge.sbatch").string();
  made.submit = (place / "submit.sh").string();
  const std::string submit =
      fmt::format("#!/bin/sh\nset -e\ncases=$(sbatch --parsable {})\nsbatch --dependency=\"afterok:$cases\" {}\n",
                  in_quotes(cases_file), in_quotes(merge_file));
  const std::vector<std::pair<std::string, std::string>> files = {
      {cases_file, batch_file("taut-cases", (place / "%a.log").string(), of_cases, shard)},
      {merge_file, batch_file("taut-merge", (place / "merge.log").string(), of_merge, merge)},
      {made.submit, submit}};
  for (const auto& [path, text] : files) {
    if (const auto written = write_text(path, text); !written) return tl::unexpected(written.error());
  }
  return made;
}

}  // namespace taut::app
