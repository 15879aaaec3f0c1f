#pragma once
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace taut::io {

/// Another program that is run to its end.
struct Child {
  std::vector<std::string> words;        ///< path of the program, then its arguments
  std::vector<std::string> environment;  ///< "NAME=value": replaces or adds to the environment of this program
  std::string output;                    ///< file that takes what it prints
  std::chrono::seconds limit{300};       ///< of elapsed time; it is ended after that
  std::function<bool()> go_on;           ///< asked several times a second; false ends it. May be empty
};

enum class ChildEnd { ended, stopped, too_long };

struct ChildResult {
  ChildEnd end = ChildEnd::ended;
  int code = 0;  ///< its exit code; 128 + number of the signal that ended it
};

/// Runs a program in a process group of its own, without standard input, and waits for its end. A program that is
/// stopped or takes too long is ended with all that it has started. The error says why it could not be started.
tl::expected<ChildResult, std::string> run_child(const Child& child);

/// Starts a program in a session of its own, without standard input and output, and leaves it running. Returns its exit
/// code where it ends with a failure within `watched`, else nothing. The error says why it could not be started.
tl::expected<std::optional<int>, std::string> start_apart(const std::vector<std::string>& words,
                                                          std::chrono::milliseconds watched);

/// The path of a program: as given where it has a slash and can be run, else from the folders of PATH.
std::optional<std::string> program_path(const std::string& name);

}  // namespace taut::io
