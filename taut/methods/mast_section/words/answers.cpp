#include "taut/calc/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "taut/methods/mast_section/mast_section.hpp"
#include "taut/methods/mast_section/tables.hpp"
#include "taut/units/display.hpp"

namespace taut::mast_section {
namespace {

/// The row of the section that is checked.
std::size_t row_in_use(const Table& sections, const Result& r) {
  for (std::size_t i = 0; i < sections.rows.size(); ++i) {
    const std::string name = fmt::format("strength of {},", text_in(sections, i, "name"));
    if (std::any_of(r.checks.begin(), r.checks.end(), [&](const Check& c) { return c.name.starts_with(name); }))
      return i;
  }
  return sections.rows.size();
}

/// "CHS 610x25 (EN 10210-2), steel S355, 12 m high, 360.7 kg/m".
std::string section_words(const Input& in, const Table& sections, std::size_t row, const Display& display) {
  std::string text = fmt::format("mast {} ({})", text_in(sections, row, "name"), text_in(sections, row, "standard"));
  if (in.steel) text += fmt::format(", steel {}", *in.steel);
  return text + fmt::format(", {} high, {}", display.brief(height_of(in), si::m),
                            display.brief(number_in(sections, row, "mass"), si::kg_per_m));
}

/// The check of the mast's stress with the largest utilisation: its slenderness and its wall are no stress.
const Check* worst_of_mast(const Result& r) {
  const Check* worst = nullptr;
  for (const Check& c : r.checks) {
    if (c.part == "mast" && c.unit.dimension == si::Pa.dimension &&
        (worst == nullptr || !(c.utilisation <= worst->utilisation)))
      worst = &c;
  }
  return worst;
}

/// What the foot has to hold: by the engine, the worst of all load cases. Without one the method's own, of a mast that
/// is its cantilever.
std::vector<std::string> foot_words(const Input& in, const Result& r, const Display& display) {
  const auto shown = [&](const char* value) {
    const Value* v = r.find_value(value);
    return v == nullptr ? std::string() : display.brief(v->value, v->unit);
  };
  if (r.find_value("N_worst_exact") == nullptr) {
    if (is_beyond_method(in)) return {};
    return {fmt::format("moment {}, ropes paid out {}", shown("M"), shown("M_payout")),
            fmt::format("axial force {}, shear {}", shown("N"), shown("Q"))};
  }
  const double least = number_of(r, "N_least_exact");
  const std::string pull =
      least < 0 ? fmt::format("pulled up with up to {}", display.brief(-least, si::N)) : std::string();
  return {in.base == Base::hinged ? "hinged, no moment" : fmt::format("moment up to {}", shown("M_worst_exact")),
          fmt::format("axial force up to {}, shear up to {}", shown("N_worst_exact"), shown("Q_worst_exact")), pull,
          "exact, worst of all load cases"};
}

}  // namespace

std::vector<Answer> answers(const Input& in, const Result& r, const Display& display) {
  Result lines;
  const auto shown = [&](const char* value) {
    const Value* v = r.find_value(value);
    return v == nullptr ? std::string() : display.brief(v->value, v->unit);
  };
  const Table* sections = r.find_table("sections");
  const std::size_t row = sections == nullptr ? 0 : row_in_use(*sections, r);
  const bool has_section = sections != nullptr && row < sections->rows.size();
  if (has_section) {
    add_answer_line(lines, in.section ? given_label : build_label, {section_words(in, *sections, row, display)});
  }
  if (const Check* c = worst_of_mast(r)) {
    add_answer_line(
        lines, "Stress",
        {fmt::format("{} of {} allowed", std::isnan(c->value) ? "no equilibrium" : display.brief(c->value, c->unit),
                     display.brief(c->limit, c->unit)),
         c->name, c->where});
  }
  add_answer_line(lines, "Foot", foot_words(in, r, display));
  const double tube = number_of(r, "D_tube_worst");
  if (std::isfinite(tube)) {
    const Unit mm = si::m.in("mm");
    add_answer_line(lines, has_section ? std::string_view("Ideal tube") : needs_label,
                    {fmt::format("outer diameter {}, wall {}", display.brief(tube, mm, Rounding::up),
                                 display.brief(tube * (1 - in.tube_ratio) / 2, mm, Rounding::up)),
                     fmt::format("by the paper's coefficients {}", shown("D_tube_printed")),
                     is_beyond_method(in) ? "for the method's mast alone: clamped, no guys, no side force" : ""});
  }
  if (r.find_value("guy_tension_max_exact") != nullptr) {
    std::vector<std::string> guys = {fmt::format("up to {}", shown("guy_tension_max_exact"))};
    if (r.find_value("guy_safety_min_exact") != nullptr)
      guys.push_back(fmt::format("least safety factor {}", shown("guy_safety_min_exact")));
    add_answer_line(lines, "Guys", guys);
  }
  return lines.answers;
}

}  // namespace taut::mast_section
