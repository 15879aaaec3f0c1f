#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "taut/catalogue/construction.hpp"
#include "taut/catalogue/rope_words.hpp"
#include "taut/checks/rope/rope_rules.hpp"

/// What the deck says of a rope beside its row of the catalogue.
namespace taut::checks {
namespace {

constexpr double same_number = 1e-9;  // of two that are given, relative

/// Whether two names of constructions may be of one rope: rules go by the class.
bool may_be_one(const std::string& one, const std::string& other) {
  if (catalogue::matches_construction(one, other) || catalogue::matches_construction(other, one)) return true;
  const std::string group = catalogue::construction_class(one);
  return !group.empty() && group == catalogue::construction_class(other);
}

}  // namespace

catalogue::RopeRow with_request(catalogue::RopeRow rope, const RopeCheckRequest& request) {
  if (request.rope) {
    if (const auto row = catalogue::find_rope_in_words(*request.rope)) {
      const catalogue::RopeRow own = std::exchange(rope, *row);
      // what the machine says of its own rope counts
      if (own.breaking_force > 0) {
        rope.breaking_force = own.breaking_force;
        rope.trust = own.trust;
      }
      if (own.diameter > 0) rope.diameter = own.diameter;
      if (own.mass_per_length > 0) rope.mass_per_length = own.mass_per_length;
    }
  }
  if (request.breaking_force && rope.breaking_force == 0) {
    rope.breaking_force = *request.breaking_force;
    rope.trust = catalogue::Trust::verified;
  }
  if (rope.diameter == 0) rope.diameter = request.diameter.value_or(0);
  if (request.construction) {
    rope.construction = *request.construction;
    if (const auto parsed = catalogue::parse_construction(*request.construction); parsed && !parsed->core.empty()) {
      rope.core = parsed->core;
    }
  }
  if (request.core) rope.core = catalogue::parse_core(*request.core).value_or(*request.core);
  if (!rope.grade) rope.grade = request.grade;
  if (rope.area == 0) rope.area = request.area.value_or(0);
  return rope;
}

void complain_of_second(const std::optional<double>& given, double known, const std::string& path,
                        std::vector<Complaint>& complaints) {
  if (!given || known == 0 || std::abs(*given - known) <= same_number * known) return;
  complaints.push_back({path, "the rope has another value already: change it there, or leave this one out"});
}

void complain_of_values(const RopeCheckRequest& request, catalogue::RopeRow rope, const std::string& path,
                        std::vector<Complaint>& complaints) {
  const auto row = catalogue::find_rope_in_words(request.rope.value_or(""));
  if (row && rope.diameter > 0 && std::abs(rope.diameter - row->diameter) > same_number * rope.diameter) {
    complaints.push_back({path + ".rope", fmt::format("is a rope of {:.4g} mm, and that of the machine has {:.4g} mm",
                                                      row->diameter * 1e3, rope.diameter * 1e3)});
  }
  RopeCheckRequest named;
  named.rope = request.rope;
  rope = with_request(std::move(rope), named);
  if (request.core && !rope.core.empty() && catalogue::parse_core(*request.core).value_or(*request.core) != rope.core) {
    complaints.push_back({path + ".core", fmt::format("the rope has the core {}", rope.core)});
  }
  if (request.construction && !rope.construction.empty() && !may_be_one(*request.construction, rope.construction)) {
    complaints.push_back({path + ".construction", fmt::format("the rope has the construction {}", rope.construction)});
  }
  const auto named_core = catalogue::parse_construction(request.construction.value_or(""));
  const bool other_core = named_core && !named_core->core.empty() && !rope.core.empty();
  if (other_core && !request.core && named_core->core != rope.core) {
    complaints.push_back({path + ".construction", fmt::format("the rope has the core {}", rope.core)});
  }
  complain_of_second(request.breaking_force, rope.breaking_force, path + ".breaking_force", complaints);
  complain_of_second(request.diameter, rope.diameter, path + ".diameter", complaints);
  complain_of_second(request.area, rope.area, path + ".area", complaints);
  complain_of_second(request.grade, rope.grade.value_or(0), path + ".grade", complaints);
}

void complain_of_candidates(const RopeCheckRequest& request, const std::string& path,
                            std::vector<Complaint>& complaints) {
  if (!request.rope) return;
  complaints.push_back({path + ".rope",
                        "'design' chooses this rope, and each candidate has the values of its row: leave this one out, "
                        "or ask for such a rope below 'design.ropes'"});
}

namespace {

/// Whether the deck says the construction of such a rope more exactly than its row, which names the class alone.
bool says_more(const std::string& asked, const std::string& own) {
  const auto known = catalogue::parse_construction(own);
  return known && known->lay.empty() && known->layers.empty() && catalogue::matches_construction(own, asked);
}

}  // namespace

catalogue::RopeRow candidate_with_request(catalogue::RopeRow rope, RopeCheckRequest request, const std::string& path,
                                          std::vector<std::string>& denied) {
  std::vector<Complaint> other;
  complain_of_values(request, rope, path, other);
  for (const Complaint& one : other) denied.push_back(fmt::format("{}: {}", one.path, one.message));
  if (!rope.core.empty()) request.core.reset();
  const bool own = !rope.construction.empty();
  if (own && request.construction && (!other.empty() || !says_more(*request.construction, rope.construction)))
    request.construction.reset();
  return with_request(std::move(rope), request);
}

}  // namespace taut::checks
