#include "taut/app/cases/study/calibrated_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "taut/io/deck/document.hpp"
#include "taut/io/deck/include.hpp"
#include "taut/io/deck/override.hpp"
#include "taut/io/deck/write.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

/// Fits whose correlation is smaller are taken as independent.
constexpr double least_correlation = 1e-3;

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

/// The law of a number found: normal, within the bounds of the fit.
io::Node law_of(const chance::CalibratedParameter& p, const chance::FreeParameter& bounds, const Unit& unit) {
  io::Node normal = map_node();
  normal.entries.push_back({"mean", {}, text_node(si_text(p.value, unit))});
  normal.entries.push_back({"sd", {}, text_node(si_text(p.standard_error, unit))});
  io::Node law = map_node();
  law.entries.push_back({"normal", {}, std::move(normal)});
  law.entries.push_back(
      {"truncate", {}, list_node({text_node(si_text(bounds.low, unit)), text_node(si_text(bounds.high, unit))})});
  return law;
}

/// Puts the laws of the fit into the deck's study, or makes one that asks for what was measured.
void add_study(const CaseModel& model, const std::vector<chance::FreeParameter>& free, const chance::Calibration& found,
               io::Node& study) {
  const std::size_t n = free.size();
  for (std::size_t i = 0; i < n; ++i) {
    at(at(study, "vary"), free[i].name) = law_of(found.parameters[i], free[i], model.inputs[i].unit);
    for (std::size_t k = 0; k < i; ++k) {
      const double r =
          found.covariance[i * n + k] / found.parameters[i].standard_error / found.parameters[k].standard_error;
      if (!(std::abs(r) > least_correlation)) continue;
      io::Node& pairs = at(study, "correlate");
      if (pairs.kind != io::Node::Kind::sequence) pairs = list_node({});
      pairs.items.push_back(
          list_node({text_node(free[k].name), text_node(free[i].name), text_node(fmt::format("{:.6f}", r))}));
    }
  }
  if (study.kind != io::Node::Kind::map || study.find("of") != nullptr) return;
  std::vector<io::Node> outputs;
  outputs.reserve(model.outputs.size());
  for (const CaseOutput& one : model.outputs) outputs.push_back(text_node(one.name));
  at(study, "of") = list_node(std::move(outputs));
}

}  // namespace

std::string calibrated_deck(const Job& job, const CaseModel& model, const std::vector<chance::FreeParameter>& free,
                            const chance::Calibration& found) {
  Diagnostics mistakes;  // none: the deck was read before
  auto document = io::parse(job.text, job.name);
  if (!document) return {};
  io::resolve_includes(*document, mistakes);
  const std::vector<std::string> keys = {"machine", "input", "analyses", "checks", "design", "study", "calibrate"};
  for (const std::string& one : job.set) io::override_value(*document, one, keys, mistakes);
  for (std::size_t i = 0; i < free.size(); ++i) {
    const std::string value = si_text(found.parameters[i].value, model.inputs[i].unit);
    io::override_value(*document, fmt::format("{}={}", free[i].name, value), keys, mistakes);
  }
  io::Node& root = document->root;
  std::erase_if(root.entries, [](const io::Entry& e) { return e.key == "calibrate" || e.key == "include"; });
  name_files_wholly(root);
  add_study(model, free, found, at(root, "study"));
  return fmt::format("# Made by taut from '{}' with the numbers that its measurements tell.\n{}",
                     fs::path(job.name).filename().string(), io::to_yaml(root));
}

}  // namespace taut::app
