#include <fmt/format.h>

#include <cmath>

#include "taut/checks/mast/mast_checks.hpp"

namespace taut::checks {
namespace {

double given_number(const Result& r, const char* key) {
  for (const Given& g : r.given) {
    if (g.key == key && g.numbers.size() == 1) return g.numbers.front();
  }
  return std::nan("");
}

double value_in(const Result& r, const char* name) {
  const Value* v = r.find_value(name);
  return v == nullptr ? std::nan("") : v->value;
}

/// The resultants of `mast_section` on its two blocks, at the position that governs.
std::vector<MastLoadRequest> loads_of_mast_section(const Result& r) {
  const double h_sky = given_number(r, "skyline_block_height");
  double h_main = given_number(r, "mainline_block_height");
  if (std::isnan(h_main)) h_main = h_sky;
  std::vector<MastLoadRequest> loads;
  for (const auto& [R, gamma, h] :
       {std::tuple{"R_sky", "gamma_sky", h_sky}, std::tuple{"R_main", "gamma_main", h_main}}) {
    MastLoadRequest l;
    l.load_case = "mast_section";
    l.at = h;
    l.down = value_in(r, R) * std::sin(value_in(r, gamma));
    l.across = value_in(r, R) * std::cos(value_in(r, gamma));
    if (std::isnan(l.down + h)) return {};
    loads.push_back(l);
  }
  return loads;
}

bool takes_methods_loads(const MastCheckRequest& one, const std::string& method) {
  return one.loads.empty() && method == "mast_section";
}

}  // namespace

void complain_of_method_masts(const std::vector<MastCheckRequest>& masts, const std::string& method,
                              std::vector<Complaint>& complaints) {
  for (const MastCheckRequest& one : masts) {
    const std::string path = fmt::format("checks.masts.{}", one.name);
    if (!one.beams.empty()) complaints.push_back({path + ".beams", "a published method has no beams"});
    if (one.top_criterion) complaints.push_back({path + ".top_criterion", "is of the guys of a machine"});
    if (takes_methods_loads(one, method)) {
      if (!one.pieces.empty()) complaints.push_back({path + ".pieces", "with the method's own forces give 'section'"});
      if (!one.combinations.empty()) {
        complaints.push_back({path + ".combinations", "with the method's own forces give 'load_factor'"});
      }
    }
    if (!one.carries.empty()) complaints.push_back({path + ".carries", "is of a machine"});
    if (one.plate) complaints.push_back({path + ".plate", "is of the guys of a machine"});
    complain_of_own_mast(one, path, takes_methods_loads(one, method) ? LoadsOf::method : LoadsOf::deck, {}, complaints);
  }
}

void add_method_masts(const std::vector<MastCheckRequest>& masts, Result& r) {
  if (r.status != Status::ok) return;
  for (const MastCheckRequest& one : masts) {
    if (!one.loads.empty()) {
      add_mast_report(one, own_mast(one, one.loads), r);
      continue;
    }
    const std::vector<MastLoadRequest> loads = loads_of_mast_section(r);
    if (loads.empty()) continue;
    MastCheckRequest own = one;
    const double top = std::max(*loads[0].at, *loads[1].at);
    if (!own.height || *own.height < top) own.height = top;
    MastReport report = own_mast(own, loads);
    report.words.push_back(
        fmt::format("{}: under the resultants of the method on its blocks, at the position that governs the clamp; a "
                    "rope paid out under load bends the mast more (M_payout).",
                    one.name));
    add_mast_report(one, report, r);
  }
}

}  // namespace taut::checks
