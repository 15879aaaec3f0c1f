#pragma once
#include <string>
#include <vector>

#include "taut/app/explain/listing.hpp"

namespace taut::cli {

enum ExitCode {
  computed = 0,
  our_fault = 1,
  usage_or_deck = 2,
  says_no = 3,
  check_fails = 4,
  file_trouble = 5,
  interrupted = 130
};

struct RunOptions {
  std::string deck;
  std::string folder;  ///< empty: print only
  std::vector<std::string> set;
  bool json = false;
  bool quiet = false;
  bool all = false;     ///< every value on the screen, not the summary
  bool strict = false;  ///< a part without a limit is no success
  bool appendix = false;
  std::string paper = "a4";  ///< of the report: a4 or a3
};

/// Each verb prints what it found (standard output), messages (standard error), and returns the exit code.
int run(const RunOptions& options);
int check(const RunOptions& options);
int compare(const RunOptions& options);
int export_as(const std::string& format, const RunOptions& options);
int print_text(const std::string& text);
int print_new(const std::string& name);
int print_list(const std::string& what, const app::ListFilter& filter);
int print_explain(const std::string& name, bool markdown);
int print_schema();

}  // namespace taut::cli
