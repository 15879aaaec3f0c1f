#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "taut/calc/answers.hpp"
#include "taut/calc/none.hpp"
#include "taut/calc/quantity.hpp"
#include "taut/checks/checked_parts.hpp"
#include "taut/math/index.hpp"
#include "taut/results/analyses/analyses.hpp"
#include "taut/results/answers/line_profile.hpp"
#include "taut/results/described.hpp"
#include "taut/results/load_path_table.hpp"
#include "taut/study/deck/missing.hpp"
#include "taut/study/deck/watch.hpp"
#include "taut/study/line/carriage_way.hpp"
#include "taut/units/display.hpp"

namespace taut::results {
namespace {

/// A support of a rope at which a limit counts, as columns name it.
std::string support_name(const machine::Model& model, const study::LimitState& limit) {
  const machine::Reeving& rope = model.reevings[*limit.reeving];
  return fmt::format("{}.{}.", rope.name, rope.nodes[*limit.node].name);
}

/// The angle of each support that `least_break_angle` limits, which is not all of the rope's bend there: by the prefix
/// of its column, and by place.
std::map<std::string, std::vector<double>> held_angles(const study::PayloadRun& run) {
  std::map<std::string, std::vector<double>> all;
  for (std::size_t i = 0; i < run.positions.size(); ++i) {
    const study::PayloadPosition& p = run.positions[i];
    if (!p.answered()) continue;
    for (const study::LimitState& limit : p.states) {
      if (limit.kind != study::LimitKind::least_break_angle) continue;
      std::vector<double>& angles = all[support_name(*p.model, limit)];
      angles.resize(run.positions.size(), none);
      angles[i] = limit.value;
    }
  }
  return all;
}

Table payload_table(const machine::Model& model, const study::PayloadRun& run) {
  constexpr std::ptrdiff_t behind_place = 3;  // x, z, clearance
  Table t{.name = "payload" + run.ending,
          .title = fmt::format("Payload within the limits, {}", run.words),
          .columns = load_path_columns(model),
          .rows = {}};
  std::vector<Column> own;
  add_columns(own, study::payload_quantities());
  const auto held = held_angles(run);
  for (const auto& [support, angles] : held) add_columns(own, prefixed(support, {held_angle_words()}));
  t.columns.insert(t.columns.begin() + behind_place, own.begin(), own.end());
  for (std::size_t i = 0; i < run.positions.size(); ++i) {
    const study::PayloadPosition& p = run.positions[i];
    std::vector<Cell> row = {p.point.x, none, none};
    if (p.answered()) {
      row = load_path_cells(
          {.all = model,
           .model = *p.model,
           .point = {.x = p.point.x, .z = p.point.z, .clearance = p.point.clearance, .at = p.point.payload.at}});
    }
    std::vector<Cell> cells;
    add_cells(cells, study::payload_quantities(), p);
    for (const auto& [support, angles] : held) cells.emplace_back(angles[i]);
    row.insert(row.begin() + behind_place, cells.begin(), cells.end());
    row.resize(t.columns.size(), none);
    t.rows.push_back(std::move(row));
  }
  return t;
}

/// The machine with what it carries there.
machine::Model loaded(const study::PayloadRun& run, const study::PayloadPosition& place) {
  machine::Model model = *place.model;
  model.bodies[model.carriages[run.way.carriage].body].mass += place.point.payload.mass;
  return model;
}

/// The line with the carriage where the payload is least, and the payload by place with the limit that governs.
Profile payload_profile(const MachineRun& machine, const study::PayloadRun& run, const study::PayloadPosition& least) {
  const study::Payload& worst = least.point.payload;
  Profile p = line_profile({.model = *least.model, .state = worst.at, .way = run.way});
  p.name = "payload_profile" + run.ending;
  p.title = fmt::format("The line and what it carries (motion: {})", run.words);
  p.caption = fmt::format("Drawn where the payload is least, {} at x = {}.",
                          machine.display.brief(worst.mass, si::kg.in("t"), Rounding::down),
                          machine.display.brief(least.point.x, si::m));
  if (std::isfinite(run.limits.clearance)) p.clearance = run.limits.clearance;
  p.value = {.label = "payload", .unit = si::kg.in("t")};
  for (const study::PayloadPosition& one : run.positions) {
    if (&one == &least) p.decisive = p.places.size();
    const bool known = one.answered();
    p.places.push_back({.x = one.point.x,
                        .z = known ? lowest(one.point.payload.at, least.model->carriages[run.way.carriage].body) : none,
                        .ground = known ? one.point.z - one.point.clearance : none,
                        .value = known ? one.point.payload.mass : none,
                        .governs = known ? one.point.payload.governing : std::string()});
  }
  sort_places(p);
  return p;
}

/// A limit that is exceeded without payload, and where.
struct NothingCarried {
  std::string limit;
  std::string where;  ///< "from x = 12 m to 22 m, at x = 40 m"
  std::size_t places = 0;
};

/// Where a payload is least, by all places and by those alone that carry something.
struct LeastPayload {
  const study::PayloadPosition* of_all = nullptr;
  const study::PayloadPosition* of_some = nullptr;  ///< nullptr: nothing is carried anywhere
  std::size_t answered = 0;
};

LeastPayload least_payload(const study::PayloadRun& run) {
  LeastPayload least;
  const auto less = [](const study::PayloadPosition& one, const study::PayloadPosition* than) {
    return than == nullptr || one.point.payload.mass < than->point.payload.mass;
  };
  for (const study::PayloadPosition& one : run.positions) {
    if (!one.answered()) continue;
    ++least.answered;
    if (less(one, least.of_all)) least.of_all = &one;
    if (one.point.payload.outcome.ok() && less(one, least.of_some)) least.of_some = &one;
  }
  return least;
}

/// "2.96 t or more, least at x = 169 m; governed by tension of 'skyline'".
std::string payload_words(const study::PayloadPosition& least, const Display& display) {
  return fmt::format("{} or more, least at x = {}; governed by {}",
                     display.brief(least.point.payload.mass, si::kg.in("t"), Rounding::down),
                     display.brief(least.point.x, si::m), least.point.payload.governing);
}

/// What the deck has put on the carriage besides, "1.5 t"; empty: nothing.
std::string load_besides(const machine::Model& model, const study::PayloadRun& run, const Display& display) {
  double weight = 0;
  for (const machine::Load& load : model.loads) {
    if (load.at.body == model.carriages[run.way.carriage].body) weight -= load.force.z();
  }
  return weight > 0 ? display.brief(weight / model.gravity, si::kg.in("t")) : std::string();
}

void add_carried(const MachineRun& machine, const study::PayloadRun& run, const LeastPayload& least,
                 const std::vector<NothingCarried>& nothing, Result& r) {
  std::vector<std::string> parts;
  parts.reserve(nothing.size() + 1);
  for (const NothingCarried& one : nothing) parts.push_back(fmt::format("nothing {} ({})", one.where, one.limit));
  if (least.of_some != nullptr) {
    parts.push_back((nothing.empty() ? "" : "elsewhere ") + payload_words(*least.of_some, machine.display));
  }
  const auto places = static_cast<std::size_t>(
      std::count_if(run.positions.begin(), run.positions.end(), [](const auto& one) { return one.support.empty(); }));
  if (least.answered < places)
    parts.push_back(fmt::format("at {} of {} places; the others have no answer", least.answered, places));
  const std::string besides = load_besides(machine.model, run, machine.display);
  if (!besides.empty()) parts.push_back(fmt::format("on top of the {} that the deck hangs on the carriage", besides));
  if (!machine.checked->judged) parts.emplace_back(checks::not_judged_words);
  if (!run.ending.empty()) parts.front() = fmt::format("{}: {}", run.ending.substr(1), parts.front());
  add_answer_line(r, carries_label, parts);
}

/// How much of each limit is used; lengths are left to the clearance's own column.
Plot used_plot(const machine::Model& model, const study::PayloadRun& run) {
  Plot p;
  p.name = "payload_limits" + run.ending;
  p.title = fmt::format("Tensions and pulls over their limits with the payload, {}", run.words);
  p.x = {.label = "x of the carriage", .unit = si::m};
  p.y = {.label = "value / limit", .unit = si::one};
  std::map<std::string, Curve> curves;
  const int body = model.carriages[run.way.carriage].body;
  for (const study::PayloadPosition& one : run.positions) {
    for (const study::LimitState& state : one.states) {
      if (state.kind != study::LimitKind::tension && state.kind != study::LimitKind::pull) continue;
      curves[study::limit_words(*one.model, body, state)];
    }
  }
  for (auto& [words, curve] : curves) {
    curve.label = words;
    for (const study::PayloadPosition& one : run.positions) {
      const auto same =
          std::find_if(one.states.begin(), one.states.end(), [&, &sought = words](const study::LimitState& s) {
            return !s.fails && study::limit_words(*one.model, body, s) == sought;
          });
      curve.x.push_back(one.point.x);
      curve.y.push_back(same == one.states.end() ? none : same->value / same->limit);
    }
    p.curves.push_back(curve);
  }
  p.marks.push_back({0, 1, "limit", true});
  return p;
}

/// The payload is put on the carriage. What hangs on it by a rope of its own does not carry it there.
void add_hung(const machine::Model& model, const study::PayloadRun& run, Result& r) {
  const machine::Carriage& car = model.carriages[run.way.carriage];
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    const auto& nodes = model.reevings[i].nodes;
    const auto last = static_cast<int>(nodes.size()) - 1;
    for (int n = 0; n < last; ++n) {
      const auto hung = study::hung_on(model, car, static_cast<int>(i), n, n + 1);
      if (!hung) continue;
      const AboutPart about(r, {.kind = PartKind::rope, .name = model.reevings[i].name});
      r.unmade.push_back(fmt::format(
          "payload{}: it is put on '{}', and '{}' that hangs '{}' there does not carry it: its strength is not judged "
          "with it; put the load on '{}' in an equilibrium or an envelope, or leave the rope out",
          run.ending, car.name, model.reevings[i].name, model.bodies[*hung].name, model.bodies[*hung].name));
      r.warnings.push_back(r.unmade.back());
      break;
    }
  }
}

/// Sheaves hold their rope; a limit of the angle counts at supports that it could leave.
void add_bends_on_sheaves(const MachineRun& machine, const study::PayloadRun& run, Result& r) {
  if (!std::isfinite(run.limits.break_angle)) return;
  std::map<std::string, double> most;
  const int rope = machine.model.carriages[run.way.carriage].reeving;
  for (const study::PayloadPosition& one : run.positions) {
    if (!one.answered()) continue;
    for (const solve::ContactResult& c : one.point.payload.at.contacts) {
      const machine::Node& node = one.model->reevings[c.reeving].nodes[c.node];
      const bool counts = node.support != Vector3::Zero() || machine::is_saddle(node);
      if (c.reeving != rope || counts || machine::rides(*one.model, node)) continue;
      double& angle = most[node.name];
      angle = std::max(angle, c.turning);
    }
  }
  for (const auto& [name, angle] : most) {
    if (angle <= run.limits.break_angle) continue;
    const AboutPart about(r, {.kind = PartKind::sheave, .name = name});
    warn_unsafe(r,
                fmt::format("payload{}: 'break_angle' does not count at sheave '{}', over which the rope bends by up "
                            "to {}: give it 'uplift: report' to count it",
                            run.ending, name, machine.display.brief(angle, si::rad)));
  }
}

/// Where a rope has to be clear of the ground and hangs slack, without mass.
void add_slack(const machine::Model& model, const study::PayloadRun& run, const Display& display, Result& r) {
  std::set<int> told;
  for (const study::PayloadPosition& one : run.positions) {
    if (!one.answered()) continue;
    for (const solve::BranchResult& branch : one.point.payload.at.branches) {
      if (!branch.slack || !std::isfinite(run.limits.rope_clearance[as_size(branch.reeving)])) continue;
      if (!told.insert(branch.reeving).second) continue;
      const AboutPart about(r, {.kind = PartKind::rope, .name = model.reevings[branch.reeving].name});
      r.unmade.push_back(
          checks::slack_words(model.reevings[branch.reeving].name,
                              fmt::format("payload{}, x = {}", run.ending, display.brief(one.point.x, si::m))));
      r.warnings.push_back(r.unmade.back());
    }
  }
}

/// Where a clearance is asked and the terrain does not reach the carriage or the rope.
void add_gaps(const machine::Model& model, const study::PayloadRun& run, const Display& display, Result& r) {
  const auto worse = [](study::TerrainGap& worst, const study::TerrainGap& gap) {
    if (gap.missing() > worst.missing()) worst = gap;
  };
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  std::vector<study::TerrainGap> ropes(model.reevings.size());
  for (const study::PayloadPosition& one : run.positions) {
    if (!one.answered()) continue;
    const auto& state = one.point.payload.at;
    const Vector3& place = state.state.bodies[one.model->carriages[run.way.carriage].body].position;
    low = std::min(low, terrain_x(model, place));
    high = std::max(high, terrain_x(model, place));
    for (std::size_t i = 0; i < ropes.size(); ++i) {
      if (!std::isfinite(run.limits.rope_clearance[i])) continue;
      worse(ropes[i], study::terrain_gap(*one.model, state.branches, static_cast<int>(i), run.limits.rope_between));
    }
  }
  const auto tell = [&](const Part& part, const study::TerrainGap& gap) {
    if (!(gap.missing() > 0)) return;
    const AboutPart about(r, part);
    r.unmade.push_back(checks::gap_words(part.name, gap, display));
    r.warnings.push_back(r.unmade.back());
  };
  if (std::isfinite(run.limits.clearance) && low <= high) {
    tell({.kind = PartKind::carriage, .name = model.carriages[run.way.carriage].name},
         study::terrain_gap(model, low, high));
  }
  for (std::size_t i = 0; i < ropes.size(); ++i) {
    tell({.kind = PartKind::rope, .name = model.reevings[i].name}, ropes[i]);
  }
}

/// Neighbouring places at which the same limit is exceeded without payload.
struct Stretch {
  double from = 0, to = 0;  ///< m
  std::size_t places = 0;
};

/// By limit. A place that carries, that has no answer or where another limit governs ends a stretch; one on a support,
/// which has no answer of its own, does not.
std::map<std::string, std::vector<Stretch>> nothing_by_limit(const study::PayloadRun& run) {
  std::map<std::string, std::vector<Stretch>> all;
  std::string last;  // the limit of the place before
  for (const study::PayloadPosition& one : run.positions) {
    if (!one.support.empty()) continue;
    const bool nothing = one.answered() && !one.point.payload.outcome.ok();
    const std::string limit = nothing ? one.point.payload.governing : std::string();
    if (nothing) {
      std::vector<Stretch>& own = all[limit];
      if (own.empty() || limit != last) own.push_back({.from = one.point.x, .to = one.point.x});
      own.back().to = one.point.x;
      ++own.back().places;
    }
    last = limit;
  }
  return all;
}

/// "from x = 12 m to 22 m, at x = 40 m and on 3 more stretches".
std::string where_words(const std::vector<Stretch>& stretches, const Display& display) {
  constexpr std::size_t most_stretches = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(most_stretches, stretches.size()); ++i) {
    const Stretch& one = stretches[i];
    const std::string low = display.brief(std::min(one.from, one.to), si::m),
                      high = display.brief(std::max(one.from, one.to), si::m);
    text += i > 0 ? ", " : "";
    text += one.places == 1 ? "at x = " + low : fmt::format("from x = {} to {}", low, high);
  }
  if (stretches.size() <= most_stretches) return text;
  const std::size_t more = stretches.size() - most_stretches;
  return text + fmt::format(" and on {} more stretch{}", more, more == 1 ? "" : "es");
}

