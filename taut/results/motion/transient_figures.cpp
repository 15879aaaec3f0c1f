#include "taut/results/motion/transient_figures.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "taut/calc/none.hpp"
#include "taut/results/machine_figures.hpp"
#include "taut/results/motion/transient_scene.hpp"
#include "taut/results/motion/transient_tables.hpp"

namespace taut::results {
namespace {

using solve::TransientFrame;

constexpr std::size_t most_curves_in_plot = 6;
constexpr std::size_t most_events = 10;
constexpr std::size_t most_readouts = 8;
constexpr std::size_t buckets = 240;  ///< of the thinned plots
constexpr std::size_t path_dots = 6;
constexpr double least_path = 0.01;        ///< of the machine's size: a body that stays where it is has no path
constexpr double least_plan_width = 1e-3;  ///< machines narrower than this part of their length need no plan

struct PlaneView {
  int right = 0;
  int above = 2;
  Point point(const Vector3& v) const { return {.x = v[right], .y = v[above]}; }
  /// Sense in which a turn about `axis` is seen: +1 counter-clockwise; 0: not seen from its side.
  double sense(const Vector3& axis) const {
    const double seen = axis.dot(Vector3::Unit(right).cross(Vector3::Unit(above)));
    return std::abs(seen) < 0.5 ? 0 : seen > 0 ? 1 : -1;
  }
};

/// How far everything comes over the whole motion.
Vector3 size_of(const study::TransientRun& run) {
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 high = -low;
  for (const auto& frame : run.result.frames) {
    for (const auto& b : frame.branches) {
      low = low.cwiseMin(b.start).cwiseMin(b.end);
      high = high.cwiseMax(b.start).cwiseMax(b.end);
      for (const Vector3& p : b.curve) low = low.cwiseMin(p);
    }
  }
  return high - low;
}

std::vector<PlaneView> views_of(const study::TransientRun& run) {
  const Vector3 size = size_of(run);
  std::vector<PlaneView> views = {{.right = size.y() > size.x() ? 1 : 0, .above = 2}};
  if (std::min(size.x(), size.y()) > least_plan_width * size.maxCoeff()) views.push_back({0, 1});
  return views;
}

std::vector<std::array<Vector3, 2>> body_lines_at(const machine::Model& m, const solve::TransientFrame& frame) {
  return body_lines(m, [&](const machine::Place& place) { return place_in(frame, place); });
}

Drawing drawing_of(const study::TransientRun& run, std::size_t index, const PlaneView& view, const std::string& title) {
  const machine::Model& m = run.model;
  const solve::TransientFrame& frame = run.result.frames[index];
  Drawing d;
  d.name = fmt::format("motion{}_{}", run.ending, index);
  d.title = title;
  d.caption = fmt::format(
      "F: forces of the ropes on what holds them and on what they move, at the output step next to "
      "that moment. {}",
      whole_forces);
  d.across = view.right == 0 ? "x" : "y";
  d.upward = view.above == 2 ? "z" : "y";
  d.legend = {{Role::rope, m.reevings.front().name},
              {Role::second_rope, m.reevings.size() == 2 ? m.reevings.back().name : "other ropes"},
              {Role::force, "ropes on what holds them"}};
  for (const auto& [from, to] : body_lines_at(m, frame)) {
    d.shapes.emplace_back(Polyline{
        .points = {view.point(from), view.point(to)}, .role = Role::structure, .closed = false, .filled = false});
  }
  for (const RopePart& part : rope_parts(m, frame)) {
    Polyline line;
    line.role = part.reeving == 0 ? Role::rope : Role::second_rope;
    for (const Vector3& p : part.points) line.points.push_back(view.point(p));
    if (line.points.size() > 1) d.shapes.emplace_back(std::move(line));
  }
  const double size = size_of(run).norm();
  for (const HeldPart& part : held_parts(m, frame, run.result.frames.front())) {
    const bool round = part.radius > 0 && view.sense(part.axis) != 0;
    const Point at = view.point(part.at);
    d.shapes.emplace_back(Circle{.center = at,
                                 .radius = round ? part.radius : size / 300,
                                 .role = Role::body,
                                 .from = 0,
                                 .to = 0,
                                 .filled = !round});
    const Point f = view.point(part.force);
    if (part.force.norm() > 0) {
      d.shapes.emplace_back(ForceArrow{.at = at,
                                       .fx = f.x,
                                       .fy = f.y,
                                       .label = "F " + part.name,
                                       .role = Role::force,
                                       .towards = false,
                                       .whole = part.force.norm()});
    } else {
      d.shapes.emplace_back(Label{.at = at, .text = part.name});
    }
  }
  return d;
}

/// The frame next to the moment of the largest tension of all.
std::size_t tightest(const study::TransientRun& run) {
  const auto& ropes = run.result.ropes;
  const auto most =
      std::max_element(ropes.begin(), ropes.end(), [](const auto& a, const auto& b) { return a.T.max < b.T.max; });
  if (most == ropes.end()) return 0;
  const auto away = [&](const auto& frame) { return std::abs(frame.t - most->T.t_max); };
  const auto& frames = run.result.frames;
  const auto nearest =
      std::min_element(frames.begin(), frames.end(), [&](const auto& a, const auto& b) { return away(a) < away(b); });
  return static_cast<std::size_t>(nearest - frames.begin());
}

/// The moment of the largest tension with its forces; the strip of the animation shows the others.
void add_drawing(const study::TransientRun& run, Result& r) {
  const std::size_t peak = tightest(run);
  r.figures.emplace_back(
      drawing_of(run, peak, views_of(run).front(),
                 fmt::format("Forces at the largest tension, t = {:.4g} s", run.result.frames[peak].t)));
}

/// Of a motion in space: the ways of the bodies, seen from above, with a dot at each of a few times.
void add_path_in_plan(const study::TransientRun& run, Result& r) {
  const std::vector<PlaneView> views = views_of(run);
  const auto& frames = run.result.frames;
  if (views.size() < 2 || frames.size() < 2) return;
  const PlaneView& plan = views.back();
  const double size = size_of(run).norm();
  Drawing d;
  d.name = "path" + run.ending;
  d.title = "Path in plan";
  d.caption = "Dots at equal steps of time; what does not move is named.";
  d.across = "x";
  d.upward = "y";
  d.legend = {{Role::rope, "path"}};
  bool any = false;
  for (std::size_t b = 0; b < run.model.bodies.size(); ++b) {
    const machine::Body& body = run.model.bodies[b];
    if (body.of_rope || body.beam || (body.free.empty() && body.driven.empty())) continue;
    Polyline way;
    way.role = Role::rope;
    for (const auto& frame : frames) way.points.push_back(plan.point(frame.bodies[b].position));
    double length = 0;
    for (std::size_t i = 1; i < way.points.size(); ++i) {
      length += std::hypot(way.points[i].x - way.points[i - 1].x, way.points[i].y - way.points[i - 1].y);
    }
    if (length < least_path * size) continue;
    any = true;
    for (std::size_t k = 0; k <= path_dots; ++k) {
      const std::size_t i = k * (frames.size() - 1) / path_dots;
      d.shapes.emplace_back(Circle{
          .center = way.points[i], .radius = size / 250, .role = Role::structure, .from = 0, .to = 0, .filled = true});
      const std::string time = fmt::format("{:.3g} s", frames[i].t);
      d.shapes.emplace_back(Label{.at = way.points[i], .text = k == 0 ? body.name + ", " + time : time});
    }
    d.shapes.emplace_back(std::move(way));
  }
  if (!any) return;
  for (const HeldPart& part : held_parts(run.model, frames.front(), frames.front())) {
    if (part.moves) continue;
    d.shapes.emplace_back(Circle{
        .center = plan.point(part.at), .radius = size / 300, .role = Role::body, .from = 0, .to = 0, .filled = true});
    d.shapes.emplace_back(Label{.at = plan.point(part.at), .text = part.name});
  }
  r.figures.emplace_back(std::move(d));
}

/// Driven sheaves and rope loads: where they begin to slip or hold, the machine does something else.
std::set<std::string> gripping_places(const machine::Model& model) {
  std::set<std::string> names;
  for (const machine::Reeving& rope : model.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (node.motor || (node.kind == machine::NodeKind::load && node.load.part == 0)) names.insert(node.name);
    }
  }
  return names;
}

/// The events that change the course of things, without repetition.
std::vector<std::pair<double, std::string>> main_events(const study::TransientRun& run) {
  static const std::vector<std::string> main = {"break",    "stop",  "drive", "brake",   "actuator",
                                                "lift_off", "slack", "taut",  "contact", "apart"};
  std::vector<std::pair<double, std::string>> all;
  std::set<std::string> reported;
  const std::set<std::string> gripping = gripping_places(run.model);
  for (const auto& e : run.result.events) {
    const bool grips = (e.what == "slip" || e.what == "stick") && gripping.contains(e.where);
    if (!grips && std::find(main.begin(), main.end(), e.what) == main.end()) continue;
    // "brake of winch set" says what it is itself
    std::string words = e.where.starts_with(e.what) ? e.where : fmt::format("{} {}", e.what, e.where);
    if (!reported.insert(words).second || all.size() >= most_events) continue;
    all.emplace_back(e.t, std::move(words));
  }
  return all;
}

/// What an animation shows of one frame.
struct ShownFrame {
  std::vector<std::array<Vector3, 2>> bodies;
  std::vector<RopePart> ropes;
  std::vector<HeldPart> held;
};

/// A line for each body and rope, a round for each part that is held.
void begin(Animation& a, const ShownFrame& f, const PlaneView& view) {
  a.lines.resize(f.bodies.size() + f.ropes.size());
  for (std::size_t i = 0; i < f.bodies.size(); ++i) a.lines[i].role = Role::structure;
  for (std::size_t i = 0; i < f.ropes.size(); ++i) {
    a.lines[f.bodies.size() + i].role = f.ropes[i].reeving == 0 ? Role::rope : Role::second_rope;
  }
  for (const HeldPart& part : f.held) {
    a.rounds.push_back({part.name, Role::body, view.sense(part.axis) != 0 ? part.radius : 0, {}, {}});
  }
}

void add(Animation& a, const ShownFrame& f, const PlaneView& view) {
  for (std::size_t i = 0; i < f.bodies.size(); ++i) {
    a.lines[i].points.push_back({view.point(f.bodies[i][0]), view.point(f.bodies[i][1])});
  }
  for (std::size_t i = 0; i < f.ropes.size(); ++i) {
    std::vector<Point> points;
    for (const Vector3& p : f.ropes[i].points) points.push_back(view.point(p));
    a.lines[f.bodies.size() + i].points.push_back(std::move(points));
    const auto& tension = f.ropes[i].tension;
    a.lines[f.bodies.size() + i].tension.push_back(tension.empty() ? none
                                                                   : *std::max_element(tension.begin(), tension.end()));
  }
  for (std::size_t i = 0; i < f.held.size(); ++i) {
    a.rounds[i].at.push_back(view.point(f.held[i].at));
    a.rounds[i].angle.push_back(view.sense(f.held[i].axis) * f.held[i].turned);
  }
}

Animation animation_of(const study::TransientRun& run, const PlaneView& view) {
  const auto& frames = run.result.frames;
  Animation a;
  a.name = fmt::format("motion{}{}", run.ending, view.above == 2 ? "" : "_plan");
  a.title = view.above == 2 ? "The motion, side view" : "The motion, plan";
  a.caption = "Ropes in the colour of their tension. On a screen it plays in real time.";
  a.t = times_of(run);
  a.events = main_events(run);
  a.scene = scene_name(run);
  for (const auto& frame : frames) {
    const ShownFrame shown{.bodies = body_lines_at(run.model, frame),
                           .ropes = rope_parts(run.model, frame),
                           .held = held_parts(run.model, frame, frames.front())};
    if (a.lines.empty()) begin(a, shown, view);
    add(a, shown, view);
  }
  for (std::size_t i = 0; i < run.model.observed.size() && a.readouts.size() < most_readouts; ++i) {
    const machine::Observable& o = run.model.observed[i];
    const bool end = o.quantity == machine::Observed::T_start || o.quantity == machine::Observed::T_end;
    if (!end) a.readouts.push_back({o.name, o.unit, run.result.observed[i]});
  }
  return a;
}

/// Frames that a plot shows: of each bucket those in which a curve is smallest or largest, so that no peak is lost.
std::vector<std::size_t> shown_frames(const std::vector<const std::vector<double>*>& curves, std::size_t count) {
  std::set<std::size_t> shown = {0, count - 1};
  if (count <= 2 * buckets) {
    for (std::size_t i = 0; i < count; ++i) shown.insert(i);
  }
  for (std::size_t b = 0; count > 2 * buckets && b < buckets; ++b) {
    const std::size_t from = b * count / buckets, to = std::max((b + 1) * count / buckets, from + 1);
    for (const auto* curve : curves) {
      const auto [low, high] = std::minmax_element(curve->begin() + static_cast<std::ptrdiff_t>(from),
                                                   curve->begin() + static_cast<std::ptrdiff_t>(to));
      shown.insert(static_cast<std::size_t>(low - curve->begin()));
      shown.insert(static_cast<std::size_t>(high - curve->begin()));
    }
  }
  return {shown.begin(), shown.end()};
}

struct OverTime {
  std::string label;
  std::vector<double> values;  ///< at each output step
};

Plot plot_of(const study::TransientRun& run, const std::string& title, const Axis& y,
             const std::vector<OverTime>& curves) {
  Plot p;
  p.title = title;
  p.caption = fmt::format("Every line written down: time{}.csv.", run.ending);
  p.x = {.label = "time", .unit = si::s};
  p.y = y;
  std::vector<const std::vector<double>*> all;
  all.reserve(curves.size());
  for (const OverTime& one : curves) all.push_back(&one.values);
  const std::vector<std::size_t> shown = shown_frames(all, run.record.count());
  const std::vector<double> t = run.record.lines()->column(0);
  for (const OverTime& one : curves) {
    Curve c;
    c.label = one.label;
    for (const std::size_t i : shown) {
      c.x.push_back(t[i]);
      c.y.push_back(one.values[i]);
    }
    p.curves.push_back(std::move(c));
  }
  for (const auto& [at, words] : main_events(run)) p.marks.push_back({at, 0, words, false, true});
  p.scene = scene_name(run);
  return p;
}

std::string forces_name(const study::TransientRun& run) { return "forces_over_time" + run.ending; }

void add_plots(const study::TransientRun& run, Result& r) {
  const auto& observed = run.model.observed;
  std::vector<bool> done(observed.size(), false);
  bool named = false;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    if (done[i]) continue;
    std::vector<OverTime> curves;
    for (std::size_t k = i; k < observed.size() && curves.size() < most_curves_in_plot; ++k) {
      if (done[k] || observed[k].unit.symbol != observed[i].unit.symbol) continue;
      done[k] = true;
      curves.push_back({observed[k].name, run.record.lines()->column(1 + k)});
    }
    const std::string kind(observed[i].unit.kind);
    const std::string title =
        fmt::format("Over time: {}{}", kind, run.ending.empty() ? "" : ", " + run.ending.substr(1));
    Plot p = plot_of(run, title, {.label = kind, .unit = observed[i].unit}, curves);
    const bool forces = observed[i].unit.symbol == si::N.symbol;
    if (forces && !named) p.name = forces_name(run);  // the first ones: the picture of page 1
    named = named || forces;
    r.figures.emplace_back(std::move(p));
  }
}

