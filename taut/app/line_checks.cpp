#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/app/guy_checks.hpp"
#include "taut/base/suggest.hpp"

namespace taut::app {
namespace {

const model::Reeving* line_named(const model::Model& model, const std::string& name) {
  const auto found =
      std::find_if(model.reevings.begin(), model.reevings.end(), [&](const auto& one) { return one.name == name; });
  return found == model.reevings.end() ? nullptr : &*found;
}

/// Supports of a line: contacts that no carriage is.
std::vector<std::string> supports_of(const model::Model& model, const model::Reeving& rope) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i + 1 < rope.nodes.size(); ++i) {
    const model::Node& node = rope.nodes[i];
    const bool rides = std::any_of(model.carriages.begin(), model.carriages.end(),
                                   [&](const auto& c) { return node.name.starts_with(c.name); });
    if (node.kind == model::NodeKind::contact && !rides) names.push_back(node.name);
  }
  return names;
}

double plan_angle(const Vector3& a, const Vector3& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y()));
}

/// One value over all states.
struct LineExtreme {
  double value = std::nan("");
  std::string where;
  void largest(double x, const std::string& words) {
    if (std::isnan(value) || x > value) *this = {x, words};
  }
  void least(double x, const std::string& words) {
    if (std::isnan(value) || x < value) *this = {x, words};
  }
};

/// The spans on both sides of a support: the one to the rope's end, and the one on the line's side.
struct Tail {
  const analysis::SpanResult* to_anchor = nullptr;
  const analysis::SpanResult* of_line = nullptr;
  bool at_end = true;  ///< of the path
};
std::optional<Tail> tail_at(const model::Model& m, const analysis::EquilibriumResult& e, const model::Reeving& rope,
                            const std::string& support) {
  const int last = static_cast<int>(rope.nodes.size()) - 1;
  Tail tail;
  for (const analysis::SpanResult& span : e.spans) {
    if (&m.reevings[static_cast<std::size_t>(span.reeving)] != &rope) continue;
    const auto& from = rope.nodes[static_cast<std::size_t>(span.from)].name;
    const auto& to = rope.nodes[static_cast<std::size_t>(span.to)].name;
    if (from == support && span.to == last) {
      tail.to_anchor = &span;
      tail.at_end = true;
    } else if (to == support && span.from == 0) {
      tail.to_anchor = &span;
      tail.at_end = false;
    }
  }
  if (tail.to_anchor == nullptr) return std::nullopt;
  for (const analysis::SpanResult& span : e.spans) {
    if (&m.reevings[static_cast<std::size_t>(span.reeving)] != &rope || &span == tail.to_anchor) continue;
    const int node = tail.at_end ? span.to : span.from;
    if (rope.nodes[static_cast<std::size_t>(node)].name == support) tail.of_line = &span;
  }
  return tail;
}

void check_tail(const LineCheckRequest& request, const MachineRun& run, Result& r) {
  LineExtreme angle, off;
  for (const Answer& a : answers_of(run)) {
    const auto tail = tail_at(*a.model, *a.result, *line_named(*a.model, request.name), *request.tail_tree);
    if (!tail) continue;
    const analysis::SpanResult& s = *tail->to_anchor;
    const double V = tail->at_end ? s.V_from : s.V_to;  // at the tree
    angle.largest(std::atan2(std::abs(V), s.H), a.words);
    if (tail->of_line != nullptr) {
      off.largest(plan_angle(s.end - s.start, tail->of_line->end - tail->of_line->start), a.words);
    }
  }
  const auto add = [&](const char* name, const LineExtreme& x, const std::optional<double>& own, const char* rule,
                       const char* words) {
    if (std::isnan(x.value)) return;
    RuleLimit limit = rule_limit(rule, false);
    if (own) limit = {*own, "the deck's own", "user"};
    add_part_check(request.name, name, x.value, Sense::at_most, limit.value, si::rad,
                   fmt::format("{} ({}); {}", words, x.where, limit.words), limit.trust, r);
  };
  add("tail_angle", angle, request.tail_angle, "layout.tail_tree_angle",
      "from the horizontal, between the tail tree and the anchor");
  add("anchor_off_line", off, request.off_line, "layout.anchor_off_line", "anchor against the line, seen from above");
}