/// Where a limit is exceeded without payload: warnings, and checks that fail.
std::vector<NothingCarried> add_nothing(const MachineRun& machine, const study::PayloadRun& run, Result& r) {
  std::vector<NothingCarried> all;
  for (const auto& [limit, stretches] : nothing_by_limit(run)) {
    const auto places = std::accumulate(stretches.begin(), stretches.end(), std::size_t{0},
                                        [](std::size_t sum, const Stretch& one) { return sum + one.places; });
    all.push_back({.limit = limit, .where = where_words(stretches, machine.display), .places = places});
    const std::string words = fmt::format(
        "nothing can be carried {} ({} place{}): without any payload the limit is exceeded already: {}; raise the "
        "line, give it more rope or a stronger one",
        all.back().where, places, places == 1 ? "" : "s", limit);
    r.warnings.push_back("payload: " + words);
    if (!machine.checked->judged) continue;
    Check c = make_check("payload_min" + run.ending, 0, si::kg.in("t"),
                         {.sense = Sense::at_least, .limit = 0, .rule = words, .trust = "user"});
    c.utilisation = none;
    c.passes = false;
    c.part = machine.model.carriages[run.way.carriage].name;
    c.kind = PartKind::carriage;
    r.checks.push_back(std::move(c));
  }
  return all;
}

