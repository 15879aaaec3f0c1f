#include "taut/app/cases/study/calibrated_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>
#include <utility>

#include "taut/chance/correlation.hpp"
#include "taut/io/deck/deck.hpp"
#include "taut/io/deck/override.hpp"
#include "taut/io/deck/parameters.hpp"
#include "taut/io/deck/write.hpp"
#include "taut/units/any_quantity.hpp"
#include "taut/units/parse.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

/// Numbers of a fit whose correlations are all smaller are taken as independent.
constexpr double least_correlation = 1e-3;

/// A fit and the deck that it is of.
struct FittedDeck {
  const ReadCases& read;
  const CaseModel& model;
  const std::vector<chance::FreeParameter>& free;
  const chance::Calibration& found;
};

/// What of the old deck cannot stand beside the fit, for the user's eyes.
using Notes = std::vector<std::string>;

io::Node text_node(std::string text) {
  io::Node n;
  n.kind = io::Node::Kind::scalar;
  n.text = std::move(text);
  return n;
}

io::Node list_node(std::vector<io::Node> items) {
  io::Node n;
  n.kind = io::Node::Kind::sequence;
  n.items = std::move(items);
  return n;
}

io::Node map_node() {
  io::Node n;
  n.kind = io::Node::Kind::map;
  return n;
}

/// The value of a key, made where there is none.
io::Node& at(io::Node& map, const std::string& key) {
  if (map.kind != io::Node::Kind::map) map = map_node();
  if (io::Node* there = map.find(key)) return *there;
  map.entries.push_back({key, {}, map_node()});
  return map.entries.back().value;
}

void erase(io::Node& map, const std::string& key) {
  std::erase_if(map.entries, [&](const io::Entry& e) { return e.key == key; });
}

std::string si_text(double x, const Unit& unit) {
  return unit.needs_text() ? fmt::format("{:.12g} {}", x, unit.symbol) : fmt::format("{:.12g}", x);
}

/// Files are named beside the deck that names them; the new one may lie elsewhere.
void name_files_wholly(io::Node& node) {
  for (io::Entry& e : node.entries) {
    const bool names = e.key == "file" || e.key == "catalogue" || e.key == "restart";
    if (names && e.value.kind == io::Node::Kind::scalar && e.value.spot.source) {
      std::error_code failed;
      const fs::path path = fs::path(e.value.spot.source->name).parent_path() / e.value.text;
      if (fs::exists(path, failed)) {
        e.value.text = fs::absolute(path, failed).lexically_normal().string();
        e.value.quoted = true;
      }
    }
    name_files_wholly(e.value);
  }
  for (io::Node& item : node.items) name_files_wholly(item);
}

/// Puts the numbers found over those of the deck.
void put_found(const FittedDeck& fit, io::Document& document, Notes& notes) {
  for (std::size_t i = 0; i < fit.free.size(); ++i) {
    const std::string& name = fit.free[i].name;
    const std::string value = si_text(fit.found.parameters[i].value, fit.model.inputs[i].unit);
    Diagnostics refused;
    io::override_value(document, fmt::format("{}={}", name, value), io::deck_keys(), refused);
    for (const Diagnostic& one : refused) {
      notes.push_back(fmt::format("{}: {} is in its law only, not in the deck: {}", name, value, one.message));
    }
  }
}

/// The temperature of a machine's deck; nothing where it has none, or of a method.
std::optional<double> temperature_of(const ReadCases& read) {
  const auto* machine = std::get_if<ReadMachine>(&read.of);
  return machine != nullptr ? machine->deck->machine.temperature : std::nullopt;
}

/// Lengths hold at the temperature that the deck had while it was fitted. With another one in it the new deck has to
/// name that of each rope and beam.
void put_references(const FittedDeck& fit, io::Document& document, Notes& notes) {
  const std::optional<double> before = temperature_of(fit.read);
  if (!before) return;
  const Job& job = fit.read.job;
  const auto after =
      read_cases({.text = io::to_yaml(document.root), .name = job.name, .set = {}, .progress = {}, .read = job.read});
  if (after && temperature_of(*after) == before) return;
  const std::string text = fmt::format("{:.12g} degC", *before - zero_celsius);
  const auto put = [&](const char* list, const auto& all) {
    for (const auto& one : all) {
      if (one.reference_temperature) continue;
      Diagnostics refused;
      io::override_value(document, fmt::format("machine.{}.{}.reference_temperature={}", list, one.name, text),
                         io::deck_keys(), refused);
      for (const Diagnostic& wrong : refused) {
        notes.push_back(
            fmt::format("the length of {} holds at {}, not at the new temperature: {}", one.name, text, wrong.message));
      }
    }
  };
  const machine::Machine& machine = std::get<ReadMachine>(fit.read.of).deck->machine;
  put("ropes", machine.ropes);
  put("beams", machine.beams);
}

