#include "taut/study/transient_record.hpp"

#include <algorithm>
#include <cmath>

#include "taut/base/array.hpp"

namespace taut::study {
namespace {

// Pictures of 2000 moments are as good as of more; with many parts in each of them they would take gigabytes.
constexpr std::size_t most_frames = 2001, most_parts = 400'000;

/// How many frames like this one are shown.
std::size_t shown_at_most(const solve::TransientFrame& frame) {
  std::size_t parts = frame.bodies.size() + frame.contacts.size() + frame.branches.size() + 1;
  for (const auto& branch : frame.branches) parts += branch.curve.size();
  return std::clamp<std::size_t>(most_parts / parts, 3, most_frames);
}

Array<double> observed_at(const solve::TransientResult& so_far, std::size_t frame) {
  Array<double> values;
  values.reserve(so_far.observed.size());
  for (const auto& one : so_far.observed) values.push_back(one[frame]);
  return values;
}

/// When the largest tension of all ropes was, s.
double time_of_peak(const solve::TransientResult& so_far) {
  const auto most = std::max_element(so_far.ropes.begin(), so_far.ropes.end(),
                                     [](const auto& a, const auto& b) { return a.T.max < b.T.max; });
  return most == so_far.ropes.end() ? 0 : most->T.t_max;
}

}  // namespace

void TransientRecord::take(const solve::TransientResult& so_far) {
  const solve::TransientFrame& frame = so_far.frames.back();
  const Array<double> observed = observed_at(so_far, so_far.frames.size() - 1);
  if (count_ == 0) {
    lines_ = std::make_shared<LongRows>(1 + observed.size());
    energy_ = std::make_shared<LongRows>(6);
    most_ = shown_at_most(frame);
  }
  Array<double> line = {frame.t};
  line.insert(line.end(), observed.begin(), observed.end());
  lines_->add(line);
  const solve::EnergyLedger& e = frame.energy;
  energy_->add({e.kinetic, e.elastic, e.potential, e.supplied, e.dissipated(), e.residual});
  follow_peak(so_far);
  if (count_ % every_ == 0) shown_.push_back({frame, observed});
  if (shown_.size() > most_) thin();
  ++count_;
}

void TransientRecord::follow_peak(const solve::TransientResult& so_far) {
  const double t = time_of_peak(so_far);
  if (t_peak_ == t) return;
  t_peak_ = t;
  // it was after the output step before, or it is that of another rope
  std::size_t nearest = so_far.frames.size() - 1;
  if (nearest > 0) {
    const double now = std::abs(so_far.frames[nearest].t - t), before = std::abs(so_far.frames[nearest - 1].t - t);
    if (before <= now) --nearest;
  }
  peak_ = {.frame = so_far.frames[nearest], .observed = observed_at(so_far, nearest)};
}

void TransientRecord::thin() {
  Array<Shown> half;
  for (std::size_t i = 0; i < shown_.size(); i += 2) half.push_back(std::move(shown_[i]));
  shown_ = std::move(half);
  every_ *= 2;
}

void TransientRecord::show(solve::TransientResult& result) const {
  if (empty()) return;
  Array<Shown> all = shown_;
  const auto put_in = [&](Shown one) {
    const auto place =
        std::lower_bound(all.begin(), all.end(), one.frame.t, [](const Shown& a, double t) { return a.frame.t < t; });
    if (place == all.end() || place->frame.t != one.frame.t) all.insert(place, std::move(one));
  };
  if (every_ > 1) {
    put_in(peak_);
    put_in({.frame = result.frames.back(), .observed = observed_at(result, result.frames.size() - 1)});
  }
  result.frames.clear();
  for (auto& values : result.observed) values.clear();
  for (Shown& one : all) {
    result.frames.push_back(std::move(one.frame));
    for (std::size_t i = 0; i < one.observed.size(); ++i) result.observed[i].push_back(one.observed[i]);
  }
}

}  // namespace taut::study