void check_breaks(const LineCheckRequest& request, const MachineRun& run, Result& r) {
  for (const std::string& support : supports_of(run.model, *line_named(run.model, request.name))) {
    LineExtreme most, least;
    for (const Answer& a : answers_of(run)) {
      const model::Reeving& rope = *line_named(*a.model, request.name);
      for (const analysis::ContactResult& c : a.result->contacts) {
        if (&a.model->reevings[static_cast<std::size_t>(c.reeving)] != &rope) continue;
        if (rope.nodes[static_cast<std::size_t>(c.node)].name != support) continue;
        const bool lifts = c.state == analysis::ContactState::lifted || c.state == analysis::ContactState::pulled;
        most.largest(c.wrap, a.words);
        least.least(lifts ? -c.wrap : c.wrap, a.words);
      }
    }
    if (std::isnan(most.value)) continue;
    const auto& ends = request.end_masts;
    const bool end = std::find(ends.begin(), ends.end(), support) != ends.end();
    const RuleLimit high =
        rule_limit(end ? "layout.break_angle_loaded_end" : "layout.break_angle_loaded_support", false);
    const RuleLimit low =
        rule_limit(request.hold_down ? "layout.break_angle_hold_down" : "layout.break_angle_empty", true);
    add_part_check(request.name, support + ".break_angle", most.value, Sense::at_most, high.value, si::rad,
                   fmt::format("largest bend over '{}' ({}); {}", support, most.where, high.words), high.trust, r);
    add_part_check(request.name, support + ".least_break_angle", least.value, Sense::at_least, low.value, si::rad,
                   fmt::format("least bend over '{}', with the empty line among the states ({}); {}", support,
                               least.where, low.words),
                   low.trust, r);
  }
}

void check_rating(const LineCheckRequest& request, const model::Model& model, Result& r) {
  const double strength = request.breaking_force.value_or(line_named(model, request.name)->breaking_force);
  const char* trust = "verified";
  if (request.limiter) {
    add_part_check(request.name, "limiter", *request.limiter, Sense::at_most, *request.spar_rating, si::N,
                   fmt::format("tension limiter or line fuse against the rating on the spar's plate; the rope itself "
                               "breaks at {:.4g} kN (WAC 296-54-553)",
                               strength / 1e3),
                   trust, r);
    return;
  }
  add_part_check(request.name, "spar_rating", strength, Sense::at_most, *request.spar_rating, si::N,
                 "breaking force of the rope against the rating on the spar's plate, else a tension limiter or line "
                 "fuse (WAC 296-54-553)",
                 trust, r);
}

}  // namespace

void complain_of_lines(const std::vector<LineCheckRequest>& lines, const model::Model& model,
                       std::vector<Complaint>& complaints) {
  for (const LineCheckRequest& one : lines) {
    const std::string path = fmt::format("checks.lines.{}", one.name);
    const model::Reeving* rope = line_named(model, one.name);
    if (rope == nullptr) {
      std::vector<std::string> known;
      known.reserve(model.reevings.size());
      for (const model::Reeving& each : model.reevings) known.push_back(each.name);
      complaints.push_back({path, fmt::format("there is no reeving '{}'{}", one.name, did_you_mean(one.name, known))});
      continue;
    }
    const std::vector<std::string> supports = supports_of(model, *rope);
    const auto known = [&](const std::string& name) {
      return std::find(supports.begin(), supports.end(), name) != supports.end();
    };
    if (one.tail_tree &&
        (supports.empty() || (*one.tail_tree != supports.front() && *one.tail_tree != supports.back()))) {
      complaints.push_back(
          {path + ".tail_tree", fmt::format("'{}' is not the first or last support of '{}'{}", *one.tail_tree, one.name,
                                            did_you_mean(*one.tail_tree, supports))});
    }
    if (!one.tail_tree && (one.tail_angle || one.off_line)) {
      complaints.push_back({path, "'tail_angle' and 'off_line' need 'tail_tree'"});
    }
    for (std::size_t i = 0; i < one.end_masts.size(); ++i) {
      if (known(one.end_masts[i])) continue;
      complaints.push_back({fmt::format("{}.end_masts[{}]", path, i),
                            fmt::format("'{}' does not run over a support '{}'{}", one.name, one.end_masts[i],
                                        did_you_mean(one.end_masts[i], supports))});
    }
    if (one.limiter && !one.spar_rating) complaints.push_back({path + ".limiter", "needs 'spar_rating'"});
    if (one.spar_rating && !one.breaking_force && rope->breaking_force == 0) {
      complaints.push_back({path, "the rope's breaking force is not known: give 'breaking_force'"});
    }
  }
}

void add_line_checks(const std::vector<LineCheckRequest>& lines, const MachineRun& run, Result& r) {
  for (const LineCheckRequest& one : lines) {
    if (one.tail_tree) check_tail(one, run, r);
    if (one.break_angles) check_breaks(one, run, r);
    if (one.spar_rating) check_rating(one, run.model, r);
  }
}

}  // namespace taut::app
