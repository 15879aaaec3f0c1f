#include "taut/methods/closed_loop/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "taut/math/degree.hpp"
#include "taut/units/display.hpp"

namespace taut::closed_loop {
namespace {

constexpr int samples_of_a_rope = 24;
constexpr int samples_of_a_plot = 61;
constexpr double ground_depth = 1.8;  // of the ground under the chord, in sags

/// What the figures need to know of a solved position.
struct View {
  double l, m, x1, x2, f1, f2, w_b, w_T, S_x, S_y, W_c;
  bool two;
};

double slope_of(const Input& in) { return in.height_difference ? *in.height_difference / in.span : std::tan(in.slope); }

View view_of(const Input& in, const Output& o) {
  View v{};
  v.l = in.span;
  v.m = slope_of(in);
  v.two = in.carriage == Carriage::two_section;
  v.x1 = v.two ? o.x_1 : o.x;
  v.x2 = v.two ? o.x_2 : o.x;
  v.f1 = v.two ? o.f_1 : o.f;
  v.f2 = v.two ? o.f_2 : o.f;
  const double cos_a = 1 / std::sqrt(1 + v.m * v.m);
  v.w_b = o.q_b / cos_a;
  v.w_T = o.q_T / cos_a;
  const double gamma =
      in.gathering_angle_from == AngleFrom::vertical ? in.gathering_angle : 90 * degree - in.gathering_angle;
  v.S_x = in.gathering_force * std::sin(gamma);
  v.S_y = in.gathering_force * std::cos(gamma);
  v.W_c = in.carriage_weight;
  return v;
}

/// A parabola between two points with weight w per horizontal metre.
void add_rope(Drawing& d, Point a, Point b, double w, double H, Role role) {
  Polyline rope;
  rope.role = role;
  for (int i = 0; i <= samples_of_a_rope; ++i) {
    const double t = static_cast<double>(i) / samples_of_a_rope;
    const double x = a.x + t * (b.x - a.x);
    rope.points.push_back({x, a.y + t * (b.y - a.y) - w * (x - a.x) * (b.x - x) / (2 * H)});
  }
  d.shapes.emplace_back(rope);
}

/// Slope of that rope at its left (end = -1) or right (end = +1) end.
double end_slope(Point a, Point b, double w, double H, int end) {
  return (b.y - a.y) / (b.x - a.x) + end * w * (b.x - a.x) / (2 * H);
}

/// The points that the drawing hangs on.
struct Frame {
  Point A_l, B_l, A_u, B_u, L1, L2, U;
};

Frame frame_of(const View& v, double rise, double lean) {
  const auto up = [&](Point p) { return Point{.x = p.x - lean, .y = p.y + rise}; };
  Frame k;
  k.A_l = {.x = 0, .y = 0};
  k.B_l = {.x = v.l, .y = v.l * v.m};
  k.L1 = {.x = v.x1, .y = v.m * v.x1 - v.f1};
  k.L2 = {.x = v.x2, .y = v.m * v.x2 - v.f2};
  k.A_u = up(k.A_l);
  k.B_u = up(k.B_l);
  k.U = up(k.L1);
  return k;
}

/// Stretches a flat loop so that its sag can be seen: 1, 2, ... 5.
double stretch_of(const View& v) {
  const double height = std::max(v.f1, v.f2) + std::abs(v.l * v.m);
  return std::clamp(std::floor(0.16 * v.l / height), 1.0, 5.0);
}

void add_ground(Drawing& d, const View& v, const Frame& k) {
  const double below = ground_depth * std::max(v.f1, v.f2);
  const double margin = 0.06 * v.l;
  d.shapes.emplace_back(Polyline{
      .points = {{.x = -margin, .y = -v.m * margin - below}, {.x = v.l + margin, .y = v.m * (v.l + margin) - below}},
      .role = Role::ground});
  d.shapes.emplace_back(Polyline{.points = {{.x = 0, .y = -below}, k.A_l, k.A_u}, .role = Role::structure});
  d.shapes.emplace_back(
      Polyline{.points = {{.x = v.l, .y = v.l * v.m - below}, k.B_l, k.B_u}, .role = Role::structure});
  d.shapes.emplace_back(Polyline{.points = {k.A_l, k.B_l}, .role = Role::axis});
}

/// What the deck puts on the carriage.
void add_loads(Drawing& d, const View& v, const Frame& k) {
  d.shapes.emplace_back(
      ForceArrow{.at = k.L2, .fx = v.S_x, .fy = -v.S_y, .label = "S", .role = Role::force, .towards = false});
  if (v.W_c > 0)
    d.shapes.emplace_back(
        ForceArrow{.at = k.L1, .fx = 0, .fy = -v.W_c, .label = "W_c", .role = Role::second_force, .towards = false});
}

void add_forces(Drawing& d, const View& v, const Frame& k, const Output& o) {
  const auto pull = [&](Point at, double H, double slope, int side, const char* label, Role role) {
    d.shapes.emplace_back(
        ForceArrow{.at = at, .fx = side * H, .fy = side * H * slope, .label = label, .role = role, .towards = false});
  };
  add_loads(d, v, k);
  d.shapes.emplace_back(ForceArrow{.at = k.U,
                                   .fx = o.P_v * std::tan(o.phi),
                                   .fy = -o.P_v,
                                   .label = "N",
                                   .role = Role::second_force,
                                   .towards = true});
  // The upper ends first: labels are placed in this order, and theirs belong above.
  pull(k.A_u, o.H_3, end_slope(k.A_u, k.U, v.w_b, o.H_3, -1), -1, "T_uA", Role::second_force);
  pull(k.B_u, o.H_4, end_slope(k.U, k.B_u, v.w_b, o.H_4, +1), +1, "T_uB", Role::second_force);
  pull(k.A_l, o.H_1, end_slope(k.A_l, k.L1, v.w_T, o.H_1, -1), -1, "T_lA", Role::force);
  pull(k.B_l, o.H_2, end_slope(k.L2, k.B_l, v.w_b, o.H_2, +1), +1, "T_lB", Role::force);
}

void add_measures(Drawing& d, const View& v, const Frame& k, const Output& o, const Display& display) {
  const double stretch = d.vertical_scale;
  // Under the lower end of the ground, so that nothing crosses.
  const double row = 0.045 * v.l / stretch;
  const double ground = std::min(0.0, v.l * v.m) - ground_depth * std::max(v.f1, v.f2);
  const double x = o.x;
  d.shapes.emplace_back(DimensionLine{.from = {.x = 0, .y = ground - row},
                                      .to = {.x = x, .y = ground - row},
                                      .offset = 0,
                                      .text = "x = " + display.brief(x, si::m)});
  d.shapes.emplace_back(DimensionLine{.from = {.x = 0, .y = ground - 2 * row},
                                      .to = {.x = v.l, .y = ground - 2 * row},
                                      .offset = 0,
                                      .text = "l = " + display.brief(v.l, si::m)});
  const Point at = std::abs(x - v.x1) <= std::abs(x - v.x2) ? k.L1 : k.L2;
  d.shapes.emplace_back(
      DimensionLine{.from = at, .to = {.x = x, .y = v.m * x}, .offset = 0, .text = "f = " + display.brief(o.f, si::m)});
  d.shapes.emplace_back(Label{.at = {.x = -0.03 * v.l, .y = k.A_l.y - 0.02 * v.l / stretch}, .text = "A"});
  d.shapes.emplace_back(Label{.at = {.x = 1.03 * v.l, .y = k.B_l.y - 0.02 * v.l / stretch}, .text = "B"});
}

}  // namespace

namespace {

/// Whether the deck gives the distance of the branches; else they are drawn apart.
bool gives_distance(const Input& in) { return in.branch_distance > 0; }

const char* distance_words(const Input& in) {
  return gives_distance(in) ? "" : " The branches are drawn apart to distinguish them.";
}

/// Ground, ropes, carriage and tail sheave. A rope without weight, or with an infinite H, is straight.
Frame draw_loop(const Input& in, const View& v, const Output& out, Drawing& d) {
  d.name = "loop";
  d.vertical_scale = stretch_of(v);
  d.legend = {{Role::rope, "return rope"}, {Role::second_rope, "traction rope"}};
  const bool given = gives_distance(in);
  const double c = given ? in.branch_distance : 0.03 * v.l / d.vertical_scale;
  const double alpha = std::atan(v.m);
  const bool normal = in.branch_offset == BranchOffset::normal && given;
  const Frame k = frame_of(v, normal ? c * std::cos(alpha) : c, normal ? c * std::sin(alpha) : 0);
  add_ground(d, v, k);
  add_rope(d, k.A_u, k.U, v.w_b, out.H_3, Role::rope);
  add_rope(d, k.U, k.B_u, v.w_b, out.H_4, Role::rope);
  add_rope(d, k.L2, k.B_l, v.w_b, out.H_2, Role::rope);
  if (v.two) d.shapes.emplace_back(Polyline{.points = {k.L1, k.L2}, .role = Role::rope});
  add_rope(d, k.A_l, k.L1, v.w_T, out.H_1, Role::second_rope);
  d.shapes.emplace_back(Polyline{.points = {k.L1, k.U}, .role = Role::body});
  const double size = 0.006 * v.l / std::sqrt(d.vertical_scale);
  d.shapes.emplace_back(Circle{.center = k.U, .radius = size, .role = Role::body, .from = 0, .to = 0, .filled = true});
  d.shapes.emplace_back(Circle{.center = k.L1, .radius = size, .role = Role::body, .from = 0, .to = 0, .filled = true});
  if (v.two)
    d.shapes.emplace_back(
        Circle{.center = k.L2, .radius = size, .role = Role::body, .from = 0, .to = 0, .filled = true});
  d.shapes.emplace_back(Circle{
      .center = {.x = 0.5 * (k.B_l.x + k.B_u.x), .y = 0.5 * (k.B_l.y + k.B_u.y)}, .radius = c / 2, .role = Role::body});
  return k;
}

}  // namespace

Drawing loop_drawing(const Input& in, const Output& out, const Display& display) {
  const View v = view_of(in, out);
  Drawing d;
  d.title = "The loop in its span";
  const Frame k = draw_loop(in, v, out, d);
  add_forces(d, v, k, out);
  add_measures(d, v, k, out, display);
  d.caption = fmt::format(
      "Return rope (upper branch and back to the carriage) and traction rope (carriage to A) as parabolas of the "
      "closed-form tier.{}",
      distance_words(in));
  return d;
}

Drawing loop_without_answer(const Input& in, const Display& display) {
  constexpr double drawn_sag = 0.05;  // of the span, where the deck gives none
  Output at;
  at.x = at.x_1 = at.x_2 = in.position.empty() ? in.span / 2 : in.position.front();
  at.f = at.f_1 = at.f_2 = in.sag.value_or(drawn_sag * in.span);
  if (in.carriage == Carriage::two_section) {
    const double distance = in.section_distance.value_or(0);
    (in.position_of == Section::first ? at.x_2 : at.x_1) += in.position_of == Section::first ? distance : -distance;
  }
  at.H_1 = at.H_2 = at.H_3 = at.H_4 = std::numeric_limits<double>::infinity();
  at.q_b = at.q_T = 0;
  const View v = view_of(in, at);
  Drawing d;
  d.title = "Loop as described; no answer was found";
  const Frame k = draw_loop(in, v, at, d);
  add_loads(d, v, k);
  add_measures(d, v, k, at, display);
  d.caption =
      fmt::format("This is not an answer: no tension is known, and the ropes are drawn straight.{}{}",
                  in.sag ? "" : " The deck gives no sag: f is a twentieth of the span here.", distance_words(in));
  return d;
}

namespace {

struct PolygonForce {
  double fx;
  double fy;
  const char* label;
  Role role;
};

std::vector<PolygonForce> forces_at_carriage(const View& v, const Output& o) {
  const Frame k = frame_of(v, 0, 0);
  const double left = end_slope(k.A_l, k.L1, v.w_T, o.H_1, +1);
  const double right = end_slope(k.L2, k.B_l, v.w_b, o.H_2, -1);
  std::vector<PolygonForce> all;
  all.push_back({o.H_2, o.H_2 * right, "T_lLB", Role::rope});
  all.push_back({v.S_x, -v.S_y, "S", Role::force});
  if (v.W_c > 0) all.push_back({0, -v.W_c, "W_c", Role::force});
  all.push_back({-o.P_v * std::tan(o.phi), o.P_v, "N", Role::second_force});
  all.push_back({-o.H_1, -o.H_1 * left, "T_lLA", Role::second_rope});
  return all;
}

}  // namespace

Drawing force_polygon(const Input& in, const Output& out) {
  Drawing d;
  d.name = "force_polygon";
  d.title = "Forces on the carriage";
  d.unit = si::N;
  d.caption =
      in.carriage == Carriage::single
          ? "Rope tensions at the carriage, gathering force S and roller reaction N close: the carriage is in "
            "equilibrium."
          : "Both sections together: what is missing to close the polygon is the weight of the rope between them.";
  Point at{.x = 0, .y = 0};
  for (const PolygonForce& f : forces_at_carriage(view_of(in, out), out)) {
    const Point next{.x = at.x + f.fx, .y = at.y + f.fy};
    d.shapes.emplace_back(
        ForceArrow{.at = at, .fx = f.fx, .fy = f.fy, .label = f.label, .role = f.role, .towards = false});
    at = next;
  }
  return d;
}

namespace {

using Member = double Output::*;

Curve curve_of(const char* label, const std::vector<Row>& rows, Member y) {
  Curve c;
  c.label = label;
  for (const Row& row : rows) {
    c.x.push_back(row.out.x);
    c.y.push_back(row.outcome.ok() ? row.out.*y : Output::none);
  }
  return c;
}

std::vector<Row> by_place(std::vector<Row> rows) {
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.out.x < b.out.x; });
  return rows;
}

