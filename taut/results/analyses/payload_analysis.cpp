#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include "taut/base/suggest.hpp"
#include "taut/calc/none.hpp"
#include "taut/catalogue/rule.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/math/index.hpp"
#include "taut/results/analyses/machine_analysis.hpp"
#include "taut/results/machine_tables.hpp"
#include "taut/results/missing.hpp"
#include "taut/study/carriage_way.hpp"
#include "taut/study/payload.hpp"
#include "taut/study/watch.hpp"
#include "taut/units/display.hpp"

namespace taut::results {
namespace {

using study::LimitKind;
using study::LimitState;

/// A rule of the catalogue that a rope is checked by.
struct RopeRule {
  int reeving = 0;
  double factor = 1;
  const catalogue::RuleRow* row = nullptr;
};

/// A payload analysis with its names resolved, and its answer.
struct PayloadRun {
  std::string ending;
  std::string words;
  std::vector<study::MotionRequest> motion;
  study::Way way;
  bool one_place = false;
  bool held = false;
  study::PayloadLimits limits;
  std::vector<RopeRule> rules;
};

struct PayloadPosition {
  const machine::Model* model = nullptr;
  study::PayloadPoint point;
  std::vector<study::LimitState> states;  ///< of all limits with the payload
  std::string support;                    ///< on which it lies; else empty
};

struct Answers {
  std::vector<study::WayPart> parts;
  std::vector<PayloadPosition> positions;
};

/// Resolves the limits of one name.
class NamedLimit {
 public:
  NamedLimit(const study::RopeLimitRequest& request, std::string path, Preparation& p, PayloadRun& run)
      : request_(request), path_(std::move(path)), p_(p), run_(run) {}

  void resolve() {
    const auto& reevings = p_.model.reevings;
    const auto rope =
        std::find_if(reevings.begin(), reevings.end(), [&](const auto& one) { return one.name == request_.name; });
    const auto& drums = p_.machine.drums;
    const bool drum =
        std::any_of(drums.begin(), drums.end(), [&](const auto& one) { return one.name == request_.name; });
    if (rope != reevings.end()) {
      of_rope(static_cast<int>(rope - reevings.begin()));
    } else if (drum) {
      of_drum();
    } else {
      std::vector<std::string> names;
      names.reserve(reevings.size() + drums.size());
      for (const auto& one : reevings) names.push_back(one.name);
      for (const auto& one : drums) names.push_back(one.name);
      complain("",
               fmt::format("there is no rope and no drum '{}'{}", request_.name, did_you_mean(request_.name, names)));
    }
  }

 private:
  void complain(const std::string& key, std::string message) {
    p_.complaints.push_back({key.empty() ? path_ : path_ + "." + key, std::move(message)});
  }

  void of_rope(int reeving) {
    const machine::Reeving& rope = p_.model.reevings[reeving];
    if (request_.pull) complain("pull", "is a limit of a drum; a rope has 'tension'");
    if (!request_.tension && !request_.safety_factor && !request_.rule && !request_.clearance) {
      complain("", "says no limit: give tension, safety_factor, rule or clearance");
    }
    if ((request_.safety_factor || request_.rule) && rope.breaking_force <= 0) {
      complain(request_.safety_factor ? "safety_factor" : "rule",
               fmt::format("the breaking force of '{}' is not known: give its rope a 'breaking_force'", rope.name));
      return;
    }
    double most = request_.tension.value_or(std::numeric_limits<double>::infinity());
    if (request_.safety_factor) most = std::min(most, rope.breaking_force / *request_.safety_factor);
    if (request_.rule) most = by_rule(reeving, most);
    run_.limits.tension[reeving] = most;
    if (request_.clearance) run_.limits.rope_clearance[reeving] = *request_.clearance;
  }

