#include "cli/study_verbs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <filesystem>
#include <optional>
#include <tuple>
#include <utility>

#include "cli/progress.hpp"
#include "cli/report_files.hpp"
#include "cli/say.hpp"
#include "taut/app/cases/study/calibrate.hpp"
#include "taut/app/cases/study/slurm.hpp"
#include "taut/app/cases/study/study.hpp"
#include "taut/app/cases/study/study_folder.hpp"
#include "taut/app/cases/study/study_result.hpp"
#include "taut/app/cases/study/study_run.hpp"

namespace taut::cli {
namespace {

int no_file(const app::FileError& error) {
  say("taut: {}\n", error.message);
  return file_trouble;
}

/// "2/7" as (2, 7).
std::optional<std::pair<std::uint64_t, std::uint64_t>> shard_of(const std::string& text) {
  std::uint64_t shard = 0, of = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard);
  if (first.ec != std::errc{} || first.ptr == end || *first.ptr != '/') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, of);
  if (second.ec != std::errc{} || second.ptr != end || shard < 1 || shard > of) return std::nullopt;
  return std::pair(shard, of);
}

std::string words_of(const app::StudyState& s) {
  return fmt::format("{} of {} cases done, {} of {} parts", s.cases_done, s.cases, s.parts_done, s.parts);
}

/// A study and its folder, as far as all actions need them.
struct Opened {
  app::Study study;
  app::StudyFolder folder;
};

/// Whether the command names a deck, else the folder of a study.
bool begins(const StudyVerbOptions& options) {
  return options.action == "run" || (options.action == "slurm" && !options.run.folder.empty());
}

/// Of the deck of `run`, else of the job that the folder keeps. Else the exit code.
tl::expected<Opened, int> open_study(const StudyVerbOptions& options, bool first) {
  auto job = first ? app::read_job(options.run.deck) : app::StudyFolder::job_in(options.run.deck);
  if (!job) return tl::unexpected(no_file(job.error()));
  if (first) job->set = options.run.set;
  auto study = app::read_study(*job);
  if (!study) return tl::unexpected(tell(study.error(), RunOptions{}));
  auto folder = app::StudyFolder::make(options.run.folder, *job, *study);
  if (!folder) return tl::unexpected(no_file(folder.error()));
  return Opened{.study = std::move(*study), .folder = std::move(*folder)};
}

app::StudyOptions with_progress(const StudyVerbOptions& options, ProgressLine& line) {
  return {.threads = options.threads, .progress = [&line](const Progress& progress) { return line(progress); }};
}

/// Reads all cases and writes the report.
int merge(const Opened& opened, const StudyVerbOptions& options) {
  const app::StudyState state = app::state_of(opened.folder);
  if (!state.whole()) {
    say("taut: {}; 'taut study resume {}' calculates the others\n", words_of(state), options.run.folder);
    return file_trouble;
  }
  opened.folder.tidy();
  const auto data = app::read_cases(opened.study, opened.folder);
  if (!data) return no_file(data.error());
  warn_without_chromium(options.run);
  ProgressLine line(!options.run.quiet && isatty(STDERR_FILENO) != 0);
  const Result r = app::study_result(opened.study, *data, with_progress(options, line));
  line.clear();
  return tell(r, options.run);
}

int calculate(const Opened& opened, const StudyVerbOptions& options) {
  ProgressLine line(!options.run.quiet && isatty(STDERR_FILENO) != 0);
  app::StudyOptions how = with_progress(options, line);
  if (!options.shard.empty()) std::tie(how.shard, how.of) = *shard_of(options.shard);
  const auto state = app::run_cases(opened.study, opened.folder, how);
  line.clear();
  if (!state) return no_file(state.error());
  if (state->interrupted) {
    say("taut: interrupted: {}; 'taut study resume {}' goes on\n", words_of(*state), options.run.folder);
    return interrupted;
  }
  if (options.shard.empty()) return merge(opened, options);
  if (!options.run.quiet) {
    say("shard {}: {}; when all shards are done: taut study merge {}\n", options.shard, words_of(*state),
        options.run.folder);
  }
  return computed;
}

int print_status(const StudyVerbOptions& options) {
  const auto folder = app::StudyFolder::open(options.run.folder);
  if (!folder) return no_file(folder.error());
  return print_text(fmt::format("{}: {}\n", options.run.folder, words_of(app::state_of(*folder))));
}

/// The path of this program, so that the nodes of a cluster find the same one.
std::string own_path() {
  std::error_code failed;
  const auto path = std::filesystem::read_symlink("/proc/self/exe", failed);
  return failed ? std::string("taut") : path.string();
}

int write_batch(const Opened& opened, const StudyVerbOptions& options) {
  const auto made = app::write_slurm(opened.study, opened.folder, options.run.folder,
                                     {.program = own_path(), .throttle = options.throttle, .lines = options.sbatch});
  if (!made) return no_file(made.error());
  return print_text(
      fmt::format("{} shards of about {:.0f} s; submit them with: sh {}\n", made->shards, made->seconds, made->submit));
}

int calibrate(const StudyVerbOptions& options) {
  auto job = app::read_job(options.run.deck);
  if (!job) return no_file(job.error());
  job->set = options.run.set;
  warn_without_chromium(options.run);
  ProgressLine line(!options.run.quiet && isatty(STDERR_FILENO) != 0);
  job->progress = [&line](const Progress& progress) { return line(progress); };
  const Result r = app::calibrate(*job, options.threads);
  line.clear();
  return tell(r, options.run);
}

}  // namespace

int study(StudyVerbOptions options) {
  if (options.action == "calibrate") return calibrate(options);
  const bool first = begins(options);
  if (!first) options.run.folder = options.run.deck;
  if (options.run.folder.empty()) {
    say("taut: 'study run' needs a folder for the cases: -o DIR\n");
    return usage_or_deck;
  }
  if (!options.shard.empty() && !shard_of(options.shard)) {
    say("taut: --shard {}: K/N is expected, with K from 1 to N, as in --shard 2/7\n", options.shard);
    return usage_or_deck;
  }
  if (options.action == "status") return print_status(options);
  if (const auto usable = app::check_folder(options.run.folder); !usable) return no_file(usable.error());
  const auto opened = open_study(options, first);
  if (!opened) return opened.error();
  if (options.action == "slurm") return write_batch(*opened, options);
  return options.action == "merge" ? merge(*opened, options) : calculate(*opened, options);
}

}  // namespace taut::cli
