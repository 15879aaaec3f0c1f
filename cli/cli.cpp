#include "cli/cli.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "cli/command_words.hpp"
#include "cli/completion.hpp"
#include "cli/progress.hpp"
#include "cli/say.hpp"
#include "cli/serve_verb.hpp"
#include "cli/study_verbs.hpp"
#include "cli/verbs.hpp"
#include "taut/base/suggest.hpp"
#include "taut/base/version.hpp"

namespace taut::cli {
namespace {

/// Not the empty text that a forgotten variable of a script leaves.
CLI::Validator a_name() {
  return CLI::Validator(
      [](const std::string& text) { return std::string(text.empty() ? "the folder's name is empty" : ""); }, "");
}

void add_deck(CLI::App& verb, RunOptions& options) {
  verb.add_option("deck", options.deck, "the deck, or - for standard input")->type_name("DECK")->required();
}

void add_set(CLI::App& verb, RunOptions& options) {
  // one value each: what stands behind it is the deck
  verb.add_option("--set", options.set, "put a value over the deck's, as in --set 'input.span=200 m'")
      ->type_name("PATH=VALUE")
      ->take_all()
      ->allow_extra_args(false);
}

/// The folder of a result, its PDF, and what shows it.
void add_folder(CLI::App& verb, RunOptions& options) {
  auto* folder =
      verb.add_option("-o,--output", options.folder, "folder for result.json, report.html and the tables as CSV")
          ->type_name("DIR")
          ->check(a_name());
  verb.add_flag("--pdf", options.pdf, "with -o: the report as report.pdf too, printed by Chromium")->needs(folder);
  verb.add_flag("--open", options.open, "with -o: open report.html in the browser")->needs(folder);
}

/// How the report that -o writes is laid out.
void add_report_options(CLI::App& verb, RunOptions& options) {
  verb.add_flag("--appendix", options.appendix, "unfold and print the report's appendix: all values, tables, defaults");
  verb.add_option("--paper", options.paper, "pages of the report: a4 (default) or a3")
      ->type_name("PAPER")
      ->check(CLI::IsMember({"a4", "a3"}, CLI::ignore_case));
}

void add_run(CLI::App& app, std::function<int()>& action) {
  auto* verb = app.add_subcommand("run", "Calculate a deck: a summary on the screen, the report and tables with -o");
  auto options = std::make_shared<RunOptions>();
  add_deck(*verb, *options);
  add_folder(*verb, *options);
  add_set(*verb, *options);
  verb->add_flag("--json", options->json, "the result as JSON, and nothing else, on standard output");
  verb->add_flag("-q,--quiet", options->quiet, "print nothing but errors");
  verb->add_flag("--si", options->si, "CSV files of tables and plots in SI units; else in those of the report");
  verb->add_flag("-a,--all", options->all, "print every check, value and short table, not the summary of 40 lines");
  add_report_options(*verb, *options);
  verb->add_flag("--strict", options->strict, "exit with 4 where a part has no limit, too");
  verb->callback([options, &action] { action = [options] { return run(*options); }; });
}

void add_compare(CLI::App& app, std::function<int()>& action) {
  auto* verb = app.add_subcommand("compare", "Run a set of decks and compare their results with published values");
  auto options = std::make_shared<RunOptions>();
  verb->add_option("set", options->deck, "a folder with compare.part.yaml, or such a file")
      ->type_name("SET")
      ->required();
  add_folder(*verb, *options);
  verb->add_flag("--json", options->json, "the result as JSON, and nothing else, on standard output");
  verb->add_flag("-q,--quiet", options->quiet, "print nothing but errors");
  verb->add_flag("--si", options->si, "CSV files of tables and plots in SI units; else in those of the report");
  verb->add_flag("-a,--all", options->all, "print every check, value and short table, not the summary of 40 lines");
  add_report_options(*verb, *options);
  verb->callback([options, &action] { action = [options] { return compare(*options); }; });
}

void add_export(CLI::App& app, std::function<int()>& action) {
  auto* verb = app.add_subcommand("export", "Write what a deck computes in another program's format");
  auto format = std::make_shared<std::string>();
  auto options = std::make_shared<RunOptions>();
  verb->add_option("format", *format, "vtk: bodies and ropes in space for ParaView, one .pvd over the times")
      ->type_name("FORMAT")
      ->required();
  add_deck(*verb, *options);
  verb->add_option("-o,--output", options->folder, "folder for the files")
      ->type_name("DIR")
      ->check(a_name())
      ->required();
  add_set(*verb, *options);
  verb->add_flag("-q,--quiet", options->quiet, "print nothing but errors");
  verb->callback([format, options, &action] { action = [format, options] { return export_as(*format, *options); }; });
}

void add_study(CLI::App& app, std::function<int()>& action) {
  auto* verb = app.add_subcommand("study", "Calculate many cases of a deck: its 'study' says what varies");
  auto options = std::make_shared<StudyVerbOptions>();
  verb->add_option("action", options->action,
                   "run or calibrate a deck; resume, merge, status: of the folder of a study; slurm: batch files for "
                   "a cluster")
      ->type_name("ACTION")
      ->check(CLI::IsMember({"run", "resume", "merge", "status", "slurm", "calibrate"}))
      ->required();
  verb->add_option("what", options->run.deck, "the deck; of resume, merge, status the study's folder")
      ->type_name("DECK")
      ->required();
  add_folder(*verb, options->run);
  add_set(*verb, options->run);
  verb->add_option("--threads", options->threads, "threads at work; all of the machine where it is not given")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  verb->add_option("--shard", options->shard, "calculate one share of the cases, as in --shard 2/7; then merge")
      ->type_name("K/N");
  verb->add_option("--throttle", options->throttle, "slurm: shards at work at the same time, at most")
      ->type_name("N")
      ->check(CLI::Range(1, 100000));
  verb->add_option("--sbatch", options->sbatch, "slurm: an option for its batch files, as in --sbatch=--partition=long")
      ->type_name("OPTION")
      ->take_all()
      ->allow_extra_args(false);
  verb->add_flag("--json", options->run.json, "the result as JSON, and nothing else, on standard output");
  verb->add_flag("-q,--quiet", options->run.quiet, "print nothing but errors");
  verb->add_flag("--si", options->run.si, "CSV files in SI units; else in those of the report");
  verb->add_flag("-a,--all", options->run.all, "print every check, value and short table, not the summary of 40 lines");
  add_report_options(*verb, options->run);
  verb->callback([options, &action] { action = [options] { return study(*options); }; });
}

void add_serve(CLI::App& app, std::function<int()>& action) {
  auto* verb = app.add_subcommand("serve", "Show decks of a folder in the browser, calculated by this program");
  auto options = std::make_shared<ServeVerbOptions>();
  verb->add_option("folder", options->folder, "the folder whose decks the page opens and saves; the current one")
      ->type_name("DIR")
      ->check(a_name());
  verb->add_option("--port", options->port, "port of 127.0.0.1; 0, the default, takes a free one")
      ->type_name("N")
      ->check(CLI::Range(0, 65535));
  verb->add_option("--page", options->page, "the folder of the page that './dev web' makes; else the installed one")
      ->type_name("DIR")
      ->check(a_name());
  verb->callback([options, &action] { action = [options] { return serve(*options); }; });
}

void add_check(CLI::App& app, std::function<int()>& action) {
  auto* verb = app.add_subcommand("check", "Read a deck and list its mistakes without calculating");
  auto options = std::make_shared<RunOptions>();
  add_deck(*verb, *options);
  add_set(*verb, *options);
  verb->add_flag("--json", options->json, "the mistakes as JSON on standard output");
  verb->add_flag("-q,--quiet", options->quiet, "print nothing but errors");
  verb->callback([options, &action] { action = [options] { return check(*options); }; });
}

void add_list(CLI::App& app, std::function<int()>& action) {
  auto* verb = app.add_subcommand("list", "List methods, machines, ropes, sections, steels, rules or units");
  auto what = std::make_shared<std::string>();
  auto f = std::make_shared<app::ListFilter>();
  verb->add_option("what", *what, "what to list: " + fmt::format("{}", fmt::join(app::list_names(), ", ")))
      ->type_name("LIST")
      ->required();
  verb->add_option("--construction", f->construction, "ropes: 6x36, 6x19S, 18x7, ...")->type_name("CONSTRUCTION");
  verb->add_option("--core", f->core, "ropes: FC, IWRC, WSC")->type_name("CORE");
  verb->add_option("--grade", f->grade, "ropes: '1960 MPa'")->type_name("GRADE");
  verb->add_option("--min-breaking-force", f->min_breaking_force, "ropes: '150 kN'")->type_name("FORCE");
  verb->add_option("--min-diameter", f->min_diameter, "ropes: '12 mm'")->type_name("DIAMETER");
  verb->add_option("--max-diameter", f->max_diameter, "ropes: '24 mm'")->type_name("DIAMETER");
  verb->add_option("--min-area", f->min_area, "ropes, sections: '200 mm2'")->type_name("AREA");
  verb->add_option("--shape", f->shape, "sections: CHS, SHS, RHS")->type_name("SHAPE");
  verb->add_option("--forming", f->forming, "sections: hot, cold, seamless, welded")->type_name("FORMING");
  verb->add_option("--max-height", f->max_height, "sections: largest outer side, '400 mm'")->type_name("LENGTH");
  verb->add_option("--min-section-modulus", f->min_section_modulus, "sections: elastic, '500 cm3'")
      ->type_name("VOLUME");
  verb->add_option("--standard", f->standard, "beginning of the standard's name: EN, 'GOST 2688'")
      ->type_name("STANDARD");
  verb->add_option("--name", f->name, "methods, steels, rules, carriages, yarders, units: part of the name")
      ->type_name("PART");
  verb->add_flag("--verified", f->verified_only, "only rows whose numbers were read in a public source");
  verb->callback([what, f, &action] { action = [what, f] { return print_list(*what, *f); }; });
}

void add_texts(CLI::App& app, std::function<int()>& action) {
  auto name = std::make_shared<std::string>();
  auto* starter = app.add_subcommand("new", "Print a commented starter deck of a method or a machine");
  starter->add_option("name", *name, "see 'taut list methods' and 'taut list machines'")
      ->type_name("STARTER")
      ->required();
  starter->callback([name, &action] { action = [name] { return print_new(*name); }; });

  auto markdown = std::make_shared<bool>(false);
  auto* explain = app.add_subcommand(
      "explain", "What a name means: a method, a part, an analysis, a key of a deck, a rule, a result");
  explain
      ->add_option("name", *name,
                   "mast_section, machine, sheaves, reevings.length, safety.skyline.ch, pulley, ...; with "
                   "--markdown a method or 'all'")
      ->type_name("TOPIC")
      ->required();
  explain->add_flag("--markdown", *markdown, "the keys and results as Markdown tables");
  explain->callback(
      [name, markdown, &action] { action = [name, markdown] { return print_explain(*name, *markdown); }; });

  auto* schema = app.add_subcommand("schema", "Print the JSON Schema (draft 7) of decks, for editors");
  schema->callback([&action] { action = [] { return print_schema(); }; });
}

/// What is made of the descriptions of all verbs.
void add_descriptions(CLI::App& app, std::function<int()>& action) {
  auto shell = std::make_shared<std::string>();
  auto* completion = app.add_subcommand("completion", "Print the script that completes taut's command line in a shell");
  completion->add_option("shell", *shell, fmt::format("{}", fmt::join(shells(), ", ")))->type_name("SHELL")->required();
  completion->callback(
      [&app, shell, &action] { action = [&app, shell] { return print_completion(words_of(app), *shell); }; });

  auto* man = app.add_subcommand("man", "Print the manual page, to be read with: taut man | man -l -");
  man->callback([&app, &action] { action = [&app] { return print_man_page(words_of(app)); }; });

  // answered by without_verb; here for its place in the list
  auto* help = app.add_subcommand("help", "List the verbs, or show the options of one");
  auto verb = std::make_shared<std::string>();
  help->add_option("verb", *verb, "a verb of taut")->type_name("VERB");
}

std::string exit_codes() {
  std::string text = "Exit codes:\n";
  for (const ExitWords& e : exit_words) text += fmt::format("  {:<4} {}\n", static_cast<int>(e.code), e.words);
  return text;
}

/// "run         Calculate a deck", one line for each verb.
std::string verb_list(const CLI::App& app) {
  std::string text = "Verbs:\n";
  for (const CLI::App* verb : app.get_subcommands({})) {
    text += fmt::format("  {:<11} {}\n", verb->get_name(), verb->get_description());
  }
  return text + "\n'taut help VERB' shows its options; 'taut new closed_loop' prints a first deck.\n";
}

/// The answer where the command line has no verb that taut knows: `taut`, `taut help [VERB]`, a mistyped verb.
std::optional<int> without_verb(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty()) {
    say("{}", verb_list(app));
    return usage_or_deck;
  }
  const bool help = words[0] == "help";
  if (help && (words.size() == 1 || words[1].starts_with('-'))) return print_text(verb_list(app));
  const std::string& name = words[help ? 1 : 0];
  if (!help && name.starts_with('-')) return std::nullopt;
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands({})) {
    names.push_back(verb->get_name());
    if (names.back() != name) continue;
    if (help) return print_text(verb->help(app.get_name()));
    return std::nullopt;
  }
  say("taut: there is no verb '{}'{}\n\n{}", name, did_you_mean(name, names), verb_list(app));
  return usage_or_deck;
}

