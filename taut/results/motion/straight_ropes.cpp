#include "taut/results/motion/straight_ropes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "taut/math/index.hpp"

namespace taut::results {
namespace {

constexpr double much = 0.05;    // of a tension
constexpr double little = 0.01;  // of a breaking force: a factor of 100 decides nothing

constexpr double a_moment = 1e-6;  // s

/// Of the branches of a state in motion, or at rest.
template <class Branches>
std::vector<double> largest_by_rope(const machine::Model& model, const Branches& branches) {
  std::vector<double> largest(model.reevings.size(), 0);
  for (const auto& branch : branches) {
    double& T = largest[as_size(branch.reeving)];
    T = std::max({T, branch.T_from, branch.T_to});
  }
  return largest;
}

bool begins_at_load(const machine::Reeving& rope, const solve::TransientFrame::Branch& branch) {
  return as_size(branch.from) < rope.nodes.size() && rope.nodes[branch.from].kind == machine::NodeKind::load;
}

/// What lets a rope sag.
std::string mend(const machine::Model& model, const solve::TransientFrame& begin, std::size_t reeving) {
  bool others = false;  // by their straight parts
  for (std::size_t i = 0; i < model.reevings.size(); ++i)
    others = others || (!kept_straight(model.reevings[i]) && heaviest_share(model, begin, i) > 0);
  if (kept_straight(model.reevings[reeving])) return "the force along it keeps it straight: give it 'segments'";
  return others || !any_kept_straight(model) ? "use 'branches: catenary'"
                                             : "give 'segments' to the ropes with forces along them";
}

}  // namespace

std::optional<solve::TransientFrame> start_as(const machine::Model& model, solve::TransientOptions options,
                                              solve::Branches branches) {
  options.branches = branches;
  options.method = solve::TimeMethod::implicit;
  options.step = 0;
  options.duration = options.output_step = a_moment;
  options.progress = {};
  options.take = {};
  options.moment = {};
  options.anew = {};
  const solve::TransientResult moment = solve::transient(model, options);
  if (moment.frames.empty()) return std::nullopt;
  return moment.frames.front();
}

std::optional<solve::TransientFrame> hanging_start(const machine::Model& model, solve::TransientOptions options) {
  return start_as(model, std::move(options), solve::Branches::catenary);
}

bool kept_straight(const machine::Reeving& rope) {
  const auto is_load = [](const machine::Node& node) { return node.kind == machine::NodeKind::load; };
  return rope.segments <= 1 && rope.weight > 0 && std::any_of(rope.nodes.begin(), rope.nodes.end(), is_load);
}

bool any_kept_straight(const machine::Model& model) {
  return std::any_of(model.reevings.begin(), model.reevings.end(), kept_straight);
}

std::optional<Sagging> with_sag(const machine::Model& model, const std::optional<solve::TransientFrame>& hangs,
                                solve::Start start) {
  const bool loaded = any_kept_straight(model), settles = start != solve::Start::assembled;
  const auto rest = loaded && settles ? solve::rest_before_motion(model) : std::nullopt;
  if (!hangs && !rest) return std::nullopt;
  Sagging known{.T = std::vector<double>(model.reevings.size(), 0), .with_loads = !loaded || rest.has_value()};
  const auto take = [&](const std::vector<double>& largest) {
    for (std::size_t i = 0; i < largest.size(); ++i) known.T[i] = std::max(known.T[i], largest[i]);
  };
  if (hangs) take(largest_by_rope(model, hangs->branches));
  if (rest) take(largest_by_rope(model, rest->branches));
  return known;
}

double heaviest_share(const machine::Model& model, const solve::TransientFrame& begin, std::size_t reeving) {
  const machine::Reeving& rope = model.reevings[reeving];
  if (rope.segments > 1 || !(rope.weight > 0)) return 0;
  double most = 0, weight = 0, T = 0;
  for (const solve::TransientFrame::Branch& branch : begin.branches) {
    if (as_size(branch.reeving) != reeving || !branch.whole || !branch.curve.empty()) continue;
    const double here = (branch.T_from + branch.T_to) / 2, own = rope.weight * branch.unstretched;
    const bool goes_on = begins_at_load(rope, branch);
    weight = goes_on ? weight + own : own;
    T = goes_on ? std::min(T, here) : here;
    most = std::max(most, T > 0 ? weight / T : 1.0);
  }
  return most;
}

std::vector<std::string> sag_warnings(const std::string& analysis, const machine::Model& model,
                                      const solve::TransientFrame& begin, const std::optional<Sagging>& hangs,
                                      const std::vector<double>& peaks, const Display& display) {
  std::vector<std::string> all;
  const std::vector<double> straight = largest_by_rope(model, begin.branches);
  const std::vector<double> sagging = hangs ? hangs->T : straight;
  const double largest = sagging.empty() ? 0 : *std::max_element(sagging.begin(), sagging.end());
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    const machine::Reeving& rope = model.reevings[i];
    const bool loaded = kept_straight(rope);
    if (!hangs || (loaded && !hangs->with_loads)) {
      const double share = heaviest_share(model, begin, i);
      if (share <= much) continue;
      const std::string why =
          loaded ? ": " + mend(model, begin, i)
                 : ", and the machine does not come to rest with its sag: what that pulls is not known";
      all.push_back(fmt::format("{}: '{}' is straight, though a free part of it weighs {:.0f} % of its tension{}",
                                analysis, rope.name, 100 * share, why));
      continue;
    }
    const double peak = std::max(straight[i], i < peaks.size() ? peaks[i] : 0);
    if (sagging[i] - straight[i] <= much * peak) continue;
    if (sagging[i] <= little * std::max(rope.breaking_force, largest)) continue;
    all.push_back(fmt::format("{}: '{}' begins straight with {}; with its sag it has {}: {}", analysis, rope.name,
                              display.brief(straight[i], si::N), display.brief(sagging[i], si::N),
                              mend(model, begin, i)));
  }
  return all;
}

}  // namespace taut::results
