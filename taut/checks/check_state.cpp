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

/// cos of the slope of a way.
double level_share(const Vector3& way) { return way.norm() > 0 ? std::hypot(way.x(), way.y()) / way.norm() : 0; }

/// A free part of a rope that the motion has straight, from round to round: forces along it part it in branches.
struct StraightPart {
  Vector3 start = Vector3::Zero(), end = Vector3::Zero();
  double length = 0;   ///< without tension, m
  double weight = 0;   ///< N
  double tension = 0;  ///< the least, N
  double given = 0;    ///< the least with which it was given, N; 0: its length was

  double weight_across() const { return weight * level_share(end - start); }
};

/// The elastic catenary of the unstretched length L between two places; straight where there is none.
study::RopePiece hung(const Vector3& start, const Vector3& end, const machine::Reeving& rope, double L) {
  study::RopePiece piece{.start = start, .end = end, .shape = {}, .sag = 0};
  const double weight = rope.weight / (1 + rope.thermal_strain);
  const auto span = rope::solve_span({.length = L, .weight = weight, .stiffness = rope.stiffness}, end - start);
  if (span) piece.shape = *span;
  return piece;
}

/// How it hangs with the weight that it has at its ends. Without sag its length has its tension. Where its length is
/// given, that is the rope's. Where a tension was given, T1 at the start, the rope is longer than the straight part by
/// the share W^2/(24 T1^2) that its sag took up then; W is its weight across it (Irvine, Cable Structures).
study::RopePiece hung_by_length(const StraightPart& part, const machine::Reeving& rope, double T1) {
  const double across = T1 > 0 ? part.weight_across() / T1 : 0;
  return hung(part.start, part.end, rope, part.length * (1 + across * across / 24));
}

/// Its level tension where its ends have the one that it has straight, N: H^2 = T^2 - (W/2)^2. No catenary has less at
/// its ends than the one with u tanh u = 1, u = W/(2 H) = 1.1997 by its span: with less, rope runs out without end, and
/// it is taken to hang as deep as that one, a third of the span.
double level_tension(const StraightPart& part) {
  constexpr double deepest = 1.1997;
  const double T = part.tension, half = part.weight_across() / 2;
  return std::max(std::sqrt(std::max(T * T - half * half, 0.0)), half / deepest);
}

/// The tension with which a branch was given, N; 0: its length is. A motion that goes on from another has the rope
/// pulled to something else where it begins.
double given_tension(const machine::Reeving& rope, const solve::TransientFrame& begins, std::size_t branch) {
  if (rope.given == machine::Given::length) return 0;
  const bool goes_on = begins.t > 0 && rope.given != machine::Given::equal;
  return goes_on ? rope.value : mean_tension(begins.branches[branch]);
}

StraightPart straight_part(std::span<const solve::TransientFrame::Branch> branches, const machine::Reeving& rope,
                           const solve::TransientFrame& begins, std::size_t first) {
  StraightPart part{.start = branches.front().start, .end = branches.back().end};
  for (std::size_t k = 0; k < branches.size(); ++k) {
    const solve::TransientFrame::Branch& b = branches[k];
    const double T = mean_tension(b), given = given_tension(rope, begins, first + k);
    part.length += (b.end - b.start).norm() / (1 + T / rope.stiffness);
    part.weight += weight_of(b, rope);
    part.tension = k == 0 ? T : std::min(part.tension, T);
    part.given = k == 0 ? given : std::min(part.given, given);
  }
  return part;
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
  const double least_T = most > 0 ? W * level_share(b.end - b.start) / most : T;
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
    const machine::Reeving& rope = model.reevings[first.reeving];
    const bool in_segments = rope.segments > 1, heavy = is_heavy(motion, first.reeving);
    const bool straight = heavy && !in_segments && first.curve.empty();
    for (next = i + 1; next < branches.size() && branches[next].reeving == first.reeving; ++next) {
      const solve::TransientFrame::Branch& one = branches[next];
      const bool piece = one.from == branches[next - 1].from && one.to == branches[next - 1].to;
      if (!piece && !(straight && rope.nodes[one.from].kind == machine::NodeKind::load)) break;
    }
    const auto part = branches.subspan(i, next - i);
    const auto pulls = [](const auto& b) { return std::max(b.T_from, b.T_to) > 0; };
    // joints say how a slack rope in segments lies
    if (!std::all_of(part.begin(), part.end(), [](const auto& b) { return b.whole; })) continue;
    if (!in_segments && !std::all_of(part.begin(), part.end(), pulls)) continue;
    FreeRope one{.reeving = first.reeving, .from = first.from, .to = part.back().to, .pieces = {}, .deeper = {}};
    if (!first.curve.empty()) {
      one.pieces.push_back(hung(first.start, first.end, rope, first.unstretched));
    } else if (!heavy) {
      for (const auto& b : part) one.pieces.push_back({.start = b.start, .end = b.end, .shape = {}, .sag = 0});
    } else if (in_segments) {
      add_segments(part, rope, one.pieces);
    } else {
      const StraightPart own = straight_part(part, rope, motion.frames.front(), i);
      const double has = level_tension(own);
      one.pieces.push_back(hung_by_length(own, rope, own.given));
      one.deeper.push_back(hung_by_length(own, rope, own.given > 0 ? std::min(own.given, has) : has));
    }
    all.push_back(std::move(one));
  }
  return all;
}

study::RopeClearance clearance_of(const machine::Model& model, const FreeRope& rope) {
  return study::rope_clearance(model, rope.pieces, rope.reeving, rope.from, rope.to);
}

study::RopeClearance least_clearance_of(const machine::Model& model, const FreeRope& rope) {
  if (rope.deeper.empty()) return clearance_of(model, rope);
  return study::rope_clearance(model, rope.deeper, rope.reeving, rope.from, rope.to);
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
