#include "taut/app/exact/mast_section_figures.hpp"

#include <algorithm>
#include <cmath>

#include "taut/app/exact/mast_machine.hpp"

namespace taut::app {
namespace {

using solve::BeamPoint;

template <class F>
Curve over_height(const solve::BeamResult& mast, const char* label, F&& y) {
  Curve c;
  c.label = label;
  for (const BeamPoint& p : mast.points) {
    c.x.push_back(p.s);
    c.y.push_back(y(p));
  }
  return c;
}

Plot moment_plot(const solve::BeamResult& mast) {
  Plot p{.name = "mast_exact_moment",
         .title = "Bending moment over the height, exact",
         .caption = "Towards the span and across it, in the axes of the deflected mast.",
         .x = {.label = "height above the foot", .unit = si::m},
         .y = {.label = "bending moment", .unit = si::N_m},
         .curves = {},
         .marks = {}};
  p.curves = {over_height(mast, "towards the span", [](const BeamPoint& p) { return p.bends_to_x; }),
              over_height(mast, "across the span", [](const BeamPoint& p) { return p.bends_to_y; })};
  return p;
}

Plot stress_plot(const solve::BeamResult& mast, double allowable) {
  Plot p{.name = "mast_exact_stress",
         .title = "Largest stress over the height, exact",
         .caption = "",
         .x = {.label = "height above the foot", .unit = si::m},
         .y = {.label = "stress", .unit = si::Pa},
         .curves = {},
         .marks = {}};
  p.curves = {over_height(mast, "N/A + M/W", [](const BeamPoint& p) { return p.stress; })};
  p.marks = {{.x = 0, .y = allowable, .label = "allowable", .whole_line = true}};
  return p;
}

Plot deflection_plot(const solve::BeamResult& mast) {
  Plot p{.name = "mast_exact_deflection",
         .title = "Deflection over the height, exact",
         .caption = "",
         .x = {.label = "height above the foot", .unit = si::m},
         .y = {.label = "displacement", .unit = si::m.in("mm")},
         .curves = {},
         .marks = {}};
  p.curves = {over_height(mast, "towards the span", [](const BeamPoint& p) { return p.place.x(); }),
              over_height(mast, "across the span", [](const BeamPoint& p) { return p.place.y(); })};
  return p;
}

Drawing plan(const machine::Model& model, const solve::EquilibriumResult& found) {
  Drawing d{.name = "guys_plan",
            .title = "Plan of the guys",
            .caption = "The span leaves to the right. Horizontal forces of the guys on the mast, and of the blocks.",
            .shapes = {},
            .unit = si::m,
            .vertical_scale = 1,
            .legend = {{Role::rope, "guyline"},
                       {Role::hidden, "slack guyline"},
                       {Role::force, "force of a guy"},
                       {Role::second_force, "forces of the blocks"}}};
  double reach = 0;
  for (const solve::BranchResult& guy : found.branches) {
    const Vector3& anchor = guy.start;
    const Vector3 F = rope::force_on_end(guy.shape);
    const std::string& name = model.reevings[static_cast<std::size_t>(guy.reeving)].name;
    reach = std::max(reach, anchor.head<2>().norm());
    d.shapes.emplace_back(Polyline{.points = {{.x = 0, .y = 0}, {.x = anchor.x(), .y = anchor.y()}},
                                   .role = hangs(guy) ? Role::hidden : Role::rope,
                                   .closed = false,
                                   .filled = false});
    d.shapes.emplace_back(Label{.at = {.x = 1.06 * anchor.x(), .y = 1.06 * anchor.y()}, .text = name});
    if (!hangs(guy)) {
      d.shapes.emplace_back(ForceArrow{.at = {.x = 0, .y = 0},
                                       .fx = F.x(),
                                       .fy = F.y(),
                                       .label = "T_" + name,
                                       .role = Role::force,
                                       .towards = false});
    }
  }
  Vector3 sum = Vector3::Zero();
  for (const machine::Load& load : model.loads) sum += load.force;
  d.shapes.emplace_back(ForceArrow{.at = {.x = 0, .y = 0},
                                   .fx = sum.x(),
                                   .fy = sum.y(),
                                   .label = "Q",
                                   .role = Role::second_force,
                                   .towards = false});
  d.shapes.emplace_back(Polyline{
      .points = {{.x = 0, .y = 0}, {.x = reach, .y = 0}}, .role = Role::axis, .closed = false, .filled = false});
  d.shapes.emplace_back(Circle{
      .center = {.x = 0, .y = 0}, .radius = 0.02 * reach, .role = Role::structure, .from = 0, .to = 0, .filled = true});
  return d;
}

}  // namespace

void add_mast_figures(const machine::Model& model, const solve::EquilibriumResult& found, double allowable, Result& r) {
  const solve::BeamResult& mast = found.beams[0];
  if (!found.branches.empty()) r.figures.emplace_back(plan(model, found));
  r.figures.emplace_back(moment_plot(mast));
  r.figures.emplace_back(stress_plot(mast, allowable));
  r.figures.emplace_back(deflection_plot(mast));
}

}  // namespace taut::app
