#include "taut/methods/boom_ropes/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/methods/boom_ropes/sliding.hpp"

namespace taut::boom_ropes {
namespace {

/// Places along the boom (m from its foot) of pads, heads and sheaves at one boom length.
struct Stations {
  double rear_3, rear_2, head_1, head_2, head_3;
  double height_1, height_2, height_3;
};

Stations stations(const Sliding& q, double boom_length) {
  const double travel = (boom_length - q.retracted_length) / 2;
  Stations p{};
  p.head_3 = boom_length;
  p.rear_3 = boom_length - q.head_distance;
  p.head_2 = p.rear_3 + q.overlap_23 - travel;
  p.rear_2 = p.head_2 - q.overlap_23 - q.gap;
  p.head_1 = p.rear_2 + q.overlap_12 - travel;
  p.height_3 = std::max(q.pad_height_3, 0.2);
  p.height_2 = std::max(q.pad_height_2, 1.2 * p.height_3);
  p.height_1 = 1.2 * p.height_2;
  return p;
}

/// Turns boom coordinates (along, across) by the luffing angle.
struct Frame {
  double angle = 0;
  Point operator()(double along, double across) const {
    return {.x = along * std::cos(angle) - across * std::sin(angle),
            .y = along * std::sin(angle) + across * std::cos(angle)};
  }
  ForceArrow force(Point at, double along, double across, std::string label, Role role, bool towards = false) const {
    const Point f = (*this)(along, across);
    return {.at = at, .fx = f.x, .fy = f.y, .label = std::move(label), .role = role, .towards = towards};
  }
};

Polyline box(const Frame& turn, double from, double to, double height, Role role) {
  return {.points = {turn(from, -height / 2), turn(to, -height / 2), turn(to, height / 2), turn(from, height / 2)},
          .role = role,
          .closed = true};
}

void add_sections(Drawing& d, const Frame& turn, const Stations& p) {
  d.shapes.emplace_back(box(turn, std::min(0.0, p.rear_2), p.head_1, p.height_1, Role::structure));
  d.shapes.emplace_back(box(turn, p.rear_2, p.head_2, p.height_2, Role::body));
  d.shapes.emplace_back(box(turn, p.rear_3, p.head_3, p.height_3, Role::structure));
}

/// The boom in one position, with its weights.
Drawing boom(const Input& in, const Sliding& q, const SlidingPoint& g, const Display& display) {
  Drawing d;
  d.name = "boom";
  const Frame turn{g.luffing_angle};
  const Stations p = stations(q, g.boom_length);
  add_sections(d, turn, p);
  d.shapes.emplace_back(Polyline{.points = {turn(0, 0), turn(p.rear_2, q.offset_cylinder)}, .role = Role::hidden});
  const Point head = turn(p.head_3, q.offset_hoist);
  const double fall = std::min(4.0, std::max(1.0, 0.2 * g.boom_length));
  d.shapes.emplace_back(Polyline{.points = {head, {.x = head.x, .y = head.y - fall}}, .role = Role::rope});
  d.shapes.emplace_back(ForceArrow{.at = {.x = head.x, .y = head.y - fall},
                                   .fx = 0,
                                   .fy = -g.suspended_weight,
                                   .label = "G_n",
                                   .role = Role::force});
  const Point center = turn(p.rear_3 + q.center_3, 0);
  d.shapes.emplace_back(
      ForceArrow{.at = center, .fx = 0, .fy = -in.section_weight, .label = "G_3", .role = Role::force});
  d.shapes.emplace_back(AngleMark{
      .center = {.x = 0, .y = 0}, .radius = 0.3 * g.boom_length, .from = 0, .to = g.luffing_angle, .text = "beta"});
  d.shapes.emplace_back(Polyline{.points = {{.x = -0.05 * g.boom_length, .y = 0}, {.x = 0.5 * g.boom_length, .y = 0}},
                                 .role = Role::ground});
  d.shapes.emplace_back(DimensionLine{.from = turn(0, 0),
                                      .to = turn(p.head_3, 0),
                                      .offset = 2 * p.height_1,
                                      .text = "L_b = " + display.brief(g.boom_length, si::m)});
  return d;
}

std::string position_words(const SlidingPoint& g, const Display& display) {
  return fmt::format("Luffing angle {}, boom {}", display.brief(g.luffing_angle, si::rad),
                     display.brief(g.boom_length, si::m));
}

Drawing loaded_boom(const Input& in, const Sliding& q, const SlidingPoint& g, const Display& display) {
  Drawing d = boom(in, q, g, display);
  d.title = "The boom where the cylinder force is largest";
  d.caption = position_words(g, display) + "; forces on section 3 and on the cylinder.";
  const Frame turn{g.luffing_angle};
  d.shapes.emplace_back(
      turn.force(turn(stations(q, g.boom_length).rear_2, q.offset_cylinder), g.Fh, 0, "F_h", Role::second_force, true));
  return d;
}

void add_pads(Drawing& d, const Frame& turn, double along, double height, double N, std::string label) {
  const double side = N >= 0 ? -1 : 1;  // the lower pad pushes up, the upper one down
  for (const double z : {-height / 2, height / 2}) {
    d.shapes.emplace_back(Polyline{.points = {turn(along - 0.12, z), turn(along + 0.12, z)}, .role = Role::structure});
  }
  d.shapes.emplace_back(turn.force(turn(along, side * height / 2), 0, N, std::move(label), Role::force, true));
}

/// Ropes and pads, the boom laid level and stretched across so that they can be distinguished.
Drawing ropes(const Sliding& q, const SlidingPoint& g, const Display& display) {
  Drawing d;
  const double travel = (g.boom_length - q.retracted_length) / 2;
  d.name = "ropes";
  d.title = "Ropes and pads along the boom";
  d.caption = fmt::format(
      "Boom frame, heights stretched. Extension rope from the rear of section 1 over the head of section 2 to the tail "
      "of "
      "section 3 (second branch below it the same way); retraction rope from the front of section 1 over the tail of "
      "section 2. Overlaps {} (2-3) and {} (1-2). {}",
      display.brief(q.overlap_23 - travel, si::m), display.brief(q.overlap_12 - travel, si::m),
      g.jamming() ? "The upper rear pad of section 3 carries: its friction jams the section."
                  : "Lower pads carry section 3.");
  d.vertical_scale = 6;
  const Frame level;
  const Stations p = stations(q, g.boom_length);
  add_sections(d, level, p);
  const double high = (p.height_3 + p.height_2) / 4;
  const double low = (p.height_2 + p.height_1) / 4;
  const double rear_1 = std::min(0.0, p.rear_2);
  const double tail = p.rear_3 - equaliser_distance;
  for (const double side : {1.0, -1.0}) {
    d.shapes.emplace_back(Polyline{.points = {{.x = rear_1, .y = side * low},
                                              {.x = p.head_2, .y = side * low},
                                              {.x = p.head_2, .y = side * high},
                                              {.x = tail, .y = side * high}},
                                   .role = Role::rope});
  }
  const double r = 0.35 * high;
  d.shapes.emplace_back(Polyline{
      .points = {{.x = p.head_1, .y = -r}, {.x = p.rear_2, .y = -r}, {.x = p.rear_2, .y = r}, {.x = p.rear_3, .y = r}},
      .role = Role::second_rope});
  add_pads(d, level, p.rear_3, p.height_3, g.Nr, "N_r");
  add_pads(d, level, p.head_2, p.height_3, g.Nf, "N_f");
  add_pads(d, level, p.rear_2, p.height_2, g.Mr, "M_r");
  add_pads(d, level, p.head_1, p.height_2, g.Mf, "M_f");
  d.shapes.emplace_back(Label{.at = {.x = (p.rear_3 + p.head_2) / 2, .y = 1.5 * p.height_1},
                              .text = "S_1 = " + display.brief(g.S1, si::N)});
  d.shapes.emplace_back(Label{.at = {.x = (p.rear_2 + p.rear_3) / 2, .y = -1.5 * p.height_1},
                              .text = "S_2 = " + display.brief(g.S2, si::N)});
  return d;
}

struct Part {
  std::string label;
  double force;  ///< N, + outward
};

/// The longitudinal forces on section 3 laid end to end: they close at zero.
Drawing balance(const std::string& name, const std::string& title, const std::vector<Part>& parts) {
  Drawing d;
  d.name = name;
  d.title = title;
  d.caption = "Along the boom, outward to the right; each force starts where the one above it ends, the last at zero.";
  d.unit = si::N;
  d.legend = {{Role::force, "outward"}, {Role::second_force, "inward"}, {Role::hidden, ""}};
  double reach = 0;
  double x = 0;
  for (const Part& p : parts) reach = std::max(reach, std::abs(x += p.force));
  const double drop = 0.12 * std::max(reach, 1.0);
  d.shapes.emplace_back(Polyline{
      .points = {{.x = 0, .y = drop}, {.x = 0, .y = -drop * static_cast<double>(parts.size())}}, .role = Role::axis});
  x = 0;
  double level = 0;
  for (const Part& p : parts) {
    const Role role = p.force < 0 ? Role::second_force : Role::force;
    d.shapes.emplace_back(
        ForceArrow{.at = {.x = x, .y = level}, .fx = p.force, .fy = 0, .label = p.label, .role = role});
    x += p.force;
    d.shapes.emplace_back(
        Polyline{.points = {{.x = x, .y = level}, {.x = x, .y = level - drop}}, .role = Role::hidden});
    level -= drop;
  }
  return d;
}

std::vector<Part> sliding_parts(const Input& in, const Sliding& q, const SlidingPoint& g) {
  const double falls = falls_of(q);
  const double lead = q.operation == Operation::retract ? g.suspended_weight * in.tackle_efficiency / falls
                                                        : g.suspended_weight / (falls * in.tackle_efficiency);
  const double weight = in.section_weight + g.suspended_weight;
  const double d = q.operation == Operation::extend ? 1 : -1;
  return {{.label = "2 S_1", .force = 2 * g.S1},
          {.label = "S_2", .force = -g.S2},
          {.label = "S_k", .force = -lead},
          {.label = "W sin(beta)", .force = -weight * std::sin(g.luffing_angle)},
          {.label = "pad friction", .force = -d * q.kinetic_friction * (std::abs(g.Nf) + std::abs(g.Nr))}};
}

Plot plot(std::string name, std::string title, Axis x, Axis y) {
  Plot p;
  p.name = std::move(name);
  p.title = std::move(title);
  p.x = std::move(x);
  p.y = std::move(y);
  return p;
}

/// One curve per luffing angle, at the governing weight.
Plot over_length(const Sliding& q, const Output& out, const Display& display, std::string name, std::string title,
                 double SlidingPoint::*member) {
  Plot p = plot(std::move(name), std::move(title), {.label = "boom length", .unit = si::m},
                {.label = "force", .unit = si::N});
  const std::size_t lengths = q.boom_length.size();
  const std::size_t block = lengths * q.luffing_angle.size();
  const std::size_t first = out.governing_point / block * block;
  for (std::size_t b = 0; b < q.luffing_angle.size(); ++b) {
    std::vector<std::pair<double, double>> points;
    for (std::size_t l = 0; l < lengths; ++l) {
      const SlidingPoint& g = out.grid[first + b * lengths + l];
      points.emplace_back(g.boom_length, g.*member);
    }
    std::sort(points.begin(), points.end(), [](const auto& m, const auto& n) { return m.first < n.first; });
    Curve c;
    c.label = display.brief(q.luffing_angle[b], si::rad);
    for (const auto& [x, y] : points) {
      c.x.push_back(x);
      c.y.push_back(y);
    }
    p.curves.push_back(std::move(c));
  }
  const SlidingPoint& g = out.grid[out.governing_point];
  p.caption = fmt::format("Suspended weight {}.", display.brief(g.suspended_weight, si::N));
  p.marks.push_back({g.boom_length, g.*member, "largest F_h", false});
  return p;
}

Plot case_forces(const Output& out) {
  Plot p = plot("forces", "Force F on section 3 by case", {.label = "case", .unit = si::one},
                {.label = "F, outward", .unit = si::N});
  Curve c;
  c.label = "F";
  c.points_only = true;
  for (std::size_t i = 0; i < out.F.size(); ++i) {
    c.x.push_back(static_cast<double>(i + 1));
    c.y.push_back(out.F[i]);
  }
  p.curves.push_back(std::move(c));
  const auto mark = [&](std::size_t i, const char* label) {
    p.marks.push_back({static_cast<double>(i + 1), out.F[i], label, false});
  };
  mark(out.highest_case, "governs S_10");
  mark(out.lowest_case, "governs S_20");
  return p;
}

Plot tensioning_plot(const Input& in, const Output& out) {
  Plot p = plot("tensioning", "Tensioning the ropes in turn", {.label = "step", .unit = si::one},
                {.label = "pretension", .unit = si::N});
  Curve curves[] = {{.label = "S_10, extension rope first", .x = {}, .y = {}},
                    {.label = "S_20, extension rope first", .x = {}, .y = {}},
                    {.label = "S_10, retraction rope first", .x = {}, .y = {}, .dashed = true},
                    {.label = "S_20, retraction rope first", .x = {}, .y = {}, .dashed = true}};
  double step = 0;
  for (const TensioningStep& t : tensioning(out.F0_retraction, in.tensioning_steps)) {
    const double y[] = {t.S10_extension_first, t.S20_extension_first, t.S10_retraction_first, t.S20_retraction_first};
    step += 1;
    for (int i = 0; i < 4; ++i) {
      curves[i].x.push_back(step);
      curves[i].y.push_back(y[i]);
    }
  }
  for (Curve& c : curves) p.curves.push_back(std::move(c));
  return p;
}

}  // namespace

std::vector<Figure> figures(const Input& in, const Output& out, const Display& display) {
  std::vector<Figure> all;
  if (in.sliding && std::isfinite(out.Fh)) {
    const Sliding& q = *in.sliding;
    const SlidingPoint& g = out.grid[out.governing_point];
    all.emplace_back(loaded_boom(in, q, g, display));
    all.emplace_back(ropes(q, g, display));
    all.emplace_back(balance("balance", "Forces along section 3 while sliding", sliding_parts(in, q, g)));
    all.emplace_back(
        over_length(q, out, display, "cylinder_force", "Cylinder force against boom length", &SlidingPoint::Fh));
    all.emplace_back(over_length(q, out, display, "extension_rope", "S_1 against boom length", &SlidingPoint::S1));
    all.emplace_back(over_length(q, out, display, "retraction_rope", "S_2 against boom length", &SlidingPoint::S2));
  }
  if (!out.F.empty() && std::isfinite(out.S10_set)) {
    const double F = out.F[out.lowest_case];
    const RopeTensions t = tensions(out, F);
    all.emplace_back(
        balance("lowest_case", fmt::format("Section 3 in case {}: (1)", out.lowest_case + 1),
                {{.label = "2 S_1", .force = 2 * t.S1}, {.label = "S_2", .force = -t.S2}, {.label = "F", .force = F}}));
    all.emplace_back(case_forces(out));
  }
  if (in.tensioning_steps > 0) all.emplace_back(tensioning_plot(in, out));
  return all;
}

Drawing boom_without_answer(const Input& in, const Display& display) {
  const Sliding q = in.sliding.value_or(Sliding{});
  const auto first = [](const std::vector<double>& all, double otherwise) {
    return all.empty() ? otherwise : all.front();
  };
  SlidingPoint g;
  g.boom_length = first(q.boom_length, q.retracted_length);
  g.luffing_angle = first(q.luffing_angle, 0);
  g.suspended_weight = first(q.suspended_weight, 0);
  Drawing d = boom(in, q, g, display);
  d.title = "Boom as described; no answer was found";
  d.caption =
      position_words(g, display) + ", the first of the deck. This is not an answer: only the weights are known.";
  return d;
}

}  // namespace taut::boom_ropes
