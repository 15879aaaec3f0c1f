#include "taut/results/machine_figures.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "taut/calc/none.hpp"
#include "taut/results/answers/line_profile.hpp"
#include "taut/results/described_state.hpp"
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
  bool shows(const Vector3& force) const { return std::hypot(force.dot(right), force.dot(above)) > 0; }
  /// As long as the part of the force in this view, with the whole force as its number.
  ForceArrow arrow(const Vector3& place, const Vector3& force, const std::string& label, Role role) const {
    return {.at = point(place),
            .fx = force.dot(right),
            .fy = force.dot(above),
            .label = label,
            .role = role,
            .towards = false,
            .whole = force.norm()};
  }
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

/// A state without an answer is the machine as described: its ropes are straight, their tensions not known.
bool is_described(const solve::EquilibriumResult& e) { return !e.outcome.ok(); }

/// Whether the deck's author knows a body by its name: not a section of a beam, nor a point of a rope.
bool is_own(const machine::Body& body) { return !body.of_rope && !body.beam; }

std::vector<std::array<Vector3, 2>> body_lines_of(const machine::Model& m, const solve::EquilibriumResult& e) {
  return body_lines(m, [&](const machine::Place& place) { return machine::in_ground(e.state, place); });
}

/// What of a described machine stands beside its ropes and beams: bodies, and the places that the deck names.
std::vector<Vector3> described_places(const machine::Model& m, const solve::EquilibriumResult& e) {
  std::vector<Vector3> all;
  if (!is_described(e)) return all;
  for (std::size_t i = 0; i < m.bodies.size(); ++i) {
    if (is_own(m.bodies[i])) all.push_back(e.state.bodies[i].position);
  }
  for (const machine::NamedPlace& one : m.places) all.push_back(machine::in_ground(e.state, one.place));
  for (const auto& line : body_lines_of(m, e)) all.insert(all.end(), line.begin(), line.end());
  return all;
}

