#include <fmt/format.h>

#include <cmath>

#include "taut/calc/answers.hpp"
#include "taut/calc/shown.hpp"
#include "taut/checks/mast/mast_checks.hpp"

namespace taut::checks {
namespace {

constexpr const char* methods_mast = "mast";  ///< as mast_section calls its part

double given_number(const Result& r, const char* key) {
  for (const Given& g : r.given) {
    if (g.key == key && g.numbers.size() == 1) return g.numbers.front();
  }
  return std::nan("");
}

/// The forces of `mast_section` on its two blocks, of every load case.
std::vector<MastLoadRequest> loads_of_mast_section(const Result& r, const Display& display) {
  const Table* cases = r.find_table("load_cases");
  if (cases == nullptr) return {};
  const double h_sky = given_number(r, "skyline_block_height");
  double h_main = given_number(r, "mainline_block_height");
  if (std::isnan(h_main)) h_main = h_sky;
  std::vector<MastLoadRequest> loads;
  for (std::size_t i = 0; i < cases->rows.size(); ++i) {
    const auto force = [&](const char* column) { return number_in(*cases, i, column); };
    const double x = force("x");
    MastLoadRequest sky;
    sky.load_case = fmt::format("{} {}{}", i + 1, text_in(*cases, i, "directions"),
                                std::isnan(x) ? std::string() : ", carriage at " + display.brief(x, si::m));
    MastLoadRequest main = sky;
    sky.at = h_sky, sky.down = force("sky_down"), sky.across = force("sky_across"), sky.sideways = force("sideways");
    main.at = h_main, main.down = force("main_down"), main.across = force("main_across");
    loads.insert(loads.end(), {sky, main});
  }
  return loads;
}

/// Whether the mast of `mast_section` is held by guys, which the resultants on its blocks do not show.
bool has_guys(const Result& r) { return r.find_table("guys") != nullptr; }

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

void add_method_masts(const std::vector<MastCheckRequest>& masts, const Display& display, Result& r) {
  if (r.status != Status::ok) return;
  for (const MastCheckRequest& one : masts) {
    if (!one.loads.empty()) {
      MastReport report = own_mast(one, one.loads, standard_gravity, display);
      if (one.name == methods_mast) report.covers = {methods_mast};
      add_mast_report(one, report, r);
      continue;
    }
    const std::vector<MastLoadRequest> loads = loads_of_mast_section(r, display);
    if (loads.empty()) continue;
    if (has_guys(r)) {
      r.unjudged.push_back(
          fmt::format("{} by 'checks: masts', without its guys: give its 'loads', or describe the mast "
                      "as a beam of a machine with its guys",
                      one.name));
      continue;
    }
    MastCheckRequest own = one;
    const double top = std::max(*loads[0].at, *loads[1].at);
    if (own.height && *own.height < top) {
      const auto [height, block] = brief_apart(*own.height, top, si::m, display);
      r.warnings.push_back(
          fmt::format("{}: its height of {} is less than that of its higher block: it is checked with {}", one.name,
                      height, block));
    }
    if (!own.height || *own.height < top) own.height = top;
    MastReport report = own_mast(own, loads, standard_gravity, display);
    report.covers = {methods_mast};
    report.words.push_back(
        fmt::format("{}: under the forces of the method on its blocks, each rope hauled in, paid out and at rest, at "
                    "every carriage position (table load_cases).",
                    one.name));
    add_mast_report(one, report, r);
  }
}

}  // namespace taut::checks
