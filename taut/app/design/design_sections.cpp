#include <fmt/format.h>

#include <algorithm>

#include "taut/app/design/design_space.hpp"
#include "taut/base/suggest.hpp"
#include "taut/catalogue/section_search.hpp"
#include "taut/catalogue/steel.hpp"

namespace taut::app {
namespace {

using catalogue::SectionRow;

/// Whether the steel is made in that wall.
bool is_made(const std::optional<std::string>& steel_name, const SectionRow& row) {
  if (!steel_name) return true;
  const auto steel = catalogue::find_steel(*steel_name);
  return steel && catalogue::yield(*steel, row.thickness).has_value();
}

}  // namespace

design::SectionCandidates candidates_of_section(const design::DesignSectionRequest& request, design::Seek seek,
                                                const std::vector<DesignSection>& known, const std::string& owner,
                                                std::vector<Complaint>& complaints) {
  const std::string path = fmt::format("design.sections.{}", request.name);
  design::SectionCandidates own;
  own.name = request.name;
  const auto part =
      std::find_if(known.begin(), known.end(), [&](const DesignSection& one) { return one.name == request.name; });
  if (part == known.end()) {
    std::vector<std::string> names;
    names.reserve(known.size());
    for (const DesignSection& one : known) names.push_back(one.name);
    complaints.push_back(
        {path, fmt::format("{} has no beam or mast '{}'{}", owner, request.name, did_you_mean(request.name, names))});
    return own;
  }
  if (!part->refused.empty()) {
    complaints.push_back({path, part->refused});
    return own;
  }
  if (seek == design::Seek::cheapest && !request.price) {
    complaints.push_back({path, "sections have no price in the catalogue: give a 'price' of a kilogram"});
  }
  own.rows = catalogue::sections_by_mass(checks::filter_of(request.which));
  std::erase_if(own.rows, [&](const SectionRow& r) { return !is_made(part->steel, r); });
  if (seek == design::Seek::smallest) {
    std::stable_sort(own.rows.begin(), own.rows.end(),
                     [](const SectionRow& a, const SectionRow& b) { return a.height < b.height; });
  }
  if (own.rows.empty()) complaints.push_back({path, "no section of the catalogue is so: drop a condition"});
  own.costs.reserve(own.rows.size());
  for (const SectionRow& row : own.rows) {
    const double price = seek == design::Seek::cheapest ? request.price.value_or(0) : 1;
    own.costs.push_back(seek == design::Seek::smallest ? row.height : row.mass_per_length * price);
  }
  return own;
}

void add_masts(const std::vector<checks::MastCheckRequest>& masts, std::vector<DesignSection>& sections) {
  for (const checks::MastCheckRequest& mast : masts) {
    const bool known =
        std::any_of(sections.begin(), sections.end(), [&](const DesignSection& one) { return one.name == mast.name; });
    if (known || !mast.beams.empty()) continue;
    sections.push_back({mast.name, mast.steel,
                        mast.section
                            ? std::string{}
                            : fmt::format("mast '{}' is of pieces: give it a 'section' to begin with", mast.name)});
  }
}

void put_masts(const design::DesignSpace& space, const std::vector<std::size_t>& choice,
               std::vector<checks::MastCheckRequest>& masts) {
  for (std::size_t k = 0; k < space.sections.size(); ++k) {
    for (checks::MastCheckRequest& mast : masts) {
      if (mast.name != space.sections[k].name || !mast.section) continue;
      mast.section = space.sections[k].rows[choice[space.ropes.size() + k]].name;
    }
  }
}

std::optional<double> mast_height(const std::vector<checks::MastCheckRequest>& masts, const std::string& name) {
  const auto mast =
      std::find_if(masts.begin(), masts.end(), [&](const checks::MastCheckRequest& one) { return one.name == name; });
  return mast == masts.end() ? std::optional<double>{} : mast->height;
}

}  // namespace taut::app