/// The law of a number found: normal with the interval of the fit, within its bounds and within what the number may be.
io::Node law_of(const chance::CalibratedParameter& p, const chance::FreeParameter& bounds, const CaseInput& input) {
  io::Node normal = map_node();
  normal.entries.push_back({"mean", {}, text_node(si_text(p.value, input.unit))});
  normal.entries.push_back({"sd", {}, text_node(si_text(p.spread, input.unit))});
  const double low = std::max(bounds.low, input.range.low), high = std::min(bounds.high, input.range.high);
  io::Node law = map_node();
  law.entries.push_back({"normal", {}, std::move(normal)});
  law.entries.push_back(
      {"truncate", {}, list_node({text_node(si_text(low, input.unit)), text_node(si_text(high, input.unit))})});
  return law;
}

/// Puts the laws of the fit into `vary`; where the study varies a number already, in the place and under the spelling
/// that it has there. Returns the names of the fit's numbers in `vary`.
std::vector<std::string> put_laws(const FittedDeck& fit, io::Node& vary, Notes& notes) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < fit.free.size(); ++i) {
    const std::string place = fit.read.place_of(fit.free[i].name);
    const auto same = [&](const io::Entry& e) { return fit.read.place_of(e.key) == place; };
    auto at = std::find_if(vary.entries.begin(), vary.entries.end(), same);
    if (at == vary.entries.end()) {
      vary.entries.push_back({fit.free[i].name, {}, {}});
      at = std::prev(vary.entries.end());
    } else {
      notes.push_back(fmt::format("study.vary.{}: its law gives way to that of the fit", at->key));
    }
    at->value = law_of(fit.found.parameters[i], fit.free[i], fit.model.inputs[i]);
    names.push_back(at->key);
    vary.entries.erase(std::remove_if(std::next(at), vary.entries.end(), same), vary.entries.end());
  }
  return names;
}

/// One entry of `correlate`: as read, and as it is written.
struct Pair {
  std::vector<std::string> texts;  ///< path, path, correlation
  io::Node node;
};

std::vector<Pair> pairs_of_study(const FittedDeck& fit, const io::Node& study) {
  std::vector<Pair> pairs;
  const io::Node* written = study.find("correlate");
  if (written == nullptr || !fit.read.study) return pairs;
  for (std::size_t i = 0; i < fit.read.study->correlate.size(); ++i) {
    pairs.push_back({.texts = fit.read.study->correlate[i].pair, .node = written->items.at(i)});
  }
  return pairs;
}

/// The correlations of the fit, all of them or none: a matrix without its small numbers may contradict itself.
std::vector<Pair> pairs_of_fit(const FittedDeck& fit, const std::vector<std::string>& names) {
  std::vector<Pair> pairs;
  bool correlated = false;
  const std::size_t n = names.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const double r = fit.found.covariance[i * n + k] / fit.found.parameters[i].standard_error /
                       fit.found.parameters[k].standard_error;
      correlated = correlated || std::abs(r) > least_correlation;
      std::vector<std::string> texts = {names[k], names[i], fmt::format("{:.12g}", r)};
      io::Node node = list_node({text_node(texts[0]), text_node(texts[1]), text_node(texts[2])});
      pairs.push_back({.texts = std::move(texts), .node = std::move(node)});
    }
  }
  return correlated ? pairs : std::vector<Pair>{};
}

/// The correlation of the inputs with these names; nothing where the pairs contradict each other.
std::optional<chance::Correlation> together(const std::vector<Pair>& pairs, const std::vector<std::string>& names) {
  std::vector<chance::CorrelatedPair> all;
  for (const Pair& one : pairs) {
    if (one.texts.size() != 3) return std::nullopt;
    const auto first = std::find(names.begin(), names.end(), one.texts[0]);
    const auto second = std::find(names.begin(), names.end(), one.texts[1]);
    const auto r = parse_quantity(one.texts[2], si::one);
    if (first == names.end() || second == names.end() || !r) return std::nullopt;
    all.push_back({.first = static_cast<std::size_t>(first - names.begin()),
                   .second = static_cast<std::size_t>(second - names.begin()),
                   .r = *r});
  }
  auto found = chance::correlation(all, names);
  return found ? std::optional(std::move(*found)) : std::nullopt;
}

/// Puts the correlation of the fit into the study, over what the study says of two numbers of the fit. What it says of
/// one of them and another input stays, unless it contradicts the fit. Returns whether inputs are correlated.
bool put_correlation(const FittedDeck& fit, const std::vector<std::string>& names, io::Node& study, Notes& notes) {
  std::vector<Pair> pairs = pairs_of_study(fit, study);
  const std::vector<Pair> own = pairs_of_fit(fit, names);
  const auto of_fit = [&](const std::string& path) {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return fit.read.place_of(name) == fit.read.place_of(path); });
  };
  const auto leave_out = [&](std::ptrdiff_t least, const char* why) {
    std::erase_if(pairs, [&](const Pair& one) {
      if (one.texts.size() != 3) return false;
      if (std::count_if(one.texts.begin(), one.texts.begin() + 2, of_fit) < least) return false;
      notes.push_back(fmt::format("study.correlate: [{}] {}", fmt::join(one.texts, ", "), why));
      return true;
    });
  };
  const auto with_own = [&] {
    std::vector<Pair> all = pairs;
    all.insert(all.end(), own.begin(), own.end());
    return all;
  };
  std::vector<std::string> inputs;
  for (const io::Entry& e : at(study, "vary").entries) inputs.push_back(e.key);
  leave_out(2, "gives way to that of the fit");
  if (!together(with_own(), inputs)) leave_out(1, "contradicts the correlation of the fit");
  std::vector<io::Node> written;
  for (Pair& one : with_own()) written.push_back(std::move(one.node));
  erase(study, "correlate");
  if (!written.empty()) at(study, "correlate") = list_node(std::move(written));
  const auto correlation = together(with_own(), inputs);
  return correlation && !chance::independent(*correlation);
}

