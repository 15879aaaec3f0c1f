#include "taut/app/job.hpp"

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <vector>

#include "taut/app/fingerprint.hpp"
#include "taut/app/method_deck.hpp"
#include "taut/app/prepare_machine.hpp"
#include "taut/calc/answers.hpp"
#include "taut/io/deck/deck.hpp"

namespace taut::app {
namespace {

/// A deck as far as it could be read; `calculate` is empty when there are mistakes.
struct Prepared {
  std::optional<io::Deck> deck;
  Diagnostics mistakes;
  std::function<Result()> calculate;
};

Prepared prepare(const Job& job) {
  Prepared p;
  p.deck = io::read_deck(job.text, job.name, job.set, method_names(), p.mistakes, job.read);
  if (!p.deck) return p;
  const Display& display = p.deck->display;
  if (p.deck->is_machine) p.calculate = prepare_machine(p.deck->input, p.mistakes, job.progress, display);
  if (const MethodEntry* method = find_method(p.deck->method)) {
    const io::Node* others = p.deck->others ? &*p.deck->others : nullptr;
    p.calculate =
        prepare_method(*method, p.deck->input, others, {.progress = job.progress, .display = display}, p.mistakes);
  }
  if (!p.mistakes.empty()) p.calculate = {};
  return p;
}

Result bad_deck(const Prepared& p) {
  Result r;
  r.status = Status::bad_deck;
  r.message =
      p.mistakes.size() == 1 ? "the deck has a mistake" : fmt::format("the deck has {} mistakes", p.mistakes.size());
  r.errors = p.mistakes;
  return r;
}

}  // namespace

Result run(const Job& job) {
  const Prepared p = prepare(job);
  Result r = p.calculate ? p.calculate() : bad_deck(p);
  r.deck_name = job.name;
  if (!p.deck) return r;
  if (!p.deck->title.empty()) r.title = p.deck->title;
  if (r.title.empty()) r.title = r.method_title;
  r.method = p.deck->is_machine ? "machine" : p.deck->method;
  r.project = p.deck->project;
  r.display = p.deck->display.units();
  r.deck_hash = fingerprint(job.text, p.deck->reading ? p.deck->reading->texts : std::vector<std::string>{}, job.set);
  r.overrides = job.set;
  finish_answers(r);
  return r;
}

Diagnostics check(const Job& job) { return prepare(job).mistakes; }

}  // namespace taut::app
