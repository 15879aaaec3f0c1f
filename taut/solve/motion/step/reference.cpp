#include "taut/solve/motion/step/reference.hpp"

#include <fmt/format.h>
#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "taut/base/array.hpp"
#include "taut/math/index.hpp"

namespace taut::solve::dynamics {
namespace {

constexpr double share_of_tolerance = 1e-3;  ///< backward differences leave more than their tolerance over a long run
constexpr double finest = 1e-12, coarsest = 1e-7;
constexpr double share_of_places = 1e-3;  ///< tensions follow strains, which are small
constexpr int halvings = 45;
constexpr int most_again = 200;      ///< times that it begins anew between two changes of laws, or at one time
constexpr double standstill = 1e-7;  ///< m/s, 1/s: above what a restart leaves of a rate
constexpr double at_bound = 1e-7;    ///< of tensions and moments: above what a restart leaves of them
constexpr double one_moment = 1e-9;  ///< s: laws that change closer to each other change at one time

/// An end of a line that winds on a round: what it has wound, m, is a state of its own.
struct Wound {
  std::size_t line = 0, end = 0;
};

struct Free {
  void operator()(N_Vector v) const { N_VDestroy(v); }
  void operator()(SUNMatrix a) const { SUNMatDestroy(a); }
  void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
};
template <class Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Free>;

void say_nothing(int /*code*/, const char* /*module*/, const char* /*function*/, char* /*words*/, void* /*data*/) {}

}  // namespace

/// The unknowns: by column of the mechanism the places (of a contact the rope passed) and, in the same order, the
/// velocities (of a contact the rope rolled); then what each end has wound.
struct ReferenceState {
  Run* run = nullptr;
  SUNContext context = nullptr;
  void* ida = nullptr;
  Owned<N_Vector> y, rates, differential, allowed;
  Owned<SUNMatrix> matrix;
  Owned<SUNLinearSolver> solver;
  Array<Wound> wound;
  Array<double> length;  ///< of each line, but for what flows and winds, m
  int again = 0;         ///< how often it had to begin anew
  Values base;           ///< poses where it began; angles and entries of the last step
  Values trial;          ///< room for one evaluation
  Scheme scheme;         ///< no step: laws at one time
  double limit = 0;      ///< signals are taken just before it
  Array<double> first;   ///< unknowns and rates where it began, until a step is done

  ReferenceState() = default;
  ReferenceState(const ReferenceState&) = delete;
  ReferenceState& operator=(const ReferenceState&) = delete;
  ~ReferenceState() {
    if (ida != nullptr) IDAFree(&ida);
    solver.reset(), matrix.reset();
    for (auto* v : {&y, &rates, &differential, &allowed}) v->reset();
    if (context != nullptr) SUNContext_Free(&context);
  }
  std::size_t size() const { return as_size(run->m.size); }
  sunindextype unknowns() const { return static_cast<sunindextype>(2 * size() + wound.size()); }
};

namespace {

bool rolls(const ReferenceState& of, std::size_t contact) { return of.base.contacts[contact].grip == Grip::stuck; }

/// Places, velocities and flows from the unknowns, into the work and the base of the evaluation.
void put(ReferenceState& of, const double* place, const double* rate, Values& now) {
  const Mechanism& m = of.run->m;
  Work& w = of.run->w;
  const std::size_t size = of.size();
  std::copy(place, place + size, w.q_star.begin());
  std::copy(place + size, place + 2 * size, w.nu_star.begin());
  now.q = w.q_star;
  for (std::size_t c = 0; c < as_size(m.body_columns); ++c) now.rate[c] = rate[size + c];
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    const std::size_t c = as_size(m.spins[i].column);
    now.rate[c] = rate[size + c];
    now.spins[i].turns = of.base.spins[i].turns;
  }
  for (std::size_t i = 0; i < m.lines.size(); ++i) of.base.lines[i].L = of.length[i];
  for (std::size_t k = 0; k < of.wound.size(); ++k) {
    of.base.lines[of.wound[k].line].L += (of.wound[k].end == 0 ? -1 : 1) * place[2 * size + k];
  }
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    const std::size_t c = as_size(m.contacts[i].column);
    now.contacts[i].grip = of.base.contacts[i].grip;
    of.base.contacts[i].slip_mean = rolls(of, i) ? 0 : rate[c];
    of.base.contacts[i].steady = rate[c];
    w.q_star[c] = place[size + c];
  }
}

