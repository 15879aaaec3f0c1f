#include "taut/structure/mast_sizing.hpp"

#include <algorithm>
#include <cmath>

namespace taut::structure {

double least_use(const LoadedMast& loaded) {
  double most = 0;
  for (const MastCase& c : loaded.cases) {
    for (const MastStation& station : c.stations) {
      const SteelSection& steel = loaded.mast.parts[station.part].member.steel;
      const CrossForces& f = station.design;
      const double strength = steel.yield / steel.gamma.M0;
      most = std::max({most, std::abs(f.N) / (steel.section.area * strength),
                       std::abs(f.M_y) / (steel.section.W_pl_y * strength),
                       std::abs(f.M_z) / (steel.section.W_pl_z * strength)});
    }
  }
  return most;
}

MastSizing size_mast(const std::vector<catalogue::SectionRow>& by_mass, const MastOf& mast_of, std::size_t count) {
  MastSizing found;
  std::optional<LoadedMast> near;
  std::optional<catalogue::SectionRow> near_row;
  double near_least = 0;
  for (const catalogue::SectionRow& row : by_mass) {
    if (found.passing.size() >= count) break;
    const std::optional<LoadedMast> loaded = mast_of(row);
    if (!loaded) continue;
    const double least = least_use(*loaded);
    if (least > 1) {
      if (found.passing.empty() && (!near || least < near_least)) {
        near = loaded;
        near_row = row;
        near_least = least;
      }
      continue;
    }
    MastUse use = mast_use(loaded->mast, loaded->cases);
    if (use.utilisation() <= 1) {
      found.passing.push_back({row, std::move(use)});
    } else if (found.passing.empty() && (!found.nearest || use.utilisation() < found.nearest->use.utilisation())) {
      found.nearest = SizedMast{.section = row, .use = std::move(use)};
    }
  }
  if (!found.passing.empty()) {
    found.nearest.reset();
  } else if (near) {
    MastUse use = mast_use(near->mast, near->cases);
    if (!found.nearest || use.utilisation() < found.nearest->use.utilisation()) {
      found.nearest = SizedMast{.section = *near_row, .use = std::move(use)};
    }
  }
  return found;
}

}  // namespace taut::structure
