#include "taut/results/motion/transient_scene.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "taut/results/machine_scene.hpp"

namespace taut::results {
namespace {

constexpr double arc_step = 0.3;  ///< rad
constexpr double largest_arc = 40;

Matrix3 orientation_of(const solve::TransientFrame& frame, int body) {
  return body == machine::ground ? Matrix3(Matrix3::Identity()) : frame.bodies[body].orientation;
}

/// By its freedoms or by a given motion.
bool moves(const machine::Body& body) { return !body.free.empty() || !body.driven.empty(); }

const solve::TransientFrame::Contact* contact_at(const solve::TransientFrame& frame, int reeving, int node) {
  for (const auto& c : frame.contacts) {
    if (c.reeving == reeving && c.node == node) return &c;
  }
  return nullptr;
}

/// The rope on a round from where it arrives, without that point and the last one.
void add_arc(const machine::Node& node, const solve::TransientFrame& frame, double wrap, double tension,
             RopePart& part) {
  if (node.radius <= 0 || part.points.empty() || !(wrap > 0)) return;
  const Vector3 centre = place_in(frame, node.at);
  const Vector3 axis = orientation_of(frame, node.at.body) * node.axis;
  const Vector3 arm = part.points.back() - centre;
  const int steps = static_cast<int>(std::ceil(std::min(wrap, largest_arc) / arc_step));
  for (int i = 1; i <= steps; ++i) {
    const double turned = node.side * wrap * i / steps;
    part.points.emplace_back(centre + Eigen::AngleAxisd(turned, axis) * arm);
    part.tension.push_back(tension);
  }
}

/// The first end of a rope on a drum, by whose turning and layer it is shown.
const solve::TransientFrame::OnDrum* shown_on(const solve::TransientFrame& frame, int drum) {
  const auto end =
      std::find_if(frame.on_drums.begin(), frame.on_drums.end(), [&](const auto& one) { return one.drum == drum; });
  return end == frame.on_drums.end() ? nullptr : &*end;
}

double radius_now(const machine::Model& m, const machine::Node& node, const solve::TransientFrame& frame) {
  const auto* end = node.drum ? shown_on(frame, *node.drum) : nullptr;
  if (end == nullptr) return node.radius;
  const machine::Drum& drum = m.drums[*node.drum];
  const int layer = end->layer;
  if (drum.layer < 1 || layer == drum.layer) return node.radius;
  // the deck's radius is core + (layer - 1/2) d of its own layer
  const double d = (node.radius - drum.core_radius) / (drum.layer - 0.5);
  return drum.core_radius + (layer - 0.5) * d;
}

class Parts {
 public:
  Parts(const machine::Model& model, const solve::TransientFrame& frame, const solve::TransientFrame& first)
      : model_(model), frame_(frame), first_(first) {}

  std::vector<HeldPart> all() {
    for (std::size_t r = 0; r < model_.reevings.size(); ++r) {
      const machine::Reeving& rope = model_.reevings[r];
      for (std::size_t n = 0; n < rope.nodes.size(); ++n) {
        HeldPart& part = part_of(rope.nodes[n]);
        const solve::TransientFrame::Contact* c = contact_at(frame_, static_cast<int>(r), static_cast<int>(n));
        if (c != nullptr) {
          part.force += rope.copies * c->force;
          part.turned = rope.nodes[n].side * c->angle;
        }
        if (rope.nodes[n].drum) turn_drum(part, rope.nodes[n], static_cast<int>(r), n > 0);
      }
    }
    for (const auto& b : frame_.branches) add_ends(b);
    drop_rounding();
    return std::move(parts_);
  }

 private:
  HeldPart& part_of(const machine::Node& node) {
    const auto at = index_.find(node.name);
    if (at != index_.end()) {
      HeldPart& part = parts_[at->second];
      part.radius = std::max(part.radius, node.radius);
      return part;
    }
    index_[node.name] = parts_.size();
    HeldPart part;
    part.name = node.name;
    part.at = place_in(frame_, node.at);
    part.radius = radius_now(model_, node, frame_);
    part.axis = orientation_of(frame_, node.at.body) * node.axis;
    part.moves = node.at.body != machine::ground && moves(model_.bodies[node.at.body]);
    parts_.push_back(std::move(part));
    return parts_.back();
  }

  /// Forces that are nothing beside the others.
  void drop_rounding() {
    double largest = 0;
    for (const HeldPart& part : parts_) largest = std::max(largest, part.force.norm());
    for (HeldPart& part : parts_) {
      if (part.force.norm() < 1e-9 * largest) part.force.setZero();
    }
  }

  /// Rope that is taken in at the start of a path runs against it.
  void turn_drum(HeldPart& part, const machine::Node& node, int reeving, bool at_end) const {
    const auto* now = shown_on(frame_, *node.drum);
    const auto* first = shown_on(first_, *node.drum);
    if (now == nullptr || first == nullptr || now->reeving != reeving || now->at_end != at_end) return;
    if (part.radius > 0) part.turned = node.side * (at_end ? 1 : -1) * (now->content - first->content) / part.radius;
  }

