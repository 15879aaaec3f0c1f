#include "taut/checks/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "taut/base/suggest.hpp"

namespace taut::checks {
namespace {

/// A part as a deck may name it.
struct NamedPart {
  std::string word;  ///< "drum"
  Part part;
};

/// All parts. A contact that has the name of its point is that point's.
class NamedParts {
 public:
  NamedParts(const ChecksRequest& request, const machine::Machine& machine) {
    for (const auto& one : machine.reevings) add("rope", PartKind::rope, name_of(one));
    add_all("guy", PartKind::rope, machine.guys);
    add_all("beam", PartKind::beam, machine.beams);
    add_all("drum", PartKind::drum, machine.drums);
    add_all("sheave", PartKind::sheave, machine.sheaves);
    add_all("support", PartKind::sheave, machine.supports);
    add_all("carriage", PartKind::carriage, machine.carriages);
    add_all("point", PartKind::point, machine.points);
    add_all("point", PartKind::point, machine.markers);
    add_all("body", PartKind::body, machine.bodies);
    add_all("cylinder", PartKind::cylinder, machine.actuators);
    for (const auto& one : machine.contacts) {
      const std::string name = one.name.value_or(one.point);
      add(name == one.point ? word_of_place(name) : "contact", PartKind::contact, name);
    }
    for (const auto& one : request.masts) {
      if (!has({.kind = PartKind::beam, .name = one.name})) add("mast", PartKind::mast, one.name);
    }
    add_all("yarder", PartKind::yarder, request.yarders);
    for (const auto& one : request.anchors) {  // the top of a beam is none of these
      const Part part = part_of_anchor(machine, one.name);
      if (!has(part)) add("point", part.kind, part.name);
    }
  }

  /// Parts of this name, by itself or after the word of what it is.
  std::vector<NamedPart> find(const std::string& text) const {
    std::vector<NamedPart> named, told;
    for (const NamedPart& one : all_) {
      if (one.part.name == text) named.push_back(one);
      if (fmt::format("{} {}", one.word, one.part.name) == text) told.push_back(one);
    }
    return named.empty() ? told : named;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    names.reserve(all_.size());
    for (const NamedPart& one : all_) names.push_back(one.part.name);
    return names;
  }

 private:
  void add(std::string word, PartKind kind, std::string name) {
    all_.push_back({.word = std::move(word), .part = {.kind = kind, .name = std::move(name)}});
  }
  template <class All>
  void add_all(const char* word, PartKind kind, const All& all) {
    for (const auto& one : all) add(word, kind, one.name);
  }
  bool has(const Part& part) const {
    return std::any_of(all_.begin(), all_.end(), [&](const NamedPart& one) { return one.part == part; });
  }
  /// What a point of a contact is: it may be the origin of a body.
  std::string word_of_place(const std::string& name) const {
    return has({.kind = PartKind::point, .name = name}) ? "point" : "body";
  }

  std::vector<NamedPart> all_;
};

/// The kinds of parts, each once, in the order of the machine.
std::vector<std::string> words_of(const std::vector<NamedPart>& parts) {
  std::vector<std::string> words;
  for (const NamedPart& one : parts) {
    if (std::find(words.begin(), words.end(), one.word) == words.end()) words.push_back(one.word);
  }
  return words;
}

}  // namespace

Part part_of_body(const machine::Model& m, int body) {
  const machine::Body& own = m.bodies[body];
  if (own.beam) return {.kind = PartKind::beam, .name = m.beams[*own.beam].name};
  const bool carriage = std::any_of(m.carriages.begin(), m.carriages.end(),
                                    [&](const machine::Carriage& car) { return car.body == body; });
  return {.kind = carriage ? PartKind::carriage : PartKind::body, .name = own.name};
}

Part part_at(const machine::Model& m, const machine::Node& node) {
  if (node.drum) return {.kind = PartKind::drum, .name = m.drums[*node.drum].name};
  if (machine::rides(m, node)) return part_of_body(m, node.at.body);
  const bool end = node.kind == machine::NodeKind::anchor;
  return {.kind = end ? PartKind::point : PartKind::sheave, .name = node.name};
}

Part part_of_anchor(const machine::Machine& machine, const std::string& name) {
  const auto is_one = [&](const auto& all) {
    return std::any_of(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  };
  PartKind kind = PartKind::point;
  if (is_one(machine.points) || is_one(machine.markers)) return {.kind = kind, .name = name};
  if (is_one(machine.bodies)) kind = PartKind::body;
  if (is_one(machine.sheaves) || is_one(machine.supports)) kind = PartKind::sheave;
  if (is_one(machine.drums)) kind = PartKind::drum;
  return {.kind = kind, .name = name};
}

Part part_of_mast(const machine::Model& model, const std::string& name) {
  const bool beam = std::any_of(model.beams.begin(), model.beams.end(), [&](const auto& b) { return b.name == name; });
  return {.kind = beam ? PartKind::beam : PartKind::mast, .name = name};
}

std::vector<Part> exempt_parts(const ChecksRequest& request, const machine::Machine& machine) {
  std::vector<Part> parts;
  if (request.exempt.empty()) return parts;
  const NamedParts all(request, machine);
  for (const std::string& text : request.exempt) {
    const std::vector<NamedPart> found = all.find(text);
    if (words_of(found).size() != 1) continue;
    for (const NamedPart& one : found) parts.push_back(one.part);
  }
  return parts;
}

/// A misspelt name would take nothing out, and page 1 would name what the machine has not. One of several parts would
/// take out more than the deck means.
void complain_of_exempt(const ChecksRequest& request, const machine::Machine& machine,
                        std::vector<Complaint>& complaints) {
  if (request.exempt.empty()) return;
  const NamedParts all(request, machine);
  for (std::size_t i = 0; i < request.exempt.size(); ++i) {
    const std::string& text = request.exempt[i];
    const std::string path = fmt::format("checks.exempt[{}]", i);
    const std::vector<std::string> words = words_of(all.find(text));
    if (words.empty())
      complaints.push_back(
          {path, fmt::format("the machine has no part '{}'{}", text, did_you_mean(text, all.names()))});
    if (words.size() < 2) continue;
    std::vector<std::string> each;
    each.reserve(words.size());
    for (const std::string& word : words) each.push_back(fmt::format("'{} {}'", word, text));
    complaints.push_back({path, fmt::format("several parts are called '{}': a {}; say which one: {}", text,
                                            fmt::join(words, ", a "), fmt::join(each, ", "))});
  }
}

}  // namespace taut::checks
