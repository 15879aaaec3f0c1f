#include "taut/checks/check_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "taut/math/index.hpp"
#include "taut/rope/span.hpp"

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

double mean_tension(const solve::TransientFrame::Branch& b) { return (b.T_from + b.T_to) / 2; }

/// Of a branch without its heat, N.
double weight_of(const solve::TransientFrame::Branch& b, const machine::Reeving& rope) {
  return rope.weight * b.unstretched / (1 + rope.thermal_strain);
}

/// cos of a branch's slope.
double level_share(const solve::TransientFrame::Branch& b) {
  const Vector3 way = b.end - b.start;
  return way.norm() > 0 ? std::hypot(way.x(), way.y()) / way.norm() : 0;
}

/// The elastic catenary of the unstretched length L between the ends of a branch; straight where there is none.
study::RopePiece hung(const solve::TransientFrame::Branch& b, const machine::Reeving& rope, double L) {
  study::RopePiece piece{.start = b.start, .end = b.end, .shape = {}, .sag = 0};
  const double weight = rope.weight / (1 + rope.thermal_strain);
  const auto span = rope::solve_span({.length = L, .weight = weight, .stiffness = rope.stiffness}, b.end - b.start);
  if (span) piece.shape = *span;
  return piece;
}

/// How a straight branch hangs whose weight is at its ends. Without sag its length has the tension T0. Where its length
/// is given, that is the rope's. Where a tension was given, T1 at the start, the rope is longer than the straight
/// branch by the share W^2/(24 T1^2) that its sag took up then; W is its weight across it (Irvine, Cable Structures).
/// With the level part of T0 as T1 it hangs in the tension that it has.
study::RopePiece hung_by_length(const solve::TransientFrame::Branch& b, const machine::Reeving& rope, double T1) {
  const double L = (b.end - b.start).norm() / (1 + mean_tension(b) / rope.stiffness);
  const double across = T1 > 0 ? weight_of(b, rope) * level_share(b) / T1 : 0;
  return hung(b, rope, L * (1 + across * across / 24));
}

/// Whether the free rope stays as long as it is. Rope that a weight pulls over rounds, or a tension off a drum, comes
/// after until it has its tension. A carriage on the rope takes none of its length.
bool keeps_its_length(const machine::Model& model, const machine::Reeving& rope) {
  return std::all_of(rope.nodes.begin(), rope.nodes.end(), [&](const machine::Node& node) {
    if (!node.drum) {
      const bool stands = node.at.body == machine::ground || machine::stands_fast(model.bodies[node.at.body]);
      return stands || rope.nodes.size() == 2 || machine::rides(model, node) || node.kind == machine::NodeKind::load;
    }
    const machine::DriveKind kind = model.drums[*node.drum].drive.kind;
    return kind == machine::DriveKind::held || kind == machine::DriveKind::speed;
  });
}

/// The level tension of a branch whose ends have the one that a straight branch has, N: H^2 = T^2 - (W/2)^2. No
/// catenary has less at its ends than the one with u tanh u = 1, u = W/(2 H) = 1.1997 by its span: with less, rope runs
/// out without end, and it is taken to hang as deep as that one, a third of the span.
double level_tension(const solve::TransientFrame::Branch& b, const machine::Reeving& rope) {
  constexpr double deepest = 1.1997;
  const double T = mean_tension(b), half = weight_of(b, rope) * level_share(b) / 2;
  return std::max(std::sqrt(std::max(T * T - half * half, 0.0)), half / deepest);
}

/// The tension with which a branch was given, N; 0: its length is. A motion that goes on from another has the rope
/// pulled to something else where it begins.
double given_tension(const machine::Reeving& rope, const solve::TransientFrame& begins, std::size_t branch) {
  if (rope.given == machine::Given::length) return 0;
  const bool goes_on = begins.t > 0 && rope.given != machine::Given::equal;
  return goes_on ? rope.value : mean_tension(begins.branches[branch]);
}