  /// The limit, the rule's own where there is no other.
  double by_rule(int reeving, double most) {
    const auto row = catalogue::find_rule(*request_.rule);
    if (!row) {
      complain("rule", catalogue::to_text(row.error()));
      return most;
    }
    const auto factor = catalogue::value_of(*row);
    if (!row->id.starts_with("safety.") || row->unit != "1") {
      complain("rule", fmt::format("'{}' is not a safety factor; 'taut list rules --name safety' shows them", row->id));
    } else if (!factor) {
      complain("rule", fmt::format("{}; give a 'safety_factor' within it", factor.error().message));
    } else {
      const auto& table = catalogue::rules();
      const auto same = std::find_if(table.begin(), table.end(), [&](const auto& one) { return one.id == row->id; });
      run_.rules.push_back({reeving, *factor, &*same});
      if (std::isinf(most)) return p_.model.reevings[reeving].breaking_force / *factor;
    }
    return most;
  }

  void of_drum() {
    if (!request_.pull) complain("", "says no limit: a drum has 'pull'");
    for (const auto& [given, key] : {std::pair{request_.tension.has_value(), "tension"},
                                     {request_.safety_factor.has_value(), "safety_factor"},
                                     {request_.rule.has_value(), "rule"},
                                     {request_.clearance.has_value(), "clearance"}}) {
      if (given) complain(key, "is a limit of a rope; a drum has 'pull'");
    }
    bool winds = false;
    for (std::size_t r = 0; r < p_.model.reevings.size(); ++r) {
      const auto& nodes = p_.model.reevings[r].nodes;
      for (const bool at_end : {false, true}) {
        const machine::Node& node = at_end ? nodes.back() : nodes.front();
        if (node.kind != machine::NodeKind::anchor || node.name != request_.name) continue;
        winds = true;
        run_.limits.ends.push_back({static_cast<int>(r), at_end, request_.pull.value_or(1)});
      }
    }
    if (!winds) complain("", fmt::format("no rope is wound on '{}'", request_.name));
  }

