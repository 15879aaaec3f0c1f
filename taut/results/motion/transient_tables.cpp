#include "taut/results/motion/transient_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/expects.hpp"
#include "taut/calc/shown.hpp"
#include "taut/catalogue/rule.hpp"
#include "taut/machine/links/observable.hpp"
#include "taut/results/described.hpp"
#include "taut/results/motion/straight_ropes.hpp"

namespace taut::results {
namespace {

/// One form of energy.
struct EnergyRow {
  std::string form;
  double at_start = 0, at_end = 0;  ///< J
};

const Quantities<EnergyRow>& energy_quantities() {
  using Row = EnergyRow;
  static const Quantities<Row> all = {{"form", "", si::one, "the form", &Row::form},
                                      {"at_start", "", si::J, "at the start of the motion", &Row::at_start},
                                      {"at_end", "", si::J, "at its end", &Row::at_end}};
  return all;
}

QuantityWords time_itself() {
  return {.name = machine::time_name, .symbol = "t", .unit = si::s, .words = "time since the start of the motion"};
}

void add_series(const study::TransientRun& run, Result& r) {
  Table t;
  t.name = "time" + run.ending;
  t.title = "Observed quantities over time";
  add_columns(t.columns, {time_itself()});
  for (const machine::Observable& o : run.model.observed) add_columns(t.columns, {observed_words(o.name, o.unit)});
  t.long_rows = run.record.lines();
  r.series.push_back(std::move(t));
}

void add_events(const study::TransientRun& run, const Display& display, Result& r) {
  Table events = make_table("events" + run.ending, "Events", study::event_quantities(), run.result.events);
  for (std::size_t i = 0; i < events.rows.size(); ++i)
    events.rows[i].back() = study::values_in_words(run.result.events[i], display);
  r.tables.push_back(std::move(events));
}

/// An observable by its name; a length says what statics gives otherwise, at the reference temperature.
std::string told_of(const machine::Observable& o) {
  const bool length = o.quantity == machine::Observed::length || o.quantity == machine::Observed::branch_length;
  return length ? o.name + ", unstretched at its temperature" : o.name;
}

/// What a measure is in one number, under its own name.
void add_measure(const study::TransientRun& run, const machine::Observable& o, const solve::Extreme& e, Result& r) {
  using machine::description::Taken;
  if (o.taken == Taken::automatic) return;
  const auto [x, words] = o.taken == Taken::mean  ? std::pair{e.mean, "mean"}
                          : o.taken == Taken::min ? std::pair{e.min, "smallest value"}
                          : o.taken == Taken::max ? std::pair{e.max, "largest value"}
                                                  : std::pair{e.end, "value at the end"};
  if (std::isfinite(x)) {
    r.values.push_back(make_value(named(value_kinds(), "MEASURE"), o.name, run.ending, x,
                                  fmt::format("{} of {} ({})", words, o.name, words_of(run))));
    r.values.back().unit = o.unit;
  } else {
    r.warnings.push_back(
        fmt::format("{} has no value: the motion never comes to where it is taken ({})", o.name, words_of(run)));
  }
}

void add_envelope(const study::TransientRun& run, Result& r) {
  std::vector<study::ObservedRow> rows;
  for (std::size_t i = 0; i < run.result.extremes.size(); ++i) {
    rows.push_back({run, i});
    const machine::Observable& o = run.model.observed[i];
    const solve::Extreme& e = run.result.extremes[i];
    const auto value = [&](const char* name, double x, const char* when, double t) {
      if (!std::isfinite(x)) return;
      const ValueKind& kind = named(value_kinds(), name);  // a detail: the table of the envelope has them in one line
      r.values.push_back(
          make_value(kind, o.name, run.ending, x,
                     fmt::format("{}, {} {:.6g} s, of {} ({})", kind.about.words, when, t, told_of(o), words_of(run))));
      r.values.back().unit = o.unit;
    };
    value("OBSERVED_min", e.min, "at t =", e.t_min);
    value("OBSERVED_max", e.max, "at t =", e.t_max);
    value("OBSERVED_end", e.end, "t =", run.result.t_end);
    add_measure(run, o, e, r);
  }
  r.tables.push_back(make_table(run.envelope + run.ending, "Envelope: smallest and largest over all steps (SI)",
                                study::observed_quantities(), rows));
}

void add_energy(const study::TransientRun& run, Result& r) {
  const solve::EnergyLedger &first = run.result.frames.front().energy, &last = run.result.frames.back().energy;
  std::vector<EnergyRow> rows;
  const auto add = [&](const char* form, double solve::EnergyLedger::*part) {
    rows.push_back({.form = form, .at_start = first.*part, .at_end = last.*part});
  };
  add("kinetic", &solve::EnergyLedger::kinetic);
  add("elastic", &solve::EnergyLedger::elastic);
  add("potential", &solve::EnergyLedger::potential);
  add("supplied by drives", &solve::EnergyLedger::supplied);
  add(run.options.quasi_static ? "damped where it fell" : "damped in ropes", &solve::EnergyLedger::damped);
  add("slip of ropes on sheaves", &solve::EnergyLedger::slipped);
  add("bearings of sheaves, brakes, drag", &solve::EnergyLedger::bearings);
  const bool jolts = std::any_of(run.result.events.begin(), run.result.events.end(), [](const auto& event) {
    return event.what == "brake" || event.what == "drive" || event.what == "layer";
  });
  add(jolts ? "broken ropes, jolts by brakes and drives" : "broken ropes", &solve::EnergyLedger::broken);
  add("contacts", &solve::EnergyLedger::contacts);
  const auto add_if_any = [&](const char* form, double solve::EnergyLedger::*part, double of_turnover) {
    if (std::abs(last.*part) > of_turnover * last.turnover) add(form, part);
  };
  add_if_any("weight of slack ropes", &solve::EnergyLedger::slack, 1e-5);
  add_if_any("flanges, where ropes leave rounds out of their plane", &solve::EnergyLedger::flanges, 1e-5);
  add_if_any("the steps themselves: ropes that go taut at once, joints laid out anew", &solve::EnergyLedger::numerical,
             0);
  add("residual", &solve::EnergyLedger::residual);
  r.tables.push_back(make_table("energy" + run.ending,
                                "Energy: what the machine holds, what was supplied and lost since the start",
                                as_details(energy_quantities()), rows));
  if (last.turnover > 0) {
    const ValueKind& share = named(value_kinds(), "energy_residual");
    r.values.push_back(make_value(share, "", run.ending, last.residual / last.turnover, share.about.words));
  }
}

/// What the steps leave open beyond the tolerance: unsafe where the motion is judged.
void warn_of_errors(const study::TransientRun& run, bool judged, Result& r) {
  const auto warn = [&](std::string words, bool counts) {
    const bool unsafe = judged && counts;
    unsafe ? warn_unsafe(r, std::move(words)) : r.warnings.push_back(std::move(words));
  };
  const solve::TransientResult& result = run.result;
  const double tolerance = energy_tolerance(run);
  const bool in_steps = run.options.step > 0 || run.options.quasi_static;
  const char* const better = in_steps ? "take a shorter 'step'" : "compare 'method: reference'";
  if (!(result.open <= tolerance)) {
    warn(
        fmt::format("{}: the energy ledger is open by {:.2g} % of the turnover at t = {:.4g} s, tolerance {:.2g} %: {}",
                    words_of(run), 100 * result.open, result.t_open, 100 * tolerance, better),
        true);
  }
  if (result.spent > 1) {
    warn(fmt::format("{}: the errors of its steps add up to {:.2g}, tolerance {:.2g}: ropes shake fast, undamped; give "
                     "a 'damping_ratio', a coarser 'tolerance' or a 'step'",
                     words_of(run), result.spent * tolerance, tolerance),
         result.spent * tolerance > study::coarse_tolerance);
  }
  if (result.tension_error > tolerance) {
    const bool by_verlet = run.options.method == solve::TimeMethod::verlet;
    warn(fmt::format("{}: {} steps leave an error of up to {:.2g} % in the tensions, tolerance {:.2g} %: {}",
                     words_of(run), by_verlet ? "Verlet's" : "its given", 100 * result.tension_error, 100 * tolerance,
                     better),
         true);
  }
}

void add_ropes(const study::TransientRun& run, Result& r) {
  std::vector<study::DynamicRow> rows;
  for (std::size_t i = 0; i < run.result.ropes.size(); ++i) {
    rows.push_back({run, static_cast<int>(i)});
    const Value factor = make_value(named(study::dynamic_quantities(), "dynamic_factor"), rows.back(),
                                    run.model.reevings[i].name, run.ending, words_of(run));
    if (std::isfinite(factor.value)) r.values.push_back(factor);
  }
  r.tables.push_back(
      make_table("dynamic" + run.ending, "Ropes: peak over static tension", study::dynamic_quantities(), rows));
}

/// How much of the way of each driven rim its rope did not go along with, over all steps.
void add_slip_shares(const study::TransientRun& run, Result& r) {
  const Array<solve::ContactWays>& ways = run.result.ways;
  for (std::size_t c = 0; c < ways.size(); ++c) {
    const auto& first = run.result.frames.front().contacts[c];
    const machine::Node& node = run.model.reevings[first.reeving].nodes[first.node];
    if (!node.motor) continue;
    const auto [slipped, rim] = ways[c];
    if (!(rim > 0)) continue;
    const std::string words = fmt::format("way that the rope slips on {}, as a share of the way of its rim", node.name);
    r.values.push_back(make_value(named(value_kinds(), "SHEAVE.slip_share"), node.name, run.ending, slipped / rim,
                                  fmt::format("{} ({})", words, words_of(run))));
  }
}

/// The tension of a rope in the last second of a motion, N.
struct TensionAtEnd {
  double mean = 0;
  std::optional<double> still;  ///< with which it hangs still or runs steadily: the same over that second
};

/// None where too few output steps are in that second to tell a swing.
TensionAtEnd tension_at_end(const study::TransientRun& run, int reeving) {
  constexpr double lasts = 1, same = 0.01;  // s; as a share
  constexpr int enough = 10;
  const Array<solve::TransientFrame>& frames = run.result.frames;
  const double from = frames.back().t - lasts;
  if (from < frames.front().t) return {};
  double least = HUGE_VAL, most = 0, sum = 0;
  int seen = 0;
  for (const solve::TransientFrame& frame : frames) {
    if (frame.t < from) continue;
    ++seen;
    double T = 0;
    for (const auto& branch : frame.branches) {
      if (branch.reeving == reeving) T = std::max({T, branch.T_from, branch.T_to});
    }
    least = std::min(least, T);
    most = std::max(most, T);
    sum += T;
  }
  if (seen < enough) return {};
  const bool still = most > 0 && most - least <= same * most;
  return {.mean = sum / seen, .still = still ? std::optional(least) : std::nullopt};
}

/// Peak over static against phi2 of EN 13001-2. A load that is picked up from the ground hangs at the end alone.
void check_hoist_factor(const study::TransientRun& run, const Display& display, Result& r) {
  if (!run.request.hoist_factor) return;
  const study::HoistFactor& asked = *run.request.hoist_factor;
  const auto rope = std::find_if(run.model.reevings.begin(), run.model.reevings.end(),
                                 [&](const machine::Reeving& one) { return one.name == asked.rope; });
  if (rope == run.model.reevings.end()) return;
  const auto index = static_cast<int>(rope - run.model.reevings.begin());
  const solve::RopeExtreme& e = run.result.ropes[index];
  const AboutPart about(r, {.kind = PartKind::rope, .name = asked.rope});
  if (std::isnan(e.T_static)) {
    r.unmade.push_back(
        fmt::format("{}.phi2{}: the saved state does not say the tension at rest: calculate the first part anew",
                    asked.rope, run.ending));
    return;
  }
  constexpr double much_more = 2;  // than where it begins: the load has stood there
  const TensionAtEnd end = tension_at_end(run, index);
  const double at_end = end.still.value_or(0);
  const bool bears_nothing = !(e.T_static > 0), at_rest = bears_nothing || study::begins_at_rest(run, index);
  const bool bears_load = end.mean <= much_more * e.T_static && !study::lifts_from_face(run, index);
  const bool by_end = !at_rest || !bears_load;
  const double T_static = by_end ? at_end : e.T_static;
  if (!(T_static > 0)) {
    const std::string begins =
        bears_nothing ? "the rope bears nothing"
        : !at_rest    ? "the rope is out of balance with its load"
                      : fmt::format("the rope does not bear its load, with {},", display.brief(e.T_static, si::N));
    r.unmade.push_back(fmt::format(
        "{}.phi2{}: {} where the motion begins, and no load is seen to hang still on it for 1 s where it ends: give a "
        "longer 'duration', a 'damping_ratio' with which its swing dies down, or an 'output_step' of 0.1 s{}",
        asked.rope, run.ending, begins, at_rest ? "" : ", or 'start: settled'"));
    return;
  }
  const std::string id = fmt::format("hoist.HC{}", static_cast<int>(asked.hoisting_class) + 1);
  const auto phi2_min = catalogue::find_rule(id + ".phi2_min");
  const auto beta2 = catalogue::find_rule(id + ".beta2");
  expects(phi2_min && beta2, "the table of rules has the hoisting classes");
  const double phi2 = *catalogue::value_of(*phi2_min) + *catalogue::value_of(*beta2) * asked.speed;
  r.checks.push_back(make_check(
      fmt::format("{}.phi2{}", asked.rope, run.ending), e.T.max / T_static, si::one,
      {.sense = Sense::at_most,
       .limit = phi2,
       .rule = fmt::format("peak over static tension{} against {}, HC{}, v_h = {:.4g} m/s ({})",
                           by_end ? fmt::format(" of the end, {},", display.brief(at_end, si::N)) : std::string(),
                           phi2_min->text, static_cast<int>(asked.hoisting_class) + 1, asked.speed, phi2_min->source),
       .trust = phi2_min->trust_text.empty() ? "unverified" : fmt::format("unverified: {}", phi2_min->trust_text)}));
}

std::string slid_words(const study::TransientRun& run, const Display& display) {
  std::string ways;
  for (const solve::Slid& slid : run.options.slid) {
    const auto index = static_cast<std::size_t>(slid.index);
    const std::string& name = slid.drum ? run.model.drums[index].name : run.model.actuators[index].name;
    const char* verb = slid.drum ? (slid.by > 0 ? "taken in" : "let out") : slid.by > 0 ? "extended" : "retracted";
    ways +=
        fmt::format("{}{} has {} {}", ways.empty() ? "" : ", ", name, verb, display.brief(std::abs(slid.by), si::m));
  }
  return fmt::format("starts sliding: at rest, with the friction that is left when slowly {}", ways);
}

std::string start_words(const study::TransientRun& run, const Display& display) {
  if (run.options.from) return fmt::format("goes on from a saved state at t = {:.6g} s", run.options.from->t);
  switch (run.options.start) {
    case solve::Start::settled:
      return "starts settled: at rest in equilibrium, without loss";
    case solve::Start::sliding:
      return slid_words(run, display);
    case solve::Start::assembled:
      break;
  }
  return "starts assembled: as described, at rest";
}

std::string scheme_words(const study::TransientRun& run) {
  if (run.options.quasi_static) return "quasi-static: an equilibrium at the end of every step, with friction";
  switch (run.options.method) {
    case solve::TimeMethod::verlet:
      return "velocity Verlet";
    case solve::TimeMethod::reference:
      return fmt::format("the reference, IDA of SUNDIALS, tolerance {:.1e}", run.options.tolerance);
    default:
      return run.options.step > 0 ? std::string("generalised-alpha with a fixed step")
                                  : fmt::format("generalised-alpha, tolerance {:.1e}", run.options.tolerance);
  }
}

/// Events that did not happen while the motion lasted: one with a time is reported as a warning.
void add_missed_events(const study::TransientRun& run, Result& r) {
  const solve::TransientResult& result = run.result;
  if (!result.outcome.ok() || result.interrupted) return;
  const std::string name = words_of(run);
  for (std::size_t i = 0; i < run.model.events.size() && i < result.state.happened.size(); ++i) {
    const machine::Event& event = run.model.events[i];
    if (result.state.happened[i]) continue;
    if (event.at) {
      r.warnings.push_back(fmt::format("{}: '{}' at {:.6g} s does not happen: the motion ends at {:.6g} s", name,
                                       event.words, *event.at, result.t_end));
    } else {
      r.assumptions.push_back(fmt::format("{}: '{}' does not happen: its condition on {} never holds.", name,
                                          event.words, event.when->of.name));
    }
  }
}

/// Tension at an end of a rope where the motion begins, N.
double begins_with(const study::TransientRun& run, std::size_t reeving, bool at_start) {
  double T = 0;
  for (const auto& branch : run.result.frames.front().branches) {
    if (branch.reeving != static_cast<int>(reeving)) continue;
    if (at_start) return branch.T_from;
    T = branch.T_to;
  }
  return T;
}

/// A machine with contacts or cylinders comes to rest with the lengths that have the given tensions where it is
/// described. At rest it has others, and what is judged is not what the deck says.
constexpr double same_tension = 0.01;

/// Ropes that statics knows by a tension at an end where nothing in motion keeps it: they have their length.
void add_kept_lengths(const study::TransientRun& run, const Display& display, Result& r) {
  using machine::DriveKind;
  for (std::size_t i = 0; i < run.model.reevings.size(); ++i) {
    const machine::Reeving& rope = run.model.reevings[i];
    const bool at_start = rope.given == machine::Given::tension_at_start;
    if (rope.closed || (!at_start && rope.given != machine::Given::tension_at_end)) continue;
    const auto& drum = (at_start ? rope.nodes.front() : rope.nodes.back()).drum;
    const bool driven = drum && run.model.drums[*drum].drive.kind != DriveKind::held;
    const bool tensioned = std::any_of(run.model.tensioners.begin(), run.model.tensioners.end(),
                                       [&](const auto& one) { return one.reeving == static_cast<int>(i); });
    if (driven || tensioned) continue;
    const bool described = !run.model.contacts.empty() || !run.model.actuators.empty();
    const double T = described && !run.options.from ? begins_with(run, i, at_start) : rope.value;
    if (std::abs(T - rope.value) > same_tension * rope.value) {
      const auto [has, given] = brief_apart(T, rope.value, si::N, display);
      const AboutPart about(r, {.kind = PartKind::rope, .name = rope.name});
      warn_unsafe(r, fmt::format("{}: '{}' has {} at its {} where the motion begins, not {}: they are those of the "
                                 "places described. Give its 'length'",
                                 words_of(run), rope.name, has, at_start ? "start" : "end", given));
      continue;
    }
    r.warnings.push_back(fmt::format(
        "{}: '{}' keeps its length in motion; the {} at its {} are those at rest. Where they have to stay, hang "
        "the counterweight on it as a body, or give its drum a 'pull'",
        words_of(run), rope.name, display.brief(rope.value, si::N), at_start ? "start" : "end"));
  }
}

/// What straight branches leave out, where that is much: the heaviest one by its tension at the start.
std::string weight_words(const study::TransientRun& run, std::size_t reeving) {
  if (!run.options.rope_mass) return {};
  const double most = heaviest_share(run.model, run.result.frames.front(), reeving);
  if (most <= run.options.light) return {};
  const std::string much = most < 1 ? fmt::format("{:.0f} % of", 100 * most) : std::string("more than");
  return fmt::format("; straight, though a free part of it weighs {} its tension at the start ('{}' lets it sag)", much,
                     kept_straight(run.model.reevings[reeving]) ? "segments" : "branches: catenary");
}

/// Kinetic energy that a rope would have by the motion along itself of the halves of its free parts that does not
/// count, J. One that is torn whips as it will.
double energy_along(const study::TransientRun& run, const solve::TransientFrame& frame, int reeving) {
  const machine::Reeving& rope = run.model.reevings[reeving];
  double energy = 0;
  for (const auto& branch : frame.branches) {
    if (branch.reeving != reeving) continue;
    if (!branch.whole) return 0;
    for (const double speed : branch.uncounted) {
      energy += rope.copies * rope.mass * branch.unstretched / 2 * speed * speed / 2;
    }
  }
  return energy;
}

/// Ropes whose mass along themselves is left out in part, and that part is much beside the inertia that they move with.
void warn_of_mass_along(const study::TransientRun& run, Result& r) {
  constexpr double much = 0.05, of_turnover = 1e-3;  // less than that of all energy is no motion
  if (!run.options.rope_mass || run.options.quasi_static) return;
  for (std::size_t i = 0; i < run.model.reevings.size(); ++i) {
    const machine::Reeving& rope = run.model.reevings[i];
    if (rope.segments > 1 || !(rope.mass > 0)) continue;
    double most = 0, share = 0, t = 0;
    for (const solve::TransientFrame& frame : run.result.frames) {
      const double along = energy_along(run, frame, static_cast<int>(i));
      if (along <= most) continue;
      most = along;
      share = along / (frame.energy.kinetic + along);
      t = frame.t;
    }
    if (share <= much || most <= of_turnover * run.result.frames.back().energy.turnover) continue;
    r.warnings.push_back(fmt::format(
        "{}: the inertia of '{}' along itself is not counted where it slips on a rim, has hardly any tension, or runs "
        "over rounds without inertia of their own; at t = {:.4g} s that is {:.0f} % of what moves: give the sheaves "
        "that "
        "it runs over their 'inertia'",
        words_of(run), rope.name, t, 100 * share));
  }
}

void add_words(const study::TransientRun& run, const Display& display, Result& r) {
  const solve::TransientResult& result = run.result;
  const bool explicit_steps = run.options.method == solve::TimeMethod::verlet;
  std::string steps = fmt::format("{} steps from {:.3g} s to {:.3g} s, {} rejected", result.steps, result.smallest_step,
                                  result.largest_step, result.rejected);
  if (explicit_steps) steps += fmt::format("; stable below {:.3g} s at the start", result.stability_limit);
  r.assumptions.push_back(
      fmt::format("{}: {}; {}; {}.", words_of(run), start_words(run, display), scheme_words(run), steps));
  for (std::size_t i = 0; i < run.model.reevings.size(); ++i) {
    const double beta = i < result.damping_time.size() ? result.damping_time[i] : 0;
    const double omega = i < result.frequency.size() ? result.frequency[i] : 0;
    const bool lumped = i < result.mass_lumped.size() && result.mass_lumped[i];
    const int sagging = i < result.sagging.size() ? result.sagging[i] : 0;
    const int all = machine::branch_count(run.model.reevings[i]);
    const std::string hangs =
        sagging == 0 ? std::string()
                     : fmt::format("{} its free parts hang as the catenary at rest between their ends; ",
                                   sagging == all ? std::string("all") : fmt::format("{} of {} of", sagging, all));
    const std::string damping =
        beta <= 0   ? "without damping"
        : omega > 0 ? fmt::format("damping time {:.4g} s, from its lowest stretching mode of {:.4g} rad/s", beta, omega)
                    : fmt::format("damping time {:.4g} s", beta);
    r.assumptions.push_back(fmt::format(
        "Rope {} in motion: {}; {}{}{}.", run.model.reevings[i].name, damping, hangs,
        lumped ? "half of each free part's mass at each of its ends" : "its own mass not counted between its ends",
        weight_words(run, i)));
  }
  add_missed_events(run, r);
  add_kept_lengths(run, display, r);
  warn_of_mass_along(run, r);
  if (run.request.save && result.interrupted) {
    r.warnings.push_back(
        fmt::format("the saved state is that of t = {:.6g} s, where it was interrupted", result.t_end));
  }
}

}  // namespace

QuantityWords observed_words(const std::string& name, const Unit& unit) {
  return {.name = name, .symbol = "", .unit = unit, .words = "what is observed, by its name, in its own unit"};
}

std::vector<QuantityWords> time_words() { return {time_itself(), observed_words("OBSERVED", si::one)}; }

std::vector<QuantityWords> energy_words() { return words_of(energy_quantities()); }

std::vector<double> times_of(const study::TransientRun& run) {
  std::vector<double> t;
  t.reserve(run.result.frames.size());
  for (const auto& frame : run.result.frames) t.push_back(frame.t);
  return t;
}

void add_transient_tables(const study::TransientRun& run, const Display& display, bool judged, Result& r) {
  add_series(run, r);
  add_ropes(run, r);
  if (judged) check_hoist_factor(run, display, r);
  add_slip_shares(run, r);
  add_envelope(run, r);
  add_events(run, display, r);
  add_energy(run, r);
  warn_of_errors(run, judged, r);
  add_words(run, display, r);
}

}  // namespace taut::results
