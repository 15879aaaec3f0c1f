#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "taut/base/suggest.hpp"
#include "taut/calc/shown.hpp"
#include "taut/catalogue/section_search.hpp"
#include "taut/checks/mast/mast_checks.hpp"

namespace taut::checks {
namespace {

using structure::ColumnMast;
using structure::MastCombination;

/// The pieces of the request; a mast of one section is one piece.
std::vector<MastPieceRequest> pieces_of(const MastCheckRequest& request) {
  if (!request.pieces.empty()) return request.pieces;
  return {{.length = request.height.value_or(1), .section = request.section.value_or(""), .top = {}}};
}

double height_of(const MastCheckRequest& request) {
  double h = 0;
  for (const MastPieceRequest& p : pieces_of(request)) h += p.length;
  return h;
}

std::vector<std::string> cases_of(const std::vector<MastLoadRequest>& loads) {
  std::vector<std::string> names;
  for (const MastLoadRequest& l : loads) {
    if (std::find(names.begin(), names.end(), l.load_case) == names.end()) names.push_back(l.load_case);
  }
  return names;
}

using LoadsByCase = std::map<std::string, std::vector<const MastLoadRequest*>, std::less<>>;

/// One combination: loads of its cases with their factors, its own weight with its own. The dynamic factor is of what
/// moves: not of the weight.
MastCombination combination(const MastCheckRequest& request, const LoadsByCase& loads, const std::string& words,
                            const std::vector<MastTerm>& terms) {
  MastCombination c;
  c.words = words;
  c.weight_factor = weight_factor(terms);
  const double height = height_of(request);
  for (const MastTerm& term : terms) {
    const auto own = loads.find(term.name);
    if (own == loads.end()) continue;
    for (const MastLoadRequest* load : own->second) {
      const MastLoadRequest& l = *load;
      c.loads.push_back({l.at.value_or(height), l.down, l.across, l.sideways, l.moment, l.sideways_moment, l.torsion});
      c.factors.push_back(term.factor * request.dynamic_factor);
    }
  }
  return c;
}

std::vector<MastCombination> combinations_of(const MastCheckRequest& request,
                                             const std::vector<MastLoadRequest>& loads) {
  LoadsByCase by_case;
  for (const MastLoadRequest& l : loads) by_case[l.load_case].push_back(&l);
  std::vector<MastCombination> all;
  all.reserve(request.combinations.size());
  for (const MastCombinationRequest& one : request.combinations) {
    all.push_back(combination(request, by_case, one.name, one.terms));
  }
  if (!all.empty()) return all;
  for (const std::string& name : cases_of(loads)) {
    all.push_back(combination(request, by_case, name, {{.name = name, .factor = request.load_factor}}));
  }
  return all;
}

ColumnMast own_column(const MastCheckRequest& request, const std::vector<MastLoadRequest>& loads, double gravity) {
  ColumnMast m;
  m.gravity = gravity;
  m.clamped_base = request.base != MastBase::hinge;
  m.top_stiffness = request.top_stiffness;
  m.own_weight = request.own_weight;
  m.gamma = {.M0 = request.gamma_M0, .M1 = request.gamma_M1};
  m.curve = curve_of(request);
  m.sway = request.sway;
  m.bow = request.bow;
  m.C_m = request.C_m;
  m.combinations = combinations_of(request, loads);
  return m;
}

/// Whether the loads of a combination, without its own weight, pull the mast at some height.
bool pulls(const MastCombination& c) {
  for (const structure::MastLoad& at : c.loads) {
    double N = 0;
    for (std::size_t i = 0; i < c.loads.size(); ++i) {
      if (c.loads[i].height >= at.height) N += c.factors[i] * c.loads[i].down;
    }
    if (N < 0) return true;
  }
  return false;
}

/// Of two combinations: the same loads with the same factors.
bool same_loads(const MastCombination& a, const MastCombination& b) {
  if (a.factors != b.factors) return false;
  for (std::size_t i = 0; i < a.loads.size(); ++i) {
    if (a.loads[i].height != b.loads[i].height || a.loads[i].down != b.loads[i].down) return false;
  }
  return true;
}

/// Where loads pull, the weight relieves: a factor above 1 on it is then on the unsafe side, EN 1990, table A1.2 (B).
std::string relieved(const ColumnMast& m) {
  if (!m.own_weight) return {};
  for (const MastCombination& c : m.combinations) {
    if (c.weight_factor <= 1 || !pulls(c)) continue;
    const bool also_light =
        std::any_of(m.combinations.begin(), m.combinations.end(),
                    [&](const MastCombination& other) { return other.weight_factor <= 1 && same_loads(c, other); });
    if (also_light) continue;
    return fmt::format(
        "the loads of '{}' pull it, where its weight relieves, and that counts {:.4g} times: add a "
        "combination with 'own_weight' of at most 1",
        c.words, c.weight_factor);
  }
  return {};
}

/// The longest buckling length of the column over its cases: of the part that is pressed most, about the axis about
/// which it is longer. It takes the critical force of the column there.
struct BucklingLength {
  double length = 0;  ///< m; 0: nothing is pressed
  std::string where;
};
BucklingLength buckling_length_of(const structure::ColumnMastResult& solved) {
  BucklingLength longest;
  for (const structure::MastCase& c : solved.cases) {
    const auto most = std::max_element(c.critical_force.begin(), c.critical_force.end(),
                                       [](const auto& a, const auto& b) { return a.z < b.z; });
    if (most == c.critical_force.end() || most->z <= 0) continue;
    const structure::SteelSection& steel =
        solved.mast.parts[static_cast<std::size_t>(most - c.critical_force.begin())].member.steel;
    for (const double length : {structure::buckling_length(steel.E * steel.section.I_y, 1, most->y),
                                structure::buckling_length(steel.E * steel.section.I_z, 1, most->z)}) {
      if (length > longest.length) longest = {.length = length, .where = c.words};
    }
  }
  return longest;
}

/// What is wrong with the buckling length of the deck; else empty.
std::string short_length(const MastCheckRequest& request, const structure::ColumnMastResult& solved,
                         const Display& display) {
  if (!request.buckling_length) return {};
  const BucklingLength own = buckling_length_of(solved);
  if (as_rounded * own.length <= *request.buckling_length) return {};
  const auto [given, length] = brief_apart(*request.buckling_length, own.length, si::m, display);
  return fmt::format(
      "'buckling_length' of {} is shorter than that of the mast with its 'base' and 'top_stiffness', {} ({}); leave "
      "'buckling_length' out, or describe what holds the mast",
      given, length, own.where);
}

void use_length(const MastCheckRequest& request, structure::LoadedMast& m) {
  if (!request.buckling_length) return;
  for (auto& part : m.mast.parts) part.member.y.length = part.member.z.length = request.buckling_length;
  for (auto& c : m.cases) c.critical_force.clear();
}

/// The mast and its cases, with the buckling length of the deck where it gives one.
structure::LoadedMast loaded_of(const MastCheckRequest& request, structure::ColumnMastResult& solved) {
  structure::LoadedMast loaded{.mast = std::move(solved.mast), .cases = std::move(solved.cases)};
  use_length(request, loaded);
  return loaded;
}

/// Empty where it buckles.
std::optional<structure::LoadedMast> loaded_in(const MastCheckRequest& request, const ColumnMast& column) {
  structure::ColumnMastResult solved = column_mast(column);
  if (!solved.refused.empty()) return std::nullopt;
  return loaded_of(request, solved);
}

constexpr std::size_t shown_together = 500;  ///< combinations; a path with its steps has less, a motion may have more

/// A number that is worse the larger it is, and the first combination that has the largest.
struct Deciding {
  double value = -std::numeric_limits<double>::infinity();
  std::size_t combination = 0;
};

/// Of more than 500 combinations those that decide: each is the worst in one of the checks, or in one of the numbers of
/// the report. Every combination is solved and checked by itself. A choice by its loads would not do, nor would their
/// convex hull: the interaction (6.61) bounds a region of N and M that is not convex, and the critical load has its own
/// places of N in each combination.
std::vector<MastCombination> deciding(const MastCheckRequest& request, const ColumnMast& column) {
  if (column.combinations.size() <= shown_together) return column.combinations;
  ColumnMast one = column;
  std::vector<Deciding> worst;
  for (std::size_t i = 0; i < column.combinations.size(); ++i) {
    one.combinations = {column.combinations[i]};
    structure::ColumnMastResult solved = column_mast(one);
    if (!solved.refused.empty()) return one.combinations;
    const double longest = buckling_length_of(solved).length;
    const structure::LoadedMast loaded = loaded_of(request, solved);
    const structure::MastUse u = mast_use(loaded.mast, loaded.cases);
    const std::array numbers = {u.slenderness.value,
                                u.section.value,
                                u.shear.value,
                                u.torsion.value,
                                u.flexural.value,
                                u.member.value,
                                u.stress.value,
                                u.stress_use.value,
                                solved.bow,
                                solved.sway,
                                solved.top_displacement,
                                -solved.critical_factor,
                                longest};
    worst.resize(numbers.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (numbers.at(k) > worst[k].value) worst[k] = {.value = numbers.at(k), .combination = i};
    }
  }
  std::set<std::size_t> kept;
  for (const Deciding& d : worst) kept.insert(d.combination);
  std::vector<MastCombination> all;
  all.reserve(kept.size());
  for (const std::size_t i : kept) all.push_back(column.combinations[i]);
  return all;
}

/// A piece of a mast, and what its lower end is made of.
struct FoundPiece {
  structure::MastPiece piece;
  MastMaterial material;
};

/// The piece with its sections and steel found, or what is wrong with it, at `path` and below.
tl::expected<FoundPiece, Complaint> piece_of(const MastCheckRequest& request, const MastPieceRequest& given,
                                             const std::string& path) {
  const std::string steel = request.steel.value_or("");
  const auto low = mast_material(request, given.section, steel, path);
  if (!low) return tl::unexpected(low.error());
  FoundPiece found{.piece = {.length = given.length,
                             .section = low->section,
                             .top = {},
                             .yield = low->yield,
                             .allowable_stress = low->allowable_stress},
                   .material = *low};
  if (!given.top) return found;
  const auto high = mast_material(request, *given.top, steel, path);
  if (!high) return tl::unexpected(Complaint{.path = path + ".top", .message = high.error().message});
  if (high->section.shape != low->section.shape || high->section.forming != low->section.forming) {
    return tl::unexpected(
        Complaint{.path = path + ".top",
                  .message = "a taper keeps shape and making: a tube ends as a tube, hot-finished as such"});
  }
  found.piece.top = high->section;
  found.piece.yield = std::min(found.piece.yield, high->yield);
  return found;
}

/// `known`: names of load cases and of `analyses`.
void complain_of_combination(const MastCombinationRequest& c, const std::string& at,
                             const std::vector<std::string>& known, const std::vector<std::string>& analyses,
                             std::vector<Complaint>& complaints) {
  if (c.terms.empty()) complaints.push_back({at, "has no load case: `{work: 1.5}`"});
  const auto of_machine = std::count_if(c.terms.begin(), c.terms.end(), [&](const MastTerm& t) {
    return std::find(analyses.begin(), analyses.end(), t.name) != analyses.end();
  });
  if (of_machine > 1) {
    complaints.push_back({at,
                          "takes one analysis: the machine is in one state at a time; put the loads that come "
                          "together into one analysis"});
  }
  for (const MastTerm& t : c.terms) {
    if (std::find(known.begin(), known.end(), t.name) != known.end()) continue;
    complaints.push_back({fmt::format("{}.{}", at, t.name),
                          t.name == weight_term
                              ? std::string("is the weight of the mast, which needs 'own_weight: true'")
                              : fmt::format("no load{} is of case '{}'{}", analyses.empty() ? "" : " or analysis",
                                            t.name, did_you_mean(t.name, known))});
  }
}

void complain_of_loads(const MastCheckRequest& request, const std::string& path, double height,
                       const std::vector<std::string>& analyses, std::vector<Complaint>& complaints) {
  for (std::size_t i = 0; i < request.loads.size(); ++i) {
    const MastLoadRequest& l = request.loads[i];
    if (l.at && *l.at > height * (1 + 1e-9)) {
      complaints.push_back(
          {fmt::format("{}.loads[{}].at", path, i), fmt::format("is above the top of the mast at {:.6g} m", height)});
    }
  }
  std::vector<std::string> known = cases_of(request.loads);
  if (request.own_weight) {
    const auto refuse = [&](const std::vector<std::string>& names, const char* key, const char* what) {
      if (std::find(names.begin(), names.end(), weight_term) == names.end()) return;
      complaints.push_back(
          {path + key, fmt::format("'{}' is the weight of the mast: give the {} another name", weight_term, what)});
    };
    refuse(known, ".loads", "load case");
    refuse(analyses, ".own_weight", "analysis");
    known.emplace_back(weight_term);
  }
  known.insert(known.end(), analyses.begin(), analyses.end());
  for (const MastCombinationRequest& c : request.combinations) {
    complain_of_combination(c, fmt::format("{}.combinations.{}", path, c.name), known, analyses, complaints);
  }
}

}  // namespace

namespace {

void complain_of_place(const MastCheckRequest& request, const std::string& path, std::vector<Complaint>& complaints) {
  const char* const words = "belongs to a mast that 'carries' something";
  if (!request.foot.empty()) complaints.push_back({path + ".foot", words});
  if (!request.towards.empty()) complaints.push_back({path + ".towards", words});
}

}  // namespace

void complain_of_own_mast(const MastCheckRequest& request, const std::string& path, LoadsOf loads,
                          const std::vector<std::string>& analyses, std::vector<Complaint>& complaints) {
  const std::size_t before = complaints.size();
  if (!request.steel) complaints.push_back({path, "needs 'steel', such as S355 (taut list steels)"});
  if (request.pieces.empty() && !request.section) complaints.push_back({path, "needs 'section' or 'pieces'"});
  if (!request.pieces.empty() && request.section) {
    complaints.push_back({path + ".section", "either 'section' with 'height', or 'pieces'"});
  }
  if (!request.pieces.empty() && request.height) {
    complaints.push_back({path + ".height", "the pieces have their lengths already"});
  }
  if (request.pieces.empty() && !request.height && loads != LoadsOf::method) {
    complaints.push_back({path, "needs 'height'"});
  }
  if (request.loads.empty() && loads == LoadsOf::deck) {
    complaints.push_back({path, "is no beam of a machine: give its 'loads', or what of the machine it 'carries'"});
  }
  if (loads != LoadsOf::machine) complain_of_place(request, path, complaints);
  if (request.allowable_stress && request.safety) {
    complaints.push_back({path + ".safety", "either 'allowable_stress' or 'safety'"});
  }
  if (complaints.size() > before) return;
  const std::vector<MastPieceRequest> pieces = pieces_of(request);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::string at = request.pieces.empty() ? path : fmt::format("{}.pieces[{}]", path, i);
    const auto found = piece_of(request, pieces[i], at);
    if (found) continue;
    // the steel is that of all pieces
    complaints.push_back(
        {found.error().path == at + ".steel" ? path + ".steel" : found.error().path, found.error().message});
  }
  complain_of_loads(request, path, height_of(request), analyses, complaints);
  refuse_both_factors(request, path, complaints);
}

