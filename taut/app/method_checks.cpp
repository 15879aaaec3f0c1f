#include "taut/app/method_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "taut/base/suggest.hpp"
#include "taut/calc/answers.hpp"
#include "taut/catalogue/rope_search.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/checks/checks.hpp"
#include "taut/checks/mast/mast_checks.hpp"
#include "taut/checks/rope/rope_life.hpp"
#include "taut/checks/rope/rope_rules.hpp"
#include "taut/rope/rope_check.hpp"
#include "taut/units/display.hpp"

namespace taut::app {
namespace {

rope::RopeUse named_use(const char* name) {
  rope::RopeUse use;
  use.name = name;
  use.rope.trust = catalogue::Trust::verified;  // of the deck's own numbers
  return use;
}

void raise_to(rope::RopeUse& use, const Result& r, const std::string& value) {
  const Value* v = r.find_value(value);
  if (v == nullptr || !(v->value > use.tension)) return;
  use.tension = v->value;
  use.where = v->label.empty() ? v->name : v->label;
}

void one_end(rope::RopeUse& use) { use.ends = {{.name = "an end", .tension = use.tension}}; }

/// The methods do not know the diameters of the sheaves that their ropes run over.
constexpr const char* sheaves = "its sheaves";

}  // namespace

std::vector<rope::RopeUse> ropes_of_mast(const mast_section::Input& in, const Result* /*r*/) {
  std::vector<rope::RopeUse> all = {named_use("skyline"), named_use("mainline")};
  all[0].tension = in.skyline_force;
  all[1].tension = in.mainline_force;
  for (rope::RopeUse& use : all) {
    use.unmeasured = {sheaves};
    use.where = "the deck's largest";
    one_end(use);
  }
  return all;
}

namespace {

/// A rope of the loop as the deck says it, by its name or by what it is chosen from.
rope::RopeUse rope_of_loop(const char* name, const std::optional<std::string>& row, const closed_loop::Input& in) {
  rope::RopeUse use = named_use(name);
  if (row) {
    if (const auto known = catalogue::find_rope_in_words(*row)) use.rope = *known;
  } else if (in.choose_ropes) {
    use.chosen = true;
    use.rope.construction = in.choose_ropes->construction.value_or("");
    use.rope.core = in.choose_ropes->core.value_or("");
    use.rope.grade = in.choose_ropes->grade;
  }
  use.own_factor = in.safety_factor;
  return use;
}

/// The rope chosen and its largest tension, from the result's table of ropes.
void take_rope_row(const Result& r, rope::RopeUse& use) {
  const Table* t = r.find_table("ropes");
  if (t == nullptr) return;
  for (std::size_t k = 0; k < t->rows.size(); ++k) {
    if (text_in(*t, k, "role") != use.name) continue;
    if (const auto row = catalogue::find_rope(text_in(*t, k, "designation"))) use.rope = *row;
    use.tension = number_in(*t, k, "largest_tension");
    use.where = text_in(*t, k, "where");
  }
}

}  // namespace

std::vector<rope::RopeUse> ropes_of_loop(const closed_loop::Input& in, const Result* r) {
  std::vector<rope::RopeUse> all = {rope_of_loop("return", in.return_rope, in),
                                    rope_of_loop("traction", in.traction_rope, in)};
  for (rope::RopeUse& use : all) use.unmeasured = {sheaves};
  if (r == nullptr) return all;
  for (rope::RopeUse& use : all) take_rope_row(*r, use);
  for (rope::RopeUse& use : all) one_end(use);
  return all;
}

std::vector<rope::RopeUse> ropes_of_drive(const friction_drive::Input& in, const Result* r) {
  rope::RopeUse use = named_use("rope");
  if (in.rope) {
    if (const auto row = catalogue::find_rope_in_words(*in.rope)) use.rope = *row;
  }
  if (in.rope_area) use.rope.area = *in.rope_area;
  if (r != nullptr) {
    for (const char* value : {"P_tight", "T_1", "T_1_no_slip", "T_tight_exact", "T_1_exact"}) raise_to(use, *r, value);
  }
  const auto bend = [&](const char* name, const std::optional<double>& radius, double wrap) {
    if (radius) {
      use.bends.push_back({.name = name,
                           .kind = rope::BendKind::sheave,
                           .diameter = 2 * *radius,
                           .tension = use.tension,
                           .wrap = wrap});
    } else {
      use.unmeasured.push_back(fmt::format("its {}", name));
    }
  };
  bend("driving sheave", in.sheave_radius, in.wrap);
  bend("idler", in.idler_radius, std::numbers::pi);  // about: it is far more than a touch
  return {use};
}

std::vector<rope::RopeUse> ropes_of_boom(const boom_ropes::Input& in, const Result* r) {
  std::vector<rope::RopeUse> all = {named_use("extension"), named_use("retraction")};
  for (rope::RopeUse& use : all) use.unmeasured = {sheaves};
  if (r == nullptr) return all;
  const boom_ropes::Rope ropes[] = {boom_ropes::Rope::extension, boom_ropes::Rope::retraction};
  for (std::size_t i = 0; i < all.size(); ++i) {
    boom_ropes::LargestTension most = boom_ropes::largest_tension(in, *r, ropes[i], Display());
    if (!std::isnan(most.tension)) {
      all[i].tension = most.tension;
      all[i].where = std::move(most.where);
    }
    one_end(all[i]);
  }
  return all;
}

namespace {

/// A rope that is chosen has the values of its row. Those that all candidates have alike may be said again.
void complain_of_chosen(const checks::RopeCheckRequest& one, const catalogue::RopeRow& alike, const std::string& path,
                        std::vector<Complaint>& complaints) {
  const auto refuse = [&](bool given, const char* key) {
    if (!given) return;
    complaints.push_back({fmt::format("{}.{}", path, key),
                          "the rope is chosen, and has the value of its row: leave this one out, ask for such a rope "
                          "where it is chosen, or name it in the input"});
  };
  refuse(one.rope.has_value(), "rope");
  refuse(one.breaking_force.has_value(), "breaking_force");
  refuse(one.diameter.has_value(), "diameter");
  refuse(one.area.has_value(), "area");
  refuse(one.grade.has_value() && !alike.grade, "grade");
  refuse(one.core.has_value() && alike.core.empty(), "core");
  refuse(one.construction.has_value() && alike.construction.empty(), "construction");
}

/// The safety factor that a method's input asks of a rope of which it has the weight alone, with the strength that
/// `checks` gives. It stands beside the limits of `checks`: both were asked.
/// By the breaking force of `checks`, and by the strength that the rope has at its temperature: the method knows a cold
/// one.
void judge_own_factor(const rope::RopeUse& use, const rope::RopeRules& rules, Result& r) {
  if (!use.own_factor || !(use.rope.breaking_force > 0)) return;
  const std::string part = use.name + " rope", name = fmt::format("safety factor of the {}", part);
  if (!rules.no_strength.empty()) {
    leave_unmade(r, fmt::format("{} is not checked: {}", name, rules.no_strength),
                 {.part = {.kind = PartKind::rope, .name = use.name}});
    return;
  }
  const double share = rope::heat_share(rules);
  const bool judged = std::any_of(r.checks.begin(), r.checks.end(), [&](const Check& c) { return c.name == name; });
  if (judged && share == 1) return;
  std::vector<Doubt> doubts;
  if (share < 1) rope::add_doubt(rules.heat_strength->trust, rules.heat_strength->rule, doubts);
  rope::add_doubt_of_rope(use.rope, doubts);
  const std::string strength =
      judged ? std::string("breaking force") : fmt::format("breaking force of 'checks: ropes: {}'", use.name);
  const std::string hot = share < 1 ? fmt::format(" x {:.3g} ({})", share, rules.heat_strength->rule) : std::string();
  Check c = make_check(name, share * use.rope.breaking_force / use.tension, si::one,
                       {.sense = Sense::at_least,
                        .limit = *use.own_factor,
                        .rule = fmt::format("{}{} / largest tension ({}) at least safety_factor of the deck's input",
                                            strength, hot, use.where),
                        .trust = rope::trust_with("user", doubts),
                        .doubts = doubts});
  c.part = use.name;
  c.covers = {use.name, part};
  c.where = use.where;
  r.checks.push_back(std::move(c));
  std::erase(r.unmade, closed_loop::unknown_strength(use.name));
}

}  // namespace

checks::AskedChecks resolve_checks(const checks::ChecksRequest& request, const std::vector<rope::RopeUse>& ropes,
                                   const std::string& method, std::vector<Complaint>& complaints) {
  checks::AskedChecks asked;
  std::vector<std::string> known;
  known.reserve(ropes.size());
  for (const rope::RopeUse& use : ropes) known.push_back(use.name);
  for (const checks::RopeCheckRequest& one : request.ropes) {
    const std::string path = fmt::format("checks.ropes.{}", one.name);
    const auto use = std::find_if(ropes.begin(), ropes.end(), [&](const auto& u) { return u.name == one.name; });
    if (use == ropes.end()) {
      complaints.push_back(
          {path, known.empty() ? "the method has no rope to check"
                               : fmt::format("the method has no rope '{}': {}", one.name, fmt::join(known, ", "))});
      continue;
    }
    const checks::AskedRules& rules = asked.ropes.emplace_back(checks::asked_rules(one, path, complaints));
    catalogue::RopeRow rope;
    // each candidate of a design has a row of its own, by which it is judged
    if (use->chosen && !use->rope.id.empty()) {
      checks::complain_of_candidates(one, path, complaints);
    } else {
      checks::complain_of_values(one, use->rope, path, complaints);
      if (use->chosen) complain_of_chosen(one, use->rope, path, complaints);
      rope = checks::with_request(use->rope, one);
      checks::complain_of_limits(one, rules, rope, path, complaints);
    }
    std::vector<std::string> rounds;
    for (const rope::Bend& bend : use->bends) rounds.push_back(bend.name);
    checks::complain_of_life(one, rope, rounds, path, complaints);
    if (!one.compensating.empty())
      complaints.push_back({path + ".compensating", "a published method has no such sheave: describe a machine"});
  }
  checks::complain_of_confirmed(request, complaints);
  checks::complain_of_method_masts(request.masts, method, complaints);
  const auto refuse = [&](const auto& all, const char* key) {
    if (!all.empty())
      complaints.push_back({fmt::format("checks.{}", key), "a published method has none: describe a machine"});
  };
  refuse(request.guys, "guys");
  refuse(request.anchors, "anchors");
  refuse(request.lines, "lines");
  refuse(request.supports, "supports");
  refuse(request.yarders, "yarders");
  if (!request.exempt.empty()) complaints.push_back({"checks.exempt", "a published method judges all its parts"});
  return asked;
}

void add_method_checks(const checks::ChecksRequest& request, const checks::AskedChecks& asked,
                       const std::vector<rope::RopeUse>& ropes, const Display& display, Result& r) {
  if (r.status != Status::ok) return;
  for (std::size_t k = 0; k < request.ropes.size(); ++k) {
    const checks::RopeCheckRequest& one = request.ropes[k];
    for (rope::RopeUse use : ropes) {
      if (use.name != one.name) continue;
      checks::put_request(one, use, r);
      checks::add_checks_of(one, asked.ropes.at(k), use, r);
      judge_own_factor(use, checks::rope_rules(one, asked.ropes.at(k), use.rope), r);
    }
  }
  checks::add_method_masts(request.masts, display, r);
  // a rope whose strength `checks` judges is judged
  for (const rope::RopeUse& use : ropes) {
    const bool judged = std::any_of(r.checks.begin(), r.checks.end(),
                                    [&](const Check& c) { return c.limits && c.name == use.name + ".safety_factor"; });
    if (!judged) continue;
    std::erase_if(r.unjudged, [&](const auto& part) { return part == use.name || part == use.name + " rope"; });
  }
  checks::finish_checks(request, r);
}

}  // namespace taut::app
