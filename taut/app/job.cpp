#include "taut/app/job.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "taut/app/cases/read_cases.hpp"
#include "taut/app/cases/study/calibrate.hpp"
#include "taut/app/cases/study/study.hpp"
#include "taut/app/fingerprint.hpp"
#include "taut/app/method_deck.hpp"
#include "taut/app/prepare_machine.hpp"
#include "taut/calc/answers.hpp"
#include "taut/io/data_files.hpp"
#include "taut/io/deck/deck.hpp"

namespace taut::app {
namespace {

/// A deck as far as it could be read; `calculate` is empty when there are mistakes.
struct Prepared {
  std::optional<io::Deck> deck;
  Diagnostics mistakes;
  std::function<Result()> calculate;
};

bool replaces_analyses(const std::string& set) { return set.starts_with("analyses="); }

/// Mistakes of the blocks `study` and `calibrate`, which a run leaves out. These blocks are about the deck's own
/// analyses. Where `--set analyses=...` puts others in their place, nothing is said.
void add_mistakes_of_blocks(const Job& job, const io::Deck& deck, Diagnostics& mistakes) {
  const io::Node& blocks = blocks_of(deck);
  if (blocks.find("study") == nullptr && blocks.find("calibrate") == nullptr) return;
  if (std::any_of(job.set.begin(), job.set.end(), replaces_analyses)) return;
  const auto read = read_cases(job);
  if (!read) return;
  for (const auto& more : {check_study(*read), check_calibration(*read)})
    mistakes.insert(mistakes.end(), more.begin(), more.end());
}

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
  if (p.mistakes.empty()) add_mistakes_of_blocks(job, *p.deck, p.mistakes);
  if (!p.mistakes.empty()) p.calculate = {};
  return p;
}

bool same(const io::Node& a, const io::Node& b) {
  return a.kind == b.kind && a.text == b.text &&
         std::equal(a.items.begin(), a.items.end(), b.items.begin(), b.items.end(), same) &&
         std::equal(a.entries.begin(), a.entries.end(), b.entries.begin(), b.entries.end(),
                    [](const io::Entry& x, const io::Entry& y) { return x.key == y.key && same(x.value, y.value); });
}

/// "sweep 'mass'": the analysis of one entry of `analyses`.
std::string words_of(const io::Node& analysis) {
  if (analysis.entries.empty()) return "an analysis";
  const io::Entry& kind = analysis.entries.front();
  const io::Node* name = kind.value.find("name");
  return name == nullptr ? kind.key : fmt::format("{} '{}'", kind.key, name->text);
}

/// The analyses of the deck that `--set analyses=...` has put others in place of: their checks are not made.
std::vector<std::string> put_aside(const Job& job, const io::Deck& deck) {
  std::vector<std::string> others = job.set;
  if (std::erase_if(others, replaces_analyses) == 0) return {};
  Diagnostics ignored;
  const auto own = io::read_deck(job.text, job.name, others, method_names(), ignored, job.read);
  if (!own) return {};
  const io::Node *before = own->input.find("analyses"), *now = deck.input.find("analyses");
  if (before == nullptr || now == nullptr) return {};
  std::vector<std::string> all;
  for (const io::Node& one : before->items) {
    const bool stays =
        std::any_of(now->items.begin(), now->items.end(), [&](const auto& other) { return same(one, other); });
    if (!stays) all.push_back(words_of(one));
  }
  return all;
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
  if (const auto aside = put_aside(job, *p.deck); !aside.empty() && r.status == Status::ok) {
    r.warnings.push_back(fmt::format("the deck's own analyses do not count here, and their checks are not made: {}",
                                     fmt::join(aside, ", ")));
  }
  finish_answers(r);
  io::name_apart(r);
  return r;
}

Diagnostics check(const Job& job) { return prepare(job).mistakes; }

}  // namespace taut::app
