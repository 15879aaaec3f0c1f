#pragma once
#include <array>
#include <string_view>

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

struct ExitWords {
  ExitCode code;
  std::string_view words;
};

/// What each exit code means, for --help and the man page.
inline constexpr std::array<ExitWords, 7> exit_words{{
    {.code = computed, .words = "computed; nothing fails"},
    {.code = our_fault, .words = "a bug in taut"},
    {.code = usage_or_deck, .words = "a mistake in the command or the deck"},
    {.code = says_no,
     .words = "no answer: no equilibrium, not converged, or nothing that passes; the message gives the cause"},
    {.code = check_fails, .words = "computed; a check fails, or the result is not judged"},
    {.code = file_trouble, .words = "a file cannot be read or written; also where --pdf finds no Chromium"},
    {.code = interrupted, .words = "interrupted; what was computed until then is written"},
}};

}  // namespace taut::cli