/// The machine at t by all its laws, with nothing of a step in it. False where a line has no place.
bool evaluate(ReferenceState& of, double t, const double* place, const double* rate, Values& now) {
  const Mechanism& m = of.run->m;
  put(of, place, rate, now);
  fade(*of.run, t, now);
  of.scheme.h = t >= of.limit ? 1 : 0;
  if (!follow(m, of.scheme, of.base, of.run->w, t, now)) return false;
  bool slips = false;
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    if (m.contacts[i].spin < 0 || rolls(of, i)) continue;
    of.base.contacts[i].slip_mean -= now.contacts[i].roll_rate;  // what passes less what rolls
    slips = true;
  }
  if (slips && !follow(m, of.scheme, of.base, of.run->w, t, now)) return false;
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    SpinValues& is = now.spins[i];
    const std::size_t c = as_size(m.spins[i].column);
    now.q[c] = is.angle = place[c];
    is.capacity = friction_of_spin(m, m.spins[i], of.base, now);
  }
  return true;
}

/// Rope that an end lays on its round by the turning of its line, m/s.
double winding_rate(const ReferenceState& of, const Wound& one, const Values& now) {
  const Mechanism& m = of.run->m;
  const Line& line = m.lines[one.line];
  if (sags(line, now.lines[one.line])) return sag_winding_rate(m, one.line, one.end, now);
  std::array<LineColumn, 14> columns;
  line_columns(line, m.bodies, now.bodies, now.lines[one.line], columns);
  double rate = 0;
  for (std::size_t k = 0; k < as_size(line.freedoms[0] + line.freedoms[1]); ++k) {
    rate += columns[k].angle[one.end] * now.nu[line.column[k]];
  }
  const int contact = line.contact[one.end];
  const double winding = winding_stretch(m, now, m.contacts[contact], now.contacts[contact]);
  return now.lines[one.line].radius[one.end] / winding * rate;
}

void contact_rows(ReferenceState& of, std::size_t i, const double* rate, double* out) {
  const Contact& contact = of.run->m.contacts[i];
  const ContactValues& is = of.trial.contacts[i];
  const std::size_t c = as_size(contact.column);
  out[of.size() + c] = rate[of.size() + c] - is.roll_rate;
  if (rolls(of, i)) {
    out[c] = rate[c] - is.roll_rate;
  } else if (loose(contact, of.trial)) {
    out[c] = rate[c];
  } else {
    out[c] = of.run->w.residual[c] / stiffness_at(of.run->m, contact, of.trial);
  }
}

int residual(realtype t, N_Vector y, N_Vector rates, N_Vector rows, void* data) {
  ReferenceState& of = *static_cast<ReferenceState*>(data);
  const double *place = N_VGetArrayPointer(y), *rate = N_VGetArrayPointer(rates);
  double* out = N_VGetArrayPointer(rows);
  Mechanism& m = of.run->m;
  if (!evaluate(of, t, place, rate, of.trial)) return 1;
  of.run->w.tangent = false;
  assemble(m, of.scheme, of.base, of.trial, of.run->w);
  const std::size_t size = of.size();
  const auto moves = [&](std::size_t c) {
    out[c] = rate[c] - place[size + c];
    out[size + c] = of.run->w.residual[c];
  };
  for (std::size_t c = 0; c < as_size(m.body_columns); ++c) moves(c);
  for (const Spin& spin : m.spins) {
    const std::size_t c = as_size(spin.column);
    moves(c);
    if (const auto set = prescribed(m, spin, of.base, of.trial.when)) out[size + c] = place[size + c] - set->omega;
  }
  for (std::size_t i = 0; i < m.contacts.size(); ++i) contact_rows(of, i, rate, out);
  for (std::size_t k = 0; k < of.wound.size(); ++k) {
    out[2 * size + k] = rate[2 * size + k] - winding_rate(of, of.wound[k], of.trial);
  }
  for (sunindextype k = 0; k < of.unknowns(); ++k) {
    if (!std::isfinite(out[k])) return 1;
  }
  return 0;
}

