#include "taut/checks/mast/mast_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "taut/calc/none.hpp"
#include "taut/calc/verdict.hpp"
#include "taut/catalogue/section_search.hpp"
#include "taut/catalogue/steel.hpp"
#include "taut/catalogue/trust.hpp"
#include "taut/checks/described.hpp"
#include "taut/checks/guy/guy_checks.hpp"
#include "taut/structure/hollow_section.hpp"

namespace taut::checks {
namespace {

using structure::LoadedMast;
using structure::MastPlace;
using structure::MastStation;
using structure::MastUse;

constexpr const char* recalled_section =
    "UNVERIFIED: class limits and M_N of hollow sections as recalled, not compared with the standard";
constexpr const char* recalled_curve = "UNVERIFIED: buckling curve and class limits as recalled; annex B verified";

constexpr double same_place = 1e-4;  // m

const structure::MastCase& case_at(const LoadedMast& m, const MastPlace& at) { return m.cases[at.load_case]; }
const MastStation& station_at(const LoadedMast& m, const MastPlace& at) { return case_at(m, at).stations[at.station]; }

std::string place_words(const MastReport& report, const MastPlace& at) {
  const LoadedMast& m = report.loaded;
  return fmt::format("{} above its base, {}", report.display.brief(station_at(m, at).height, si::m),
                     case_at(m, at).words);
}

/// A limit of the strength of what the mast covers.
void limit_strength(const MastReport& report, const char* name, double value, const Unit& unit, Bound bound,
                    Result& r) {
  add_part_check(report.name, name, value, unit, std::move(bound), r);
  r.checks.back().covers = report.covers;
}

/// The use of a strength: passes at 1.
void limit_use(const MastReport& report, const char* name, double use, std::string rule, const char* trust, Result& r) {
  limit_strength(report, name, use, si::one,
                 {.sense = Sense::at_most, .limit = 1, .rule = std::move(rule), .trust = trust}, r);
}

void add_wall_check(const MastReport& report, const MastUse& u, Result& r) {
  if (u.slenderness.value == 0) return;  // pulled everywhere
  const structure::WallClass& wall = u.slenderest;
  add_part_check(report.name, "wall", wall.slenderness, si::one,
                 {.sense = Sense::at_most,
                  .limit = wall.slenderness / u.slenderness.value,
                  .rule = fmt::format("{} of the {} of {}, class {}: up to class 3, EN 1993-1-1, table 5.2",
                                      wall.wall == "tube" ? "D/t" : "c/t", wall.wall, u.slenderest_section, wall.value),
                  .trust = recalled_section},
                 r);
}

/// Of a mast in a plane torsion is what rounding leaves.
bool counts_torsion(const MastUse& u) { return structure::counts_torsion(u.torsion.value); }

void add_section_checks(const MastReport& report, const MastUse& u, Result& r) {
  const LoadedMast& m = report.loaded;
  const auto& steel = m.mast.parts[u.section.at.part].member.steel;
  const int section_class =
      structure::section_class(steel.section, steel.yield, station_at(m, u.section.at).design).value;
  limit_use(report, "section", u.section.value,
            fmt::format("{} in one section ({}, class {}, f_y = {}), EN 1993-1-1, {}; {}",
                        counts_torsion(u) ? "N, M, V and torsion" : "N, M and V", steel.section.name, section_class,
                        report.display.brief(steel.yield, si::Pa), section_class < 3 ? "6.2.9.1" : "(6.42)",
                        place_words(report, u.section.at)),
            recalled_section, r);
  limit_use(report, "shear", u.shear.value,
            fmt::format("V over V_pl,T, EN 1993-1-1, (6.18), (6.28); {}", place_words(report, u.shear.at)),
            "UNVERIFIED: shear areas as recalled", r);
  if (!counts_torsion(u)) return;
  const auto& twisted = m.mast.parts[u.torsion.at.part].member.steel;
  limit_use(report, "torsion", u.torsion.value,
            fmt::format("T over T_Rd = W_t f_y/(sqrt(3) gamma_M0) of {}, EN 1993-1-1, (6.23); {}", twisted.section.name,
                        place_words(report, u.torsion.at)),
            "derived", r);
}

bool asks_for_members(const LoadedMast& m) {
  return std::any_of(m.cases.begin(), m.cases.end(), [](const structure::MastCase& c) { return c.members; });
}

void add_member_checks(const MastReport& report, const MastUse& u, Result& r) {
  if (!u.pressed) return;
  const LoadedMast& m = report.loaded;
  const auto curve = [&](const MastPlace& at) {
    const auto& member = m.mast.parts[at.part].member;
    return to_text(member.curve.value_or(structure::curve_of(member.steel.section, member.steel.yield)));
  };
  limit_use(report, "buckling", u.flexural.value,
            fmt::format("N over chi A f_y/gamma_M1, curve {}, EN 1993-1-1, (6.46); {}", curve(u.flexural.at),
                        case_at(m, u.flexural.at).words),
            recalled_curve, r);
  if (!asks_for_members(m)) return;
  limit_use(report, "member", u.member.value,
            fmt::format("N and M of the member, curve {}, EN 1993-1-1, (6.61), (6.62) by annex B; {}",
                        curve(u.member.at), case_at(m, u.member.at).words),
            recalled_curve, r);
}

/// [sigma] of the deck, or as good as the yield stress that it is a share of.
std::string trust_of_stress(const MastCheckRequest& request, const MastReport& report, std::size_t part) {
  const std::string& yield = report.materials[std::min(part, report.materials.size() - 1)].trust;
  return request.safety && is_unverified(yield) ? yield : std::string("user");
}

void add_stress_check(const MastCheckRequest& request, const MastReport& report, const MastUse& u, Result& r) {
  if (u.stress_use.value == 0) return;
  const LoadedMast& m = report.loaded;
  const MastPlace& at = u.stress_use.at;
  const double allowed = *m.mast.parts[at.part].allowable_stress;
  limit_strength(
      report, "allowable_stress", u.stress_use.value * allowed, si::Pa,
      {.sense = Sense::at_most,
       .limit = allowed,
       .rule = fmt::format("N/A + M/W{} <= [sigma] without other factors, Shoshin et al. 2022, (12)-(14); {}",
                           counts_torsion(u) ? ", with torsion sqrt(sigma^2 + 3 tau^2)," : "", place_words(report, at)),
       .trust = trust_of_stress(request, report, at.part)},
      r);
}

/// A mast at its worst section.
struct MastRow {
  const MastReport& report;
  const MastUse& use;
  const MastStation& station() const { return station_at(report.loaded, use.section.at); }
  const structure::Member& member() const { return report.loaded.mast.parts[use.section.at.part].member; }
};

double class_of(const MastRow& row) {
  const auto& steel = row.member().steel;
  return static_cast<double>(structure::section_class(steel.section, steel.yield, row.station().design).value);
}

const Quantities<MastRow>& mast_quantities() {
  using Row = MastRow;
  const auto force = [](double structure::CrossForces::*part) {
    return [part](const Row& r) { return r.station().design.*part; };
  };
  static const Quantities<Row> all = {
      {"name", "", si::one, "the mast", [](const Row& r) { return r.report.name; }},
      {"section", "", si::one, "its cross-section there", [](const Row& r) { return r.member().steel.section.name; }},
      {"class", "", si::one, "class of that cross-section, EN 1993-1-1, table 5.2", class_of},
      {"f_y", "f_y", si::Pa, "yield strength of its wall", [](const Row& r) { return r.member().steel.yield; }},
      {"height", "", si::m, "height of that cross-section above the base",
       [](const Row& r) { return r.station().height; }},
      {"N", "N", si::N, "axial design force there, compression positive", force(&structure::CrossForces::N)},
      {"M_y", "M_y", si::N_m, "design moment about the strong axis", force(&structure::CrossForces::M_y)},
      {"M_z", "M_z", si::N_m, "design moment about the weak axis", force(&structure::CrossForces::M_z)},
      {"V", "V", si::N, "design shear force, resultant of both axes",
       [](const Row& r) { return std::hypot(r.station().design.V_y, r.station().design.V_z); }},
      {"section_use", "", si::one, "utilisation of the cross-section by N, M, V and torsion, EN 1993-1-1, 6.2",
       [](const Row& r) { return r.use.section.value; }},
      {"buckling", "", si::one, "utilisation by flexural buckling, (6.46); empty: not pressed",
       [](const Row& r) { return r.use.pressed ? r.use.flexural.value : none; }},
      {"member", "", si::one, "utilisation of the member by N and M, (6.61), (6.62); empty: not pressed",
       [](const Row& r) { return r.use.pressed && asks_for_members(r.report.loaded) ? r.use.member.value : none; }},
      {"stress", "sigma", si::Pa, "largest |N|/A + M/W (with torsion by von Mises) anywhere, without factors",
       [](const Row& r) { return r.use.stress.value; }},
      {"case", "", si::one, "load case of the worst cross-section",
       [](const Row& r) { return case_at(r.report.loaded, r.use.section.at).words; }}};
  return all;
}

void add_row(const MastReport& report, const MastUse& u, Result& r) {
  add_line(r, "masts", "Masts at their worst section (design forces, N: compression positive) and as members",
           mast_quantities(), MastRow{.report = report, .use = u});
}

/// Along the height, of all cases: how far the sections are used by both routes.
void add_profile(const MastReport& report, Result& r) {
  Plot plot{.name = fmt::format("{}_profile", report.name),
            .title = fmt::format("How far the sections of {} are used along its height", report.name),
            .caption = "The largest over all cases.",
            .x = {.label = "use of the section", .unit = si::one},
            .y = {.label = "height above the base", .unit = si::m},
            .curves = {},
            .marks = {}};
  struct At {
    double height;
    std::size_t part;
    double ec3, sigma;
  };
  std::vector<At> points;
  const auto& parts = report.loaded.mast.parts;
  for (const auto& c : report.loaded.cases) {
    for (const MastStation& s : c.stations) {
      Sheet<double> plain;
      const auto& part = parts[s.part];
      const double ec3 = structure::cross_section(part.member.steel, s.design, plain).worst();
      const double stress = structure::elastic_stress(part.member.steel.section, s.service);
      const double sigma = part.allowable_stress ? stress / *part.allowable_stress : std::nan("");
      const auto known = std::find_if(points.begin(), points.end(), [&](const At& p) {
        return p.part == s.part && std::abs(p.height - s.height) < same_place;
      });
      if (known == points.end()) {
        points.push_back({s.height, s.part, ec3, sigma});
      } else {
        known->ec3 = std::max(known->ec3, ec3);
        known->sigma = std::max(known->sigma, sigma);
      }
    }
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const At& a, const At& b) { return a.part != b.part ? a.part < b.part : a.height < b.height; });
  Curve ec3{.label = "EN 1993-1-1, N + M + V", .x = {}, .y = {}},
      sigma{.label = "N/A + M/W over [sigma]", .x = {}, .y = {}, .dashed = true};
  for (const At& p : points) {
    ec3.x.push_back(p.ec3);
    ec3.y.push_back(p.height);
    sigma.x.push_back(p.sigma);
    sigma.y.push_back(p.height);
  }
  plot.curves.push_back(std::move(ec3));
  if (!std::isnan(points.front().sigma)) plot.curves.push_back(std::move(sigma));
  r.figures.emplace_back(std::move(plot));
}

void write_mast(const MastCheckRequest& request, const MastReport& report, const MastUse& u, Result& r) {
  Sheet<Num> s("EN 1993-1-1", MastCheckRequest::describe(), &request);
  const LoadedMast& m = report.loaded;
  const auto& steel = m.mast.parts[u.section.at.part].member.steel;
  s.section(fmt::format("{}: its worst section, {}", report.name, place_words(report, u.section.at)));
  const auto& design = station_at(m, u.section.at).design;
  write_class(steel.section, steel.yield, design, s);
  cross_section(steel, design, s);
  if (u.pressed && asks_for_members(m)) {
    s.section(fmt::format("{}: the member, {}", report.name, case_at(m, u.member.at).words));
    const auto& c = case_at(m, u.member.at);
    member_use(member_in(m.mast, c, u.member.at.part), member_forces(m.mast, c, u.member.at.part), s);
  }
  s.move_to(r);
}

}  // namespace

