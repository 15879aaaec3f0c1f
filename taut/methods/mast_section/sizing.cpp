#include "taut/methods/mast_section/sizing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "taut/base/expects.hpp"
#include "taut/catalogue/steel.hpp"
#include "taut/catalogue/trust.hpp"

namespace taut::mast_section {
namespace {

using catalogue::SectionRow;
using catalogue::SectionShape;

/// Series of standards whose hollow sections are made of their own steels.
constexpr std::array own_steels{"EN 10210", "EN 10219", "GOST"};

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

/// The resultant on a block by what its rope does.
struct BlockForces {
  BlockForce in, out, rest;
  BlockForce of(RopeState state) const {
    switch (state) {
      case RopeState::hauled_in:
        return in;
      case RopeState::paid_out:
        return out;
      case RopeState::at_rest:
        return rest;
      case RopeState::slack:
        break;
    }
    return {};
  }
};

/// Hauled in by (5), (6); paid out the span side carries the full force or what its brake holds, the drum side less by
/// the friction of the block; at rest that friction may hold the full force on the drum side too.
BlockForces block_of(const Input& in, const Output& o, double force, double R, double gamma) {
  const double held = std::min(force, in.paid_out_force.value_or(force)), grip = std::exp(in.block_friction * o.wrap);
  const double across = held * std::cos(o.alpha), down = held * std::sin(o.alpha);
  return {.in = {.across = R * std::cos(gamma), .down = R * std::sin(gamma)},
          .out = {.across = across, .down = down + held / grip},
          .rest = {.across = across, .down = down + std::min(force, held * grip)}};
}

/// The states of both ropes. The forces that a rope can have on its two sides lie between those of its states, and the
/// stress is a convex function of them: with one of these it is largest. What one rope does to a mast adds to what the
/// other one does, unless its guys pull against them: then either may be slack.
std::vector<std::pair<RopeState, RopeState>> states_of(const Input& in) {
  using enum RopeState;
  std::vector<std::pair<RopeState, RopeState>> all = {
      {hauled_in, hauled_in}, {paid_out, paid_out}, {hauled_in, paid_out}, {paid_out, hauled_in}, {at_rest, at_rest},
      {hauled_in, at_rest},   {at_rest, hauled_in}, {paid_out, at_rest},   {at_rest, paid_out}};
  if (in.guys.empty()) return all;
  for (const RopeState one : {hauled_in, paid_out, at_rest}) all.insert(all.end(), {{one, slack}, {slack, one}});
  return all;
}

/// The load cases of a position; N and M of the first two are the method's own.
void add_cases(const Input& in, const Position& p, std::vector<ClampForces>& all) {
  const Output& o = p.out;
  const BlockForces sky = block_of(in, o, in.skyline_force, o.R_sky, o.gamma_sky);
  const BlockForces main = block_of(in, o, in.mainline_force, o.R_main, o.gamma_main);
  const double h_sky = in.skyline_block_height, h_main = in.mainline_block_height.value_or(h_sky);
  for (const auto& [sky_is, main_is] : states_of(in)) {
    ClampForces f{.index = p.index,
                  .skyline_is = sky_is,
                  .mainline_is = main_is,
                  .skyline = sky.of(sky_is),
                  .mainline = main.of(main_is),
                  .lateral = in.lateral_force.value_or(0)};
    f.N = f.skyline.down + f.mainline.down;
    f.M = f.skyline.across * h_sky + f.mainline.across * h_main;
    if (are(f, RopeState::hauled_in)) f.N = o.N, f.M = o.M;
    if (are(f, RopeState::paid_out)) f.N = o.N_payout, f.M = o.M_payout;
    all.push_back(f);
  }
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

double largest_yield(const StressLimit& limit, const SectionRow& section, double allowable) {
  double largest = allowable * limit.safety;
  if (limit.steel) return largest;
  const auto is_of = [](const std::string& standard, const char* series) { return standard.starts_with(series); };
  for (const catalogue::SteelRow& steel : catalogue::steels()) {
    const bool own = std::all_of(own_steels.begin(), own_steels.end(), [&](const char* series) {
      return !is_of(section.standard, series) || is_of(steel.standard, series);
    });
    if (!own) continue;
    if (const auto yield = catalogue::yield(steel, section.thickness)) largest = std::max(largest, *yield);
  }
  return largest;
}

std::string trust_of(const StressLimit& limit) { return limit.steel ? catalogue::trust_words(*limit.steel) : "user"; }

ClampForces operator*(double factor, ClampForces f) {
  for (double* force :
       {&f.N, &f.M, &f.skyline.across, &f.skyline.down, &f.mainline.across, &f.mainline.down, &f.lateral})
    *force *= factor;
  return f;
}

bool are(const ClampForces& f, RopeState state) { return f.skyline_is == state && f.mainline_is == state; }

std::string direction_words(const ClampForces& f) {
  if (f.put_up) return "guys put up, no load";
  const auto words = [](RopeState state) {
    switch (state) {
      case RopeState::hauled_in:
        return "hauled in";
      case RopeState::paid_out:
        return "paid out";
      case RopeState::at_rest:
        return "at rest";
      case RopeState::slack:
        break;
    }
    return "slack";
  };
  if (f.skyline_is == f.mainline_is) return fmt::format("ropes {}", words(f.skyline_is));
  return fmt::format("skyline {}, mainline {}", words(f.skyline_is), words(f.mainline_is));
}

std::string position_words(const Input& in, const ClampForces& f) {
  const bool at_position = in.span && !f.put_up;
  return at_position ? fmt::format("carriage at {:.4g} m", in.span->carriage_position.at(f.index)) : std::string();
}

std::string case_words(const Input& in, const ClampForces& f) {
  const std::string at = position_words(in, f);
  const bool no_side = !f.put_up && f.lateral == 0 && in.lateral_force.value_or(0) != 0;
  return fmt::format("{}{}{}{}", at, at.empty() ? "" : ", ", direction_words(f), no_side ? ", no side force" : "");
}

bool is_beyond_method(const Input& in) {
  return !in.guys.empty() || in.lateral_force.has_value() || in.base == Base::hinged;
}

std::vector<ClampForces> clamp_forces(const Input& in, const std::vector<Position>& positions) {
  std::vector<ClampForces> all;
  const auto add = [&all](const Input& one, const std::vector<Position>& solved) {
    for (const Position& p : solved) {
      if (p.outcome.ok()) add_cases(one, p, all);
    }
  };
  add(in, positions);
  if (in.wrap == Wrap::paper) {
    Input geometric = in;
    geometric.wrap = Wrap::geometric;
    add(geometric, sweep(geometric));
  }
  if (in.guys.empty() || all.empty()) return all;
  if (in.lateral_force.value_or(0) != 0) {
    for (std::size_t k = 0, with = all.size(); k < with; ++k) {
      ClampForces without = all[k];
      without.lateral = 0;
      all.push_back(without);
    }
  }
  all.push_back({.put_up = true});
  return all;
}

bool Assessment::passes() const {
  const bool holds = wall_yields && !(buckling < least_buckling);
  return holds && (only_second_order || stress <= allowable) && (!second_order || *second_order <= allowable);
}

double Assessment::utilisation() const {
  if (second_order && std::isnan(*second_order)) return *second_order;
  const double largest = only_second_order ? second_order.value_or(stress) : std::max(stress, second_order.value_or(0));
  return largest / allowable;
}

namespace {

void take_second_order(const StressLimit& limit, const std::vector<ClampForces>& forces, const SecondOrder& second,
                       Assessment& a) {
  a.only_second_order = second.decides_alone;
  a.least_buckling = second.least_buckling;
  const double yield = largest_yield(limit, a.section, a.allowable);
  for (const ClampForces& f : forces) {
    if (second.wall_yields && !second.wall_yields(a.section, yield, f)) a.wall_yields = false;
    const double stress = second.stress(a.section, f);
    const bool larger = !a.second_order || stress > *a.second_order || std::isnan(stress);
    if (larger) a.second_order = stress, a.second_order_worst = f;
    if (std::isnan(stress)) {
      a.buckling = not_computed;  // the least factor is of this case
      return;
    }
    if (second.buckling) a.buckling = std::fmin(a.buckling, second.buckling(a.section, f));
  }
}

}  // namespace

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
  if (second.stress) take_second_order(limit, forces, second, a);
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

bool is_made_of(const SectionRow& section, const catalogue::SteelRow& steel) {
  const auto is_of = [](const std::string& standard, const char* series) { return standard.starts_with(series); };
  const auto mixes = [&](const char* one, const char* other) {
    return is_of(section.standard, one) && is_of(steel.standard, other);
  };
  return !mixes("EN 10210", "EN 10219") && !mixes("EN 10219", "EN 10210");
}

std::vector<SectionRow> candidates(const Input& in, SectionShape shape) {
  const double largest = in.choose_section.value_or(ChooseSection{}).largest_slenderness;
  auto rows = catalogue::sections_by_mass(filter_of(in, shape));
  const auto steel = catalogue::find_steel(in.steel.value_or(""));
  std::erase_if(rows, [&](const SectionRow& row) {
    return row.height > largest * row.thickness * (1 + 1e-9) || (steel && !is_made_of(row, *steel));
  });
  return rows;
}

namespace {

/// The first of `rows` that passes: by first order, which takes no time and decides unless second order does alone,
/// then by second order, under the worst force first.
std::optional<Assessment> first_that_passes(const Input& in, const std::vector<SectionRow>& rows,
                                            const std::vector<ClampForces>& forces, const SecondOrder& second) {
  const StressLimit limit = limit_of(in);
  for (const SectionRow& row : rows) {
    auto a = assess(limit, row, forces);
    if (!a || (!second.decides_alone && !a->passes())) continue;
    if (second.stress) {
      if (second.may_stand && !second.may_stand(row, a->worst)) continue;
      if (!(second.stress(row, a->worst) <= a->allowable)) continue;
      if (second.buckling && second.buckling(row, a->worst) < second.least_buckling) continue;
      a = assess(limit, row, forces, second);
    }
    if (a->passes()) return a;
  }
  return std::nullopt;
}

/// Whether `a` comes nearer to passing than `b`. Walls that yield come first, and an equilibrium before none.
bool nearer(const Assessment& a, const Assessment& b) {
  if (a.wall_yields != b.wall_yields) return a.wall_yields;
  const auto used = [](const Assessment& one) {
    return std::isnan(one.buckling) ? one.utilisation()
                                    : std::max(one.utilisation(), one.least_buckling / one.buckling);
  };
  const double u = used(a), v = used(b);
  if (std::isnan(u) && std::isnan(v)) return a.stress * b.allowable < b.stress * a.allowable;
  return std::isnan(v) || u < v;
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
    if (a && (!best || nearer(*a, *best))) best = std::move(a);
  }
  return best;
}

std::optional<Assessment> strongest(const Input& in, SectionShape shape, const std::vector<ClampForces>& forces,
                                    const SecondOrder& second) {
  std::optional<Assessment> best;
  const StressLimit limit = limit_of(in);
  auto rows = candidates(in, shape);
  std::reverse(rows.begin(), rows.end());  // what can not stand is passed over once there is another
  for (const SectionRow& row : rows) {
    auto a = assess(limit, row, forces);
    if (a && second.decides_alone) {
      if (best && second.may_stand && !second.may_stand(row, a->worst)) continue;
      a = assess(limit, row, {a->worst}, second);
    }
    if (a && (!best || nearer(*a, *best))) best = std::move(a);
  }
  return best && second.stress ? assess(limit, best->section, forces, second) : best;
}

}  // namespace taut::mast_section
