#include "taut/results/motion/straight_ropes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/math/index.hpp"

namespace taut::results {
namespace {

constexpr double much = 0.05;    // of a tension
constexpr double little = 0.01;  // of a breaking force: a factor of 100 decides nothing

constexpr double a_moment = 1e-6;  // s

std::vector<double> largest_by_rope(const machine::Model& model, const solve::TransientFrame& frame) {
  std::vector<double> largest(model.reevings.size(), 0);
  for (const solve::TransientFrame::Branch& branch : frame.branches) {
    double& T = largest[as_size(branch.reeving)];
    T = std::max({T, branch.T_from, branch.T_to});
  }
  return largest;
}

}  // namespace

std::optional<solve::TransientFrame> hanging_start(const machine::Model& model, solve::TransientOptions options) {
  options.branches = solve::Branches::catenary;
  options.method = solve::TimeMethod::implicit;
  options.step = 0;
  options.duration = options.output_step = a_moment;
  options.progress = {};
  options.take = {};
  const solve::TransientResult moment = solve::transient(model, options);
  if (moment.frames.empty()) return std::nullopt;
  return moment.frames.front();
}

double heaviest_share(const machine::Model& model, const solve::TransientFrame& begin, std::size_t reeving) {
  const machine::Reeving& rope = model.reevings[reeving];
  if (rope.segments > 1 || !(rope.weight > 0)) return 0;
  double most = 0;
  for (const solve::TransientFrame::Branch& branch : begin.branches) {
    if (as_size(branch.reeving) != reeving || !branch.whole || !branch.curve.empty()) continue;
    const double T = (branch.T_from + branch.T_to) / 2;
    most = std::max(most, T > 0 ? rope.weight * branch.unstretched / T : 1.0);
  }
  return most;
}

std::vector<std::string> sag_warnings(const std::string& analysis, const machine::Model& model,
                                      const solve::TransientFrame& begin,
                                      const std::optional<solve::TransientFrame>& hangs,
                                      const std::vector<double>& peaks, const Display& display) {
  std::vector<std::string> all;
  if (!hangs) {
    for (std::size_t i = 0; i < model.reevings.size(); ++i) {
      const double share = heaviest_share(model, begin, i);
      if (share <= much) continue;
      all.push_back(
          fmt::format("{}: '{}' is straight, though a free part of it weighs {:.0f} % of its tension, and the "
                      "machine does not come to rest with its sag: what that pulls is not known",
                      analysis, model.reevings[i].name, 100 * share));
    }
    return all;
  }
  const std::vector<double> straight = largest_by_rope(model, begin), sagging = largest_by_rope(model, *hangs);
  const double largest = sagging.empty() ? 0 : *std::max_element(sagging.begin(), sagging.end());
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    const machine::Reeving& rope = model.reevings[i];
    const double peak = std::max(straight[i], i < peaks.size() ? peaks[i] : 0);
    if (sagging[i] - straight[i] <= much * peak) continue;
    if (sagging[i] <= little * std::max(rope.breaking_force, largest)) continue;
    all.push_back(fmt::format("{}: '{}' begins straight with {}; with its sag it has {}: use 'branches: catenary'",
                              analysis, rope.name, display.brief(straight[i], si::N),
                              display.brief(sagging[i], si::N)));
  }
  return all;
}

}  // namespace taut::results