void add_energy_plot(const study::TransientRun& run, Result& r) {
  std::vector<OverTime> curves = {{.label = "kinetic", .values = {}},
                                  {.label = "elastic, change", .values = {}},
                                  {.label = "potential, change", .values = {}},
                                  {.label = "supplied", .values = {}},
                                  {.label = "lost", .values = {}},
                                  {.label = "residual", .values = {}}};
  const LongRows& energy = run.record.energy();
  for (std::size_t i = 0; i < curves.size(); ++i) curves[i].values = energy.column(i);
  for (const std::size_t stored : {1U, 2U}) {
    std::vector<double>& values = curves[stored].values;
    const double first = values.front();
    for (double& x : values) x -= first;
  }
  Plot p = plot_of(run, "Energy since the start", {.label = "energy", .unit = si::J}, curves);
  p.name = "energy_over_time" + run.ending;
  p.caption = "What was supplied is what is stored more than at the start, what was lost, and the residual.";
  r.figures.emplace_back(std::move(p));
}

}  // namespace

Drawing drawing_at(const study::TransientRun& run, std::size_t frame, const std::string& title) {
  return drawing_of(run, frame, views_of(run).front(), title);
}

std::string key_figure_of_motion(const study::TransientRun& run, const Result& r) {
  const std::string forces = forces_name(run), motion = fmt::format("motion{}", run.ending);
  for (const std::string& name : {forces, motion}) {
    const bool there = std::any_of(r.figures.begin(), r.figures.end(), [&](const Figure& f) {
      return std::visit([&](const auto& one) { return one.name == name; }, f);
    });
    if (there) return name;
  }
  return {};
}

void add_transient_figures(const study::TransientRun& run, Result& r) {
  add_drawing(run, r);
  if (run.result.frames.size() > 1) {
    for (const PlaneView& view : views_of(run)) r.figures.emplace_back(animation_of(run, view));
  }
  add_path_in_plan(run, r);
  add_plots(run, r);
  add_energy_plot(run, r);
  r.scenes.push_back(scene_of(run));
}

}  // namespace taut::results
