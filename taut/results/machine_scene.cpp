#include "taut/results/machine_scene.hpp"

#include <fmt/format.h>

#include <set>

#include "taut/results/machine_beams.hpp"
#include "taut/results/machine_figures.hpp"
#include "taut/results/machine_tables.hpp"

namespace taut::results {
namespace {

constexpr int scene_points_per_span = 32;

std::array<double, 3> scene_point(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

SceneLine line_of(const machine::Model& m, const solve::BranchResult& s) {
  const machine::Reeving& rope = m.reevings[s.reeving];
  SceneLine line{.name = fmt::format("{}[{}]", rope.name, s.from + 1),
                 .role = s.reeving == 0 ? Role::rope : Role::second_rope,
                 .points = {},
                 .tension = {}};
  std::vector<std::array<double, 3>> points;
  std::vector<double> tension;
  const bool sags = !s.slack && s.shape.rope.weight > 0 && s.shape.rope.length > 0;
  const int parts = sags ? scene_points_per_span : 1;
  for (int i = 0; i <= parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    const Vector3 at = sags ? Vector3(s.start + rope::point_at(s.shape, share * s.shape.rope.length))
                            : Vector3(s.start + share * (s.end - s.start));
    points.push_back(scene_point(at));
    // along a catenary V grows evenly with the unstretched length
    tension.push_back(sags ? std::hypot(s.H, s.V_from + share * (s.V_to - s.V_from))
                           : s.T_from + share * (s.T_to - s.T_from));
  }
  line.points.push_back(std::move(points));
  line.tension.push_back(std::move(tension));
  return line;
}

Scene scene_of(const study::EquilibriumRun& one) {
  Scene scene;
  scene.name = "machine" + one.ending;
  scene.t = {0};
  for (const auto& s : one.result.branches) scene.lines.push_back(line_of(one.model, s));
  const std::vector<std::vector<Vector3>> beams = beam_lines(one.result);
  for (std::size_t i = 0; i < beams.size(); ++i) {
    SceneLine line{
        .name = one.model.beams[one.result.beams[i].beam].name, .role = Role::structure, .points = {{}}, .tension = {}};
    for (const Vector3& v : beams[i]) line.points.front().push_back(scene_point(v));
    scene.lines.push_back(std::move(line));
  }
  const auto in_ground = [&](std::size_t, const machine::Place& place) {
    return machine::in_ground(one.result.state, place);
  };
  for (SceneLine& line : body_scene_lines(one.model, 1, in_ground)) scene.lines.push_back(std::move(line));
  for (std::size_t i = 0; i < one.model.bodies.size(); ++i) {
    if (one.model.bodies[i].beam) continue;  // the beam's line goes through its sections
    scene.points.push_back({one.model.bodies[i].name, 0, {scene_point(one.result.state.bodies[i].position)}, {}});
  }
  std::set<std::string> known;
  for (const machine::Reeving& rope : one.model.reevings) {
    for (const machine::Node& node : rope.nodes) {
      if (!known.insert(node.name).second) continue;
      scene.points.push_back(
          {node.name, node.radius, {scene_point(machine::in_ground(one.result.state, node.at))}, {}});
    }
  }
  return scene;
}

}  // namespace

std::vector<SceneLine> body_scene_lines(const machine::Model& m, std::size_t frames,
                                        const std::function<Vector3(std::size_t, const machine::Place&)>& in_ground) {
  std::vector<SceneLine> all;
  for (std::size_t frame = 0; frame < frames; ++frame) {
    const auto now = body_lines(m, [&](const machine::Place& place) { return in_ground(frame, place); });
    for (std::size_t i = 0; i < now.size(); ++i) {
      if (frame == 0) {
        all.push_back({.name = fmt::format("body[{}]", i + 1), .role = Role::structure, .points = {}, .tension = {}});
      }
      all[i].points.push_back({scene_point(now[i][0]), scene_point(now[i][1])});
    }
  }
  return all;
}

void add_scenes(const MachineRun& run, Result& r) {
  for (const study::EquilibriumRun& one : run.equilibria) {
    if (one.result.outcome.ok()) r.scenes.push_back(scene_of(one));
  }
}

}  // namespace taut::results
