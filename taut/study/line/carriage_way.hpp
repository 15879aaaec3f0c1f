#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/model.hpp"
#include "taut/study/load_path.hpp"
#include "taut/units/display.hpp"

namespace taut::study {

struct WayPlace;
struct Names;

/// The support or end of its rope over which x lies, nearer than its radius and the distance from the carriage's middle
/// to its outer rollers: it is in no span there. Also a guide that holds ahead of it and is nearer than its radius: the
/// carriage is on neither side of it. nullptr in a span.
const machine::Node* support_at(const machine::Model& model, int carriage, double x, const Vector3& along);

/// A way span by span, in the order of its positions. Between two spans, and beside a support on which a position lies,
/// are the places next to each support: bends over it, and forces on it, are largest there and grow fast towards it. Of
/// a carriage that is a point, steps nearer to a support than these places are left out, but for the ends of the way.
Array<WayPart> parts_of(const machine::Model& model, const Way& way);

/// How many steps that leaves out, and what to do; nullopt: at most one at each side of a support, for which the place
/// next to it stands.
std::optional<std::string> left_out_words(const machine::Model& model, const Way& way, const Display& display);

/// A load path over the positions of a part; of a single place it has two, both there.
LoadPathOptions path_over(const Way& way, const WayPart& part);

/// The tops of the ground between the last place of one part and the first of the next, where the carriage passes a
/// support or a guide: the support holds the way above the line between them. `look` solves the place at x in the model
/// with the carriage there, and is asked as long as a top may be nearer (terrain_tops.hpp).
void look_over_tops(const machine::Model& model, const Way& way, const WayPlace& from, const WayPlace& to,
                    const std::function<WayPlace(machine::Model, double x)>& look);

/// The way of a carriage, empty after a complaint, from one end to the other; complaints below `path`.
Way way_of(std::optional<int> carriage, const std::vector<double>& along, const std::string& path, Names& names);

/// The horizontal unit vector of a direction [x, y]; a complaint at `path` where it is none.
Vector3 direction_of(const Array<double>& along, const DeckPlace& path, std::vector<Complaint>& complaints);

/// A carriage that is put somewhere can't be held by two ropes of given lengths: a complaint, reported once.
void check_hold(const machine::Model& model, std::optional<int> carriage, std::vector<Complaint>& complaints);

}  // namespace taut::study
