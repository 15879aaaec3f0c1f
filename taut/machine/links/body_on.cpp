#include "taut/machine/links/body_on.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <optional>

#include "taut/base/array.hpp"
#include "taut/base/suggest.hpp"

namespace taut::machine {
namespace {

/// The ways in which a signal drives a body by more than a constant, which only says where it stands.
Array<Freedom> driven_ways(const Body& body) {
  Array<Freedom> ways;
  for (const DrivenWay& way : body.driven) {
    if (!std::holds_alternative<double>(way.signal.law)) ways.push_back({.along = way.along, .about = way.about});
  }
  return ways;
}

/// The body that each one is on; empty: on none, or on one that can't be.
Array<std::optional<int>> parents_of(const Machine& machine, std::vector<Complaint>& complaints) {
  std::vector<std::string> names;
  names.reserve(machine.bodies.size());
  for (const auto& body : machine.bodies) names.push_back(body.name);
  Array<std::optional<int>> parents(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& given = machine.bodies[i];
    if (!given.on) continue;
    const std::string path = fmt::format("bodies.{}.on", given.name);
    const auto found = std::find(names.begin(), names.end(), *given.on);
    if (found == names.end()) {
      complaints.push_back({path, fmt::format("there is no body '{}'{}", *given.on, did_you_mean(*given.on, names))});
      continue;
    }
    parents[i] = static_cast<int>(found - names.begin());
    if (given.motion) {
      complaints.push_back({path, "a driven body has its place in the ground frame"});
    }
    const auto joined = [&](const auto& beam) { return beam.from == given.name || beam.to == given.name; };
    if (std::any_of(machine.beams.begin(), machine.beams.end(), joined)) {
      complaints.push_back({path, "a beam is joined to this body: give its place in the ground frame"});
    }
  }
  return parents;
}

/// Whether `way` is a sum of some of the directions.
bool spans(const Array<Vector3>& directions, const Vector3& way) {
  constexpr double rounding = 1e-9;
  if (way.norm() <= rounding) return true;
  if (directions.empty()) return false;
  Eigen::Matrix3Xd all(3, static_cast<Eigen::Index>(directions.size()));
  for (std::size_t i = 0; i < directions.size(); ++i) all.col(static_cast<Eigen::Index>(i)) = directions[i];
  const Vector3 found = all * all.completeOrthogonalDecomposition().solve(way);
  return (found - way).norm() <= rounding * way.norm();
}

/// Whether a body has the ways to go where one of the ways of the body that it is on takes it. About an axis it goes
/// round: in all directions across the axis, and need not turn then, as what hangs on ropes; or it is on the axis,
/// moves along that only, and turns as well.
bool follows(const Body& body, const Body& under, const Freedom& way) {
  Array<Vector3> shifts, turns;
  for (const Freedom& own : body.free) {
    if (own.along != Vector3::Zero()) shifts.push_back(own.along);
    if (own.about != Vector3::Zero()) turns.push_back(own.about);
  }
  if (!spans(shifts, way.along)) return false;
  if (way.about == Vector3::Zero()) return true;
  const Vector3 across = way.about.unitOrthogonal();
  if (spans(shifts, across) && spans(shifts, way.about.cross(across))) return true;
  const auto on_axis = [&](const Vector3& one) { return spans({way.about}, one); };
  return on_axis(body.position - under.position) && std::all_of(shifts.begin(), shifts.end(), on_axis) &&
         spans(turns, way.about);
}

/// A body that has not the ways of the one that it is on.
std::optional<Complaint> left_behind(const description::Body& given, const Body& body, const Body& under) {
  const auto goes_along = [&](const Array<Freedom>& ways) {
    return std::all_of(ways.begin(), ways.end(), [&](const Freedom& way) { return follows(body, under, way); });
  };
  const std::string path = fmt::format("bodies.{}.on", given.name);
  if (!goes_along(under.free)) {
    return Complaint{.path = path,
                     .message = fmt::format(
                         "'{}' is free to move, and '{}' would stay behind: 'on' gives its place at the start, no "
                         "joint. What is fixed to '{}' is part of it: put its points, loads and mass there. What "
                         "moves on it needs the 'free' ways to go along (a 'guide' does not turn), and ropes, "
                         "cylinders or contacts that hold it",
                         under.name, given.name, under.name)};
  }
  if (!goes_along(driven_ways(under))) {
    return Complaint{
        .path = path,
        .message = fmt::format("'{}' has a 'motion', and '{}' would stay behind: 'on' gives its place at the "
                               "start, no joint. Give it the same 'motion', or the 'free' ways to go along (a "
                               "'guide' does not turn) and what holds it",
                               under.name, given.name)};
  }
  return {};
}

}  // namespace

void place_bodies_on_others(const Machine& machine, Model& model, std::vector<Complaint>& complaints) {
  const auto parents = parents_of(machine, complaints);
  enum class Now { open, under_way, done };
  Array<Now> now(parents.size(), Now::open);
  for (std::size_t first = 0; first < parents.size(); ++first) {
    // up to a body that stands, then down again
    Array<std::size_t> chain;
    for (std::optional i = static_cast<int>(first); i && now[*i] != Now::done; i = parents[*i]) {
      const auto k = static_cast<std::size_t>(*i);
      if (now[k] == Now::under_way) {
        complaints.push_back(
            {fmt::format("bodies.{}.on", machine.bodies[k].name), "the bodies stand on each other in a circle"});
        return;
      }
      now[k] = Now::under_way;
      chain.push_back(k);
    }
    std::reverse(chain.begin(), chain.end());
    for (const std::size_t i : chain) {
      now[i] = Now::done;
      if (!parents[i]) continue;
      const Body& under = model.bodies[*parents[i]];
      Body& body = model.bodies[i];
      body.position = under.position + under.orientation * body.position;
      body.orientation = under.orientation * body.orientation;
      for (Freedom& way : body.free) {
        way.along = under.orientation * way.along;
        way.about = under.orientation * way.about;
      }
      if (auto complaint = left_behind(machine.bodies[i], body, under)) complaints.push_back(*std::move(complaint));
    }
  }
}

}  // namespace taut::machine
