#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "taut/app/design.hpp"
#include "taut/base/suggest.hpp"
#include "taut/catalogue/section_search.hpp"
#include "taut/catalogue/steel.hpp"
#include "taut/model/compile.hpp"

namespace taut::app {
namespace {

using catalogue::SectionRow;

/// Whether the beam's steel is made in that wall.
bool is_made(const model::description::Beam& beam, const SectionRow& row) {
  if (!beam.steel) return true;
  const auto steel = catalogue::find_steel(*beam.steel);
  return steel && catalogue::yield(*steel, row.thickness).has_value();
}

}  // namespace

SectionCandidates candidates_of_beam(const DesignSectionRequest& request, const MachineDeck& deck,
                                     std::vector<Complaint>& complaints) {
  const std::string path = fmt::format("design.sections.{}", request.name);
  SectionCandidates own;
  own.name = request.name;
  const auto& beams = deck.machine.beams;
  const auto beam = std::find_if(beams.begin(), beams.end(), [&](const auto& b) { return b.name == request.name; });
  if (beam == beams.end()) {
    std::vector<std::string> known;
    known.reserve(beams.size());
    for (const auto& b : beams) known.push_back(b.name);
    complaints.push_back(
        {path, fmt::format("the machine has no beam '{}'{}", request.name, did_you_mean(request.name, known))});
    return own;
  }
  if (!beam->section) {
    complaints.push_back(
        {path, fmt::format("beam '{}' has its section by figures: give it a 'section' of the catalogue "
                           "to begin with",
                           request.name)});
    return own;
  }
  if (deck.design->seek == Seek::cheapest)
    complaints.push_back({"design.seek", "sections have no price: seek the lightest"});
  own.rows = catalogue::sections_by_mass(filter_of(request.which));
  std::erase_if(own.rows, [&](const SectionRow& r) { return !is_made(*beam, r); });
  if (deck.design->seek == Seek::smallest) {
    std::stable_sort(own.rows.begin(), own.rows.end(),
                     [](const SectionRow& a, const SectionRow& b) { return a.height < b.height; });
  }
  if (own.rows.empty()) complaints.push_back({path, "no section of the catalogue is so: drop a condition"});
  return own;
}

void weigh_sections(const MachineDeck& first, DesignSpace& space) {
  const auto model = model::compile(first.machine);
  for (SectionCandidates& own : space.sections) {
    double length = 1;
    if (model) {
      for (const model::Beam& beam : model->beams) length = beam.name == own.name ? beam.length : length;
    }
    own.costs.reserve(own.rows.size());
    for (const SectionRow& row : own.rows) {
      own.costs.push_back(first.design->seek == Seek::smallest ? row.height : row.mass_per_length * length);
    }
  }
}

std::vector<std::vector<double>> costs_of(const DesignSpace& space) {
  std::vector<std::vector<double>> costs;
  costs.reserve(space.ropes.size() + space.sections.size());
  for (const RopeCandidates& one : space.ropes) costs.push_back(one.costs);
  for (const SectionCandidates& one : space.sections) costs.push_back(one.costs);
  return costs;
}

}  // namespace taut::app
