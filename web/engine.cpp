#include <emscripten.h>

#include <exception>
#include <optional>
#include <string>

#include "taut/app/job.hpp"
#include "taut/base/version.hpp"
#include "web/answers.hpp"

/// The C interface of the engine for a page. All texts are UTF-8; an answer is valid until the next call.
namespace taut::web {
namespace {

// clang-format off
/// Tells the worker how far the calculation is; 0: it shall end.
EM_JS(int, tell_progress, (const char* what, double done, const char* words), {
  const tell = Module.onProgress;
  return tell && tell(UTF8ToString(what), done, UTF8ToString(words)) === false ? 0 : 1;
});
// clang-format on

std::string& answer() {
  static std::string text;
  return text;
}

std::optional<Result>& last() {
  static std::optional<Result> result;
  return result;
}

Result solved(const AskedDeck& deck) {
  app::Job job = job_of(deck);
  job.progress = [](const Progress& p) { return tell_progress(p.what.c_str(), p.done, p.words.c_str()) != 0; };
  return app::run(job);
}

}  // namespace
}  // namespace taut::web

extern "C" {

/// `request`: {text, name, files: {NAME: text}, set: [..]}. The answer: {page, places}, see page_json.hpp and
/// deck_places.hpp, or {failure} for a bug of taut. The whole result is kept for taut_ask.
EMSCRIPTEN_KEEPALIVE const char* taut_solve(const char* request) {
  using namespace taut::web;
  try {
    const AskedDeck deck = asked_deck(request);
    last() = solved(deck);
    answer() = answer_of(*last(), deck.text);
  } catch (const std::exception& e) {
    last().reset();
    answer() = failure(e.what());
  }
  return answer().c_str();
}

/// `what`: of the last result "report" (HTML), "json" (result.json) or "pictures"; "schema", "version"; empty where
/// there is none.
EMSCRIPTEN_KEEPALIVE const char* taut_ask(const char* what) {
  using namespace taut::web;
  const std::string asked = what;
  try {
    answer().clear();
    if (asked == "version") answer() = taut::version;
    if (asked == "schema") answer() = page_schema();
    if (last()) answer() += part_of(*last(), asked);
  } catch (const std::exception& e) {
    answer() = failure(e.what());
  }
  return answer().c_str();
}
}