/// Takes out of the study what its inputs do not allow any more.
void drop_unanswerable(const StudyRequest& old, bool correlated, io::Node& study, Notes& notes) {
  if (old.points == StudyPoints::grid) {
    erase(study, "points");
    notes.emplace_back("study.points: a grid is made of single values, the numbers found have laws");
  }
  std::vector<std::string> answer = old.answer;
  if (!correlated || std::erase(answer, "indices") == 0) return;
  notes.emplace_back("study.answer: 'indices' are of independent inputs, the numbers found are correlated");
  erase(study, "answer");
  std::vector<io::Node> rest;
  rest.reserve(answer.size());
  for (std::string& one : answer) rest.push_back(text_node(std::move(one)));
  if (!rest.empty()) at(study, "answer") = list_node(std::move(rest));
}

/// Whether an entry of `correlate` names this input.
bool names_input(const io::Node& written, const std::string& name) {
  const io::Node* pair = written.kind == io::Node::Kind::map ? written.find("pair") : &written;
  return pair != nullptr &&
         std::any_of(pair->items.begin(), pair->items.end(), [&](const io::Node& one) { return one.text == name; });
}

/// Takes an input out of the study, where it varies.
void drop_input(io::Node& study, const std::string& name) {
  erase(at(study, "vary"), name);
  io::Node* pairs = study.find("correlate");
  if (pairs == nullptr) return;
  std::erase_if(pairs->items, [&](const io::Node& one) { return names_input(one, name); });
  if (pairs->items.empty()) erase(study, "correlate");
}

/// Parameters that nothing uses, as what the fit found stands in place of their expressions, or that an included deck
/// left unused: in one deck they are a mistake.
void drop_unused_parameters(io::Document& document, Notes& notes) {
  io::Node& root = document.root;
  for (auto unused = io::unused_parameters(document); !unused.empty(); unused = io::unused_parameters(document)) {
    for (const std::string& name : unused) {
      erase(at(root, "parameters"), name);
      drop_input(at(root, "study"), "parameters." + name);
      notes.push_back(fmt::format("parameters.{}: nothing in this deck uses it", name));
    }
  }
  if (root.find("parameters") != nullptr && at(root, "parameters").entries.empty()) erase(root, "parameters");
}

/// Puts the laws of the fit into the deck's study, or makes one that asks for what was measured.
void put_study(const FittedDeck& fit, io::Node& study, Notes& notes) {
  io::Node& vary = at(study, "vary");
  if (vary.kind != io::Node::Kind::map) vary = map_node();
  const std::vector<std::string> names = put_laws(fit, vary, notes);
  const bool correlated = put_correlation(fit, names, study, notes);
  if (fit.read.study) drop_unanswerable(*fit.read.study, correlated, study, notes);
  if (study.find("of") != nullptr) return;
  std::vector<io::Node> outputs;
  outputs.reserve(fit.model.outputs.size());
  for (const CaseOutput& one : fit.model.outputs) outputs.push_back(text_node(one.name));
  at(study, "of") = list_node(std::move(outputs));
}

/// The lines above the deck: whence it is, and what is not in it as it was.
std::string comments(const std::string& name, const Notes& notes) {
  std::vector<std::string> lines = {
      fmt::format("Made by taut from '{}' with the numbers that its measurements tell.", name)};
  if (!notes.empty()) lines.emplace_back("Not as it was there, or not there any more:");
  for (const std::string& one : notes) lines.push_back("- " + one);
  std::string text;
  for (std::string& line : lines) {
    // a name in the deck may have a line end, which would end the comment
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < ' '; }, ' ');
    text += "# " + line + "\n";
  }
  return text;
}

}  // namespace

std::string calibrated_deck(const ReadCases& read, const CaseModel& model,
                            const std::vector<chance::FreeParameter>& free, const chance::Calibration& found) {
  const FittedDeck fit{.read = read, .model = model, .free = free, .found = found};
  Diagnostics mistakes;  // none: the deck was read before
  auto document = io::read_document(read.job.text, read.job.name, read.job.set, mistakes, read.job.read);
  if (!document) return {};
  Notes notes;
  io::Node& root = document->root;
  put_found(fit, *document, notes);
  erase(root, "calibrate");
  name_files_wholly(root);
  put_references(fit, *document, notes);
  put_study(fit, at(root, "study"), notes);
  drop_unused_parameters(*document, notes);
  return comments(fs::path(read.job.name).filename().string(), notes) + io::to_yaml(root);
}

}  // namespace taut::app