/// One step of IDA from t. Its steps after a start can be so short that a difference quotient over them, of a rope with
/// dampers, goes beyond what the laws bear; then it begins anew at t and is told how long its first step may be.
bool step_of_ida(ReferenceState& of, double limit, double& t) {
  bool done = IDASolve(of.ida, limit, &t, of.y.get(), of.rates.get(), IDA_ONE_STEP) >= 0;
  if (!done && ++of.again > most_again) return false;
  const double start = of.run->before.t;
  Array<double> from = std::exchange(of.first, {});
  double *const y = N_VGetArrayPointer(of.y.get()), *const rates = N_VGetArrayPointer(of.rates.get());
  for (double first_step = 1e-5; !done && first_step > 1e-9; first_step /= 10) {
    if (from.empty()) {  // IDA knows where it stands
      if (IDAGetDky(of.ida, start, 0, of.y.get()) < 0 || IDAGetDky(of.ida, start, 1, of.rates.get()) < 0) return false;
      from.assign(y, y + of.unknowns());
      from.insert(from.end(), rates, rates + of.unknowns());
    }
    std::copy_n(from.data(), of.unknowns(), y);
    std::copy_n(from.data() + of.unknowns(), of.unknowns(), rates);
    IDAReInit(of.ida, start, of.y.get(), of.rates.get());
    IDASetInitStep(of.ida, first_step);
    IDASetStopTime(of.ida, limit);
    done = IDASolve(of.ida, limit, &t, of.y.get(), of.rates.get(), IDA_ONE_STEP) >= 0;
  }
  return done;
}

/// Whether a rope that holds on a round is within its bounds, or beyond them by no more than a restart leaves.
bool still_holds(const Contact& contact, const Values& now, const ContactValues& is) {
  const Pressure p = pressure(contact, now);
  const double within = at_bound * (p.in + p.out);
  if (contact.load) return is.holds && std::abs(p.out - p.in) <= is.drop + within;
  return p.in > 0 && p.out > 0 && std::max(p.out - is.ratio * p.in, p.in - is.ratio * p.out) <= within;
}

/// The same of a spin that rests in its bearing.
bool still_rests(const Mechanism& m, const Spin& spin, const ReferenceState& of, const Values& now,
                 const SpinValues& is) {
  return std::abs(held_moment(m, spin, is, of.base, now)) <= (1 + at_bound) * is.capacity;
}

/// Whether a law that held in the base no longer does.
bool law_ends(ReferenceState& of, Values& now) {
  const Mechanism& m = of.run->m;
  for (std::size_t i = 0; i < m.lines.size(); ++i) {
    if ((of.base.lines[i].e > 0) != (now.lines[i].e > 0) && now.lines[i].gone > 0) return true;
  }
  Array<double> slipped;
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    slipped.push_back(of.base.contacts[i].slipped);
    of.base.contacts[i].slipped = now.contacts[i].slipped;
  }
  decide(m, of.scheme, of.base, now);
  bool ends = false;
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    const Grip was = of.base.contacts[i].grip;
    of.base.contacts[i].slipped = slipped[i];
    const bool slips = was == Grip::forward || was == Grip::backward;
    const double way = was == Grip::backward ? -1 : 1;
    const bool pressed = now.contacts[i].grip != Grip::equal;
    const bool grips = was == Grip::stuck && still_holds(m.contacts[i], now, now.contacts[i]);
    ends = ends ||
           (slips ? !pressed || way * now.contacts[i].slip_rate < -standstill : !grips && now.contacts[i].grip != was);
    now.contacts[i].grip = was;
  }
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    const double was = of.base.spins[i].turns;
    const SpinValues& is = now.spins[i];
    const bool starts = was == 0 && is.turns != 0 && !still_rests(m, m.spins[i], of, now, is);
    ends = ends || starts || was * is.omega < -standstill;
    now.spins[i].turns = of.base.spins[i].turns;
  }
  return ends;
}

/// A spin that turned in its friction and is about to turn back stands at that moment. What is left of its rate by the
/// search would count as turning back, and its friction would send it round again, and so on without end.
void stop_spins(const ReferenceState& of, Values& now) {
  const Mechanism& m = of.run->m;
  for (std::size_t i = 0; i < m.spins.size(); ++i) {
    if (of.base.spins[i].turns * now.spins[i].omega >= 0) continue;
    now.spins[i].omega = now.nu[as_size(m.spins[i].column)] = 0;
  }
}