namespace {

/// What of the loads is not checked, or not together.
void add_cases(const MastCheckRequest& request, const std::vector<MastLoadRequest>& loads, MastReport& report) {
  const std::vector<std::string> cases = cases_of(loads);
  for (const std::string& name : cases) {
    const auto has = [&](const MastCombinationRequest& c) {
      return std::any_of(c.terms.begin(), c.terms.end(), [&](const MastTerm& t) { return t.name == name; });
    };
    const auto& all = request.combinations;
    if (!all.empty() && std::none_of(all.begin(), all.end(), has)) report.left_out.insert(name);
  }
  const std::vector<std::string> own = cases_of(request.loads);
  if (!request.combinations.empty() || own.size() < 2) return;
  report.apart =
      fmt::format("its load cases {} are checked one at a time: say under 'combinations' which of them act together",
                  fmt::join(own, ", "));
}

}  // namespace

void refuse_both_factors(const MastCheckRequest& request, const std::string& path, std::vector<Complaint>& complaints) {
  if (request.combinations.empty() || request.load_factor == 1) return;
  complaints.push_back(
      {path + ".load_factor", request.own_weight ? "'combinations' have the partial factors already, of the weight by "
                                                   "the name 'own_weight'"
                                                 : "'combinations' have the partial factors already"});
}