  void add_ends(const solve::TransientFrame::Branch& b) {
    const machine::Reeving& rope = model_.reevings[b.reeving];
    const Vector3 way = b.end - b.start;
    if (!b.whole || way.norm() == 0) return;
    const auto is_anchor = [&](int n) { return rope.nodes[n].kind == machine::NodeKind::anchor; };
    // of a rope in segments only the outer ones end at a node
    const auto near = [&](int n, const Vector3& end) {
      const machine::Node& node = rope.nodes[n];
      return (end - place_in(frame_, node.at)).norm() <= 1.5 * radius_now(model_, node, frame_) + 1e-6;
    };
    if (is_anchor(b.from) && near(b.from, b.start)) {
      part_of(rope.nodes[b.from]).force += rope.copies * b.T_from * b.leaves;
    }
    if (is_anchor(b.to) && near(b.to, b.end)) {
      part_of(rope.nodes[b.to]).force -= rope.copies * b.T_to * b.arrives;
    }
  }

  const machine::Model& model_;
  const solve::TransientFrame& frame_;
  const solve::TransientFrame& first_;
  std::vector<HeldPart> parts_;
  std::map<std::string, std::size_t> index_;
};

std::array<double, 3> moving_point(const Vector3& v) { return {v.x(), v.y(), v.z()}; }

void add_lines(const study::TransientRun& run, Scene& scene) {
  for (std::size_t i = 0; i < run.result.frames.size(); ++i) {
    const std::vector<RopePart> parts = rope_parts(run.model, run.result.frames[i]);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (i == 0) {
        const machine::Reeving& rope = run.model.reevings[parts[k].reeving];
        scene.lines.push_back({fmt::format("{}[{}]", rope.name, parts[k].from + 1),
                               parts[k].reeving == 0 ? Role::rope : Role::second_rope,
                               {},
                               {}});
      }
      std::vector<std::array<double, 3>> points;
      for (const Vector3& p : parts[k].points) points.push_back(moving_point(p));
      scene.lines[k].points.push_back(std::move(points));
      scene.lines[k].tension.push_back(parts[k].tension);
    }
  }
}

void add_body_lines(const study::TransientRun& run, Scene& scene) {
  const auto& frames = run.result.frames;
  const auto in_ground = [&](std::size_t frame, const machine::Place& place) { return place_in(frames[frame], place); };
  for (SceneLine& line : body_scene_lines(run.model, frames.size(), in_ground)) scene.lines.push_back(std::move(line));
}

void add_points(const study::TransientRun& run, Scene& scene) {
  const auto& frames = run.result.frames;
  for (const auto& body : run.model.bodies) scene.points.push_back({body.name, 0, {}, {}});
  const std::size_t bodies = scene.points.size();
  for (const HeldPart& part : held_parts(run.model, frames.front(), frames.front())) {
    scene.points.push_back({part.name, part.radius, {}, {}});
  }
  for (const auto& frame : frames) {
    for (std::size_t i = 0; i < bodies; ++i) {
      scene.points[i].at.push_back(moving_point(frame.bodies[i].position));
      scene.points[i].velocity.push_back(moving_point(frame.bodies[i].velocity));
    }
    const std::vector<HeldPart> parts = held_parts(run.model, frame, frames.front());
    for (std::size_t i = 0; i < parts.size(); ++i) scene.points[bodies + i].at.push_back(moving_point(parts[i].at));
  }
}

}  // namespace

Vector3 place_in(const solve::TransientFrame& frame, const machine::Place& place) {
  if (place.body == machine::ground) return place.at;
  const auto& body = frame.bodies[place.body];
  return body.position + body.orientation * place.at;
}

std::vector<RopePart> rope_parts(const machine::Model& m, const solve::TransientFrame& frame) {
  std::vector<RopePart> parts;
  for (std::size_t r = 0; r < m.reevings.size(); ++r) {
    for (int k = 0; k < machine::branch_count(m.reevings[r]); ++k) parts.push_back({static_cast<int>(r), k, {}, {}});
  }
  const auto part_at = [&](int reeving, int from) -> RopePart* {
    for (RopePart& part : parts) {
      if (part.reeving == reeving && part.from == from) return &part;
    }
    return nullptr;
  };
  for (const auto& b : frame.branches) {
    RopePart* part = part_at(b.reeving, b.from);
    if (part == nullptr || !b.whole) continue;
    if (part->points.empty()) {
      part->points.push_back(b.start);
      part->tension.push_back(b.T_from);
    }
    for (std::size_t i = 0; i < b.curve.size(); ++i) {
      const double share = static_cast<double>(i + 1) / static_cast<double>(b.curve.size() + 1);
      part->points.push_back(b.curve[i]);
      part->tension.push_back(b.T_from + share * (b.T_to - b.T_from));
    }
    part->points.push_back(b.end);
    part->tension.push_back(b.T_to);
  }
  for (const auto& c : frame.contacts) {
    const machine::Reeving& rope = m.reevings[c.reeving];
    const auto count = machine::branch_count(rope);
    RopePart* before = part_at(c.reeving, rope.closed ? (c.node + count - 1) % count : c.node - 1);
    if (before != nullptr) add_arc(rope.nodes[c.node], frame, c.wrap, c.T_out, *before);
  }
  return parts;
}

std::vector<HeldPart> held_parts(const machine::Model& m, const solve::TransientFrame& frame,
                                 const solve::TransientFrame& first) {
  return Parts(m, frame, first).all();
}

std::string scene_name(const study::TransientRun& run) { return "motion" + run.ending; }

Scene scene_of(const study::TransientRun& run) {
  Scene scene;
  scene.name = scene_name(run);
  for (const auto& frame : run.result.frames) scene.t.push_back(frame.t);
  add_lines(run, scene);
  add_body_lines(run, scene);
  add_points(run, scene);
  return scene;
}

}  // namespace taut::results
