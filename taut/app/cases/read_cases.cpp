#include "taut/app/cases/read_cases.hpp"

#include <fmt/format.h>

#include "taut/app/cases/case_values.hpp"
#include "taut/app/cases/machine_cases.hpp"
#include "taut/app/cases/method_cases.hpp"
#include "taut/app/fingerprint.hpp"
#include "taut/io/deck/read.hpp"
#include "taut/units/any_quantity.hpp"

namespace taut::app {
namespace {

bool read_as_machine(ReadCases& read, Diagnostics& mistakes) {
  auto machine = read_machine(read.deck.input, read.deck.display, mistakes);
  if (!machine) return false;
  read.study = std::move(machine->study);
  read.calibrate = std::move(machine->calibrate);
  read.of = std::move(*machine);
  return true;
}

bool read_as_method(ReadCases& read, Diagnostics& mistakes) {
  const MethodEntry* method = find_method(read.deck.method);
  if (method == nullptr) return false;
  const io::Node* others = read.deck.others ? &*read.deck.others : nullptr;
  auto deck = read_method(*method, read.deck.input, others, read.deck.display, mistakes);
  if (!deck) return false;
  read.study = std::move(deck->blocks.study);
  read.calibrate = std::move(deck->blocks.calibrate);
  read.of = std::move(*deck);
  return true;
}

/// A parameter by its quantity in the deck.
tl::expected<CaseInput, std::string> described_parameter(const io::Node& parameters, const std::string& path) {
  const io::Node* node = parameters.find(path.substr(path.find('.') + 1));
  if (node == nullptr) return tl::unexpected(fmt::format("the deck has no '{}'", path));
  const auto quantity = parse_any_quantity(node->text);
  if (node->kind != io::Node::Kind::scalar || !quantity) {
    return tl::unexpected(fmt::format("'{}' is not a quantity in the deck", path));
  }
  return CaseInput{.path = path, .unit = quantity->unit, .range = {}, .base = quantity->value, .place = path};
}

/// The deck with more values set over it.
tl::expected<ReadCases, Outcome> read_with(Job job, const std::vector<std::string>& set) {
  job.set.insert(job.set.end(), set.begin(), set.end());
  auto read = read_cases(job);
  if (read) return std::move(*read);
  const Result& no = read.error();
  return tl::unexpected(infeasible(no.errors.empty() ? no.message : no.errors.front().message));
}

}  // namespace

const io::Node& blocks_of(const io::Deck& deck) { return deck.is_machine || !deck.others ? deck.input : *deck.others; }

MadeCases ReadCases::cases(const CaseQuestion& question) const {
  const auto describe = [parameters = deck.parameters](const std::string& path) {
    return described_parameter(parameters, path);
  };
  if (const auto* machine = std::get_if<ReadMachine>(&of)) {
    const auto again = [job = job](const std::vector<std::string>& set) -> tl::expected<MachineOfCase, Outcome> {
      const auto read = read_with(job, set);
      if (!read) return tl::unexpected(read.error());
      const auto& one = std::get<ReadMachine>(read->of);
      return MachineOfCase{.deck = *one.deck, .space = one.space};
    };
    return machine_cases(*machine, question, {.describe = describe, .read = again});
  }
  const auto again = [job = job](const std::vector<std::string>& set) -> tl::expected<MethodDeck, Outcome> {
    auto read = read_with(job, set);
    if (!read) return tl::unexpected(read.error());
    return std::get<MethodDeck>(std::move(read->of));
  };
  return method_cases(std::get<MethodDeck>(of), question, {.describe = describe, .read = again});
}

std::string ReadCases::place_of(const std::string& path) const {
  // what finds a number gives write access to it: it looks in a copy
  FoundParameter found;
  if (const auto* machine = std::get_if<ReadMachine>(&of)) {
    MachineDeck copy = *machine->deck;
    found = study::parameter_at(MachineDeck::describe(), &copy, path);
  } else {
    MethodDeck copy = std::get<MethodDeck>(of);
    found = copy.parameter(path);
  }
  return found ? found->place : path;
}

Result bad_deck(Diagnostics mistakes) {
  Result r;
  r.status = Status::bad_deck;
  r.message =
      mistakes.size() == 1 ? "the deck has a mistake" : fmt::format("the deck has {} mistakes", mistakes.size());
  r.errors = std::move(mistakes);
  return r;
}

Result refusal(const NoCases& why, const io::Node& blocks) {
  if (!why.complaints.empty()) {
    Diagnostics mistakes;
    io::place(blocks, why.complaints, mistakes);
    return bad_deck(std::move(mistakes));
  }
  Result r;
  r.status = why.outcome.status;
  r.message = why.outcome.message;
  return r;
}

tl::expected<ReadCases, Result> read_cases(const Job& job) {
  ReadCases read;
  Diagnostics mistakes;
  auto deck = io::read_deck(job.text, job.name, job.set, method_names(), mistakes, job.read);
  if (!deck) return tl::unexpected(bad_deck(std::move(mistakes)));
  read.deck = std::move(*deck);
  read.job = job;
  const bool good = read.deck.is_machine ? read_as_machine(read, mistakes) : read_as_method(read, mistakes);
  if (!good || !mistakes.empty()) return tl::unexpected(bad_deck(std::move(mistakes)));
  const auto texts = read.deck.reading ? read.deck.reading->texts : std::vector<std::string>{};
  read.hash = fingerprint(job.text, texts, job.set);
  return read;
}

}  // namespace taut::app
