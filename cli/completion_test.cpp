#include "cli/completion.hpp"

#include <gmock/gmock.h>

namespace taut::cli::completion_test {

using ::testing::HasSubstr;
using ::testing::Not;

CommandWords command() {
  const Choices papers{.kind = Choices::Kind::names, .names = {"a4", "6x19(1+6+6)", "two words", "$(date)"}};
  VerbWords run{.name = "run", .words = "It's a deck: [calculate]", .options = {}, .operands = {}};
  run.options = {
      {.names = {"-o", "--output"},
       .value = "DIR",
       .words = "folder",
       .required = false,
       .repeated = false,
       .choices = {.kind = Choices::Kind::folder, .names = {}}},
      {.names = {"--paper"},
       .value = "PAPER",
       .words = "of [the] page: a4",
       .required = false,
       .repeated = true,
       .choices = papers},
      {.names = {"--json"}, .value = "", .words = "JSON", .required = false, .repeated = false, .choices = {}}};
  run.operands = {{.names = {},
                   .value = "DECK",
                   .words = "the deck",
                   .required = true,
                   .repeated = false,
                   .choices = {.kind = Choices::Kind::deck, .names = {}}}};
  return {.name = "taut", .words = "calculates", .options = {}, .verbs = {run}};
}

TEST(Completion, KnowsItsShells) {
  for (const std::string& shell : shells()) EXPECT_THAT(completion_script(command(), shell), HasSubstr("taut"));
  EXPECT_EQ(completion_script(command(), "csh"), "");
}

TEST(Completion, BashHasOptionsPlacesAndPlainNames) {
  const std::string script = completion_script(command(), "bash");
  EXPECT_THAT(script, HasSubstr("options='-o --output --paper --json'"));
  EXPECT_THAT(script, HasSubstr("valued='-o --output --paper'"));
  EXPECT_THAT(script, HasSubstr("'run -o' | 'run --output') _taut_folders ;;"));
  EXPECT_THAT(script, HasSubstr("'run 0') _taut_decks ;;"));
  EXPECT_THAT(script, HasSubstr("'run --paper') words='a4' ;;")) << "what bash would split or expand is left out";
}

TEST(Completion, FishLeavesOutWhatItWouldExpand) {
  const std::string script = completion_script(command(), "fish");
  EXPECT_THAT(script, HasSubstr("-l paper -x -a 'a4' -d 'of [the] page: a4'"));
  EXPECT_THAT(script, HasSubstr("-s o -l output -x -a '(__fish_complete_directories"));
  EXPECT_THAT(script, HasSubstr("-a run -d 'It\\'s a deck: [calculate]'"));
  EXPECT_THAT(script, Not(HasSubstr("$(date)")));
}

TEST(Completion, ZshQuotesWhatSeparatesItsFields) {
  const std::string script = completion_script(command(), "zsh");
  EXPECT_THAT(script, HasSubstr("'run:It'\\''s a deck: [calculate]'"));
  EXPECT_THAT(script,
              HasSubstr(R"('*''--paper=''[of \[the\] page\: a4]:PAPER:(a4 6x19\(1+6+6\) two\ words \$\(date\))')"));
  EXPECT_THAT(script, HasSubstr("'(-o --output)'{-o,--output=}'[folder]:DIR:_files -/'"));
}

}  // namespace taut::cli::completion_test
