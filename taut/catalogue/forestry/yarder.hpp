#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "taut/base/diagnostic.hpp"
#include "taut/catalogue/lookup.hpp"
#include "taut/catalogue/trust.hpp"

namespace taut::catalogue {

/// One drum of a yarder as its maker lists it. SI units; empty where it is not known.
struct YarderDrum {
  std::string line;                    ///< "skyline", "mainline", "haulback"
  std::optional<double> capacity;      ///< rope that it takes, m ...
  std::optional<double> at_diameter;   ///< ... of this diameter, m
  std::optional<double> core, flange;  ///< diameters, m
  std::optional<double> face;          ///< width between the flanges, m
  double pull = 0;                     ///< rated, with the full drum, N
  std::optional<double> hold;          ///< what its brake holds, N
  std::optional<double> speed;         ///< of the rope, m/s
  Trust trust = Trust::unverified;
  std::string trust_text;  ///< where the numbers come from, one sentence
};

/// A yarder, or a class of yarders.
struct YarderRow {
  std::string name;                    ///< "class 600 m"
  std::optional<double> tower_height;  ///< m
  std::vector<YarderDrum> drums;       ///< at least one

  const YarderDrum* drum_of(std::string_view line) const;
};

/// Reads a table of yarders, one line per drum; the lines of one yarder stand together. Columns: yarder, drum, pull_kN,
/// trust, and, if wanted, capacity_m with at_diameter_mm, core_mm with flange_mm and face_mm, hold_kN, speed_m_per_s,
/// tower_height_m, trust_text; their cells may be empty. A drum has its capacity, or the three measures that give it.
tl::expected<std::vector<YarderRow>, Diagnostics> read_yarders(std::string_view csv, std::string file);

/// The built-in yarders (data/yarders/yarders.csv), in the file's order.
const std::vector<YarderRow>& yarders();

/// The yarder of that name; case and spaces do not count. On failure: the nearest names.
Found<YarderRow> find_yarder(std::string_view name, const std::vector<YarderRow>& table = yarders());

}  // namespace taut::catalogue