std::optional<structure::Curve> curve_of(const MastCheckRequest& request) {
  if (request.curve == MastCurve::by_section) return std::nullopt;
  return static_cast<structure::Curve>(static_cast<int>(request.curve) - 1);
}

std::optional<MastMaterial> mast_material(const MastCheckRequest& request, const catalogue::SectionRow& row,
                                          const std::string& steel) {
  const auto found = catalogue::find_steel(steel);
  if (!found) return std::nullopt;
  const auto yield = catalogue::yield(*found, row.thickness);
  if (!yield) return std::nullopt;
  MastMaterial m;
  m.section = structure::with_thinner_wall(row, request.wall_tolerance);
  m.yield = *yield;
  m.allowable_stress = request.allowable_stress;
  if (request.safety) m.allowable_stress = *yield / *request.safety;
  m.steel = full_name(*found);
  m.trust = catalogue::trust_words(*found);
  return m;
}

tl::expected<MastMaterial, Complaint> mast_material(const MastCheckRequest& request, const std::string& section,
                                                    const std::string& steel, const std::string& path) {
  const auto row = catalogue::find_section(section);
  if (!row) return tl::unexpected(Complaint{.path = path + ".section", .message = to_text(row.error())});
  const auto found = catalogue::find_steel(steel);
  if (!found) return tl::unexpected(Complaint{.path = path + ".steel", .message = to_text(found.error())});
  const auto yield = catalogue::yield(*found, row->thickness);
  if (!yield) return tl::unexpected(Complaint{.path = path + ".steel", .message = to_text(yield.error())});
  return *mast_material(request, *row, steel);
}

