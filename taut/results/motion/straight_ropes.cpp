#include "taut/results/motion/straight_ropes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "taut/math/index.hpp"

namespace taut::results {
namespace {

constexpr double much = 0.05;    // of a tension that is judged
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

solve::TransientFrame hanging_start(const machine::Model& model, solve::TransientOptions options) {
  options.branches = solve::Branches::catenary;
  options.method = solve::TimeMethod::implicit;
  options.step = 0;
  options.duration = options.output_step = a_moment;
  options.progress = {};
  options.take = {};
  const solve::TransientResult moment = solve::transient(model, options);
  return moment.frames.empty() ? solve::TransientFrame() : moment.frames.front();
}

std::vector<SaggingRope> ropes_that_sag(const machine::Model& model, const solve::TransientFrame& begin,
                                        const solve::TransientFrame& hangs, const std::vector<double>& peaks) {
  const std::vector<double> straight = largest_by_rope(model, begin), sagging = largest_by_rope(model, hangs);
  const double largest = sagging.empty() ? 0 : *std::max_element(sagging.begin(), sagging.end());
  std::vector<SaggingRope> found;
  for (std::size_t i = 0; i < model.reevings.size(); ++i) {
    const machine::Reeving& rope = model.reevings[i];
    const double peak = std::max(straight[i], i < peaks.size() ? peaks[i] : 0);
    if (sagging[i] - straight[i] <= much * peak || sagging[i] <= little * std::max(rope.breaking_force, largest))
      continue;
    found.push_back({.name = rope.name, .straight = straight[i], .sagging = sagging[i]});
  }
  return found;
}

std::string sag_words(const std::string& analysis, const SaggingRope& rope) {
  return fmt::format("{}: '{}' begins straight with {:.4g} kN; with its sag it has {:.4g} kN: use 'branches: catenary'",
                     analysis, rope.name, rope.straight / 1e3, rope.sagging / 1e3);
}

}  // namespace taut::results