void add_results(MachineRun& machine, const study::PayloadRun& run, Result& r) {
  study::Missing missing;
  if (const auto words = study::left_out_words(machine.model, run.way, machine.display)) {
    r.warnings.push_back(fmt::format("payload{}, {}: {}", run.ending, run.words, *words));
  }
  for (const study::PayloadPosition& one : run.positions) {
    const std::string where = "payload, x = " + machine.display.brief(one.point.x, si::m);
    if (!one.support.empty()) {
      r.warnings.push_back(fmt::format("{}: the carriage is on '{}': left out", where, one.support));
      continue;
    }
    missing.take(one.answered() ? Outcome() : one.point.payload.outcome, one.point.x, machine.display);
    if (!one.answered()) continue;
    machine.checked->take(loaded(run, one), one.point.payload.at, where, checks::analysis_name(run.ending, "payload"));
  }
  const std::vector<NothingCarried> nothing = add_nothing(machine, run, r);
  missing.note(r, fmt::format("payload{}, {}", run.ending, run.words), machine.checked->judged);
  const LeastPayload least = least_payload(run);
  if (least.of_all == nullptr) return;
  add_carried(machine, run, least, nothing, r);
  const study::Payload& worst = least.of_all->point.payload;
  const ValueKind& carried = named(value_kinds(), "payload_min");
  r.values.push_back(make_value(carried, "", run.ending, worst.mass,
                                fmt::format("{} ({}); governs: {}", carried.about.words, run.words, worst.governing)));
  const bool judged = machine.checked->judged;
  if (judged && (!machine.least_carried || worst.mass < *machine.least_carried)) {
    machine.least_carried = worst.mass;
    r.headline = "carries " + payload_words(*least.of_all, machine.display);
  }
  const ValueKind& place = named(value_kinds(), "payload_min_x");
  r.values.push_back(make_value(place, "", run.ending, least.of_all->point.x, place.about.words));
  r.tables.push_back(payload_table(machine.model, run));
  if (judged) add_gaps(machine.model, run, machine.display, r);
  if (judged) add_slack(machine.model, run, machine.display, r);
  if (judged) add_hung(machine.model, run, r);
  if (judged) add_bends_on_sheaves(machine, run, r);
  if (run.positions.size() > 1) {
    Profile profile = payload_profile(machine, run, *least.of_all);
    machine.key_figure.offer(Pictured::payload, profile.name, judged);
    r.figures.emplace_back(std::move(profile));
    Plot used = used_plot(machine.model, run);
    if (!used.curves.empty()) r.figures.emplace_back(std::move(used));
  }
  machine.others.push_back(
      {fmt::format("least payload, {} at x = {}", machine.display.brief(worst.mass, si::kg.in("t"), Rounding::down),
                   machine.display.brief(least.of_all->point.x, si::m)),
       loaded(run, *least.of_all), worst.at});
}

}  // namespace

QuantityWords held_angle_words() {
  return {.name = "least_break_angle",
          .symbol = "",
          .unit = si::rad,
          .words = "angle by which the rope is bent onto the support, where 'least_break_angle' limits it"};
}

void add_answer(const study::PayloadRun& asked, MachineRun& machine, Result& r) {
  study::PayloadRun run = asked;
  study::Watch watch(machine.progress, "payload" + run.ending, run.way.steps + 1, machine.display);
  study::solve(machine.model, run, watch);
  machine.checked->payloads.begin(run.ending);
  add_results(machine, run, r);
  machine.checked->payloads.end();
  watch.note(r);
}

}  // namespace taut::results