/// The same deck at places all over the span.
std::vector<Row> over_the_span(const Input& in, const Ropes& ropes, const Engine& engine) {
  const double d = in.section_distance.value_or(0);
  const double low = std::max(0.05 * in.span, 1.01 * d);
  const double high = std::min(0.95 * in.span, in.span - 1.01 * d);
  if (low >= high) return {};
  Input all = in;
  all.position.clear();
  for (int i = 0; i < samples_of_a_plot; ++i) {
    all.position.push_back(low + (high - low) * i / (samples_of_a_plot - 1));
  }
  return sweep(all, ropes, engine);
}

const char* law_of(const Input& in) {
  if (in.mode == Mode::winch_pull) return "with the deck's winch pull at every position";
  if (in.mode == Mode::loop_length) return "with the deck's loop length at every position";
  if (in.mode == Mode::free_running) return "with the return rope running freely at every position";
  return "with the deck's sag at every position";
}

}  // namespace

Plot tension_plot(const Input& in, const Ropes& ropes, const std::vector<Row>& rows, const Engine& engine) {
  const std::vector<Row> all = over_the_span(in, ropes, engine);
  Plot p;
  p.name = "tensions";
  p.title = "End tensions against the position of the carriage";
  p.caption = fmt::format("Closed-form tier, {}. Gaps are positions without an answer.", law_of(in));
  p.x = {.label = "distance from A to the carriage", .unit = si::m};
  p.y = {.label = "tension", .unit = si::N};
  p.curves = {curve_of("T_lA", all, &Output::T_lA), curve_of("T_lB", all, &Output::T_lB),
              curve_of("T_uB", all, &Output::T_uB), curve_of("T_uA", all, &Output::T_uA)};
  p.curves[2].dashed = true;
  p.curves[3].dashed = true;
  if (rows.size() > 1) {
    p.curves.push_back(curve_of("largest, positions of the deck", by_place(rows), &Output::T_end_max));
    p.curves.back().points_only = true;
  }
  const Row& worst = rows[worst_of(rows)];
  if (worst.outcome.ok())
    p.marks.push_back({worst.out.x, worst.out.T_end_max, rows.size() > 1 ? "governs" : "deck", false});
  return p;
}