double weight_factor(const std::vector<MastTerm>& terms) {
  double largest = 0;
  for (const MastTerm& t : terms) {
    if (t.name == weight_term) return t.factor;
    largest = std::max(largest, t.factor);
  }
  return largest;
}

bool counts_put_up_in_all(const MastCheckRequest& request) {
  const auto names_it = [](const MastCombinationRequest& c) {
    return std::any_of(c.terms.begin(), c.terms.end(), [](const MastTerm& t) { return t.name == put_up_analysis; });
  };
  return std::none_of(request.combinations.begin(), request.combinations.end(), names_it);
}

MastReport own_mast(const MastCheckRequest& request, const std::vector<MastLoadRequest>& loads, double gravity,
                    const Display& display) {
  const auto millimetres = [&](double x) { return display.brief(x, si::m.in("mm")); };
  MastReport report;
  report.name = request.name;
  report.display = display;
  ColumnMast column = own_column(request, loads, gravity);
  for (const MastPieceRequest& given : pieces_of(request)) {
    FoundPiece found = piece_of(request, given, {}).value();  // complain_of_own_mast has seen them
    report.materials.push_back(std::move(found.material));
    column.pieces.push_back(std::move(found.piece));
  }
  report.relieved = relieved(column);
  add_cases(request, loads, report);
  ColumnMast shown = column;
  shown.combinations = deciding(request, column);
  structure::ColumnMastResult solved = column_mast(shown);
  report.refused = solved.refused;
  constexpr double small = 0.1;  // rad; a column of small rotations is then wrong by 0.5 %
  if (report.refused.empty() && !column.clamped_base && solved.top_displacement > small * height_of(request)) {
    report.refused = fmt::format(
        "it is not checked: on its hinge it turns so far that its top moves by {}, which is beyond small rotations; "
        "hold "
        "its top more stiffly",
        display.brief(solved.top_displacement, si::m));
    report.unseen = true;
  }
  report.short_length = short_length(request, solved, display);
  report.loaded = loaded_of(request, solved);
  constexpr double no_way = 1e-9;  // m: what rounding leaves of a top that is held
  const double top = std::abs(solved.top_displacement) < no_way ? 0 : solved.top_displacement;
  report.words.push_back(fmt::format(
      "{}: a column in its bent shape, {} below, its top {}; as built leaning by {:.4g}{}; largest displacement of its "
      "top {}, critical over present load {:.4g}. Members by moments of first order.",
      request.name, column.clamped_base ? "clamped" : "hinged",
      column.top_stiffness == 0          ? "free"
      : std::isinf(column.top_stiffness) ? "held"
                                         : "held elastically",
      solved.sway,
      solved.bow > 0      ? ", with a bow of " + millimetres(solved.bow)
      : !solved.pressed   ? std::string(", without a bow: it is pressed nowhere and has no buckling length")
      : request.bow == 0. ? std::string(", without a bow as given")
                          : std::string(", no bow needed by (5.8)"),
      millimetres(top), solved.critical_factor));
  if (request.pieces.empty()) {
    report.in_section = [request, column, shown = shown.combinations](
                            const catalogue::SectionRow& row) -> std::optional<structure::LoadedMast> {
      const auto m = mast_material(request, row, *request.steel);
      if (!m) return std::nullopt;
      ColumnMast other = column;
      other.pieces = {{.length = column.pieces.front().length,
                       .section = m->section,
                       .top = {},
                       .yield = m->yield,
                       .allowable_stress = m->allowable_stress}};
      // what decides for this section may be another combination than for the deck's; most fail by the same
      other.combinations = shown;
      std::optional<structure::LoadedMast> loaded = loaded_in(request, other);
      if (!loaded || shown.size() == column.combinations.size()) return loaded;
      if (mast_use(loaded->mast, loaded->cases).utilisation() > 1) return loaded;
      other.combinations = column.combinations;
      other.combinations = deciding(request, other);
      return loaded_in(request, other);
    };
  }
  return report;
}

}  // namespace taut::checks