/// CLI11 has exit codes of its own; ours are 0 for help and version, 2 for a mistake.
int parse_failure(const CLI::App& app, const CLI::ParseError& e) {
  errno = 0;
  const int code = app.exit(e);
  if (code == 0 && !std::cout.flush() && errno != EPIPE) return file_trouble;
  return code == 0 ? computed : usage_or_deck;
}

/// A descriptor of standard input, output or error that is closed would be given to the next file that is opened, which
/// the program's messages would be written into. It is held by what can't be read or written instead.
void hold_closed_descriptors() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(number, F_GETFD) >= 0) continue;
    const int held = open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // the lowest that is free
    if (held != number) _exit(file_trouble);
  }
}

/// What the system would end the program for comes back from the call that failed instead.
void take_failures() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace

int main(int argc, char** argv) {
  hold_closed_descriptors();
  take_interrupts();
  take_failures();
  CLI::App app("taut: checked, explained calculations of rope-driven machines", "taut");
  app.set_version_flag("--version", std::string("taut ") + std::string(version), "print the version and exit");
  app.require_subcommand(1);
  app.set_help_flag("-h,--help", "print help and exit");
  app.footer(exit_codes());
  std::function<int()> action;
  add_run(app, action);
  add_check(app, action);
  add_compare(app, action);
  add_study(app, action);
  add_export(app, action);
  add_serve(app, action);
  add_list(app, action);
  add_texts(app, action);
  add_descriptions(app, action);
  try {
    if (const auto code = without_verb(app, {argv + 1, argv + argc})) return *code;
    app.parse(argc, argv);
    return action();
  } catch (const CLI::ParseError& e) {
    return parse_failure(app, e);
  } catch (const std::exception& e) {
    say("taut: internal error, please report it: {}\n", e.what());
    return our_fault;
  }
}

}  // namespace taut::cli
