#include "cli/man_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "cli/exit_code.hpp"
#include "taut/base/version.hpp"

namespace taut::cli {
namespace {

struct Entry {
  std::string_view name;
  std::string_view words;
};

constexpr Entry files_written[] = {
    {"result.json", "every number of the result, in SI units"},
    {"report.html", "the report; one file that opens without a network and prints on A4"},
    {"report.md", "the same as Markdown"},
    {"report.pdf", "the report as PDF; with --pdf only"},
    {"*.csv", "each table and each plot"},
    {"series.h5", "time series together, as HDF5"},
    {".taut-files",
     "the names of these files. The next run into the folder replaces them together and keeps all others."},
};

constexpr Entry variables[] = {
    {"NO_COLOR", "set and not empty: no colour on the terminal"},
    {"TERM", "\"dumb\": no colour on the terminal"},
    {"BROWSER",
     "for --open: commands with colons between them; the first whose program is installed opens the report. %s stands "
     "for its address. Without BROWSER it is xdg-open."},
    {"TAUT_CHROMIUM",
     "for --pdf: the Chromium to use. Without it the first of chromium, chromium-browser, google-chrome and "
     "google-chrome-stable in PATH."},
    {"TMPDIR", "for --pdf: the folder in which Chromium keeps its files while it prints; without it /tmp"},
};

constexpr Entry typed_examples[] = {
    {"taut new closed_loop > loop.yaml", "A first deck, with comments."},
    {"taut run loop.yaml", "A summary on the terminal. The last line is the verdict."},
    {"taut run loop.yaml -o out --pdf --open",
     "Writes report, tables and PDF into the folder out and opens the report."},
    {"taut run loop.yaml --set 'input.span=300 m' --json", "Another span; the result as JSON."},
    {"taut list ropes --construction 6x36 --min-breaking-force '150 kN'", "Ropes of the catalogue."},
};

/// Running text: what roff would read as an escape or a request is not one.
std::string text(std::string_view words) {
  std::string all;
  for (const char c : words) {
    if (c == '\\') {
      all += "\\e";
    } else if (c == '-') {
      all += "\\-";  // also in names of options, which are copied from the page
    } else {
      if (all.empty() && (c == '.' || c == '\'')) all += "\\&";
      all += c;
    }
  }
  return all;
}

/// An argument of a macro: one word for roff.
std::string argument(std::string_view words) {
  std::string all;
  for (const char c : text(words)) {
    if (c == '"') {
      all += "\\(dq";
    } else {
      all += c;
    }
  }
  return "\"" + all + "\"";
}

/// The same in lines of at most 78 characters. A line of roff must not begin with a dot or a quote of the text.
std::string filled(std::string_view words) {
  constexpr std::size_t width = 78;
  std::string all;
  std::size_t column = 0;
  for (std::size_t from = 0; from < words.size();) {
    const std::size_t end = std::min(words.find(' ', from), words.size());
    const std::string word = text(words.substr(from, end - from));
    if (column > 0 && column + 1 + word.size() > width) {
      all += '\n';
      column = 0;
    } else if (column > 0) {
      all += ' ';
      ++column;
    }
    all += word;
    column += word.size();
    from = end + 1;
  }
  return all + "\n";
}

/// A paragraph with a tag before it.
std::string tagged(const std::string& tag, std::string_view words) {
  return fmt::format(".TP\n{}\n{}", tag, filled(words));
}

std::string bold(std::string_view words) { return fmt::format("\\fB{}\\fR", text(words)); }
std::string italic(std::string_view words) { return fmt::format("\\fI{}\\fR", text(words)); }

std::string option_tag(const OptionWords& o) {
  std::string all;
  for (const std::string& name : o.names) all += (all.empty() ? "" : ", ") + bold(name);
  return o.value.empty() ? all : fmt::format("{} {}", all, italic(o.value));
}

/// With the names that can stand there where they are few and not in the words already.
std::string operand_words(const OptionWords& o) {
  std::string words = o.words;
  constexpr std::size_t few = 10;
  const std::vector<std::string>& names = o.choices.names;
  if (!names.empty() && names.size() <= few && words.find(names.front()) == std::string::npos) {
    words += fmt::format(" ({})", fmt::join(names, ", "));
  }
  return words;
}

/// Every verb has it; the page names it once.
bool is_help(const OptionWords& o) { return std::find(o.names.begin(), o.names.end(), "--help") != o.names.end(); }

std::string synopsis(const std::string& program, const VerbWords& verb) {
  std::string line = fmt::format("{} {}", bold(program), bold(verb.name));
  for (const OptionWords& o : verb.operands) {
    line += o.required ? " " + italic(o.value) : fmt::format(" [{}]", italic(o.value));
  }
  bool optional = false;
  for (const OptionWords& o : verb.options) {
    if (o.required) line += fmt::format(" {} {}", bold(o.names.front()), italic(o.value));
    if (!o.required && !is_help(o)) optional = true;
  }
  if (optional) line += fmt::format(" [{}]", italic("OPTION") + "...");
  return line + "\n";
}

std::string verb_text(const std::string& program, const VerbWords& verb) {
  std::string all =
      fmt::format(".SS {}\n{}.PP\n{}", argument(verb.name), synopsis(program, verb), filled(verb.words + "."));
  for (const OptionWords& o : verb.operands) all += tagged(italic(o.value), operand_words(o));
  for (const OptionWords& o : verb.options) {
    if (!is_help(o)) all += tagged(option_tag(o), o.words);
  }
  return all;
}

template <std::size_t N>
std::string entries(const char* heading, const Entry (&list)[N]) {
  std::string all = fmt::format(".SH {}\n", heading);
  for (const Entry& e : list) all += tagged(bold(e.name), e.words);
  return all;
}

}  // namespace

std::string man_page(const CommandWords& command, const std::string& date) {
  std::string all =
      fmt::format(".\\\" Made by '{} man' from the descriptions of its verbs and options.\n", command.name);
  all += fmt::format(".TH TAUT 1 \"{}\" {} \"User Commands\"\n", date, argument(fmt::format("taut {}", version)));
  all += fmt::format(".SH NAME\n{} \\- checked, explained calculations of rope\\-driven machines\n", command.name);
  all += ".SH SYNOPSIS\n";
  bool first = true;
  for (const VerbWords& verb : command.verbs) {
    if (!first) all += ".br\n";
    first = false;
    all += synopsis(command.name, verb);
  }
  all += ".SH DESCRIPTION\n";
  all += filled(
      "taut calculates rope-driven machines: cable yarders, skylines, rope saws, telescopic booms, tackles, guyed "
      "masts. The input is a text file in YAML, the deck. It describes a machine or names a published method. "
      "The answer is a checked calculation: formulas with their numbers, limits, drawings, and a verdict.");
  all += ".PP\n";
  all += filled("Progress and messages go to standard error, results to standard output. A closed pipe is no error.");
  all += ".SH OPTIONS\n";
  for (const OptionWords& o : command.options) all += tagged(option_tag(o), o.words);
  all += ".SH VERBS\n";
  for (const VerbWords& verb : command.verbs) all += verb_text(command.name, verb);
  all += ".SH EXIT STATUS\n";
  for (const ExitWords& e : exit_words) all += tagged(bold(fmt::format("{}", static_cast<int>(e.code))), e.words);
  all += entries("FILES", files_written);
  all += entries("ENVIRONMENT", variables);
  all += ".SH EXAMPLES\n";
  for (const Entry& e : typed_examples) all += tagged(bold(e.name), e.words);
  return all;
}

}  // namespace taut::cli
