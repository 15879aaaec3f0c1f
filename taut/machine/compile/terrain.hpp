#pragma once
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/links/links.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// Puts the ground under the line into the model. Heights over chainage stand as they are; a survey, with x and y of
/// the ground frame, is projected on the line and put in the order of its chainage. The line runs from the first to the
/// second of `between`, else from `from` along `along`, else, of a survey, from its first to its last row. Complaints
/// at "terrain": lists of different lengths, fewer than two places, chainage that does not grow, two surveyed rows at
/// one chainage, a line without length.
void add_terrain(const description::Terrain& given, const Links& links, Model& model,
                 std::vector<Complaint>& complaints);

}  // namespace taut::machine
