#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/catalogue/forestry/yarder.hpp"

namespace taut::checks {

/// What is checked of a yarder: the length and the pull of each line against its drum. Its name is the deck's own.
struct YarderCheckRequest {
  std::string name;
  std::string yarder;                                      ///< by its name in the catalogue
  std::optional<std::string> catalogue;                    ///< a file of the user's
  std::optional<std::string> skyline, mainline, haulback;  ///< reevings
  double spare = 10;                                       ///< rope that stays on the drum and at the anchor, m
  double lateral = 0;                                      ///< mainline that is pulled out of the carriage, m
  catalogue::YarderRow row;                                ///< not of the deck: as the catalogue lists it
  static const Description& describe();
};

/// A line of a yarder: its drum's name, the reeving.
struct YarderLineRequest {
  std::string line;
  std::string reeving;
};
/// Those that a request names, in the order skyline, mainline, haulback.
std::vector<YarderLineRequest> lines_of(const YarderCheckRequest& request);

}  // namespace taut::checks