/// The unknowns of a state, and which of them have a rate.
void fill(ReferenceState& of, double tolerance) {
  const Run& run = *of.run;
  const Mechanism& m = run.m;
  const Values& v = run.before;
  double* const y = N_VGetArrayPointer(of.y.get());
  double* const rate = N_VGetArrayPointer(of.rates.get());
  double* const differential = N_VGetArrayPointer(of.differential.get());
  double* const allowed = N_VGetArrayPointer(of.allowed.get());
  const std::size_t size = of.size(), all = static_cast<std::size_t>(of.unknowns());
  std::fill(y, y + all, 0.0);
  std::fill(rate, rate + all, 0.0);
  std::fill(differential, differential + all, 1.0);
  std::fill(allowed, allowed + all, share_of_places * tolerance * m.size_of_machine);
  for (std::size_t c = 0; c < size; ++c) {
    y[c] = v.q[c];
    rate[c] = y[size + c] = v.nu[c];
    rate[size + c] = v.rate[c];
    allowed[size + c] = tolerance;
  }
  for (const Spin& spin : m.spins) {
    if (prescribed(m, spin, v, v.when)) differential[size + as_size(spin.column)] = 0;
  }
  for (std::size_t i = 0; i < m.contacts.size(); ++i) {
    const Contact& contact = m.contacts[i];
    const std::size_t c = as_size(contact.column);
    y[size + c] = v.contacts[i].rolled;
    rate[c] = v.contacts[i].flow;
    rate[size + c] = v.contacts[i].roll_rate;
    allowed[size + c] = allowed[c];
    const double damping = m.lines[contact.in >= 0 ? contact.in : contact.out].damping;
    if (!rolls(of, i) && damping == 0 && !loose(contact, v)) differential[c] = 0;
  }
}

bool open(ReferenceState& of, double tolerance) {
  if (SUNContext_Create(nullptr, &of.context) != 0) return false;
  for (auto* v : {&of.y, &of.rates, &of.differential, &of.allowed}) {
    v->reset(N_VNew_Serial(of.unknowns(), of.context));
  }
  fill(of, tolerance);
  of.ida = IDACreate(of.context);
  if (of.ida == nullptr) return false;
  IDASetErrHandlerFn(of.ida, say_nothing, nullptr);
  if (IDAInit(of.ida, residual, of.run->before.t, of.y.get(), of.rates.get()) != IDA_SUCCESS) return false;
  IDASVtolerances(of.ida, tolerance, of.allowed.get());
  IDASetUserData(of.ida, &of);
  IDASetMaxNumSteps(of.ida, -1);
  of.matrix.reset(SUNDenseMatrix(of.unknowns(), of.unknowns(), of.context));
  of.solver.reset(SUNLinSol_Dense(of.y.get(), of.matrix.get(), of.context));
  IDASetLinearSolver(of.ida, of.solver.get(), of.matrix.get());
  IDASetId(of.ida, of.differential.get());
  return true;
}

}  // namespace

Reference::Reference() = default;
Reference::~Reference() = default;

StepEnd Reference::begin(Run& run) {
  state_ = std::make_unique<ReferenceState>();
  ReferenceState& of = *state_;
  of.run = &run;
  of.base = of.trial = run.now = run.before;
  of.limit = run.end;
  of.scheme = scheme_of(run.options.rho);
  of.scheme.slip_before = 1;
  for (std::size_t i = 0; i < run.m.lines.size(); ++i) {
    of.length.push_back(of.base.lines[i].L);
    for (const std::size_t end : {0U, 1U}) {
      const bool real = run.m.lines[i].contact[end] >= 0 && !run.m.lines[i].at_load[end];
      if (real && winds(run.m.lines[i], of.base.lines[i], end)) of.wound.push_back({i, end});
    }
  }
  // lengths follow what each end has wound, not an angle and one stretch
  for (ContactValues& contact : of.base.contacts) contact.winding = std::numeric_limits<double>::infinity();
  const double tolerance = std::clamp(share_of_tolerance * run.options.tolerance, finest, coarsest);
  if (!open(of, tolerance)) return StepEnd::not_converged;
  double* const y = N_VGetArrayPointer(of.y.get());
  double* const rate = N_VGetArrayPointer(of.rates.get());
  if (!evaluate(of, run.before.t, y, rate, of.trial)) return StepEnd::no_place;
  for (std::size_t k = 0; k < of.wound.size(); ++k) {
    rate[2 * of.size() + k] = winding_rate(of, of.wound[k], of.trial);
  }
  IDAReInit(of.ida, run.before.t, of.y.get(), of.rates.get());
  const double ahead = 1e-3 * (run.end - run.before.t);
  if (IDACalcIC(of.ida, IDA_YA_YDP_INIT, run.before.t + ahead) == IDA_SUCCESS) {
    IDAGetConsistentIC(of.ida, of.y.get(), of.rates.get());
  }
  of.first.assign(y, y + of.unknowns());
  of.first.insert(of.first.end(), rate, rate + of.unknowns());
  run.known = 1;
  return StepEnd::ok;
}

