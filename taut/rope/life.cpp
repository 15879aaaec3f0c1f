#include "taut/rope/life.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>

#include "taut/base/expects.hpp"

namespace taut::rope {
namespace {

constexpr double millimetre = 1e-3;
constexpr double reference_grade = 1770e6;  // Pa
constexpr double tested_bent_length = 60;   // diameters
constexpr double least_counted = 6e-3;      // m; of a rope's diameter, in its endurance factor

/// f_L of what bends. The formula grows without bound towards l = 2.585 d, and the source's tests of short lengths are
/// not known. So nothing shorter than the tests behind the constants is credited with a longer life.
double length_factor(const std::optional<double>& bent_length, double d) {
  const double length = bent_length ? *bent_length / d : tested_bent_length;
  return life_of_length(std::max(length, tested_bent_length));
}

/// Cosine of 120 deg. Where the planes in which two neighbours bend a rope differ by more, the second one bends it
/// back.
constexpr double bent_back = -0.5;

bool bends_back(const Bend& before, const Bend& bend) {
  const Bend* const later = std::max(&before, &bend, std::less<>());  // along the path: `before` may be either
  return before.both_ways || bend.both_ways || later->turned_back || turns_back(before.about, bend.about);
}

/// How often a working cycle bends the rope there: a pass straight-bent-straight is one, a drum half of it; bent
/// against the sense of the round before, it counts more.
double bendings(const Bend& bend, bool reverse, double reverse_weight) {
  const double passes = bend.kind == BendKind::drum ? 0.5 : 1.0;
  return passes * (reverse ? reverse_weight : 1.0);
}

LifeLine line_of(const RopeUse& use, const LifeRules& rules, const LifeConstants& constants, const Duty& duty,
                 const Bend& bend, double times) {
  const double d = use.rope.diameter;
  const double factors = life_of_diameter(std::max(d, least_counted) / (16 * millimetre)) *
                         length_factor(rules.bent_length, d) * rules.core_factor;
  LifeLine line;
  line.duty = duty.name;
  line.bend = bend.name;
  line.ratio = bend.diameter / d;
  line.pull = bend.tension * duty.load * rules.dynamic_factor;
  line.cycles = duty.cycles * times;
  const double pull = line.pull * millimetre * millimetre / (d * d);
  line.endures = std::pow(10.0, log_cycles(constants, pull, *use.rope.grade / reference_grade, line.ratio, factors));
  line.damage = line.cycles / line.endures;
  return line;
}

}  // namespace

bool turns_back(const Vector3& before, const Vector3& about) { return before.dot(about) < bent_back; }

bool counts(const Duty& duty, const Bend& bend) {
  if (bend.kind == BendKind::saddle || !(bend.tension > 0)) return false;
  return duty.over.empty() || std::find(duty.over.begin(), duty.over.end(), bend.name) != duty.over.end();
}

bool is_finite(const Life& life) {
  return std::all_of(life.lines.begin(), life.lines.end(), [](const LifeLine& line) {
    return line.endures > 0 && std::isfinite(line.endures) && std::isfinite(line.damage);
  });
}

namespace {

struct DutyLines {
  std::vector<LifeLine> lines;
  bool reversed = false;

  double damage() const {
    return std::accumulate(lines.begin(), lines.end(), 0.0,
                           [](double sum, const LifeLine& l) { return sum + l.damage; });
  }
};

/// What a duty does as the rope comes over its rounds in this order.
DutyLines in_order(const std::vector<const Bend*>& rounds, const RopeUse& use, const LifeRules& rules,
                   const LifeConstants& constants, const Duty& duty) {
  DutyLines all;
  const Bend* before = use.closed && !rounds.empty() ? rounds.back() : nullptr;
  for (const Bend* bend : rounds) {
    const bool reverse = before != nullptr && bends_back(*before, *bend);
    all.reversed = all.reversed || reverse;
    all.lines.push_back(line_of(use, rules, constants, duty, *bend, bendings(*bend, reverse, rules.reverse_weight)));
    before = bend;
  }
  return all;
}

/// The rope runs both ways: of two rounds that turn it against each other either is the later one. The order that does
/// more counts, its lines along the path.
DutyLines worse_order(const RopeUse& use, const LifeRules& rules, const LifeConstants& constants, const Duty& duty) {
  std::vector<const Bend*> rounds;
  for (const Bend& bend : use.bends) {
    if (counts(duty, bend)) rounds.push_back(&bend);
  }
  DutyLines along = in_order(rounds, use, rules, constants, duty);
  std::reverse(rounds.begin(), rounds.end());
  DutyLines against = in_order(rounds, use, rules, constants, duty);
  std::reverse(against.lines.begin(), against.lines.end());
  return against.damage() > along.damage() ? against : along;
}

}  // namespace

std::vector<Life> life_of(const RopeUse& use, const LifeRules& rules) {
  expects(use.rope.diameter > 1.4e-3 && use.rope.grade.has_value(), "a life needs a diameter and a grade");
  std::vector<Life> all;
  for (const LifeConstants& constants : rules.constants) {
    Life& life = all.emplace_back();
    life.constants = &constants;
    for (const Duty& duty : rules.duty) {
      DutyLines worse = worse_order(use, rules, constants, duty);
      life.reversed = life.reversed || worse.reversed;
      life.damage += worse.damage();
      std::move(worse.lines.begin(), worse.lines.end(), std::back_inserter(life.lines));
    }
  }
  return all;
}

}  // namespace taut::rope
