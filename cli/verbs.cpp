#include "cli/verbs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string_view>

#include "cli/completion.hpp"
#include "cli/man_page.hpp"
#include "cli/progress.hpp"
#include "cli/report_files.hpp"
#include "cli/say.hpp"
#include "taut/app/compare.hpp"
#include "taut/app/explain/explain.hpp"
#include "taut/app/explain/explain_name.hpp"
#include "taut/app/explain/schema.hpp"
#include "taut/app/explain/starters.hpp"
#include "taut/app/job.hpp"
#include "taut/app/methods.hpp"
#include "taut/base/suggest.hpp"
#include "taut/io/json.hpp"
#include "taut/report/terminal.hpp"

namespace taut::cli {
namespace {

/// Prints to standard output; a full disk or a closed pipe is a file that can't be written.
int print(const std::string& text, int code) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (written) return code;
  if (errno == EPIPE) return code;  // its reader has seen enough
  say("taut: can't write to standard output: {}\n", std::strerror(errno));
  return file_trouble;
}

int file_failure(const app::FileError& error, const RunOptions& options) {
  say("taut: {}\n", error.message);
  if (!options.json) return file_trouble;
  Result r;
  r.status = Status::bad_deck;
  r.message = error.message;
  r.errors.push_back({options.deck, {}, error.message, {}, 1});
  return print(io::to_json(r), file_trouble);
}

/// `others`: what else could have been meant.
const app::MethodEntry* named_method(const std::string& name, const std::vector<std::string>& others) {
  const app::MethodEntry* entry = app::find_method(name);
  if (entry == nullptr) {
    std::vector<std::string> names = app::method_names();
    names.insert(names.end(), others.begin(), others.end());
    say("taut: there is no method '{}'{}; see 'taut list methods' and 'taut list machines'\n", name,
        did_you_mean(name, names));
  }
  return entry;
}

void print_mistakes(const Diagnostics& mistakes) {
  say("{}", to_text(mistakes));
  if (mistakes.size() > 1) say("{} mistakes\n", mistakes.size());
}

/// Before a long calculation is done in vain.
tl::expected<void, app::FileError> usable_folder(const RunOptions& options) {
  if (options.folder.empty()) return {};
  return app::check_folder(options.folder);
}

/// The job done, with its progress shown on a terminal.
Result calculated(app::Job& job, const RunOptions& options, Result (*how)(const app::Job&) = app::run) {
  ProgressLine line(!options.quiet && isatty(STDERR_FILENO) != 0);
  job.set = options.set;
  job.progress = [&line](const taut::Progress& progress) { return line(progress); };
  Result result = how(job);
  line.clear();
  return result;
}

/// Colour on a terminal, unless the user does not want it (no-color.org).
bool wants_colour() {
  const char* no = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal != nullptr && std::string_view(terminal) == "dumb";
  return isatty(STDOUT_FILENO) != 0 && (no == nullptr || *no == '\0') && !dumb;
}

}  // namespace

int tell(const Result& result, const RunOptions& options) {
  int code = exit_code(result, options.strict);
  if (result.status == Status::bad_deck) print_mistakes(result.errors);
  // the files first: the verdict is then the last line on the screen
  const bool files = !options.folder.empty() && result.status != Status::bad_deck;
  const int written = files ? write_report(result, options) : static_cast<int>(computed);
  if (options.json) {
    const auto beside = options.si ? io::SeriesFiles::named_si : io::SeriesFiles::named;
    code = print(io::to_json(result, options.folder.empty() ? io::SeriesFiles::none : beside), code);
  } else if (result.status != Status::bad_deck && !options.quiet) {
    code = print(report::to_terminal(result, {.colour = wants_colour(), .all = options.all}), code);
  }
  if (result.status != Status::bad_deck && result.status != Status::ok && (options.json || options.quiet)) {
    say("taut: {}: {}\n", to_text(result.status), result.message);
  }
  return written == computed ? code : written;
}

int run(const RunOptions& options) {
  auto job = app::read_job(options.deck);
  if (!job) return file_failure(job.error(), options);
  if (const auto folder = usable_folder(options); !folder) return file_failure(folder.error(), options);
  warn_without_chromium(options);
  return tell(calculated(*job, options), options);
}

