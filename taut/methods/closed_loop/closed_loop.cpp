#include "taut/methods/closed_loop/closed_loop.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "taut/catalogue/rope_search.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/methods/closed_loop/position.hpp"

namespace taut::closed_loop {
namespace {

using Complaints = std::vector<Complaint>;

bool has_direct_weights(const Input& in) { return !in.choose_ropes && !in.return_rope && !in.traction_rope; }

void check_positions(const Input& in, Complaints& all) {
  for (std::size_t i = 0; i < in.position.size(); ++i) {
    if (in.position[i] > 0 && in.position[i] < in.span) continue;
    const std::string path = in.position.size() == 1 ? "position" : fmt::format("position[{}]", i);
    all.push_back(
        {path, fmt::format("the carriage must stand between the supports: more than 0 and less than the span of "
                           "{:.6g} m",
                           in.span)});
  }
}

void check_geometry(const Input& in, Complaints& all) {
  if (in.height_difference) {
    if (in.slope != 0) all.push_back({"height_difference", "give either slope or height_difference, not both"});
    const double limit = in.span * std::numbers::sqrt3;
    if (std::abs(*in.height_difference) >= limit) {
      all.push_back(
          {"height_difference", fmt::format("is steeper than 60 deg: at most {:.6g} m over this span", limit)});
    }
  }
  if (in.gathering_angle_from == AngleFrom::vertical && in.gathering_angle >= std::numbers::pi / 2) {
    all.push_back({"gathering_angle", "must be less than 90 deg from the vertical"});
  }
  if (in.gathering_angle_from == AngleFrom::horizontal && in.gathering_angle <= 0) {
    all.push_back({"gathering_angle", "must be more than 0 deg from the horizontal"});
  }
  check_positions(in, all);
}

void check_mode(const Input& in, Complaints& all) {
  if (in.mode == Mode::sag && !in.sag) all.push_back({"sag", "is required in mode sag: the sag f at the carriage"});
  if (in.mode != Mode::sag && in.sag) all.push_back({"sag", "is found in this mode; leave it out, or use mode: sag"});
  if (in.mode == Mode::winch_pull && !in.winch_pull) {
    all.push_back({"winch_pull", "is required in mode winch_pull"});
  }
  if (in.mode != Mode::winch_pull && in.winch_pull) {
    all.push_back({"winch_pull", "is used in mode winch_pull only; leave it out, or set mode: winch_pull"});
  }
  if (in.mode == Mode::loop_length && !in.loop_length) {
    all.push_back({"loop_length", "is required in mode loop_length: the unstretched length of the whole loop"});
  }
  if (in.mode != Mode::loop_length && in.loop_length) {
    all.push_back({"loop_length", "is used in mode loop_length only; leave it out"});
  }
}

void check_section_place(const Input& in, double x, const std::string& path, Complaints& all) {
  const double d = *in.section_distance;
  const double first = in.position_of == Section::first ? x : x - d;
  if (first > 0 && first + d < in.span) return;
  all.push_back(
      {path, fmt::format("with a section distance of {:.4g} m a section of the carriage at x = {:.4g} m would "
                         "stand outside the span",
                         d, x)});
}

void check_carriage(const Input& in, Complaints& all) {
  if (in.carriage == Carriage::single) {
    const auto refuse = [&](bool given, const char* key) {
      if (given) all.push_back({key, "belongs to carriage: two_section; leave it out or change carriage"});
    };
    refuse(in.section_distance.has_value(), "section_distance");
    refuse(in.distance_kind != DistanceKind::horizontal, "distance_kind");
    refuse(in.sag_of != Section::first, "sag_of");
    refuse(in.position_of != Section::first, "position_of");
    return;
  }
  if (!in.section_distance) {
    all.push_back({"section_distance", "is required for a two_section carriage"});
    return;
  }
  if (in.position.empty()) check_section_place(in, in.span / 2, "section_distance", all);
  for (std::size_t i = 0; i < in.position.size(); ++i) {
    check_section_place(in, in.position[i], fmt::format("position[{}]", i), all);
  }
}

void check_rope(const std::optional<std::string>& rope, bool has_weight, const std::string& role, Complaints& all) {
  const std::string key = role + "_rope";
  if (rope && has_weight) {
    all.push_back({key, fmt::format("give either {0}_rope or {0}_weight, not both", role)});
  }
  if (!rope) return;
  const auto row = catalogue::find_rope_in_words(*rope);
  if (!row) all.push_back({key, catalogue::to_text(row.error())});
}

void check_ropes(const Input& in, Complaints& all) {
  check_rope(in.return_rope, in.return_weight.has_value(), "return", all);
  check_rope(in.traction_rope, in.traction_weight.has_value(), "traction", all);
  if (!in.choose_ropes) {
    if (!in.return_rope && !in.return_weight) {
      all.push_back({"return_weight", "is required: give return_weight, return_rope or choose_ropes"});
    }
    if (!in.traction_rope && !in.traction_weight) {
      all.push_back({"traction_weight", "is required: give traction_weight, traction_rope or choose_ropes"});
    }
    return;
  }
  if (in.return_rope || in.return_weight || in.traction_rope || in.traction_weight) {
    all.push_back({"choose_ropes",
                   "picks both ropes: leave out return_rope, return_weight, traction_rope, "
                   "traction_weight"});
  }
  if (!in.safety_factor) {
    all.push_back({"choose_ropes", "needs safety_factor: it is never assumed"});
  }
  catalogue::RopeFilter wanted;
  wanted.construction = in.choose_ropes->construction.value_or("");
  wanted.core = in.choose_ropes->core.value_or("");
  wanted.grade = in.choose_ropes->grade;
  if (catalogue::select_ropes(wanted).empty()) {
    all.push_back({"choose_ropes", "no rope of the catalogue has this construction, core and grade together"});
  }
}

void check_sizing(const Input& in, Complaints& all) {
  if (in.wire_strength && !in.safety_factor) {
    all.push_back({"wire_strength", "needs safety_factor for sizing: it is never assumed"});
  }
  const bool used = in.wire_strength || in.choose_ropes || in.return_rope || in.traction_rope;
  if (in.safety_factor && !used) {
    all.push_back({"safety_factor",
                   "has nothing to size or check: add wire_strength (areas), choose_ropes, or name "
                   "return_rope and traction_rope"});
  }
}

}  // namespace

std::vector<Complaint> complaints(const Input& in) {
  Complaints all;
  check_geometry(in, all);
  check_mode(in, all);
  check_carriage(in, all);
  check_ropes(in, all);
  check_sizing(in, all);
  return all;
}

double pull_at_A(const Input& in) {
  return in.haul == Haul::in ? *in.winch_pull * in.head_efficiency : *in.winch_pull / in.head_efficiency;
}

double pull_at_winch(const Input& in, double T_lA) {
  return in.haul == Haul::in ? T_lA / in.head_efficiency : T_lA * in.head_efficiency;
}

template <class T>
Outcome compute(const Input& in, Sheet<T>& s, Output& out) {
  if (has_direct_weights(in) && in.position.size() <= 1) {
    const double* x = in.position.empty() ? nullptr : in.position.data();
    return solve_position(in, {x, *in.return_weight, *in.traction_weight}, s, out);
  }
  Ropes ropes;
  if (Outcome o = ropes_of(in, ropes); !o.ok()) return o;
  const std::size_t at = in.position.size() > 1 ? worst_of(sweep(in, ropes)) : 0;
  return solve_position(in, setting_of(in, ropes, at), s, out);
}

template Outcome compute(const Input&, Sheet<double>&, Output&);
template Outcome compute(const Input&, Sheet<Num>&, Output&);

Outcome solve(const Input& in, Output& out) {
  Sheet<double> silent;
  return compute(in, silent, out);
}

}  // namespace taut::closed_loop
