#include "taut/methods/mast_section/sizing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/base/expects.hpp"
#include "taut/catalogue/steel.hpp"

namespace taut::mast_section {
namespace {

using catalogue::SectionRow;
using catalogue::SectionShape;

catalogue::Trust least_trust(LeastTrust t) {
  switch (t) {
    case LeastTrust::verified:
      return catalogue::Trust::verified;
    case LeastTrust::derived:
      return catalogue::Trust::derived;
    case LeastTrust::unverified:
      break;
  }
  return catalogue::Trust::unverified;
}

std::optional<catalogue::Forming> forming_of(FormingChoice f) {
  switch (f) {
    case FormingChoice::hot:
      return catalogue::Forming::hot;
    case FormingChoice::cold:
      return catalogue::Forming::cold;
    case FormingChoice::seamless:
      return catalogue::Forming::seamless;
    case FormingChoice::welded:
      return catalogue::Forming::welded;
    case FormingChoice::any:
      break;
  }
  return std::nullopt;
}

/// A steeply rising rope can pull the mast up when its drum side is slack: the other fibre governs then.
double stress_in(const SectionRow& section, const ClampForces& f) {
  return std::abs(f.N) / section.area + std::abs(f.M) / section.W_el_y;
}

/// The ropes hauled in: (5), (6).
ClampForces hauled_in(const Position& p) {
  const Output& o = p.out;
  return {.N = o.N,
          .M = o.M,
          .index = p.index,
          .paid_out = false,
          .skyline = {.across = o.R_sky * std::cos(o.gamma_sky), .down = o.R_sky * std::sin(o.gamma_sky)},
          .mainline = {.across = o.R_main * std::cos(o.gamma_main), .down = o.R_main * std::sin(o.gamma_main)}};
}

/// Paid out: the span side carries the full force, the drum side less by the friction of the block.
ClampForces paid_out(const Input& in, const Position& p) {
  const Output& o = p.out;
  const double down = std::sin(o.alpha) + std::exp(-in.block_friction * o.wrap), across = std::cos(o.alpha);
  const double slips = in.paid_out_force.value_or(std::max(in.skyline_force, in.mainline_force));
  const double sky = std::min(in.skyline_force, slips), main = std::min(in.mainline_force, slips);
  return {.N = o.N_payout,
          .M = o.M_payout,
          .index = p.index,
          .paid_out = true,
          .skyline = {.across = sky * across, .down = sky * down},
          .mainline = {.across = main * across, .down = main * down}};
}

}  // namespace

StressLimit limit_of(const Input& in) {
  if (in.allowable_stress) return {.given = in.allowable_stress, .steel = std::nullopt, .safety = 1};
  const auto steel = catalogue::find_steel(in.steel.value_or(""));
  expects(steel.has_value() && in.safety.has_value(), "mast_section takes inputs without complaints");
  return {.given = std::nullopt, .steel = *steel, .safety = *in.safety};
}

std::optional<double> allowable_stress(const StressLimit& limit, double thickness) {
  if (limit.given) return limit.given;
  const auto yield = catalogue::yield(*limit.steel, thickness);
  if (!yield) return std::nullopt;
  return *yield / limit.safety;
}

std::string trust_of(const StressLimit& limit) {
  if (!limit.steel) return "user";
  const bool unverified = limit.steel->trust == catalogue::Trust::unverified;
  return unverified ? fmt::format("UNVERIFIED: {}", limit.steel->trust_text) : std::string(to_text(limit.steel->trust));
}

std::vector<ClampForces> clamp_forces(const Input& in, const std::vector<Position>& positions) {
  std::vector<ClampForces> all;
  const auto add = [&all](const Input& one, const std::vector<Position>& solved) {
    for (const Position& p : solved) {
      if (!p.outcome.ok()) continue;
      all.push_back(hauled_in(p));
      all.push_back(paid_out(one, p));
    }
  };
  add(in, positions);
  if (in.wrap == Wrap::paper) {
    Input geometric = in;
    geometric.wrap = Wrap::geometric;
    add(geometric, sweep(geometric));
  }
  return all;
}

double Assessment::utilisation() const {
  if (second_order && std::isnan(*second_order)) return *second_order;
  return std::max(stress, second_order.value_or(0)) / allowable;
}

std::optional<Assessment> assess(const StressLimit& limit, const SectionRow& section,
                                 const std::vector<ClampForces>& forces, const SecondOrder& second) {
  expects(!forces.empty(), "a section is assessed under at least one load");
  const auto allowable = allowable_stress(limit, section.thickness);
  if (!allowable) return std::nullopt;
  Assessment a{.section = section, .stress = -1, .allowable = *allowable, .worst = {}, .second_order = std::nullopt};
  for (const ClampForces& f : forces) {
    const double stress = stress_in(section, f);
    if (stress > a.stress) a.stress = stress, a.worst = f;
  }
  if (!second) return a;
  for (const ClampForces& f : forces) {
    const double stress = second(section, f);
    if (a.second_order && !(stress > *a.second_order) && !std::isnan(stress)) continue;
    a.second_order = stress;
    a.second_order_worst = f;
    if (std::isnan(stress)) break;
  }
  return a;
}

namespace {

catalogue::SectionFilter filter_of(const Input& in, SectionShape shape) {
  const ChooseSection choice = in.choose_section.value_or(ChooseSection{});
  catalogue::SectionFilter filter;
  filter.shape = shape;
  filter.forming = forming_of(choice.forming);
  filter.standard = choice.standard.value_or("");
  filter.min_trust = least_trust(choice.least_trust);
  return filter;
}

}  // namespace

std::vector<SectionShape> shapes_of(const Input& in) {
  switch (in.choose_section.value_or(ChooseSection{}).shape) {
    case SectionKind::chs:
      return {SectionShape::chs};
    case SectionKind::shs:
      return {SectionShape::shs};
    case SectionKind::rhs:
      return {SectionShape::rhs};
    case SectionKind::any:
      break;
  }
  return {SectionShape::chs, SectionShape::shs, SectionShape::rhs};
}

std::vector<SectionRow> candidates(const Input& in, SectionShape shape) {
  const double largest = in.choose_section.value_or(ChooseSection{}).largest_slenderness;
  auto rows = catalogue::sections_by_mass(filter_of(in, shape));
  std::erase_if(rows, [&](const SectionRow& row) { return row.height > largest * row.thickness * (1 + 1e-9); });
  return rows;
}

namespace {

/// The first of `rows` that passes: by first order, which takes no time, then by second order, under the worst force
/// first.
std::optional<Assessment> first_that_passes(const Input& in, const std::vector<SectionRow>& rows,
                                            const std::vector<ClampForces>& forces, const SecondOrder& second) {
  const StressLimit limit = limit_of(in);
  for (const SectionRow& row : rows) {
    auto a = assess(limit, row, forces);
    if (!a || !a->passes()) continue;
    if (second) {
      if (!(second(row, a->worst) <= a->allowable)) continue;
      a = assess(limit, row, forces, second);
    }
    if (a->passes()) return a;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Assessment> lightest(const Input& in, SectionShape shape, const std::vector<ClampForces>& forces,
                                   const SecondOrder& second) {
  return first_that_passes(in, candidates(in, shape), forces, second);
}

std::optional<Assessment> section_in_use(const Input& in, const std::vector<ClampForces>& forces,
                                         const SecondOrder& second) {
  if (in.section) return assess(limit_of(in), *catalogue::find_section(*in.section), forces, second);
  std::vector<SectionRow> all;
  for (const SectionShape shape : shapes_of(in)) {
    for (SectionRow& row : candidates(in, shape)) all.push_back(std::move(row));
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.mass_per_length < b.mass_per_length; });
  if (auto passes = first_that_passes(in, all, forces, second)) return passes;
  std::optional<Assessment> best;
  for (const SectionShape shape : shapes_of(in)) {
    auto a = strongest(in, shape, forces, second);
    if (a && (!best || a->stress * best->allowable < best->stress * a->allowable)) best = std::move(a);
  }
  return best;
}

std::optional<Assessment> strongest(const Input& in, SectionShape shape, const std::vector<ClampForces>& forces,
                                    const SecondOrder& second) {
  std::optional<Assessment> best;
  const StressLimit limit = limit_of(in);
  for (const SectionRow& row : candidates(in, shape)) {
    auto a = assess(limit, row, forces);
    if (a && (!best || a->utilisation() < best->utilisation())) best = std::move(a);
  }
  return best && second ? assess(limit, best->section, forces, second) : best;
}

}  // namespace taut::mast_section
