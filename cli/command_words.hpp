#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace taut::cli {

/// What can stand in a place of the command line, for completion.
struct Choices {
  enum class Kind { anything, deck, folder, names };
  Kind kind = Kind::anything;
  std::vector<std::string> names;  ///< of Kind::names
};

/// One option or operand as `--help` describes it.
struct OptionWords {
  std::vector<std::string> names;  ///< with their dashes ("-o", "--output"); empty for an operand
  std::string value;               ///< stands for the value of an option or for the operand ("DIR"); empty for a flag
  std::string words;
  bool required = false;
  bool repeated = false;  ///< may stand more than once
  Choices choices;        ///< of its value
};

struct VerbWords {
  std::string name;
  std::string words;
  std::vector<OptionWords> options;   ///< in the order of --help
  std::vector<OptionWords> operands;  ///< in the order of the command line
};

/// The command line of the program: the one source of its man page and its completion scripts.
struct CommandWords {
  std::string name;  ///< of the program
  std::string words;
  std::vector<OptionWords> options;  ///< without a verb
  std::vector<VerbWords> verbs;
};

/// Reads the options and verbs of a command line. Choices of a value are those of CLI::IsMember, else those that its
/// name stands for (choices_of).
CommandWords words_of(const CLI::App& app);

/// What the name of a value stands for: files for "DECK" and "SET", folders for "DIR", and the names that the library
/// has for "STARTER", "TOPIC", "LIST" and the filters of lists. Anything for other names.
Choices choices_of(const std::string& value);

}  // namespace taut::cli