  const study::RopeLimitRequest& request_;
  std::string path_;
  Preparation& p_;
  PayloadRun& run_;
};

void resolve_limits(const study::LimitsRequest& request, const std::string& path, Preparation& p, PayloadRun& run) {
  study::PayloadLimits& l = run.limits;
  l.tension.assign(p.model.reevings.size(), std::numeric_limits<double>::infinity());
  l.rope_clearance.assign(p.model.reevings.size(), -std::numeric_limits<double>::infinity());
  if (request.clearance) l.clearance = *request.clearance;
  if (request.break_angle) l.break_angle = *request.break_angle;
  if (request.least_break_angle) l.least_break_angle = *request.least_break_angle;
  l.lift_off = request.lift_off;
  l.rope_between = {run.way.along, run.way.from, run.way.to};
  if (request.rope_clearance && run.way.carriage >= 0) {
    l.rope_clearance[p.model.carriages[run.way.carriage].reeving] = *request.rope_clearance;
  }
  for (const study::RopeLimitRequest& one : request.named) {
    NamedLimit(one, fmt::format("{}.{}", path, one.name), p, run).resolve();
  }
  const auto needs_ground = [&](bool asked, const std::string& key) {
    if (asked && p.model.terrain.empty()) {
      p.complaints.push_back({path + "." + key, "there is no 'terrain' to be clear of"});
    }
  };
  needs_ground(request.clearance.has_value(), "clearance");
  needs_ground(request.rope_clearance.has_value(), "rope_clearance");
  for (const study::RopeLimitRequest& one : request.named)
    needs_ground(one.clearance.has_value(), one.name + ".clearance");
  const bool any = !request.named.empty() || request.clearance || request.rope_clearance || request.break_angle ||
                   request.least_break_angle || request.lift_off;
  if (!any) p.complaints.push_back({path, "say at least one limit, such as 'skyline: {safety_factor: 3}'"});
}

Answers solve(const machine::Model& model, const PayloadRun& run, study::Watch& watch) {
  Answers all;
  all.parts = study::parts_of(model, run.way);
  for (const study::WayPart& part : all.parts) {
    if (watch.ended()) break;
    if (part.support != nullptr) {
      PayloadPosition on;
      on.model = &part.model;
      on.support = part.support->name;
      on.point.x = run.way.x(part.first);
      all.positions.push_back(std::move(on));
      continue;
    }
    std::vector<Complaint> reported_before;
    study::LoadPathOptions options = study::path_over(run.way, part);
    options.equilibrium = study::options_of(run.motion, part.model, {}, reported_before);
    options.equilibrium.held = run.held;
    options.go_on = [&](double x) { return watch.go_on_at(x); };
    auto points = study::payload_path(part.model, run.limits, options);
    if (part.last == part.first && points.size() > 1) points.resize(1);
    const int body = part.model.carriages[run.way.carriage].body;
    for (auto& point : points) {
      PayloadPosition one;
      one.model = &part.model;
      one.point = std::move(point);
      one.states = study::limits_at(part.model, body, run.limits, one.point.payload.at);
      all.positions.push_back(std::move(one));
    }
  }
  if (run.one_place && all.positions.size() > 1) all.positions.resize(1);
  return all;
}

/// Positions with an equilibrium; where a limit is broken without payload it is 0.
bool answered(const PayloadPosition& p) { return p.support.empty() && p.point.payload.at.outcome.ok(); }

Table table_of(const machine::Model& model, const PayloadRun& run, const Answers& all) {
  Table t{
      "payload" + run.ending, fmt::format("Payload within the limits, {}", run.words), load_path_columns(model), {}};
  t.columns.insert(t.columns.begin() + 3, {{"payload", si::kg}, {"governing", si::one}});
  for (const PayloadPosition& p : all.positions) {
    std::vector<Cell> row = {p.point.x, none, none, none, std::string{}};
    if (answered(p)) {
      row = load_path_row(model, *p.model, {p.point.x, p.point.z, p.point.clearance, p.point.payload.at});
      row.insert(row.begin() + 3, {p.point.payload.mass, p.point.payload.governing});
    } else {
      row[4] = p.support.empty() ? p.point.payload.outcome.message : fmt::format("on '{}'", p.support);
    }
    row.resize(t.columns.size(), none);
    t.rows.push_back(std::move(row));
  }
  return t;
}

/// One curve for each limit that governs somewhere; where another takes over, its curve begins at the place before.
Plot payload_plot(const PayloadRun& run, const Answers& all) {
  Plot p;
  p.name = "payload_governing" + run.ending;
  p.title = fmt::format("Payload and the limit that governs, {}", run.words);
  p.x = {"x of the carriage", si::m};
  p.y = {"payload", si::kg.in("t")};
  std::vector<std::string> kinds;
  for (const PayloadPosition& one : all.positions) {
    const std::string& name = one.point.payload.governing;
    if (answered(one) && std::find(kinds.begin(), kinds.end(), name) == kinds.end()) kinds.push_back(name);
  }
  for (const std::string& kind : kinds) {
    Curve c;
    c.label = kind;
    for (std::size_t i = 0; i < all.positions.size(); ++i) {
      const PayloadPosition& one = all.positions[i];
      const bool next = i + 1 < all.positions.size() && answered(all.positions[i + 1]) &&
                        all.positions[i + 1].point.payload.governing == kind;
      c.x.push_back(one.point.x);
      c.y.push_back(answered(one) && (one.point.payload.governing == kind || next) ? one.point.payload.mass : none);
    }
    p.curves.push_back(std::move(c));
  }
  return p;
}

/// How much of each limit is used; lengths are left to the clearance's own column.
Plot used_plot(const machine::Model& model, const PayloadRun& run, const Answers& all) {
  Plot p;
  p.name = "payload_limits" + run.ending;
  p.title = fmt::format("Tensions and pulls over their limits with the payload, {}", run.words);
  p.x = {"x of the carriage", si::m};
  p.y = {"value / limit", si::one};
  std::map<std::string, Curve> curves;
  const int body = model.carriages[run.way.carriage].body;
  for (const PayloadPosition& one : all.positions) {
    for (const study::LimitState& state : one.states) {
      if (state.kind != study::LimitKind::tension && state.kind != study::LimitKind::pull) continue;
      curves[study::limit_words(*one.model, body, state)];
    }
  }
  for (auto& [words, curve] : curves) {
    curve.label = words;
    for (const PayloadPosition& one : all.positions) {
      const auto same = std::find_if(one.states.begin(), one.states.end(), [&](const study::LimitState& s) {
        return !s.fails && study::limit_words(*one.model, body, s) == words;
      });
      curve.x.push_back(one.point.x);
      curve.y.push_back(same == one.states.end() ? none : same->value / same->limit);
    }
    p.curves.push_back(curve);
  }
  p.marks.push_back({0, 1, "limit", true});
  return p;
}

/// Each rope with a limit of its tension, at its largest tension over all positions: against its rule, else against the
/// limit itself.
void add_limits(const machine::Model& model, const PayloadRun& run, const Answers& all, Result& r) {
  const auto add = [&](std::size_t reeving, double limit, std::string words, std::string trust) {
    double T = 0;
    for (const PayloadPosition& one : all.positions) {
      if (answered(one)) T = std::max(T, one.point.payload.at.ropes[reeving].T_max);
    }
    const std::string& name = model.reevings[reeving].name;
    r.checks.push_back(make_check(fmt::format("{}.payload_T_max{}", name, run.ending), T, si::N,
                                  {Sense::at_most, limit, std::move(words), std::move(trust)}));
    r.checks.back().part = name;
  };
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    const auto rule = std::find_if(run.rules.begin(), run.rules.end(),
                                   [&](const RopeRule& one) { return as_size(one.reeving) == i; });
    if (rule != run.rules.end()) {
      add(i, model.reevings[i].breaking_force / rule->factor,
          fmt::format("{}: {}, {}; safety factor {:.4g} on the breaking force; {}", rule->row->id, rule->row->field,
                      rule->row->item, rule->factor, rule->row->source),
          rule->row->trust_text);
    } else if (std::isfinite(run.limits.tension[i])) {
      add(i, run.limits.tension[i], "limit of the payload: the load is the largest one within it", "user");
    }
  }
}

/// Where a clearance is asked and the terrain does not reach the carriage or the rope.
void add_gaps(const machine::Model& model, const PayloadRun& run, const Answers& all, Result& r) {
  const auto worse = [](study::TerrainGap& worst, const study::TerrainGap& gap) {
    if (gap.missing() > worst.missing()) worst = gap;
  };
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  std::vector<study::TerrainGap> ropes(model.reevings.size());
  for (const PayloadPosition& one : all.positions) {
    if (!answered(one)) continue;
    const auto& state = one.point.payload.at;
    const Vector3& place = state.state.bodies[one.model->carriages[run.way.carriage].body].position;
    low = std::min(low, terrain_x(model, place));
    high = std::max(high, terrain_x(model, place));
    for (std::size_t i = 0; i < ropes.size(); ++i) {
      if (!std::isfinite(run.limits.rope_clearance[i])) continue;
      worse(ropes[i], study::terrain_gap(*one.model, state.spans, static_cast<int>(i), run.limits.rope_between));
    }
  }
  const auto tell = [&](const std::string& what, const study::TerrainGap& gap) {
    if (!(gap.missing() > 0)) return;
    r.unmade.push_back(checks::gap_words(what, gap));
    r.warnings.push_back(r.unmade.back());
  };
  if (std::isfinite(run.limits.clearance) && low <= high) {
    tell(model.carriages[run.way.carriage].name, study::terrain_gap(model, low, high));
  }
  for (std::size_t i = 0; i < ropes.size(); ++i) tell(model.reevings[i].name, ropes[i]);
}

void add_results(MachineRun& machine, const PayloadRun& run, Answers& all, Result& r) {
  const PayloadPosition* least = nullptr;
  std::map<std::string, std::vector<double>> nothing;  // where a limit is broken without payload
  Missing missing;
  for (const PayloadPosition& one : all.positions) {
    const std::string where = fmt::format("payload, x = {:.6g} m", one.point.x);
    if (!one.support.empty()) {
      r.warnings.push_back(fmt::format("{}: the carriage is on '{}': left out", where, one.support));
      continue;
    }
    missing.take(answered(one) ? Outcome() : one.point.payload.outcome, one.point.x);
    if (!answered(one)) continue;
    machine.checked->take(*one.model, one.point.payload.at, where, checks::analysis_name(run.ending, "payload"));
    if (!one.point.payload.outcome.ok()) nothing[one.point.payload.governing].push_back(one.point.x);
    if (least == nullptr || one.point.payload.mass < least->point.payload.mass) least = &one;
  }
  for (const auto& [limit, places] : nothing) {
    const auto [low, high] = std::minmax_element(places.begin(), places.end());
    const std::string span = places.size() == 1 ? fmt::format("at x = {:.6g} m", *low)
                                                : fmt::format("from x = {:.6g} m to {:.6g} m", *low, *high);
    const std::string words = fmt::format(
        "nothing can be carried {} ({} place{}): without any payload the limit is exceeded already: {}; raise the "
        "line, give it more rope or a stronger one",
        span, places.size(), places.size() == 1 ? "" : "s", limit);
    r.warnings.push_back("payload: " + words);
    if (!machine.checked->judged) continue;
    Check c = make_check("payload_min" + run.ending, 0, si::kg.in("t"), {Sense::at_least, 0, words, "user"});
    c.utilisation = none;
    c.passes = false;
    c.part = machine.model.carriages[run.way.carriage].name;
    r.checks.push_back(std::move(c));
  }
  missing.note(r, fmt::format("payload{}, {}", run.ending, run.words), machine.checked->judged);
  if (least == nullptr) return;
  const study::Payload& worst = least->point.payload;
  r.values.push_back({"payload_min" + run.ending,
                      worst.mass,
                      si::kg.in("t"),
                      "m_min",
                      fmt::format("least payload ({}); governs: {}", run.words, worst.governing),
                      {}});
  if (r.headline.empty()) {
    r.headline = fmt::format("carries {} or more, least at x = {:.6g} m; governed by {}",
                             Display().quantity(worst.mass, si::kg.in("t")), least->point.x, worst.governing);
  }
  r.values.push_back({"payload_min_x" + run.ending, least->point.x, si::m, "x", "where the payload is least", {}});
  r.tables.push_back(table_of(machine.model, run, all));
  add_limits(machine.model, run, all, r);
  if (machine.checked->judged) add_gaps(machine.model, run, all, r);
  Plot plot = payload_plot(run, all);
  plot.marks.push_back({least->point.x, worst.mass, "least", false});
  if (all.positions.size() > 1) {
    r.figures.emplace_back(std::move(plot));
    Plot used = used_plot(machine.model, run, all);
    if (!used.curves.empty()) r.figures.emplace_back(std::move(used));
  }
  machine.others.push_back(
      {fmt::format("least payload, {:.5g} kg at x = {:.6g} m", worst.mass, least->point.x), *least->model, worst.at});
}

}  // namespace

Analysis prepare_payload(const study::PayloadRequest& request, const std::string& path, Preparation& p) {
  const auto run = std::make_shared<PayloadRun>();
  run->ending = ending_of(p, "payload", request.name, path);
  run->words = words_of(request.motion);
  run->motion = request.motion;
  study::options_of(request.motion, p.model, path + ".motion", p.complaints);
  run->one_place = request.from == request.to;
  run->way = {carriage_of(p, request.carriage, path + ".carriage"), request.from, request.to,
              run->one_place ? 1 : request.steps, study::direction_of(request.along, path + ".along", p.complaints)};
  study::check_hold(p.model, run->way.carriage, p.complaints);
  run->limits.most = request.most;
  run->held = request.held;
  resolve_limits(request.limits, path + ".limits", p, *run);
  return [run](MachineRun& machine, Result& r) {
    study::Watch watch(machine.progress, "payload" + run->ending, run->way.steps + 1);
    Answers all = solve(machine.model, *run, watch);
    add_results(machine, *run, all, r);
    watch.note(r);
  };
}

}  // namespace taut::results
