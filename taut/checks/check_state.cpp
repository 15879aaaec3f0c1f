#include "taut/checks/check_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "taut/math/index.hpp"

namespace taut::checks {
namespace {

Vector3 level_way(const solve::BranchResult& branch) {
  Vector3 along(branch.end.x() - branch.start.x(), branch.end.y() - branch.start.y(), 0);
  if (along.norm() > 0) along.normalize();
  return along;
}

/// "", "_2": without a name.
bool is_numbered(const std::string& ending) {
  return ending.size() < 2 || ending.find_first_not_of("0123456789", 1) == std::string::npos;
}

/// Half of a branch's weight hangs at its end: the part across the branch beside the tension along it.
Vector3 weight_across(const Vector3& along, double weight) {
  const Vector3 W = -weight / 2 * up();
  return W - W.dot(along) * along;
}

/// Whether a motion has the weight of a rope at the ends of its straight branches.
bool is_heavy(const solve::TransientResult& motion, int reeving) {
  const std::size_t rope = as_size(reeving);
  return rope < motion.mass_lumped.size() && motion.mass_lumped[rope];
}

/// The tension of a branch that sags, where as a straight one of the same length it has T0. With its weight W across it
/// the sag takes up the share W^2/(24 T^2) of its length: T = T0 + EA W^2/24 (1/T^2 - 1/T1^2), Irvine, Cable
/// Structures. T1: the tension that is given at the start, from which the length of the straight branch follows; 0:
/// that is given.
double tension_with_sag(double T0, double T1, double EA, double W) {
  const double k = EA * W * W / 24, straight = T1 > 0 ? T0 - k / (T1 * T1) : T0;
  if (k == 0) return T0;
  // T^2 (T - straight) = k, by Newton's iteration from above, where the cubic is convex
  double T = std::max(straight, 0.0) + std::cbrt(k);
  for (double last = 2 * T; T < last;) {
    last = T;
    T -= (T * T * (T - straight) - k) / (3 * T * T - 2 * T * straight);
  }
  return T;
}

double mean_tension(const solve::TransientFrame::Branch& b) { return (b.T_from + b.T_to) / 2; }

/// Points of a parabola below a straight branch of the tension T: the weight W of the branch over the horizontal way a
/// at the horizontal tension H has the sag W a/(8 H).
void add_parabola(const solve::TransientFrame::Branch& b, double weight, double T, Array<Vector3>& places) {
  constexpr int pieces = 16;
  const Vector3 way = b.end - b.start;
  const double level = std::hypot(way.x(), way.y());
  const double H = T * level / way.norm();
  const double sag = H > 0 ? weight * level / (8 * H) : 0;
  for (int k = 1; k < pieces; ++k) {
    const double s = static_cast<double>(k) / pieces;
    places.push_back(b.start + s * way - 4 * sag * s * (1 - s) * up());
  }
}

/// Adds a branch in motion; the segments of one branch become one.
void add_branch(const solve::TransientFrame::Branch& b, const machine::Reeving& rope, bool heavy,
                std::vector<CheckBranch>& all) {
  const Vector3 way = b.end - b.start;
  const double length = way.norm();
  const Vector3 along = length > 0 ? Vector3(way / length) : Vector3::UnitX();
  const bool sags = !b.curve.empty();  // then its weight is in the tensions at its ends
  const double weight = heavy && b.whole && !sags ? rope.weight * b.unstretched / (1 + rope.thermal_strain) : 0;
  const Vector3 hangs = weight_across(along, weight);
  const Vector3 on_start = b.T_from * (sags ? b.leaves : along) + hangs;
  const Vector3 on_end = -b.T_to * (sags ? b.arrives : along) + hangs;
  const double most = std::max(b.T_from, b.T_to);
  const bool goes_on =
      !all.empty() && all.back().reeving == b.reeving && all.back().from == b.from && rope.segments > 1;
  const double unstretched = b.unstretched / (1 + rope.thermal_strain);  // a motion has it at its temperature
  if (!goes_on) {
    all.push_back({b.reeving, b.from, b.to, most, (b.T_from + b.T_to) / 2, length, unstretched, b.start, b.end,
                   on_start, on_end});
    return;
  }
  CheckBranch& one = all.back();
  one.T = std::max(one.T, most);
  one.to = b.to;
  one.end = b.end;
  one.unstretched += unstretched;
  one.chord = (one.end - one.start).norm();
  one.on_end = on_end;
}

}  // namespace

CheckState state_of(const machine::Model& model, const solve::EquilibriumResult& state, std::string words,
                    std::string analysis) {
  CheckState all;
  all.model = &model;
  all.words = std::move(words);
  all.analysis = std::move(analysis);
  all.rest = &state;
  for (const solve::BranchResult& s : state.branches) {
    const Vector3 along = level_way(s);
    all.branches.push_back({s.reeving, s.from, s.to, std::max({s.T_from, s.T_to, s.T_from_max, s.T_to_max}),
                            (s.T_from + s.T_to) / 2, s.chord, s.unstretched, s.start, s.end,
                            s.H * along + s.V_from * up(), -(s.H * along + s.V_to * up())});
  }
  for (const solve::ContactResult& c : state.contacts) {
    const bool lifts = c.state == solve::ContactState::lifted || c.state == solve::ContactState::pulled;
    const machine::Place& place = model.reevings[c.reeving].nodes[c.node].at;
    all.contacts.push_back({c.reeving, c.node, c.wrap, lifts, machine::in_ground(state.state, place), c.force});
  }
  return all;
}

machine::State places_of(const solve::TransientFrame& moment) {
  machine::State state;
  state.bodies.reserve(moment.bodies.size());
  for (const auto& body : moment.bodies) {
    state.bodies.push_back({.position = body.position, .orientation = body.orientation});
  }
  return state;
}

std::vector<FreeRope> free_ropes(const machine::Model& model, const solve::TransientResult& motion,
                                 const solve::TransientFrame& moment) {
  std::vector<FreeRope> all;
  const auto& branches = moment.branches;
  for (std::size_t i = 0; i < branches.size();) {
    const solve::TransientFrame::Branch& first = branches[i];
    const machine::Reeving& rope = model.reevings[first.reeving];
    FreeRope one{.reeving = first.reeving, .from = first.from, .to = first.to, .places = {first.start}};
    const bool bears = first.whole && std::max(first.T_from, first.T_to) > 0;
    for (; i < branches.size(); ++i) {
      const solve::TransientFrame::Branch& piece = branches[i];
      if (piece.reeving != first.reeving || piece.from != first.from || piece.to != first.to) break;
      const bool straight = piece.curve.empty() && rope.segments <= 1 && is_heavy(motion, first.reeving);
      if (bears && straight) {
        const double weight = rope.weight * piece.unstretched / (1 + rope.thermal_strain);
        const Vector3 way = piece.end - piece.start;
        const double across = weight * std::hypot(way.x(), way.y()) / way.norm();
        const bool by_length = rope.given == machine::Given::length;
        const double first = by_length ? 0 : mean_tension(motion.frames.front().branches[i]);
        add_parabola(piece, weight, tension_with_sag(mean_tension(piece), first, rope.stiffness, across), one.places);
      }
      one.places.insert(one.places.end(), piece.curve.begin(), piece.curve.end());
      one.places.push_back(piece.end);
    }
    if (bears) all.push_back(std::move(one));
  }
  return all;
}

study::RopeClearance clearance_of(const machine::Model& model, const FreeRope& rope) {
  return study::rope_clearance(model, rope.places, rope.reeving, rope.from, rope.to);
}

CheckState state_of(const machine::Model& model, const solve::TransientResult& motion,
                    const solve::TransientFrame& moment, std::string words, std::string analysis) {
  CheckState all;
  all.model = &model;
  all.words = std::move(words);
  all.analysis = std::move(analysis);
  all.moves = true;  // until whoever shows it says that it is at rest
  all.t = moment.t;
  for (const auto& b : moment.branches) {
    add_branch(b, model.reevings[b.reeving], is_heavy(motion, b.reeving), all.branches);
    if (has_no_shape(model, moment, b)) all.slack.push_back(b.reeving);
  }
  const machine::State places = places_of(moment);
  for (const auto& c : moment.contacts) {
    const bool lifts = c.state == solve::ContactState::lifted || c.state == solve::ContactState::pulled;
    const machine::Place& place = model.reevings[c.reeving].nodes[c.node].at;
    all.contacts.push_back({c.reeving, c.node, c.wrap, lifts, machine::in_ground(places, place), c.force});
  }
  return all;
}

bool has_no_shape(const machine::Model& model, const solve::TransientFrame& moment,
                  const solve::TransientFrame::Branch& branch) {
  if (std::max(branch.T_from, branch.T_to) > 0 || !branch.curve.empty() || model.reevings[branch.reeving].segments > 1)
    return false;
  return std::all_of(moment.branches.begin(), moment.branches.end(), [&](const solve::TransientFrame::Branch& one) {
    return one.reeving != branch.reeving || one.whole;
  });
}

std::string span_words(const machine::Model& m, int reeving, int from, int to) {
  const machine::Reeving& rope = m.reevings[reeving];
  return fmt::format("{} between {} and {}", rope.name, rope.nodes[from].name, rope.nodes[to].name);
}

std::string gap_words(const std::string& what, const study::TerrainGap& gap, const Display& display) {
  const auto length = [&](double x) { return display.brief(x, si::m); };
  return fmt::format(
      "{}: its clearance is not judged on {}, where there is no terrain ({} before its first place, {} behind its last "
      "one): give the ground under all of it",
      what, length(gap.missing()), length(gap.before), length(gap.after));
}

std::string slack_words(const std::string& rope, const std::string& where) {
  return fmt::format(
      "{}: its clearance is not judged where it is slack ({}): without mass, or straight in a motion, it has no shape "
      "there; give its 'mass', in a motion 'segments' too",
      rope, where);
}

std::string analysis_name(const std::string& ending, const char* kind) {
  return is_numbered(ending) ? std::string(kind) : ending.substr(1);
}

std::string analysis_words(const std::string& ending, const char* kind) {
  if (!is_numbered(ending)) return ending.substr(1);
  return ending.size() < 2 ? std::string(kind) : fmt::format("{} {}", kind, ending.substr(1));
}

}  // namespace taut::checks