Plot error_plot(const Input& in, const Ropes& ropes, const Output& out) {
  Plot p;
  p.name = "paper_error";
  p.title = "Error of the paper's formulas over the slope of the chord";
  p.caption =
      "Repaired formulas against the closed-form tier, at the position, sag and load of the deck; 0.05 is 5 %. Below "
      "zero "
      "the paper is unsafe for a tension. + slope: downhill work.";
  p.x = {.label = "slope of the chord", .unit = si::rad};
  p.y = {.label = "paper / closed form - 1", .unit = si::one};
  p.curves = {{.label = "load of the upper branch (1)", .x = {}, .y = {}},
              {.label = "upper branch, upper support (7)", .x = {}, .y = {}},
              {.label = "traction rope at A (9)", .x = {}, .y = {}}};
  Input at = in;
  at.mode = Mode::sag;
  at.winch_pull.reset();
  at.sag = out.f;
  at.height_difference.reset();
  at.position = {out.x};
  at.wire_strength.reset();
  Sheet<double> silent;
  for (int i = -30; i <= 30; i += 2) {
    at.slope = i * degree;
    Output o;
    const bool ok = solve_position(at, setting_of(at, ropes, 0), silent, o).ok();
    const double upper = i < 0 ? o.T_uA : o.T_uB;
    const std::array<double, 3> error = {o.P_b / o.P_b_closed - 1, o.T_up / upper - 1, o.T_lA_paper / o.T_lA - 1};
    for (std::size_t j = 0; j < error.size(); ++j) {
      p.curves[j].x.push_back(at.slope);
      p.curves[j].y.push_back(ok ? error[j] : Output::none);
    }
  }
  p.marks.push_back({0, 0, "no error", true});
  return p;
}

}  // namespace taut::closed_loop
