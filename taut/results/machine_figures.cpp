#include "taut/results/machine_figures.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "taut/calc/none.hpp"
#include "taut/results/answers/line_profile.hpp"
#include "taut/results/machine_beams.hpp"
#include "taut/results/machine_tables.hpp"
#include "taut/results/plot_curves.hpp"
#include "taut/solve/quantities.hpp"
#include "taut/study/line/rope_clearance.hpp"

namespace taut::results {
namespace {

constexpr int points_per_span = 32;
/// Machines narrower than this part of their length need no plan.
constexpr double least_width = 1e-3;
constexpr std::size_t most_named_ropes = 8;
constexpr std::size_t most_dimensions = 6;

/// A view: which horizontal direction goes to the right, and which one up.
struct View {
  Vector3 right = Vector3::UnitX();
  Vector3 above = up();
  bool plan = false;
  Point point(const Vector3& v) const { return {.x = v.dot(right), .y = v.dot(above)}; }
};

struct Box {
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 high = -low;
  void add(const Vector3& v) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  Vector3 size() const { return high - low; }
};

std::vector<Vector3> line_of(const solve::BranchResult& s) {
  if (s.slack || s.shape.rope.weight <= 0 || !(s.shape.rope.length > 0)) return {s.start, s.end};
  std::vector<Vector3> line;
  for (int i = 0; i <= points_per_span; ++i) {
    line.emplace_back(s.start + rope::point_at(s.shape, s.shape.rope.length * i / points_per_span));
  }
  return line;
}

Box box_of(const solve::EquilibriumResult& e) {
  Box box;
  for (const auto& s : e.branches) {
    for (const Vector3& v : line_of(s)) box.add(v);
  }
  for (const auto& line : beam_lines(e)) {
    for (const Vector3& v : line) box.add(v);
  }
  return box;
}

/// What holds the ropes somewhere: all forces of one name at one place.
struct Held {
  Vector3 at = Vector3::Zero();
  double radius = 0;
  Vector3 force = Vector3::Zero();
  bool moves = false;
};

std::map<std::string, Held> held_of(const machine::Model& m, const solve::EquilibriumResult& e) {
  std::map<std::string, Held> all;
  const auto add = [&](int reeving, int n, const Vector3& force) {
    const machine::Reeving& rope = m.reevings[reeving];
    const machine::Node& node = rope.nodes[n];
    Held& h = all[node.name];
    h.at = machine::in_ground(e.state, node.at);
    h.radius = std::max(h.radius, node.radius);
    h.force += force * rope.copies;
    h.moves = node.at.body != machine::ground && !m.bodies[node.at.body].free.empty();
  };
  const auto is_anchor = [&](int reeving, int n) {
    return m.reevings[reeving].nodes[n].kind == machine::NodeKind::anchor;
  };
  for (const auto& s : e.branches) {
    if (is_anchor(s.reeving, s.from)) add(s.reeving, s.from, solve::pull_on_start(s));
    if (is_anchor(s.reeving, s.to)) add(s.reeving, s.to, solve::pull_on_end(s));
  }
  for (const auto& c : e.contacts) {
    const auto& rope = m.reevings[c.reeving];
    if (rope.nodes[c.node].kind != machine::NodeKind::load) add(c.reeving, c.node, c.force);
  }
  return all;
}

void draw_ground(Drawing& d, const machine::Model& m, const View& view, const Box& box) {
  // seen along the profile, or not at all
  if (view.plan || m.terrain.empty() || std::abs(view.right.dot(m.terrain_along)) < 1 - 1e-9) return;
  const double margin = 0.03 * box.size().norm();
  const double low = std::min(view.point(box.low).x, view.point(box.high).x) - margin;
  const double high = std::max(view.point(box.low).x, view.point(box.high).x) + margin;
  Polyline ground;
  ground.role = Role::ground;
  for (const auto& p : m.terrain) {
    const double x = view.point(m.terrain_from + p.x * m.terrain_along).x;
    if (x >= low && x <= high) ground.points.push_back({x, p.z});
  }
  if (ground.points.size() > 1) d.shapes.emplace_back(std::move(ground));
}

void draw_ropes(Drawing& d, const solve::EquilibriumResult& e, const View& view) {
  for (const auto& s : e.branches) {
    Polyline line;
    line.role = s.reeving == 0 ? Role::rope : Role::second_rope;
    for (const Vector3& v : line_of(s)) line.points.push_back(view.point(v));
    d.shapes.emplace_back(std::move(line));
  }
}

/// Bodies as lines from their origin to where ropes hold them.
void draw_bodies(Drawing& d, const machine::Model& m, const solve::EquilibriumResult& e, const View& view) {
  std::set<std::pair<int, std::string>> drawn;
  for (const machine::Reeving& rope : m.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (node.at.body == machine::ground || node.at.at.norm() == 0) continue;
      if (!drawn.insert({node.at.body, node.name}).second) continue;
      const Vector3& origin = e.state.bodies[node.at.body].position;
      Polyline line;
      line.role = Role::structure;
      line.points = {view.point(origin), view.point(machine::in_ground(e.state, node.at))};
      d.shapes.emplace_back(std::move(line));
    }
  }
}

/// Beams as they stand, and beside them with deflections so many times as large.
void draw_beams(Drawing& d, const solve::EquilibriumResult& e, const View& view, double times) {
  const auto draw = [&](const std::vector<std::vector<Vector3>>& lines, Role role) {
    for (const auto& points : lines) {
      Polyline line;
      line.role = role;
      for (const Vector3& v : points) line.points.push_back(view.point(v));
      d.shapes.emplace_back(std::move(line));
    }
  };
  draw(beam_lines(e), Role::structure);
  if (times > 0) draw(beam_lines(e, times), Role::highlight);
}

/// Each rope with its largest tension, where that is; too many names would hide the machine.
void name_ropes(Drawing& d, const machine::Model& m, const solve::EquilibriumResult& e, const View& view) {
  if (m.reevings.size() > most_named_ropes) {
    d.caption += " Tensions of the ropes: table ropes.";
    return;
  }
  for (std::size_t i = 0; i < m.reevings.size() && i < e.ropes.size(); ++i) {
    const auto& rope = e.ropes[i];
    if (rope.branch < 0 || static_cast<std::size_t>(rope.branch) >= e.branches.size()) continue;
    const std::vector<Vector3> line = line_of(e.branches[rope.branch]);
    const auto at = [&](double share) {
      const double place = share * static_cast<double>(line.size() - 1);
      const auto k = std::min(static_cast<std::size_t>(place), line.size() - 2);
      return view.point(line[k] + (place - static_cast<double>(k)) * (line[k + 1] - line[k]));
    };
    d.shapes.emplace_back(Label{.at = at(0.5),
                                .text = "T " + m.reevings[i].name,
                                .or_at = {at(0.35), at(0.65), at(0.2), at(0.8)},
                                .force = rope.T_max});
  }
}

/// Lengths of beams; the span and the difference in height of the first rope's ends; the sag of wide branches.
void draw_dimensions(Drawing& d, const machine::Model& m, const solve::EquilibriumResult& e, const View& view) {
  const Box box = box_of(e);
  const double size = box.size().norm();
  for (const auto& b : e.beams) {
    const Point from = view.point(b.points.front().place), to = view.point(b.points.back().place);
    if (e.beams.size() > most_dimensions || std::hypot(to.x - from.x, to.y - from.y) < 0.1 * size) continue;
    d.shapes.emplace_back(DimensionLine{
        .from = from, .to = to, .offset = 0.03 * size, .text = m.beams[b.beam].name, .with_length = true});
  }
  if (view.plan) return;
  std::size_t drawn = 0;
  for (const auto& s : e.branches) {
    if (s.reeving != 0 || s.slack || drawn == most_dimensions) continue;
    const std::vector<Vector3> line = line_of(s);
    const Point from = view.point(line.front()), to = view.point(line.back());
    const double span = std::abs(to.x - from.x);
    if (span < 0.3 * size || line.size() < 3) continue;
    ++drawn;
    double sag = 0;
    Point lowest, chord;
    for (const Vector3& v : line) {
      const Point p = view.point(v);
      const double on_chord = from.y + (p.x - from.x) / (to.x - from.x) * (to.y - from.y);
      if (on_chord - p.y <= sag) continue;
      sag = on_chord - p.y;
      lowest = p;
      chord = {.x = p.x, .y = on_chord};
    }
    if (sag > 0.02 * span) {
      d.shapes.emplace_back(
          DimensionLine{.from = chord, .to = lowest, .offset = 0, .text = "sag", .with_length = true});
    }
  }
}

/// Over everything that is drawn: how far the first rope's ends are apart, level and in height.
void draw_span(Drawing& d, const machine::Model& m, const solve::EquilibriumResult& e, const View& view) {
  if (view.plan || m.reevings.empty() || m.reevings.front().closed) return;
  const auto first = std::find_if(e.branches.begin(), e.branches.end(), [](const auto& s) { return s.reeving == 0; });
  const auto last = std::find_if(e.branches.rbegin(), e.branches.rend(), [](const auto& s) { return s.reeving == 0; });
  if (first == e.branches.end()) return;
  Point from = view.point(first->start), to = view.point(last->end);
  if (from.x > to.x) std::swap(from, to);
  const Box box = box_of(e);
  const double size = box.size().norm(), span = to.x - from.x, rise = std::abs(to.y - from.y);
  if (span < 0.5 * size) return;
  const double top = box.high.z() + 0.06 * size;
  d.shapes.emplace_back(DimensionLine{
      .from = {.x = from.x, .y = top}, .to = {.x = to.x, .y = top}, .offset = 0, .text = "span", .with_length = true});
  if (rise > 0.02 * span) {
    const Point& low = from.y < to.y ? from : to;
    const double x = low.x + (low.x == to.x ? 0.03 : -0.03) * size;
    d.shapes.emplace_back(DimensionLine{.from = {.x = x, .y = low.y},
                                        .to = {.x = x, .y = low.y + rise},
                                        .offset = 0,
                                        .text = "height",
                                        .with_length = true});
  }
}

void draw_holders(Drawing& d, const machine::Model& m, const solve::EquilibriumResult& e, const View& view,
                  double size) {
  for (const auto& [name, h] : held_of(m, e)) {
    const bool round = h.radius > 0 && !view.plan;
    d.shapes.emplace_back(Circle{.center = view.point(h.at),
                                 .radius = round ? h.radius : size / 300,
                                 .role = Role::body,
                                 .from = 0,
                                 .to = 0,
                                 .filled = !round});
    const Point f = view.point(h.force);
    if (h.moves || std::hypot(f.x, f.y) <= 0) {  // the ropes of what moves are in balance with its weight
      d.shapes.emplace_back(Label{.at = view.point(h.at), .text = name});
      continue;
    }
    d.shapes.emplace_back(ForceArrow{
        .at = view.point(h.at), .fx = f.x, .fy = f.y, .label = "F " + name, .role = Role::force, .towards = false});
  }
}

/// Forces along the ropes; a rate as one arrow in the middle of its parts.
void draw_rope_loads(Drawing& d, const solve::EquilibriumResult& e, const machine::Model& m, const View& view) {
  for (std::size_t i = 0; i < e.rope_loads.size();) {
    const auto load_of = [&](std::size_t k) -> const machine::Node& {
      const auto& one = e.rope_loads[k];
      return m.reevings[one.reeving].nodes[one.node];
    };
    const std::string name = load_of(i).name.substr(0, load_of(i).name.find('['));
    Vector3 force = Vector3::Zero(), place = Vector3::Zero();
    std::size_t last = i;
    for (; last < e.rope_loads.size() && load_of(last).name.substr(0, load_of(last).name.find('[')) == name; ++last) {
      force += e.rope_loads[last].force;
      place += e.rope_loads[last].at;
    }
    place /= static_cast<double>(last - i);
    const Point f = view.point(force);
    if (std::hypot(f.x, f.y) > 0) {
      d.shapes.emplace_back(ForceArrow{
          .at = view.point(place), .fx = f.x, .fy = f.y, .label = name, .role = Role::second_force, .towards = false});
    }
    i = last;
  }
}

void draw_weights(Drawing& d, const machine::Model& m, const solve::EquilibriumResult& e, const View& view) {
  const auto draw = [&](const machine::Place& place, const Vector3& force, const std::string& label) {
    const Point f = view.point(force);
    if (std::hypot(f.x, f.y) <= 0) return;
    d.shapes.emplace_back(ForceArrow{.at = view.point(machine::in_ground(e.state, place)),
                                     .fx = f.x,
                                     .fy = f.y,
                                     .label = label,
                                     .role = Role::second_force,
                                     .towards = false});
  };
  for (std::size_t i = 0; i < m.bodies.size(); ++i) {
    const machine::Body& body = m.bodies[i];
    const auto index = static_cast<int>(i);
    if (body.free.empty()) continue;
    // what hangs at the same place as the body's own weight is one arrow with it
    Vector3 own = -body.mass * m.gravity * up();
    for (const machine::Load& load : m.loads) {
      if (load.at.body != index) continue;
      if ((load.at.at - body.centre).norm() == 0) {
        own += load.force;
      } else {
        draw(load.at, load.force, "P " + body.name);
      }
    }
    draw({.body = index, .at = body.centre}, own, (body.mass > 0 ? "W " : "P ") + body.name);
  }
}

Drawing drawing_of(const machine::Model& m, const solve::EquilibriumResult& e, const View& view,
                   const std::string& words) {
  const Box box = box_of(e);
  const bool plan = view.plan;
  Drawing d;
  d.name = plan ? "plan" : "machine";
  d.title = plan ? "Plan" : "Side view";
  d.caption = fmt::format(
      "{}. T: largest tension of a rope. F: ropes on what holds them, W and P: weights and loads, as they are seen in "
      "this view.",
      words);
  d.across = view.right == Vector3::UnitX() ? "x" : view.right == Vector3::UnitY() ? "y" : "along the line";
  d.upward = plan ? "y" : "z";
  d.legend = {{Role::rope, m.reevings.empty() ? "rope" : m.reevings.front().name},
              {Role::second_rope, m.reevings.size() == 2 ? m.reevings.back().name : "other ropes"},
              {Role::force, "ropes on what holds them"},
              {Role::second_force, "weights and loads"},
              {Role::ground, "ground"}};
  const double times = shown_times(e, box.size().norm());
  if (times > 0) d.legend.emplace_back(Role::highlight, fmt::format("beams, deflections {:g} times", times));
  draw_ground(d, m, view, box);
  draw_bodies(d, m, e, view);
  draw_beams(d, e, view, times);
  draw_ropes(d, e, view);
  draw_holders(d, m, e, view, box.size().norm());
  draw_weights(d, m, e, view);
  draw_rope_loads(d, e, m, view);
  name_ropes(d, m, e, view);
  draw_span(d, m, e, view);
  draw_dimensions(d, m, e, view);
  return d;
}

void add_drawings(const machine::Model& m, const solve::EquilibriumResult& e, const std::optional<Vector3>& line,
                  const std::string& words, Result& r) {
  const Box box = box_of(e);
  const Vector3 size = box.size();
  // seen across its longer horizontal side, or across the line that the ground or a load path follows
  const Vector3 longer = size.y() > size.x() ? Vector3(Vector3::UnitY()) : Vector3(Vector3::UnitX());
  const Vector3 right = line ? *line : longer;
  r.figures.emplace_back(drawing_of(m, e, {.right = right}, words));
  const Vector3 aside = up().cross(right);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& s : e.branches) {
    for (const Vector3& v : {s.start, s.end}) {
      low = std::min(low, v.dot(aside));
      high = std::max(high, v.dot(aside));
    }
  }
  if (high - low <= least_width * std::max(size.x(), size.y())) return;
  r.figures.emplace_back(drawing_of(m, e, {.right = Vector3::UnitX(), .above = Vector3::UnitY(), .plan = true}, words));
}