namespace {

/// Of a mast whose own weight counts: with which factors.
std::string weight_words(const MastCheckRequest& request) {
  if (request.combinations.empty()) return fmt::format("own weight times {:.4g}", request.load_factor);
  std::vector<std::string> each;
  each.reserve(request.combinations.size());
  for (const MastCombinationRequest& c : request.combinations) {
    each.push_back(fmt::format("{:.4g} ({})", weight_factor(c.terms), c.name));
  }
  return fmt::format("own weight times {}", fmt::join(each, ", "));
}

}  // namespace

std::string factor_words(const MastCheckRequest& request, const MastReport& report) {
  std::string words = fmt::format("{}: ", report.name);
  if (request.combinations.empty()) {
    words += request.load_factor == 1
                 ? "EN 1993-1-1 with forces without partial factor (gamma_F = 1)"
                 : fmt::format("EN 1993-1-1 with forces times gamma_F = {:.4g}", request.load_factor);
  } else {
    words += "EN 1993-1-1 with forces times the partial factors of 'combinations'";
  }
  if (request.own_weight) words += fmt::format(", {} without dynamic factor", weight_words(request));
  words += fmt::format(", dynamic factor {:.4g}, strength over gamma_M0 = {:.4g}, gamma_M1 = {:.4g}",
                       request.dynamic_factor, request.gamma_M0, request.gamma_M1);
  if (request.wall_tolerance > 0) words += fmt::format(", walls {:.3g} % thinner", request.wall_tolerance * 100);
  const MastMaterial& first = report.materials.front();
  if (first.allowable_stress) {
    words += fmt::format(
        "; by [sigma] = {} forces have no factor, bending is elastic, and f_y/[sigma] = {:.4g} stands for all "
        "factors, buckling and dynamics together",
        report.display.brief(*first.allowable_stress, si::Pa), first.yield / *first.allowable_stress);
  }
  return words + ".";
}

