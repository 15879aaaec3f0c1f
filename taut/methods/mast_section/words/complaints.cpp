#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/catalogue/rope_words.hpp"
#include "taut/catalogue/section_search.hpp"
#include "taut/catalogue/steel.hpp"
#include "taut/methods/mast_section/mast_section.hpp"
#include "taut/methods/mast_section/sizing.hpp"

namespace taut::mast_section {
namespace {

void branch_angle_rules(const Input& in, std::vector<Complaint>& all) {
  if (in.branch_angle && in.span) {
    all.push_back({"branch_angle", "the span gives the branch angle: give branch_angle or span, not both"});
  }
  if (!in.branch_angle && !in.span) {
    all.push_back({"", "no branch angle: give branch_angle, or span so that it follows from the carriage's position"});
  }
  if (!in.span) return;
  const Span& span = *in.span;
  if (span.carriage_position.empty())
    all.push_back({"span.carriage_position", "at least one carriage position is needed"});
  for (std::size_t i = 0; i < span.carriage_position.size(); ++i) {
    const double x = span.carriage_position[i];
    if (!(x > span.length)) continue;
    const std::string at = span.carriage_position.size() > 1 ? fmt::format("[{}]", i) : "";
    all.push_back({fmt::format("span.carriage_position{}", at),
                   fmt::format("the carriage at {:.6g} m is beyond the span of {:.6g} m", x, span.length)});
  }
}

/// The tension of the skyline at one end of it, with the carriage somewhere.
struct EndTension {
  double force = 0;  ///< N
  double x = 0;      ///< of the carriage, m
  const char* end = "";
};

/// The largest of all carriage positions: the horizontal tension along the chord between the carriage and an end, (10),
/// (11), which is the least that a rope with weight has there.
EndTension largest_by_span(const Span& span) {
  const double l = span.length, H = span.horizontal_tension, slope = std::tan(span.chord_slope);
  EndTension most;
  const auto raise = [&](double rise, double run, double x, const char* end) {
    if (!(run > 0)) return;
    const double force = H * std::hypot(1, rise / run);
    if (force > most.force) most = {.force = force, .x = x, .end = end};
  };
  for (const double x : span.carriage_position) {
    if (!(x > 0) || x > l) continue;
    const double sag = x * (l - x) / (2 * H) * (span.rope_weight / std::cos(span.chord_slope) + 2 * span.load / l);
    raise(sag + x * slope, x, x, "at the mast");
    raise((l - x) * slope - sag, l - x, x, "at its far end");
  }
  return most;
}

/// The skyline of the span is that of the mast: its largest force is no less than what the span asks of it.
void skyline_rules(const Input& in, std::vector<Complaint>& all) {
  constexpr double rounding = 0.005;  // forces are given with three digits
  if (!in.span) return;
  const EndTension most = largest_by_span(*in.span);
  if (!(most.force > (1 + rounding) * in.skyline_force)) return;
  all.push_back({"skyline_force",
                 fmt::format("the skyline has {:.4g} kN {} with the carriage at {:.4g} m, by the span's "
                             "horizontal_tension of {:.4g} kN: its largest force is no less; raise skyline_force, or "
                             "lower horizontal_tension",
                             most.force / 1e3, most.end, most.x, in.span->horizontal_tension / 1e3)});
}

void stress_rules(const Input& in, std::vector<Complaint>& all) {
  if (in.allowable_stress && in.steel) {
    all.push_back({"steel", "the allowable stress is given already: give allowable_stress, or steel and safety"});
  }
  if (in.allowable_stress && in.safety) {
    all.push_back({"safety", "safety goes with steel: an allowable_stress holds as it is"});
  }
  if (!in.allowable_stress && !in.steel) {
    all.push_back({"", "no allowable stress: give allowable_stress, or steel and safety"});
  }
  if (in.steel && !in.safety && !in.allowable_stress) {
    all.push_back({"steel", "safety is missing: the allowable stress is the steel's yield stress over the safety"});
  }
  if (!in.steel) return;
  const auto steel = catalogue::find_steel(*in.steel);
  if (!steel) all.push_back({"steel", to_text(steel.error())});
}

void section_rules(const Input& in, std::vector<Complaint>& all) {
  if (in.section && in.choose_section) {
    all.push_back({"choose_section", "the section is given already: give section or choose_section, not both"});
  }
  if (in.section) {
    const auto section = catalogue::find_section(*in.section);
    if (!section) {
      all.push_back({"section", to_text(section.error())});
    } else if (in.steel && !in.allowable_stress && catalogue::find_steel(*in.steel)) {
      const auto yield = catalogue::yield(*in.steel, section->thickness);
      if (!yield) all.push_back({"section", to_text(yield.error())});
    }
  }
  if (!in.choose_section) return;
  const auto shapes = shapes_of(in);
  const bool any = std::any_of(shapes.begin(), shapes.end(),
                               [&](catalogue::SectionShape shape) { return !candidates(in, shape).empty(); });
  if (!any)
    all.push_back(
        {"choose_section",
         "no section of the catalogue is like that: allow another standard, forming, trust or slenderness, or take "
         "the steel of its standard (EN 10210-1 hot-finished, EN 10219-1 cold-formed)"});
}

void guy_rules(const Input& in, std::size_t i, std::vector<Complaint>& all) {
  const Guy& guy = in.guys[i];
  const std::string at = fmt::format("guys[{}]", i);
  if (guy.rope) {
    const auto rope = catalogue::find_rope_in_words(*guy.rope);
    if (!rope) all.push_back({at + ".rope", to_text(rope.error())});
  } else if (!guy.stiffness || !guy.weight) {
    all.push_back({at, "without a rope of the catalogue a guy needs its stiffness and its weight"});
  }
  const double top = std::max(in.skyline_block_height, in.mainline_block_height.value_or(0));
  const double fixing = guy.attachment_height.value_or(top);
  if (fixing > top) {
    all.push_back({at + ".attachment_height",
                   fmt::format("the guy's upper end at {:.6g} m is above the mast, which ends at its higher block, "
                               "{:.6g} m",
                               fixing, top)});
  }
  if (guy.install.has_value() == guy.length.has_value()) {
    all.push_back({at, "give install (its tension) or length, one of them"});
  }
}

void base_rules(const Input& in, std::vector<Complaint>& all) {
  if (in.base == Base::hinged && in.guys.empty()) {
    all.push_back({"base", "a mast on a hinge falls without guys: give guys, or base: clamped"});
  }
}

}  // namespace

std::vector<Complaint> complaints(const Input& in) {
  std::vector<Complaint> all;
  branch_angle_rules(in, all);
  skyline_rules(in, all);
  stress_rules(in, all);
  section_rules(in, all);
  for (std::size_t i = 0; i < in.guys.size(); ++i) guy_rules(in, i, all);
  base_rules(in, all);
  return all;
}

}  // namespace taut::mast_section