Plot plot(const study::LoadPathRun& run, const std::string& name, const std::string& title, const Axis& y) {
  Plot p;
  p.name = name + run.ending;
  p.title = fmt::format("{}, {}", title, run.words);
  p.x = {.label = "x of the carriage", .unit = si::m};
  p.y = y;
  return p;
}

template <class Of>
Curve curve(const study::LoadPathRun& run, const std::string& label, Of&& of, bool dashed = false) {
  Curve c;
  c.label = label;
  c.dashed = dashed;
  for (const study::LoadPathPart& part : run.parts) {
    for (const auto& point : part.result.points) {
      c.x.push_back(point.x);
      c.y.push_back(point.at.outcome.ok() ? of(point) : none);
    }
  }
  return c;
}

void add_plots(const machine::Model& m, const study::LoadPathRun& run, Result& r) {
  Plot tensions = plot(run, "load_path_tensions", "Largest tension of each rope", {.label = "tension", .unit = si::N});
  for (std::size_t i = 0; i < m.reevings.size(); ++i) {
    tensions.curves.push_back(curve(run, m.reevings[i].name, [&](const auto& p) { return p.at.ropes[i].T_max; }));
  }
  keep_largest(tensions, most_shown_curves);
  r.figures.emplace_back(std::move(tensions));
  if (m.terrain.empty()) return;
  Plot clearance = plot(run, "load_path_clearance", "Clearance over the ground", {.label = "clearance", .unit = si::m});
  clearance.curves.push_back(curve(run, "carriage", [](const auto& p) { return p.clearance; }));
  clearance.curves.push_back(
      curve(run, "lowest rope", [&](const auto& p) { return study::rope_clearance(m, p.at).height; }));
  clearance.marks.push_back({0, 0, "ground", true});
  r.figures.emplace_back(std::move(clearance));
}

