#include "taut/checks/anchor/support_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "taut/base/suggest.hpp"
#include "taut/calc/none.hpp"
#include "taut/catalogue/forestry/tree.hpp"
#include "taut/checks/anchor/rope_ends.hpp"
#include "taut/checks/described.hpp"
#include "taut/checks/guy/guy_checks.hpp"
#include "taut/study/load_path.hpp"

namespace taut::checks {
namespace {

/// From the axis of the trunk: beyond, a force bends the tree more than it presses it.
constexpr double most_lean = std::numbers::pi / 4;

/// Rounds that no carriage is, and the ends of ropes.
std::vector<std::string> pulled_places(const machine::Model& model, bool ends) {
  std::vector<std::string> names;
  for (const machine::Reeving& rope : model.reevings) {
    for (std::size_t i = 0; i < rope.nodes.size(); ++i) {
      const machine::Node& node = rope.nodes[i];
      const bool is_end = !rope.closed && (i == 0 || i + 1 == rope.nodes.size());
      const bool round = node.kind == machine::NodeKind::contact || node.kind == machine::NodeKind::drive;
      if (machine::rides(model, node) || (!round && !(ends && is_end))) continue;
      if (std::find(names.begin(), names.end(), node.name) == names.end()) names.push_back(node.name);
    }
  }
  return names;
}

/// Force of all ropes on a place: over it, and ending at it.
Vector3 force_at(const CheckState& state, const std::string& name) {
  Vector3 F = Vector3::Zero();
  each_pull_at(state, name, [&](const RopePull& pull) { F += pull.force; });
  return F;
}

/// How the deck places a support or sheave by its height over the ground; nullptr: it gives x, y, z.
const machine::PlaceOverGround* place_over_ground(const machine::Model& model, const std::string& name) {
  const auto& all = model.over_ground;
  const auto place = std::find_if(all.begin(), all.end(), [&](const machine::PlaceOverGround& one) {
    return one.name == name && (one.kind == "support" || one.kind == "sheave" || one.kind == "drum");
  });
  return place == all.end() ? nullptr : &*place;
}

/// Of the saddle: along its trunk where the deck gives that, else vertically over the terrain; NaN where there is none.
double height_over_ground(const CheckState& state, const std::string& name) {
  if (const machine::PlaceOverGround* place = place_over_ground(*state.model, name)) return place->over_ground;
  for (const CheckContact& c : state.contacts) {
    if (state.model->reevings[c.reeving].nodes[c.node].name != name) continue;
    return c.place.z() - study::ground_height(state.model->terrain, machine::terrain_x(*state.model, c.place));
  }
  return none;
}

double lashing_height(const SupportStates& s) { return s.height + s.request->lashing; }

/// At the lashing; empty beyond the table, where the height is not known, and where the ropes pull upwards or sideways.
std::optional<double> lashing_diameter(const SupportStates& s) {
  const bool along_trunk = s.upwards.empty() && s.sideways.empty();
  if (std::isnan(s.height) || !along_trunk) return std::nullopt;
  return catalogue::support_tree_diameter(s.force, std::max(lashing_height(s), 0.0));
}

std::optional<double> tree_diameter(const SupportStates& s) {
  const auto diameter = lashing_diameter(s);
  if (!diameter) return std::nullopt;
  return catalogue::breast_height_diameter(*diameter, lashing_height(s));
}

/// Angle of the force from the vertical, downwards 0.
double lean_of(const Vector3& F) { return std::atan2(std::hypot(F.x(), F.y()), -F.z()); }

/// Unit vector from the foot to the saddle. A trunk of which the deck does not say that it leans stands upright.
Vector3 trunk_of(const machine::Model& model, double lean) {
  return std::sin(lean) * model.terrain_along + std::cos(lean) * Vector3::UnitZ();
}

/// Angle of the force from the axis of the trunk, towards its foot 0.
double angle_from_trunk(const Vector3& F, const Vector3& trunk) {
  const double up = F.dot(trunk);
  return std::atan2((F - up * trunk).norm(), -up);
}

const Quantities<SupportStates>& support_quantities() {
  using Row = SupportStates;
  static const Quantities<Row> all = {
      {"name", "", si::one, "the saddle or sheave on the tree", [](const Row& s) { return s.request->name; }},
      {"force", "F", si::N, "largest force of all ropes on the tree together, without factors",
       [](const Row& s) { return s.pull.norm(); }},
      {"lean", "", si::rad, "its angle from the vertical", [](const Row& s) { return lean_of(s.pull); }},
      {"height", "h", si::m, "height of the saddle over the ground", &Row::height},
      {"lashing_diameter", "", si::m.in("cm"), "diameter needed at the lashing, by force and height",
       [](const Row& s) { return lashing_diameter(s).value_or(none); }},
      {"tree_diameter", "", si::m.in("cm"), "the same at breast height: 1 cm more for each metre down",
       [](const Row& s) { return tree_diameter(s).value_or(none); }},
      {"where", "", si::one, "state in which that is", &Row::where}};
  return all;
}

std::string force_words(const SupportStates& s) {
  return fmt::format("force {} ({}), lashing at {}", s.display.brief(s.force, si::N), with_factor(s.where, s.factor),
                     s.display.brief(lashing_height(s), si::m));
}

/// Why there is no diameter.
std::string why_none(const SupportStates& s) {
  if (!s.upwards.empty())
    return fmt::format("its ropes pull it upwards ({}), and the table is one of trees that are pressed", s.upwards);
  if (!s.sideways.empty()) {
    const std::string than = s.trunk_lean == 0 ? "downwards"
                                               : fmt::format("along its trunk, which leans by {},",
                                                             s.display.brief(std::abs(s.trunk_lean), si::rad));
    return fmt::format("its ropes pull it more sideways than {} ({}), and the table is one of forces along the trunk",
                       than, s.sideways);
  }
  if (std::isnan(s.height)) return "its height over the ground is not known: give 'height'";
  return fmt::format("beyond the table of support trees: {}", force_words(s));
}

void check_tree(const SupportStates& s, Result& r) {
  const std::string& name = s.request->name;
  const auto needed = tree_diameter(s);
  const auto diameter = [&](double x) { return s.display.brief(x, si::m.in("cm")); };
  if (needed) {
    r.values.push_back(
        make_value(named(value_kinds(), "SUPPORT.tree_diameter"), name, "", *needed,
                   fmt::format("diameter of the tree at breast height that carries {}, by force and height: {}", name,
                               force_words(s))));
  }
  if (!s.request->tree_diameter) return;
  if (!needed) {
    r.unmade.push_back(
        fmt::format("{}: its tree of {} is not judged: {}", name, diameter(*s.request->tree_diameter), why_none(s)));
    r.warnings.push_back(r.unmade.back());
    return;
  }
  add_part_check(name, "support_tree", *s.request->tree_diameter, si::m.in("cm"),
                 {.sense = Sense::at_least,
                  .limit = *needed,
                  .rule = fmt::format("diameter at breast height; {}; the table gives {} there (SEILAPLAN), and "
                                      "1 cm more for each metre down; it holds for a force along the trunk",
                                      force_words(s), diameter(*lashing_diameter(s))),
                  .trust = "derived"},
                 r);
}

}  // namespace

TableWords support_words() {
  return {.name = "support_forces",
          .rows = "every support of `checks: supports:`",
          .columns = words_of(support_quantities())};
}

std::vector<SupportStates> support_states(const std::vector<SupportCheckRequest>& supports) {
  std::vector<SupportStates> all;
  for (const SupportCheckRequest& one : supports) all.emplace_back().request = &one;
  return all;
}

void take(const CheckState& state, SupportStates& support) {
  const SupportCheckRequest& request = *support.request;
  const double factor = state.moves ? 1 : request.dynamic_factor;
  Vector3 F = force_at(state, request.name);
  for (const std::string& other : request.with) F += force_at(state, other);
  if (F.z() > 0 && support.upwards.empty()) support.upwards = state.words;
  const machine::PlaceOverGround* place = place_over_ground(*state.model, request.name);
  const double trunk_lean = place == nullptr ? 0 : place->lean;
  const bool sideways = F != Vector3::Zero() && angle_from_trunk(F, trunk_of(*state.model, trunk_lean)) > most_lean;
  if (sideways && support.sideways.empty()) {
    support.sideways = state.words;
    support.trunk_lean = trunk_lean;
  }
  if (factor * F.norm() <= support.force) return;
  support.force = factor * F.norm();
  support.pull = F;
  support.factor = factor;
  support.where = state.words;
  support.height = request.height ? *request.height : height_over_ground(state, request.name);
}

void complain_of_supports(const std::vector<SupportCheckRequest>& supports, const machine::Model& model,
                          std::vector<Complaint>& complaints) {
  const std::vector<std::string> rounds = pulled_places(model, false), places = pulled_places(model, true);
  const auto missing = [](const std::string& name, const std::vector<std::string>& known) {
    return std::find(known.begin(), known.end(), name) == known.end();
  };
  for (const SupportCheckRequest& one : supports) {
    const std::string path = fmt::format("checks.supports.{}", one.name);
    if (missing(one.name, rounds)) {
      complaints.push_back({path, fmt::format("no rope runs over a support or sheave '{}'{}", one.name,
                                              did_you_mean(one.name, rounds))});
      continue;
    }
    for (std::size_t i = 0; i < one.with.size(); ++i) {
      if (!missing(one.with[i], places)) continue;
      complaints.push_back(
          {fmt::format("{}.with[{}]", path, i),
           fmt::format("no rope runs over '{}' or ends there{}", one.with[i], did_you_mean(one.with[i], places))});
    }
    if (!one.height && model.terrain.empty())
      complaints.push_back({path, "the machine has no terrain: give the 'height' of the saddle over the ground"});
  }
}

void add_support_checks(const std::vector<SupportStates>& supports, Result& r) {
  for (const SupportStates& s : supports) {
    const std::string& name = s.request->name;
    const Part part = {.kind = PartKind::sheave, .name = name};
    const AboutPart about(r, part);
    if (s.force == 0) {
      leave_unmade(r, fmt::format("{} is not checked: no load case of the deck loads it", name),
                   {.part = part, .no_load = "support " + name});
      continue;
    }
    r.loaded.insert("support " + name);
    add_line(r, "support_forces",
             "Largest force of all ropes together on a support, without factors, and the tree that carries it",
             support_quantities(), s);
    check_tree(s, r);
  }
}

}  // namespace taut::checks