/// The angle by which a rope turns from one segment to the next.
double turn_of(const solve::TransientFrame::Branch& in, const solve::TransientFrame::Branch& out) {
  const Vector3 a = in.end - in.start, b = out.end - out.start;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// A segment of a rope, with half of its weight W at each joint. At the tension T along its chord l the rope sags by
/// W l/(8 T) below it, and turns by W cos(slope)/T. A rope through the joints that only sags turns in the segment by no
/// more than at both of them, `turns`: a wave that has slackened the segment leaves its sag within that.
study::RopePiece hung_between_joints(const solve::TransientFrame::Branch& b, const machine::Reeving& rope,
                                     double turns) {
  study::RopePiece piece{.start = b.start, .end = b.end, .shape = {}, .sag = 0};
  const double W = weight_of(b, rope), T = mean_tension(b);
  const double most = std::min(turns, std::numbers::pi);
  if (!(most > 0) && !(T > 0)) return piece;
  const double least_T = most > 0 ? W * level_share(b) / most : T;
  piece.sag = W * (b.end - b.start).norm() / (8 * std::max(T, least_T));
  return piece;
}

/// The segments of a rope between two nodes.
void add_segments(std::span<const solve::TransientFrame::Branch> segments, const machine::Reeving& rope,
                  Array<study::RopePiece>& pieces) {
  const std::size_t last = segments.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    double before = i > 0 ? turn_of(segments[i - 1], segments[i]) : 0;
    double behind = i < last ? turn_of(segments[i], segments[i + 1]) : 0;
    // at the end of the rope no turn is known: it is that of the other joint
    if (i == 0) before = behind;
    if (i == last) behind = before;
    pieces.push_back(hung_between_joints(segments[i], rope, before + behind));
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

Array<Vector3> FreeRope::places() const {
  Array<Vector3> all = {pieces.front().start};
  for (const study::RopePiece& piece : pieces) all.push_back(piece.end);
  return all;
}

std::vector<FreeRope> free_ropes(const machine::Model& model, const solve::TransientResult& motion,
                                 const solve::TransientFrame& moment) {
  std::vector<FreeRope> all;
  const std::span<const solve::TransientFrame::Branch> branches(moment.branches.data(), moment.branches.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < branches.size(); i = next) {
    const solve::TransientFrame::Branch& first = branches[i];
    while (next < branches.size() && branches[next].reeving == first.reeving && branches[next].from == first.from &&
           branches[next].to == first.to)
      ++next;
    const machine::Reeving& rope = model.reevings[first.reeving];
    const bool in_segments = rope.segments > 1, heavy = is_heavy(motion, first.reeving);
    // joints say how a slack rope in segments lies
    if (!first.whole || !(in_segments || std::max(first.T_from, first.T_to) > 0)) continue;
    FreeRope one{.reeving = first.reeving, .from = first.from, .to = first.to, .pieces = {}};
    if (!first.curve.empty()) {
      one.pieces.push_back(hung(first, rope, first.unstretched));
    } else if (!heavy) {
      for (std::size_t k = i; k < next; ++k)
        one.pieces.push_back({.start = branches[k].start, .end = branches[k].end, .shape = {}, .sag = 0});
    } else if (in_segments) {
      add_segments(branches.subspan(i, next - i), rope, one.pieces);
    } else {
      const double given = given_tension(rope, motion.frames.front(), i), has = level_tension(first, rope);
      const double lower = given > 0 ? std::min(given, has) : has;
      one.pieces.push_back(hung_by_length(first, rope, keeps_its_length(model, rope) ? given : lower));
    }
    all.push_back(std::move(one));
  }
  return all;
}

study::RopeClearance clearance_of(const machine::Model& model, const FreeRope& rope) {
  return study::rope_clearance(model, rope.pieces, rope.reeving, rope.from, rope.to);
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

std::string ground_words(const machine::Model& model, double chainage, const Display& display) {
  const bool is_x = model.terrain_along == Vector3::UnitX() && model.terrain_from.x() == 0;
  return fmt::format("{}{}", is_x ? "x = " : "chainage ", display.brief(chainage, si::m));
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
