#include "taut/app/explain/explain_machine.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/app/explain/explain.hpp"
#include "taut/app/machine_deck.hpp"
#include "taut/results/described.hpp"

namespace taut::app {
namespace {

/// What is calculated, in the order of a rope's way; where it is explained.
constexpr const char* laws[][3] = {
    {"free rope",
     "x = H s/EA + (H/w) (asinh(V/H) - asinh(V_0/H)), z = (V_0 s + w s^2/2)/EA + (T - T_0)/w, V = V_0 + w s",
     "catenary.md"},
    {"temperature", "L (1 + a dT), w/(1 + a dT), EA unchanged", "length.md"},
    {"sheave", "T_large = T_small/eta by the motion; with friction at most T_small exp(mu theta)", "contact.md"},
    {"saddle", "T_large = T_small exp(mu theta), Euler-Eytelwein", "contact.md"},
    {"driven sheave", "M = R (T_in - T_out); grip (T_1 - c)/(T_2 - c) <= exp(mu alpha)", "drives.md"},
    {"running rope", "c = m v^2 in every tension; shape and forces on supports depend on T - c", "drives.md"},
    {"force on a rope", "T_out = T_in - F at a fraction of the branch", "rope-load.md"},
    {"drum", "R_k = (D + d)/2 + (k - 1) h; M = T R_k", "drum.md"},
    {"carriage", "rolling: equal tensions, or friction between them; clamped: a fixed length before it",
     "carriages.md"},
    {"guy", "put up by tension on the unloaded machine, then its length is kept", "guy.md"},
    {"line put up", "its base tension gives its length, which is kept", "installation.md"},
    {"beam", "elastic rod of first or second order, with ropes anywhere along it", "beam.md"},
    {"equilibrium",
     "balance of every degree of freedom, law of every contact, given lengths and tensions; damped Newton",
     "equilibrium.md"}};

constexpr const char* equilibrium_tables[][2] = {
    {"places", "places given over the ground: x, y, z"},
    {"spans", "tensions at both ends, their components H and V, chord, unstretched and stretched length, sag"},
    {"sheaves", "T_in and T_out by the order of the path, wrap, force on it, state"},
    {"bodies", "place, rotation, force that holds each body"},
    {"anchors", "force of the ropes at their ends"},
    {"put_up", "lines with `install`: tensions and lengths when they are put up"},
    {"ropes", "unstretched length, largest tension and where, safety factor"},
    {"rope_loads", "forces along the ropes: force, tensions beside it, place"},
    {"drives", "driven sheaves: torque, grip, slip arc, creep, power and its parts"},
    {"drums", "layer, radius, wraps, rope on it, capacity, pull, torque"},
    {"beams", "along each beam: place, axial force, shear, moment, stress, deflection"},
    {"beam_ends", "largest values of each beam, force and moment at its base, critical force"},
    {"closure", "residuals: lengths, forces, sum of all forces"},
    {"masts", "with checks of masts: the worst section by each route"}};

constexpr const char* path_tables[][2] = {
    {"load_path", "for each position of the carriage: its place, clearance, tensions of every rope and contact"}};
constexpr const char* payload_tables[][2] = {{"payload", "for each position the payload and the limit that governs"}};

template <std::size_t N>
std::string table_lines(const char* const (&tables)[N][2]) {
  std::string text;
  for (const auto& [name, words] : tables) text += fmt::format("  {:<16}{}\n", name, words);
  return text;
}

/// Those that are not of an equilibrium, with what their rows are.
std::string analysis_tables() {
  std::string text;
  for (const TableWords& t : results::table_words()) {
    const auto same = [&](const auto& row) { return t.name == row[0]; };
    if (std::any_of(std::begin(equilibrium_tables), std::end(equilibrium_tables), same)) continue;
    text += fmt::format("  {:<23}a row for: {}\n", t.name, t.rows);
  }
  return text;
}

constexpr const char* blocks[] = {"checks", "design", "study", "calibrate"};

const Field* analysis_named(const std::string& name) { return study::AnalysisRequest::describe().find(name); }

std::string whole_machine() {
  std::string text =
      "A machine instead of a method: `machine:` describes its parts and the paths of its ropes, `analyses:` what is\n"
      "computed. The guide: docs/guide/machine-decks.md; starter decks: taut list machines, taut new NAME.\n"
      "\nParts (keys of one: taut explain PART)\n";
  for (const Field& f : machine::Machine::describe().fields) text += fmt::format("  {:<16}{}\n", f.key, f.words);
  text += "\nAnalyses (keys and results: taut explain ANALYSIS)\n";
  for (const Field& f : study::AnalysisRequest::describe().fields) text += fmt::format("  {:<16}{}\n", f.key, f.words);
  text += "\nBeside them (keys: taut explain BLOCK)\n";
  for (const char* block : blocks)
    text += fmt::format("  {:<16}{}\n", block, MachineDeck::describe().find(block)->words);
  text += "\nLaws (docs/theory)\n";
  for (const auto& [name, law, page] : laws) text += fmt::format("  {:<17}{}  [{}]\n", name, law, page);
  text += "\nResult tables of an equilibrium\n" + table_lines(equilibrium_tables);
  text += "\nResult tables of analyses\n" + analysis_tables();
  text +=
      "\nResult values\n"
      "  T_max, ROPE.T_max, ROPE.safety_factor, clearance_min over all analyses; BODY.x, y, z and ROPE.unstretched of "
      "the\n"
      "  first equilibrium; ROPE.T_start, ROPE.T_end, SHEAVE.torque, SHEAVE.power of every one (with its name "
      "appended)\n";
  for (const LaterKey& key : machine::Machine::describe().later) {
    text += fmt::format("\nNot yet: {}: {}\n", key.key, key.words);
  }
  return text;
}

std::string analysis_text(const Field& f) {
  std::string text =
      fmt::format("analyses: - {}: {}\n\nDeck keys\n{}", f.key, f.words, keys_text(f.key + ".", *f.record));
  if (f.key == "equilibrium") text += "\nResult tables\n" + table_lines(equilibrium_tables);
  if (f.key == "load_path") text += "\nResult tables\n" + table_lines(path_tables);
  if (f.key == "payload") text += "\nResult tables\n" + table_lines(payload_tables);
  return text;
}

/// A block beside the machine: checks, design.
std::string block_text(const Field& f) {
  const std::string guide = f.key == "calibrate" ? "study" : f.key;
  return fmt::format("{0}: {1}\nThe guide: docs/guide/{3}.md.\n\nDeck keys\n{2}", f.key, f.words,
                     keys_text(f.key + ".", *f.record), guide);
}

std::string part_text(const Field& f) {
  std::string words = fmt::format("machine: {}: {}\n", f.key, f.words);
  if (f.record == nullptr) return words;
  const char* const inner = f.is_list ? "[]." : f.kind == FieldKind::named_records ? ".NAME." : ".";
  return fmt::format("{}\nDeck keys\n{}", words, keys_text(f.key + inner, *f.record));
}

}  // namespace

std::vector<std::string> machine_topics() {
  std::vector<std::string> all = {"machine"};
  for (const Field& f : machine::Machine::describe().fields) all.push_back(f.key);
  for (const Field& f : study::AnalysisRequest::describe().fields) all.push_back(f.key);
  for (const char* block : blocks) all.emplace_back(block);
  return all;
}

std::optional<std::string> explain_machine(const std::string& topic) {
  if (topic == "machine") return whole_machine();
  if (const Field* f = analysis_named(topic)) return analysis_text(*f);
  if (const Field* f = machine::Machine::describe().find(topic)) return part_text(*f);
  if (std::find(std::begin(blocks), std::end(blocks), topic) != std::end(blocks)) {
    return block_text(*MachineDeck::describe().find(topic));
  }
  return std::nullopt;
}

}  // namespace taut::app