int compare(const RunOptions& options) {
  auto set = app::read_set(options.deck);
  if (!set) return file_failure(set.error(), options);
  if (const auto folder = usable_folder(options); !folder) return file_failure(folder.error(), options);
  warn_without_chromium(options);
  return tell(calculated(*set, options, app::compare), options);
}

int export_as(const std::string& format, const RunOptions& options) {
  if (format != "vtk") {
    say("taut: there is no format '{}'; there is vtk\n", format);
    return usage_or_deck;
  }
  auto job = app::read_job(options.deck);
  if (!job) return file_failure(job.error(), options);
  if (const auto folder = usable_folder(options); !folder) return file_failure(folder.error(), options);
  const Result result = calculated(*job, options);
  if (result.status == Status::bad_deck) print_mistakes(result.errors);
  if (result.status == Status::bad_deck) return exit_code(result);
  if (result.status != Status::ok) say("taut: {}: {}\n", to_text(result.status), result.message);
  const auto written = app::write_vtk(result, options.folder);
  if (!written) {
    say("taut: {}\n", written.error().message);
    return file_trouble;
  }
  if (written->empty() && result.status != Status::ok) return exit_code(result, options.strict);
  if (written->empty()) {
    say("taut: no analysis of the deck has a state in space that this format takes: add an 'equilibrium', a "
        "'transient' or a slow 'pretension'\n");
    return usage_or_deck;
  }
  if (!options.quiet) say("{} files, open {}\n", written->size(), written->back());
  return exit_code(result, options.strict);
}

int check(const RunOptions& options) {
  auto job = app::read_job(options.deck);
  if (!job) return file_failure(job.error(), options);
  job->set = options.set;
  const Diagnostics mistakes = app::check(*job);
  const int code = mistakes.empty() ? computed : only_unreadable_files(mistakes) ? file_trouble : usage_or_deck;
  print_mistakes(mistakes);
  if (options.json) return print(io::to_json(mistakes), code);
  if (mistakes.empty() && !options.quiet) return print(fmt::format("{}: no mistakes found\n", job->name), code);
  return code;
}

int print_text(const std::string& text) { return print(text, computed); }

int print_new(const std::string& name) {
  const app::Starter* starter = app::find_method(name) == nullptr ? app::find_starter(name) : nullptr;
  if (starter != nullptr) return print(app::starter_deck(starter->text), computed);
  const app::MethodEntry* entry = named_method(name, app::starter_names());
  return entry == nullptr ? static_cast<int>(usage_or_deck) : print(app::starter_deck(entry->example), computed);
}

int print_list(const std::string& what, const app::ListFilter& filter) {
  const auto text = app::list_text(what, filter);
  if (text) return print(*text, computed);
  say("taut: {}\n", text.error());
  return usage_or_deck;
}

int print_explain(const std::string& name, bool markdown) {
  if (markdown && name == "all") return print(app::reference_guide(), computed);
  if (markdown) {
    const app::MethodEntry* entry = named_method(name, {});
    return entry == nullptr ? static_cast<int>(usage_or_deck) : print(app::reference_markdown(*entry), computed);
  }
  const auto text = app::explain_name(name);
  if (text) return print(*text, computed);
  say("taut: {}\n", text.error());
  return usage_or_deck;
}

int print_schema() { return print(app::schema_text(), computed); }

int print_completion(const CommandWords& command, const std::string& shell) {
  const std::string script = completion_script(command, shell);
  if (!script.empty()) return print(script, computed);
  say("taut: there is no completion for '{}'{}; the shells are {}\n", shell, did_you_mean(shell, shells()),
      fmt::join(shells(), ", "));
  return usage_or_deck;
}

/// Of a build whose files have this date, else of today: "2026-02-13".
int print_man_page(const CommandWords& command) {
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  std::time_t when = std::time(nullptr);
  if (epoch != nullptr) std::from_chars(epoch, epoch + std::strlen(epoch), when);
  std::tm day = {};
  gmtime_r(&when, &day);
  std::array<char, sizeof("2026-02-13") + 10> date{};
  std::strftime(date.data(), date.size(), "%Y-%m-%d", &day);
  return print(man_page(command, date.data()), computed);
}

}  // namespace taut::cli