Box box_of(const machine::Model& m, const solve::EquilibriumResult& e) {
  Box box;
  for (const auto& s : e.branches) {
    for (const Vector3& v : line_of(s)) box.add(v);
  }
  for (const Vector3& v : described_places(m, e)) box.add(v);
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
  const auto seen = [&](const machine::GroundPoint& p) {
    return Point{.x = view.point(m.terrain_from + p.x * m.terrain_along).x, .y = p.z};
  };
  for (std::size_t i = 1; i < m.terrain.size(); ++i) {
    const Point from = seen(m.terrain[i - 1]), to = seen(m.terrain[i]);
    if (std::max(from.x, to.x) <= low || std::min(from.x, to.x) >= high) continue;
    const auto add = [&](const Point& p) {
      const double x = std::clamp(p.x, low, high);
      ground.points.push_back({.x = x, .y = from.y + (x - from.x) / (to.x - from.x) * (to.y - from.y)});
    };
    if (ground.points.empty()) add(from);
    add(to);
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

/// Bodies as lines from their origin to what sits on them.
void draw_bodies(Drawing& d, const machine::Model& m, const solve::EquilibriumResult& e, const View& view) {
  const auto draw = [&](const Vector3& from, const Vector3& to) {
    Polyline line;
    line.role = Role::structure;
    line.points = {view.point(from), view.point(to)};
    d.shapes.emplace_back(std::move(line));
  };
  for (const auto& [from, to] : body_lines_of(m, e)) draw(from, to);
  if (!is_described(e)) return;
  std::set<std::pair<int, std::string>> on_ropes;
  for (const machine::Reeving& rope : m.reevings) {
    for (const machine::Node& node : rope.nodes) on_ropes.insert({node.at.body, node.name});
  }
  for (const machine::NamedPlace& one : m.places) {
    if (one.place.body == machine::ground || on_ropes.contains({one.place.body, one.name})) continue;
    draw(e.state.bodies[one.place.body].position, machine::in_ground(e.state, one.place));
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

/// Each rope with its largest tension, where that is, or with its name alone where no tension is known; too many names
/// would hide the machine.
void name_ropes(Drawing& d, const machine::Model& m, const solve::EquilibriumResult& e, const View& view) {
  if (m.reevings.size() > most_named_ropes) {
    if (!is_described(e)) d.caption += " Tensions of the ropes: table ropes.";
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
    Label label{.at = at(0.5), .text = m.reevings[i].name, .or_at = {at(0.35), at(0.65), at(0.2), at(0.8)}};
    if (!is_described(e)) {
      label.text = "T " + label.text;
      label.force = rope.T_max;
    }
    d.shapes.emplace_back(std::move(label));
  }
}

/// Lengths of beams; the span and the difference in height of the first rope's ends; the sag of wide branches.
void draw_dimensions(Drawing& d, const machine::Model& m, const solve::EquilibriumResult& e, const View& view) {
  const Box box = box_of(m, e);
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

/// Whether the first rope has one span: nothing but carriages and points of the free rope is between its ends.
bool has_one_span(const machine::Model& m) {
  if (m.reevings.empty() || m.reevings.front().closed) return false;
  const auto& nodes = m.reevings.front().nodes;
  const auto carries = [&](int node) {
    return std::any_of(m.carriages.begin(), m.carriages.end(), [&](const machine::Carriage& car) {
      return car.reeving == 0 && node >= car.node && node < car.node + car.rollers;
    });
  };
  for (int n = 1; n + 1 < static_cast<int>(nodes.size()); ++n) {
    if (nodes[n].kind != machine::NodeKind::load && !carries(n)) return false;
  }
  return true;
}

/// Over everything that is drawn: the span of the first rope, and the difference in height of its ends.
void draw_span(Drawing& d, const machine::Model& m, const solve::EquilibriumResult& e, const View& view) {
  if (view.plan || !has_one_span(m)) return;
  const auto first = std::find_if(e.branches.begin(), e.branches.end(), [](const auto& s) { return s.reeving == 0; });
  const auto last = std::find_if(e.branches.rbegin(), e.branches.rend(), [](const auto& s) { return s.reeving == 0; });
  if (first == e.branches.end()) return;
  Point from = view.point(first->start), to = view.point(last->end);
  if (from.x > to.x) std::swap(from, to);
  const Box box = box_of(m, e);
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

void draw_round(Drawing& d, const Point& centre, double radius, double size) {
  const bool round = radius > 0;
  d.shapes.emplace_back(Circle{.center = centre,
                               .radius = round ? radius : size / 300,
                               .role = Role::body,
                               .from = 0,
                               .to = 0,
                               .filled = !round});
}

void draw_holders(Drawing& d, const machine::Model& m, const solve::EquilibriumResult& e, const View& view,
                  double size) {
  for (const auto& [name, h] : held_of(m, e)) {
    draw_round(d, view.point(h.at), view.plan ? 0 : h.radius, size);
    if (h.moves || h.force.norm() <= 0) {  // the ropes of what moves are in balance with its weight
      d.shapes.emplace_back(Label{.at = view.point(h.at), .text = name});
      continue;
    }
    d.shapes.emplace_back(view.arrow(h.at, h.force, "F " + name, Role::force));
  }
}

/// Of a described machine the bodies and named places that no rope touches.
void draw_others(Drawing& d, const machine::Model& m, const solve::EquilibriumResult& e, const View& view,
                 double size) {
  if (!is_described(e)) return;
  const std::map<std::string, Held> held = held_of(m, e);
  const auto draw = [&](const std::string& name, const Vector3& at) {
    if (held.contains(name)) return;
    draw_round(d, view.point(at), 0, size);
    d.shapes.emplace_back(Label{.at = view.point(at), .text = name});
  };
  for (std::size_t i = 0; i < m.bodies.size(); ++i) {
    if (is_own(m.bodies[i])) draw(m.bodies[i].name, e.state.bodies[i].position);
  }
  for (const machine::NamedPlace& one : m.places) draw(one.name, machine::in_ground(e.state, one.place));
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
    if (view.shows(force)) d.shapes.emplace_back(view.arrow(place, force, name, Role::second_force));
    i = last;
  }
}

void draw_weights(Drawing& d, const machine::Model& m, const solve::EquilibriumResult& e, const View& view) {
  const auto draw = [&](const machine::Place& place, const Vector3& force, const std::string& label) {
    if (!view.shows(force)) return;
    d.shapes.emplace_back(view.arrow(machine::in_ground(e.state, place), force, label, Role::second_force));
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

/// Titles and caption of the drawings of one state.
struct FigureText {
  std::string title, plan_title, caption;
};

FigureText text_of_answer(const std::string& words) {
  return {.title = "Side view",
          .plan_title = "Plan",
          .caption = fmt::format("{}. T: largest tension of a rope. F: ropes on what holds them. W and P: weights and "
                                 "loads. {}",
                                 words, whole_forces)};
}

FigureText text_of_description(const std::string& why) {
  const std::string title = "Machine as described; " + why;
  return {.title = title,
          .plan_title = title + ", plan",
          .caption =
              fmt::format("This is not an answer: ropes are drawn straight, and no tension is known. W and P: weights "
                          "and loads that are given. {}",
                          whole_forces)};
}

Drawing drawing_of(const machine::Model& m, const solve::EquilibriumResult& e, const View& view,
                   const FigureText& text) {
  const Box box = box_of(m, e);
  const bool plan = view.plan;
  Drawing d;
  d.name = plan ? "plan" : "machine";
  d.title = plan ? text.plan_title : text.title;
  d.caption = text.caption;
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
  draw_others(d, m, e, view, box.size().norm());
  draw_weights(d, m, e, view);
  draw_rope_loads(d, e, m, view);
  name_ropes(d, m, e, view);
  draw_span(d, m, e, view);
  draw_dimensions(d, m, e, view);
  return d;
}

void add_drawings(const machine::Model& m, const solve::EquilibriumResult& e, const std::optional<Vector3>& line,
                  const FigureText& text, Result& r) {
  const Box box = box_of(m, e);
  const Vector3 size = box.size();
  // seen across its longer horizontal side, or across the line that the ground or a load path follows
  const Vector3 longer = size.y() > size.x() ? Vector3(Vector3::UnitY()) : Vector3(Vector3::UnitX());
  const Vector3 right = line ? *line : longer;
  r.figures.emplace_back(drawing_of(m, e, {.right = right}, text));
  const Vector3 aside = up().cross(right);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto take = [&](const Vector3& v) {
    low = std::min(low, v.dot(aside));
    high = std::max(high, v.dot(aside));
  };
  for (const auto& s : e.branches) {
    take(s.start);
    take(s.end);
  }
  for (const Vector3& v : described_places(m, e)) take(v);
  if (high - low <= least_width * std::max(size.x(), size.y())) return;
  r.figures.emplace_back(drawing_of(m, e, {.right = Vector3::UnitX(), .above = Vector3::UnitY(), .plan = true}, text));
}

Plot plot(const study::LoadPathRun& run, const std::string& name, const std::string& title, const Axis& y) {
  Plot p;
  p.name = name + run.ending;
  p.title = fmt::format("{}, {}", title, path_words(run));
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

/// The state that decides: of those that are judged, if any are, the one that strains its ropes most.
const Answer& deciding(const std::vector<Answer>& all) {
  const bool any_judged = std::any_of(all.begin(), all.end(), [](const Answer& one) { return one.judged; });
  return *std::max_element(all.begin(), all.end(), [&](const Answer& a, const Answer& b) {
    if (any_judged && a.judged != b.judged) return b.judged;
    return strain_of(*a.model, *a.result) < strain_of(*b.model, *b.result);
  });
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

std::vector<std::array<Vector3, 2>> body_lines(const machine::Model& m,
                                               const std::function<Vector3(const machine::Place&)>& in_ground) {
  std::vector<std::array<Vector3, 2>> lines;
  std::set<std::pair<int, std::string>> drawn;
  for (const machine::Reeving& rope : m.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (node.at.body == machine::ground || node.at.at.norm() == 0) continue;
      if (!drawn.insert({node.at.body, node.name}).second) continue;
      lines.push_back({in_ground({.body = node.at.body}), in_ground(node.at)});
    }
  }
  for (const machine::Face& face : m.faces) {
    lines.push_back({in_ground({.body = face.body, .at = face.from}), in_ground({.body = face.body, .at = face.to})});
  }
  for (const machine::Actuator& one : m.actuators) {
    lines.push_back(
        {in_ground({.body = one.from_body, .at = one.from}), in_ground({.body = one.to_body, .at = one.to})});
  }
  return lines;
}

void add_described_figures(MachineRun& run, const std::string& why, Result& r) {
  const solve::EquilibriumResult e = described_state(run.model);
  const double size = box_of(run.model, e).size().norm();
  if (!(size > 0) || std::isinf(size)) return;  // one place alone, or nothing
  add_drawings(run.model, e, line_of(run), text_of_description(why), r);
  run.key_figure.offer(Pictured::machine, "machine");
  r.key_figure = run.key_figure.name;
}

void add_figures(MachineRun& run, Result& r) {
  const std::vector<Answer> all = pictured_of(run);
  if (all.empty()) {
    const bool at_rest = !run.equilibria.empty() || !run.paths.empty();
    if (r.status != Status::ok && run.key_figure.shows == Pictured::nothing) {
      add_described_figures(run, at_rest ? "no equilibrium was found" : "no answer was found", r);
    }
    return;
  }
  const Answer& drawn = deciding(all);
  const bool at_rest = std::any_of(run.equilibria.begin(), run.equilibria.end(),
                                   [&](const auto& one) { return &one.result == drawn.result; });
  std::string words = fmt::format("{}{}", at_rest ? "Equilibrium, " : "", drawn.words);
  if (const std::string more = strained_more(run, strain_of(*drawn.model, *drawn.result), r); !more.empty()) {
    words += fmt::format(". Its ropes bear more in a state that is not drawn: {}", more);
  } else if (all.size() > 1) {
    words = "The state that strains its ropes most: " + words;
  }
  add_drawings(*drawn.model, *drawn.result, line_of(run), text_of_answer(words), r);
  run.key_figure.offer(Pictured::machine, "machine");
  for (const study::LoadPathRun& path : run.paths) {
    Profile profile = load_path_profile(run, path);
    if (profile.places.size() > 1) {
      run.key_figure.offer(Pictured::load_path, profile.name, path.judged);
      r.figures.emplace_back(std::move(profile));
    }
    add_plots(run.model, path, r);
  }
  add_path_plots(run, r);
}

}  // namespace taut::results