StepEnd Reference::step(Run& run, double limit, bool& changed) {
  ReferenceState& of = *state_;
  of.limit = limit;
  for (std::size_t i = 0; i < run.m.lines.size(); ++i) of.base.lines[i] = run.before.lines[i];
  of.base.sags = run.before.sags;
  for (std::size_t i = 0; i < run.m.contacts.size(); ++i) {
    of.base.contacts[i].entry = run.before.contacts[i].entry;
    of.base.contacts[i].wrap = run.before.contacts[i].wrap;
    of.base.contacts[i].flow = run.before.contacts[i].flow;
  }
  run.now.drum_drive = run.before.drum_drive;
  run.now.motor_drive = run.before.motor_drive;
  IDASetStopTime(of.ida, limit);
  double t = run.before.t;
  if (!step_of_ida(of, limit, t)) return StepEnd::not_converged;
  const double *y = N_VGetArrayPointer(of.y.get()), *rate = N_VGetArrayPointer(of.rates.get());
  if (!evaluate(of, t, y, rate, run.now)) return StepEnd::no_place;
  changed = law_ends(of, run.now);
  double before = run.before.t, after = t;
  const auto look = [&](double when) {
    IDAGetDky(of.ida, when, 0, of.y.get());
    IDAGetDky(of.ida, when, 1, of.rates.get());
    return evaluate(of, when, y, rate, run.now);
  };
  for (int i = 0; changed && i < halvings; ++i) {
    const double middle = (before + after) / 2;
    if (!look(middle)) return StepEnd::no_place;
    (law_ends(of, run.now) ? after : before) = middle;
  }
  if (changed && !look(after)) return StepEnd::no_place;
  if (changed) {
    stop_spins(of, run.now);
    // laws that change and change back without end, in a time in which nothing else moves
    if (after - first_change_ > std::max(one_moment, floor_of(run))) {
      changes_ = 0;
      first_change_ = after;
    }
    if (++changes_ > most_again) return StepEnd::to_and_fro;
  }
  for (std::size_t i = 0; i < run.m.contacts.size(); ++i) {
    ContactValues& contact = run.now.contacts[i];
    contact.winding = winding_stretch(run.m, run.now, run.m.contacts[i], contact);
  }
  run.scheme.h = after - run.before.t;
  return StepEnd::ok;
}

Outcome reference_refuses(const Mechanism& m) {
  if (!m.chain_loads.empty()) return infeasible("the reference has no forces along ropes in 'segments'");
  if (!m.couples.empty())
    return infeasible(
        "the reference does without contacts on faces, actuators and loads over time; take 'method: implicit'");
  for (const Body& body : m.bodies) {
    int turns = body.driven ? 1 : 0;
    for (int f = 0; f < body.count; ++f) turns += body.about[as_size(f)] != Vector3::Zero() ? 1 : 0;
    if (turns <= 1) continue;
    return infeasible(fmt::format("'{}' turns about more than one axis, or is driven and turns: not in the reference",
                                  m.model->bodies[body.model].name));
  }
  for (const Line& line : m.lines) {
    for (const std::size_t end : {0U, 1U}) {
      const bool driven = line.body[end] >= 0 && m.bodies[line.body[end]].driven;
      if (!driven || (line.radius[0] == 0 && line.radius[1] == 0)) continue;
      return infeasible(fmt::format("'{}' is driven and carries a round or its rope: not in the reference",
                                    m.model->bodies[m.bodies[line.body[end]].model].name));
    }
  }
  for (const machine::Drum& drum : m.model->drums) {
    if (drum.automatic_layers)
      return infeasible(fmt::format("the drum '{}' changes its layers: not in the reference", drum.name));
  }
  const auto& events = m.model->events;
  if (std::any_of(events.begin(), events.end(), [](const machine::Event& e) { return e.when.has_value(); })) {
    return infeasible("the reference has no events by condition: give them times");
  }
  return {};
}

}  // namespace taut::solve::dynamics
