#include "taut/study/pretension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"
#include "taut/base/expects.hpp"
#include "taut/machine/compile/guides.hpp"
#include "taut/machine/links/observable.hpp"
#include "taut/math/index.hpp"
#include "taut/study/deck/bounds.hpp"
#include "taut/study/deck/motion_checks.hpp"
#include "taut/units/parse.hpp"

namespace taut::study {
namespace {

constexpr double pull_speed = 1e-3;  ///< m/s of rope taken out
constexpr int pull_steps = 250;
constexpr double slow_way = 0.5;  ///< m: how far a slow pull goes that does not end before

double longest_of(const PretensionOptions& options) { return options.longest.value_or(slow_way); }

std::string words_of_pull(const machine::Model& model, std::size_t number, const Pull& pull) {
  return fmt::format("pull {}, '{}'", number + 1, model.reevings[pull.reeving].name);
}

// ---- without friction: equilibria ----

/// Whether a tension is given, which holds in every state.
bool keeps_tension(const machine::Reeving& rope) {
  return rope.given == machine::Given::tension_at_start || rope.given == machine::Given::tension_at_end;
}

/// A tension that is given is one in which the machine has to stay; one that a pull has made is not.
solve::EquilibriumOptions at_rest(const machine::Model& model) {
  solve::EquilibriumOptions options;
  options.lengths_kept = std::none_of(model.reevings.begin(), model.reevings.end(), keeps_tension);
  return options;
}

PretensionResult pull_at_rest(const machine::Model& given, const Array<Pull>& pulls, const PretensionOptions& options) {
  PretensionResult r;
  solve::EquilibriumResult found = solve::equilibrium(given, at_rest(given));
  r.outcome = found.outcome;
  if (!r.outcome.ok()) return r;
  machine::Model model = machine::with_sides(given, found.state);
  r.before = end_of(model, found);
  Array<double> taken(model.reevings.size(), 0.0);
  for (std::size_t i = 0; i < pulls.size(); ++i) {
    if (options.progress && !options.progress(i)) {
      r.interrupted = true;
      return r;
    }
    const Pull& pull = pulls[i];
    machine::Reeving& rope = model.reevings[pull.reeving];
    const double length = found.ropes[as_size(pull.reeving)].unstretched;
    const solve::EquilibriumOptions here = at_rest(model);
    if (pull.force) {
      rope.given = pull.at_end ? machine::Given::tension_at_end : machine::Given::tension_at_start;
      rope.value = *pull.force;
    } else {
      expects(pull.take_up.has_value(), "a pull at rest ends at a force or a length");
      rope.given = machine::Given::length;
      rope.value = length - *pull.take_up;
    }
    found = solve::equilibrium(model, here, found.state);
    if (!found.outcome.ok()) {
      r.outcome = {.status = found.outcome.status,
                   .message = fmt::format("{}: {}", words_of_pull(model, i, pull), found.outcome.message)};
      return r;
    }
    model = machine::with_sides(std::move(model), found.state);
    machine::Reeving& pulled = model.reevings[pull.reeving];
    pulled.given = machine::Given::length;
    pulled.value = found.ropes[as_size(pull.reeving)].unstretched;
    PullEnd end = end_of(model, found);
    end.taken = length - pulled.value;
    if (pull.force && options.longest && std::abs(end.taken) > *options.longest) {
      r.outcome = infeasible(fmt::format("{}: {:.4g} N need {:.4g} m of rope, more than {:.4g} m ('longest')",
                                         words_of_pull(model, i, pull), *pull.force, end.taken, *options.longest));
      return r;
    }
    taken[pull.reeving] += end.taken;
    end.taken_in_all = taken[pull.reeving];
    r.ends.push_back(std::move(end));
    r.model = model;
  }
  return r;
}

// ---- with friction: slowly ----

machine::Observable tension_at(const Pull& pull) {
  machine::Observable o;
  o.name = "tension";
  o.quantity = pull.at_end ? machine::Observed::T_end : machine::Observed::T_start;
  o.unit = si::N;
  o.index = pull.reeving;
  return o;
}

machine::Event stop_when(const machine::Observable& of, bool above, double threshold) {
  machine::Event stop;
  stop.words = "pulled";
  stop.kind = machine::EventKind::stop;
  stop.when = machine::Condition{.of = of, .above = above, .threshold = threshold};
  return stop;
}

void hold_still(machine::Signal& signal) {
  const double value = machine::at(signal, 0).value;
  if (!std::isnan(value)) signal.law = machine::Moves{.from = value, .moves = {}};
}

void hold_still(machine::Drive& drive) {
  if (drive.kind == machine::DriveKind::speed) drive.kind = machine::DriveKind::held;
  hold_still(drive.signal);
}

/// The machine with its drives and signals as they begin, and no events.
machine::Model standing_still(const machine::Model& given) {
  machine::Model m = given;
  m.events.clear();
  for (machine::Signal& signal : m.signals) hold_still(signal);
  for (machine::Drum& drum : m.drums) hold_still(drum.drive);
  for (machine::Motor& motor : m.motors) hold_still(motor.drive);
  for (machine::Tensioner& tensioner : m.tensioners) hold_still(tensioner.change);
  for (machine::Body& body : m.bodies) {
    for (machine::DrivenWay& way : body.driven) hold_still(way.signal);
  }
  for (machine::Actuator& actuator : m.actuators) {
    hold_still(actuator.signal);
    if (actuator.kind != machine::ActuatorKind::force && actuator.lock_stiffness > 0)
      actuator.mode = machine::ActuatorMode::lock;
  }
  return m;
}

/// The machine slowly: the ropes' tensions are observed behind what the deck observes.
struct SlowMachine {
  machine::Model model;
  std::size_t own = 0;  ///< observed by the deck
  solve::TransientOptions options;
  double t = 0;
  PullEnd last;
  solve::TransientFrame frame;  ///< of that end
};

SlowMachine slow_machine(const machine::Model& given, const PretensionOptions& options) {
  SlowMachine slow;
  slow.model = standing_still(given);
  slow.own = given.observed.size();
  for (std::size_t r = 0; r < given.reevings.size(); ++r) {
    for (const bool end : {false, true}) {
      Pull of;
      of.reeving = static_cast<int>(r);
      of.at_end = end;
      slow.model.observed.push_back(tension_at(of));
    }
  }
  slow.options.quasi_static = true;
  slow.options.tolerance = options.tolerance;
  slow.options.start = options.start;
  slow.options.duration = longest_of(options) / pull_speed;
  slow.options.output_step = slow.options.duration / pull_steps;
  return slow;
}

/// What the run has left; goes on from there.
void take_over(const solve::TransientResult& r, SlowMachine& slow) {
  PullEnd end;
  for (std::size_t k = 0; k < slow.own; ++k) end.observed.push_back(r.observed[k].back());
  for (std::size_t i = 0; i < slow.model.reevings.size(); ++i) {
    end.T_start.push_back(r.observed[slow.own + 2 * i].back());
    end.T_end.push_back(r.observed[slow.own + 2 * i + 1].back());
    double length = 0;
    for (const double part : r.state.ropes[i].length) length += part;
    end.unstretched.push_back(length);
  }
  end.taken_in_all = slow.last.taken_in_all;
  slow.last = std::move(end);
  slow.frame = r.frames.back();
  slow.options.from = r.state;
  slow.options.from->memory.clear();
  slow.options.from->happened.clear();
  slow.t = r.state.t;
}

/// The machine with that rope being pulled from now on.
machine::Model being_pulled(const SlowMachine& slow, const Pull& pull, double way, double where) {
  machine::Model m = slow.model;
  machine::Tensioner tensioner;
  tensioner.reeving = pull.reeving;
  tensioner.at_start = !pull.at_end;
  tensioner.change.unit = si::m;
  tensioner.change.law =
      machine::Curve{.t = {slow.t, slow.t + slow.options.duration}, .value = {0, -way}, .slopes = {}};
  m.tensioners.push_back(tensioner);
  if (pull.force) m.events.push_back(stop_when(tension_at(pull), way > 0, *pull.force));
  if (pull.until) {
    m.events.push_back(stop_when(*pull.until, true, where + pull.moves));
    m.events.push_back(stop_when(*pull.until, false, where - pull.moves));
  }
  return m;
}

/// Value of what is not to move, in the machine as it stands.
double where_now(const SlowMachine& slow, const Pull& pull) {
  machine::Model m = slow.model;
  m.observed.push_back(*pull.until);
  solve::TransientOptions o = slow.options;
  o.duration = o.output_step;
  const solve::TransientResult r = solve::transient(m, o);
  return r.observed.back().empty() ? 0 : r.observed.back().back();
}

Outcome pull_slowly(const Pull& pull, const PretensionOptions& options, SlowMachine& slow, bool& interrupted) {
  const double T = pull.at_end ? slow.last.T_end[pull.reeving] : slow.last.T_start[pull.reeving];
  double way = longest_of(options);
  if (pull.force && T > *pull.force) way = -way;
  if (pull.take_up) way = *pull.take_up;
  slow.options.duration = std::abs(way) / pull_speed;
  slow.options.output_step = slow.options.duration / pull_steps;
  const double where = pull.until ? where_now(slow, pull) : 0;
  const machine::Model pulled = being_pulled(slow, pull, way, where);
  const solve::TransientResult r = solve::transient(pulled, slow.options);
  interrupted = r.interrupted;
  if (options.moved && !r.frames.empty()) options.moved(pulled, r);
  if (!r.outcome.ok() || r.interrupted) return r.outcome;
  const double begun = slow.t;
  take_over(r, slow);
  slow.last.taken = way * (slow.t - begun) / slow.options.duration;
  const bool stopped = std::any_of(r.events.begin(), r.events.end(), [](const auto& e) { return e.what == "stop"; });
  if (stopped || pull.take_up) return {};
  return infeasible(fmt::format(
      "{:.4g} m of rope are out and {} ('longest')", std::abs(way),
      pull.until
          ? fmt::format("'{}' has not moved", pull.until->name)
          : fmt::format("its tension is {:.4g} N, not {:.4g} N",
                        pull.at_end ? slow.last.T_end[pull.reeving] : slow.last.T_start[pull.reeving], *pull.force)));
}

void add_frame(const SlowMachine& slow, PretensionResult& r) {
  r.frames.push_back(slow.frame);
  r.frames.back().t = static_cast<double>(r.ends.size());
}

PretensionResult pull_slowly(const machine::Model& given, const Array<Pull>& pulls, const PretensionOptions& options) {
  PretensionResult r;
  r.slowly = true;
  SlowMachine slow = slow_machine(given, options);
  solve::TransientOptions rest = slow.options;
  rest.duration = rest.output_step;
  const solve::TransientResult before = solve::transient(slow.model, rest);
  r.outcome = before.outcome;
  if (options.moved && !before.frames.empty()) options.moved(slow.model, before);
  if (!r.outcome.ok()) return r;
  take_over(before, slow);
  r.before = slow.last;
  add_frame(slow, r);
  Array<double> taken(given.reevings.size(), 0.0);
  for (std::size_t i = 0; i < pulls.size(); ++i) {
    if (options.progress && !options.progress(i)) {
      r.interrupted = true;
      return r;
    }
    slow.options.progress = [&](double) { return !options.progress || options.progress(i); };
    const Outcome outcome = pull_slowly(pulls[i], options, slow, r.interrupted);
    if (r.interrupted) return r;
    if (!outcome.ok()) {
      r.outcome = {.status = outcome.status,
                   .message = fmt::format("{}: {}", words_of_pull(given, i, pulls[i]), outcome.message)};
      return r;
    }
    taken[pulls[i].reeving] += slow.last.taken;
    slow.last.taken_in_all = taken[pulls[i].reeving];
    r.ends.push_back(slow.last);
    add_frame(slow, r);
    r.state = slow.options.from;
  }
  return r;
}

/// What a pull waits for, with the way that it is to move.
void resolve_until(const PullRequest& request, const std::string& path, Names& p, Pull& pull) {
  if (!request.until) {
    if (request.moves) p.complaints.push_back({path + ".moves", "belongs to 'until'"});
    return;
  }
  if (!request.moves) {
    p.complaints.push_back({path, "'until' needs 'moves': by how much"});
    return;
  }
  const auto until = machine::observable(*request.until, p.model, path + ".until", p.complaints);
  if (!until) return;
  const auto moves = parse_quantity(*request.moves, until->unit);
  if (!moves) {
    p.complaints.push_back({path + ".moves", moves.error().message});
  } else if (!(*moves > 0)) {
    p.complaints.push_back({path + ".moves", "must be above 0"});
  } else {
    pull.until = until;
    pull.moves = *moves;
  }
}

/// A pull takes over the end at which a tension is given. At the other end that tension would hold against it.
void check_given_tension(const machine::Reeving& rope, const std::string& path, Names& p, const Pull& pull) {
  const auto end = pull.at_end ? machine::Given::tension_at_end : machine::Given::tension_at_start;
  if (rope.also) {
    p.complaints.push_back({path + ".rope", "has a second given quantity at its drive: it can't be pulled"});
  } else if (rope.given != end) {
    p.complaints.push_back({path + ".rope", fmt::format("keeps the tension given at its {} in every state: give it a "
                                                        "'length' or 'install' in place of that",
                                                        pull.at_end ? "start" : "end")});
  }
}

/// Where a machine moves, only a drum with a pull or a torque keeps a tension; other ropes keep their lengths.
bool holds_in_motion(const machine::Model& model, const machine::Reeving& rope) {
  const bool at_end = rope.given == machine::Given::tension_at_end;
  const std::optional<int> drum = (at_end ? rope.nodes.back() : rope.nodes.front()).drum;
  if (!drum) return false;
  const machine::DriveKind kind = model.drums[*drum].drive.kind;
  return kind == machine::DriveKind::pull || kind == machine::DriveKind::torque;
}

void check_held_tensions(const Array<Pull>& pulls, const std::string& path, Names& p) {
  for (std::size_t r = 0; r < p.machine.reevings.size(); ++r) {
    const machine::Reeving& rope = p.model.reevings[r];
    const auto pulls_it = [&](const Pull& one) { return as_size(one.reeving) == r; };
    if (!keeps_tension(rope) || holds_in_motion(p.model, rope)) continue;
    if (std::any_of(pulls.begin(), pulls.end(), pulls_it)) continue;
    p.complaints.push_back(
        {path, fmt::format("'{}' has a given tension, which no slow motion keeps where it has contacts, cylinders or "
                           "'until': give it a 'length' or 'install', or let a drum with a 'pull' hold it",
                           rope.name)});
  }
}

Pull resolved_pull(const PullRequest& request, std::optional<double> longest, const std::string& path, Names& p) {
  Pull pull;
  const auto reeving = reeving_of(p, request.rope, path + ".rope");
  pull.reeving = reeving.value_or(0);
  pull.at_end = request.end == RopeEnd::end;
  pull.force = request.force;
  pull.take_up = request.take_up;
  if (pull.take_up && longest && std::abs(*pull.take_up) > *longest) {
    p.complaints.push_back({path + ".take_up", fmt::format("is more than {:.4g} m, 'longest'", *longest)});
  }
  resolve_until(request, path, p, pull);
  if (!reeving) return pull;
  const machine::Reeving& rope = p.model.reevings[pull.reeving];
  if (rope.closed) {
    p.complaints.push_back({path + ".rope", "an endless rope has no end to be pulled at: tighten it by 'take_up'"});
  } else if ((pull.at_end ? rope.nodes.back() : rope.nodes.front()).drum) {
    p.complaints.push_back({path + ".rope", "is on a drum at that end, which pulls it: name the other end"});
  } else if (as_size(pull.reeving) < p.machine.reevings.size() && (keeps_tension(rope) || rope.also)) {
    check_given_tension(rope, path, p, pull);
  }
  return pull;
}

}  // namespace

PullEnd end_of(const machine::Model& model, const solve::EquilibriumResult& result) {
  PullEnd end;
  const std::size_t ropes = model.reevings.size();
  end.T_start.assign(ropes, 0.0);
  end.T_end = end.T_start;
  std::for_each(result.branches.rbegin(), result.branches.rend(),
                [&](const solve::BranchResult& branch) { end.T_start[branch.reeving] = branch.T_from; });
  for (const solve::BranchResult& branch : result.branches) end.T_end[branch.reeving] = branch.T_to;
  for (const solve::RopeResult& rope : result.ropes) end.unstretched.push_back(rope.unstretched);
  end.at = result;
  return end;
}

bool pulled_slowly(const machine::Model& model, const Array<Pull>& pulls) {
  return !model.contacts.empty() || !model.actuators.empty() ||
         std::any_of(pulls.begin(), pulls.end(), [](const Pull& one) { return one.until.has_value(); });
}

PretensionResult pretension(const machine::Model& model, const Array<Pull>& pulls, const PretensionOptions& options) {
  for (const Pull& one : pulls) {
    expects((one.force ? 1 : 0) + (one.take_up ? 1 : 0) + (one.until ? 1 : 0) == 1, "a pull ends in one way");
    expects(!one.until || one.moves > 0, "what begins to move moves by something");
  }
  return pulled_slowly(model, pulls) ? pull_slowly(model, pulls, options) : pull_at_rest(model, pulls, options);
}

const Description& PullRequest::describe() {
  static const Description d =
      Describe<PullRequest>()
          .field(&PullRequest::rope, "rope", "the rope that is pulled: a reeving or a guy")
          .required()
          .choice(&PullRequest::end, "end", {{"start", RopeEnd::start}, {"end", RopeEnd::end}},
                  "the end of its path with the tensioner")
          .field(&PullRequest::force, "force", "F", si::N, "tension there at which the pull ends")
          .above(0)
          .at_most(strongest)
          .field(&PullRequest::take_up, "take_up", "dL", si::m,
                 "unstretched rope taken out, at which the pull ends; below 0 let in")
          .at_least(-longest_pull)
          .at_most(longest_pull)
          .field(&PullRequest::until, "until",
                 "quantity at whose movement the pull ends: a path as in 'observe', or a measure")
          .exactly_one({"force", "take_up", "until"})
          .field(&PullRequest::moves, "moves",
                 "movement of 'until' at which the pull ends, in either direction, with its unit");
  return d;
}

const Description& PretensionRequest::describe() {
  static const Description d =
      Describe<PretensionRequest>()
          .field(&PretensionRequest::name, "name", "appended to the names of its tables, when a deck has several")
          .field(&PretensionRequest::judge, "judge", "false: its states do not count for the verdict")
          .record(&PretensionRequest::pull, "pull", "pulls, one after the other")
          .record(&PretensionRequest::least, "least",
                  "lengths of ropes for which each keeps a least tension under all loads")
          .exactly_one({"pull", "least"})
          .field(&PretensionRequest::rounds, "rounds", "n", si::one,
                 "number of times that the list of pulls is repeated")
          .at_least(1)
          .at_most(1000)
          .field(&PretensionRequest::longest, "longest", "dL", si::m,
                 "largest length that a pull may take out or let in; default: 0.5 m with contacts or cylinders, else "
                 "any")
          .above(0)
          .at_most(longest_pull)
          .field(&PretensionRequest::tolerance, "tolerance", "", si::one,
                 "tolerance of tensions relative to the largest of the rope, of places relative to the size of the "
                 "machine")
          .at_least(1e-13)
          .at_most(1e-3)
          .choice(&PretensionRequest::start, "start", {{"settled", Start::settled}, {"assembled", Start::assembled}},
                  "of a machine with contacts or cylinders. settled: from the equilibrium at rest; assembled: from "
                  "places and lengths as described, held by friction");
  return d;
}

PretensionRun resolve(const PretensionRequest& request, const std::string& path, Names& names) {
  PretensionRun run;
  run.ending = ending_of(names, "pretension", request.name, path);
  if (request.name) run.words = fmt::format("pretension, {}", *request.name);
  run.rounds = request.rounds;
  run.options.longest = request.longest;
  run.options.tolerance = request.tolerance;
  const bool settled = request.start == PretensionRequest::Start::settled;
  run.options.start = settled ? solve::Start::settled : solve::Start::assembled;
  run.observes = !names.machine.observe.empty();
  for (std::size_t i = 0; i < request.pull.size(); ++i) {
    run.pulls.push_back(resolved_pull(request.pull[i], request.longest, fmt::format("{}.pull[{}]", path, i), names));
  }
  if (request.pull.empty()) names.complaints.push_back({path + ".pull", "names no rope"});
  for (const machine::Observable& measure : names.model.measures) {
    const auto& columns = pull_quantities();
    if (std::none_of(columns.begin(), columns.end(), [&](const auto& q) { return q.about.name == measure.name; }))
      continue;
    names.complaints.push_back({fmt::format("machine.measures.{}", measure.name),
                                "is the name of a column in the table of a pretension: choose another one"});
  }
  if (pulled_slowly(names.model, run.pulls)) {
    if (!names.machine.beams.empty()) {
      names.complaints.push_back({path, "a machine with beams is pulled without contacts, cylinders and 'until'"});
    } else {
      check_held_tensions(run.pulls, path, names);
      check_inertia(names.machine, names.model, names.complaints);
      check_guides(names.machine, names.complaints);
      check_masses(names.machine, names.model, {.slowly = true}, names.complaints);
    }
  }
  return run;
}

void solve(const machine::Model& model, PretensionRun& run, const std::function<bool(std::size_t, std::size_t)>& go_on,
           const std::function<void(const machine::Model&, const solve::TransientResult&)>& moved) {
  Array<Pull> pulls;
  for (int i = 0; i < run.rounds; ++i) pulls.insert(pulls.end(), run.pulls.begin(), run.pulls.end());
  PretensionOptions options = run.options;
  options.moved = moved;
  options.progress = [&](std::size_t i) { return go_on(i, pulls.size()); };
  run.answer = pretension(machine::with_guides_at_start(model), pulls, options);
}

const Quantities<PullRow>& pull_quantities() {
  using Row = PullRow;
  static const Quantities<Row> all = {
      {"step", "", si::one, "number of the pull; 0: before any of them", &Row::step},
      {"pulled", "", si::one, "the rope that is pulled", &Row::pulled},
      {"taken_out", "dL", si::m, "unstretched rope taken out by this pull", [](const Row& r) { return r.end.taken; }},
      {"taken_out_in_all", "", si::m, "by all pulls of this rope so far",
       [](const Row& r) { return r.end.taken_in_all; }}};
  return all;
}

}  // namespace taut::study