TableWords mast_words() {
  return {.name = "masts", .rows = "every mast of `checks: masts:`", .columns = words_of(mast_quantities())};
}

/// Loads that count with less than they are, wherever they count.
void warn_of_small_factors(const MastCheckRequest& request, const MastReport& report, Result& r) {
  std::map<std::string, double> largest;  // by load case
  for (const MastCombinationRequest& c : request.combinations) {
    for (const MastTerm& t : c.terms) {
      double& one = largest[t.name];
      one = std::max(one, t.factor);
    }
  }
  const auto warn = [&](double factor, const std::string& of, const char* key) {
    if (factor * request.dynamic_factor >= 1) return;
    warn_unsafe(
        r, fmt::format("{}: {} count with a factor of {:.4g}, less than they are: give '{}' of 1 or more", report.name,
                       of.empty() ? "its forces" : "the forces of '" + of + "'", factor * request.dynamic_factor, key));
  };
  if (request.combinations.empty()) warn(request.load_factor, "", "load_factor");
  for (const auto& [name, factor] : largest) warn(factor, name, "combinations");
}

void add_mast_report(const MastCheckRequest& request, const MastReport& report, Result& r) {
  if (!report.materials.empty()) r.assumptions.push_back(factor_words(request, report));
  r.assumptions.insert(r.assumptions.end(), report.words.begin(), report.words.end());
  for (const std::string& analysis : report.left_out) {
    r.unjudged.push_back(fmt::format("{0} in '{1}', which none of its combinations names: add {{{1}: its factor}}",
                                     report.name, analysis));
  }
  if (!report.apart.empty()) {
    r.unmade.push_back(fmt::format("{}: {}", report.name, report.apart));
    r.warnings.push_back(r.unmade.back());
  }
  if (!report.relieved.empty()) r.warnings.push_back(fmt::format("{}: {}", report.name, report.relieved));
  warn_of_small_factors(request, report, r);
  if (!report.swings.empty()) warn_unsafe(r, fmt::format("{}: {}", report.name, report.swings));
  if (!report.short_length.empty()) warn_unsafe(r, fmt::format("{}: {}", report.name, report.short_length));
  const bool factored = request.load_factor != 1 || !request.combinations.empty();
  if (!factored) {
    r.warnings.push_back(
        fmt::format("{} is checked with forces as they are: give 'load_factor' or 'combinations' "
                    "for a check by EN 1993-1-1 that stands by itself",
                    report.name));
  }
  if (!report.refused.empty()) {
    r.warnings.push_back(fmt::format("{}: {}", report.name, report.refused));
    if (report.unseen) {
      r.unmade.push_back(r.warnings.back());
    } else {
      limit_use(report, "section", std::nan(""), report.refused, "derived", r);
    }
    add_mast_choice(request, report, r);
    return;
  }
  const MastUse u = mast_use(report.loaded.mast, report.loaded.cases);
  add_wall_check(report, u, r);
  if (u.refused.empty()) {
    add_section_checks(report, u, r);
    add_member_checks(report, u, r);
  } else {
    r.warnings.push_back(fmt::format("{}: {}", report.name, u.refused));
  }
  add_stress_check(request, report, u, r);
  for (const MastMaterial& one : report.materials) {
    if (!is_unverified(one.trust)) continue;
    r.warnings.push_back(fmt::format("{}: f_y of {} is {}", report.name, one.steel, one.trust));
    break;
  }
  const auto value = [&](const char* name, double v) {
    const ValueKind& kind = named(value_kinds(), name);
    r.values.push_back(make_value(kind, report.name, "", v, fmt::format("{} of {}", kind.about.words, report.name)));
  };
  if (u.refused.empty()) {
    value("MAST.utilisation",
          std::max({u.section.value, u.shear.value, u.torsion.value, u.flexural.value, u.member.value}));
    add_row(report, u, r);
    add_profile(report, r);
    write_mast(request, report, u, r);
  }
  value("MAST.service_stress", u.stress.value);
  add_mast_choice(request, report, r);
}

}  // namespace taut::checks
