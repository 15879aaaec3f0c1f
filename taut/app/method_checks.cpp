#include "taut/app/method_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "taut/base/suggest.hpp"
#include "taut/catalogue/rope_search.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/checks/checks.hpp"
#include "taut/checks/mast/mast_checks.hpp"
#include "taut/checks/rope/rope_life.hpp"
#include "taut/checks/rope/rope_rules.hpp"

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

double number_in(const Table& t, std::size_t row, const std::string& column) {
  for (std::size_t i = 0; i < t.columns.size(); ++i) {
    if (t.columns[i].name != column) continue;
    const auto* number = std::get_if<double>(&t.rows[row][i]);
    return number == nullptr ? 0 : *number;
  }
  return 0;
}

std::string text_in(const Table& t, std::size_t row, const std::string& column) {
  for (std::size_t i = 0; i < t.columns.size(); ++i) {
    if (t.columns[i].name != column) continue;
    const auto* text = std::get_if<std::string>(&t.rows[row][i]);
    return text == nullptr ? std::string{} : *text;
  }
  return {};
}

void one_end(rope::RopeUse& use) { use.ends = {{.name = "an end", .tension = use.tension}}; }

}  // namespace

std::vector<rope::RopeUse> ropes_of_mast(const mast_section::Input& in, const Result* /*r*/) {
  std::vector<rope::RopeUse> all = {named_use("skyline"), named_use("mainline")};
  all[0].tension = in.skyline_force;
  all[1].tension = in.mainline_force;
  for (rope::RopeUse& use : all) {
    use.where = "the deck's largest";
    one_end(use);
  }
  return all;
}

std::vector<rope::RopeUse> ropes_of_loop(const closed_loop::Input& in, const Result* r) {
  std::vector<rope::RopeUse> all = {named_use("return"), named_use("traction")};
  const std::optional<std::string>* const named[] = {&in.return_rope, &in.traction_rope};
  for (std::size_t i = 0; i < all.size(); ++i) {
    rope::RopeUse& use = all[i];
    if (*named[i]) {
      if (const auto row = catalogue::find_rope(**named[i])) use.rope = *row;
    } else if (in.choose_ropes) {
      use.rope.construction = in.choose_ropes->construction.value_or("");
      use.rope.core = in.choose_ropes->core.value_or("");
    }
    if (r == nullptr) continue;
    if (const Table* t = r->find_table("ropes")) {
      for (std::size_t k = 0; k < t->rows.size(); ++k) {
        if (text_in(*t, k, "role") != use.name) continue;
        if (const auto row = catalogue::find_rope(text_in(*t, k, "designation"))) use.rope = *row;
        use.tension = number_in(*t, k, "largest_tension");
        use.where = text_in(*t, k, "where");
      }
    }
    // by figures alone: the values of the worst position, exact where known
    const bool exact = r->find_value("T_lA_exact") != nullptr;
    const std::vector<std::string> places = i == 0 ? std::vector<std::string>{"T_uA", "T_U", "T_uB", "T_lB", "T_lLB"}
                                                   : std::vector<std::string>{"T_lA", "T_lLA"};
    const bool in_table = use.tension > 0;
    for (const std::string& place : places) {
      if (!in_table) raise_to(use, *r, exact ? place + "_exact" : place);
    }
    one_end(use);
  }
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
  if (in.sheave_radius) {
    use.bends.push_back({"driving sheave", rope::BendKind::sheave, 2 * *in.sheave_radius, use.tension, in.wrap, 1});
  }
  return {use};
}

std::vector<rope::RopeUse> ropes_of_boom(const boom_ropes::Input& /*in*/, const Result* r) {
  std::vector<rope::RopeUse> all = {named_use("extension"), named_use("retraction")};
  if (r == nullptr) return all;
  const char* const columns[] = {"S1", "S2"};
  for (std::size_t i = 0; i < all.size(); ++i) {
    raise_to(all[i], *r, fmt::format("{}_max", columns[i]));
    raise_to(all[i], *r, columns[i]);
    raise_to(all[i], *r, fmt::format("S{}0_set", i + 1));
    if (const Table* t = r->find_table("cases")) {
      for (std::size_t k = 0; k < t->rows.size(); ++k) {
        const double T = number_in(*t, k, columns[i]);
        if (!(T > all[i].tension)) continue;
        all[i].tension = T;
        all[i].where = "case " + text_in(*t, k, "name");
      }
    }
    one_end(all[i]);
  }
  return all;
}

std::vector<Complaint> method_check_complaints(const checks::ChecksRequest& request,
                                               const std::vector<rope::RopeUse>& ropes, const std::string& method) {
  std::vector<Complaint> complaints;
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
    const catalogue::RopeRow rope = checks::with_request(use->rope, one);
    checks::rope_rules(one, rope, path, complaints);
    checks::complain_of_life(one, rope, {}, path, complaints);
  }
  checks::complain_of_method_masts(request.masts, method, complaints);
  const auto refuse = [&](const auto& all, const char* key) {
    if (!all.empty())
      complaints.push_back({fmt::format("checks.{}", key), "a published method has none: describe a machine"});
  };
  refuse(request.guys, "guys");
  refuse(request.anchors, "anchors");
  refuse(request.lines, "lines");
  return complaints;
}

void add_method_checks(const checks::ChecksRequest& request, const std::vector<rope::RopeUse>& ropes, Result& r) {
  if (r.status != Status::ok) return;
  for (const checks::RopeCheckRequest& one : request.ropes) {
    for (rope::RopeUse use : ropes) {
      if (use.name != one.name) continue;
      use.rope = checks::with_request(std::move(use.rope), one);
      std::vector<Complaint> reported_before;
      checks::add_checks_of(one, use, checks::rope_rules(one, use.rope, {}, reported_before), r);
    }
  }
  checks::add_method_masts(request.masts, r);
  // a rope whose strength `checks` judges is judged
  for (const rope::RopeUse& use : ropes) {
    const bool judged = std::any_of(r.checks.begin(), r.checks.end(),
                                    [&](const Check& c) { return c.limits && c.name == use.name + ".safety_factor"; });
    if (judged)
      std::erase_if(r.unjudged, [&](const auto& part) { return part == use.name || part == use.name + " rope"; });
  }
  checks::finish_checks(request, r);
}

}  // namespace taut::app
