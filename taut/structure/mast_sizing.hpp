#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "taut/catalogue/section.hpp"
#include "taut/structure/mast.hpp"

/// The lightest section of a table that carries a mast.
namespace taut::structure {

/// A mast in a section, and its cases (which know the section's stiffness).
struct LoadedMast {
  Mast mast;
  std::vector<MastCase> cases;
};

/// The mast in that section; empty where it cannot be: the steel is not made so thick, the column buckles.
using MastOf = std::function<std::optional<LoadedMast>(const catalogue::SectionRow& section)>;

struct SizedMast {
  catalogue::SectionRow section;
  MastUse use;
};

struct MastSizing {
  std::vector<SizedMast> passing;    ///< lightest first, at most as many as asked for
  std::optional<SizedMast> nearest;  ///< where none passes: the least utilisation
};

/// Less than this no section of these forces can use: the larger of |N| over A f_y/gamma_M0 and M over W_pl
/// f_y/gamma_M0.
double least_use(const LoadedMast& loaded);

/// The first `count` sections of `by_mass` (lightest first) whose mast passes. What `least_use` rules out is not looked
/// at in full; the answer is that of trying all.
MastSizing size_mast(const std::vector<catalogue::SectionRow>& by_mass, const MastOf& mast_of, std::size_t count = 1);

}  // namespace taut::structure
