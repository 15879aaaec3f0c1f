#pragma once
#include <string>
#include <vector>

#include "cli/command_words.hpp"
#include "cli/exit_code.hpp"
#include "taut/app/explain/listing.hpp"
#include "taut/calc/result.hpp"

namespace taut::cli {

struct RunOptions {
  std::string deck;
  std::string folder;  ///< empty: print only
  std::vector<std::string> set;
  bool json = false;
  bool quiet = false;
  bool all = false;          ///< every value on the screen, not the summary
  bool si = false;           ///< CSV files in SI units
  bool strict = false;       ///< a part without a limit is no success
  bool pdf = false;          ///< report.pdf beside report.html
  bool open = false;         ///< shows report.html in the browser
  bool appendix = false;     ///< of the report: unfolded, and printed
  std::string paper = "a4";  ///< of the report: a4 or a3
};

/// Each verb prints what it found (standard output), messages (standard error), and returns the exit code.
int run(const RunOptions& options);
/// Writes and shows a result that is there already.
int tell(const Result& result, const RunOptions& options);
int check(const RunOptions& options);
int compare(const RunOptions& options);
int export_as(const std::string& format, const RunOptions& options);
int print_text(const std::string& text);
int print_new(const std::string& name);
int print_list(const std::string& what, const app::ListFilter& filter);
int print_explain(const std::string& name, bool markdown);
int print_schema();
int print_completion(const CommandWords& command, const std::string& shell);
int print_man_page(const CommandWords& command);

}  // namespace taut::cli