double largest_tension(const solve::EquilibriumResult& e) {
  double T = 0;
  for (const auto& rope : e.ropes) T = std::max(T, rope.T_max);
  return T;
}

/// The direction that the ground or a load path follows, where the deck says one across the axes.
std::optional<Vector3> line_of(const MachineRun& run) {
  const Vector3 x = Vector3::UnitX();
  if (!run.model.terrain.empty() && run.model.terrain_along != x) return run.model.terrain_along;
  for (const study::LoadPathRun& path : run.paths) {
    if (path.way.along != x) return path.way.along;
  }
  return std::nullopt;
}

}  // namespace

void add_figures(MachineRun& run, Result& r) {
  const std::vector<Answer> all = answers_of(run);
  if (all.empty()) return;
  const bool has_equilibrium = all.front().point == nullptr && !run.equilibria.empty();
  const Answer drawn =
      has_equilibrium ? all.front() : *std::max_element(all.begin(), all.end(), [](const Answer& a, const Answer& b) {
        return largest_tension(*a.result) < largest_tension(*b.result);
      });
  add_drawings(*drawn.model, *drawn.result, line_of(run),
               (has_equilibrium ? "Equilibrium, " : "Where the tension is largest: ") + drawn.words, r);
  run.key_figure.offer(Pictured::machine, "machine");
  for (const study::LoadPathRun& path : run.paths) {
    Profile profile = load_path_profile(run, path);
    if (profile.places.size() > 1) {
      run.key_figure.offer(Pictured::load_path, profile.name);
      r.figures.emplace_back(std::move(profile));
    }
    add_plots(run.model, path, r);
  }
  add_path_plots(run, r);
}

}  // namespace taut::results
