#pragma once
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/calc/field.hpp"
#include "taut/machine/model.hpp"
#include "taut/study/load_path.hpp"

namespace taut::study {

/// The support or end of its rope over which x lies, nearer than its radius: a carriage, taken as a point, is in no
/// span there. nullptr in a span.
const machine::Node* support_at(const machine::Model& model, int carriage, double x, const Vector3& along);

/// Positions of a carriage, `steps` + 1 of them from `from` to `to`.
struct Way {
  int carriage = 0;
  double from = 0, to = 0;  ///< m
  int steps = 1;
  Vector3 along = Vector3::UnitX();  ///< horizontal unit vector
  double x(int i) const { return from + (to - from) * i / steps; }
};

/// Positions first .. last within one span, with the carriage in that span's place of its rope's path. `support`: the
/// single position lies on it, in no span.
struct WayPart {
  machine::Model model;
  int first = 0, last = 0;
  const machine::Node* support = nullptr;  ///< of the model that the parts were made of
};

/// A way span by span, in the order of its positions.
Array<WayPart> parts_of(const machine::Model& model, const Way& way);

/// A load path over the positions of a part; of a single position it has two, both there.
study::LoadPathOptions path_over(const Way& way, const WayPart& part);

/// The horizontal unit vector of a direction [x, y]; a complaint at `path` where it is none.
Vector3 direction_of(const Array<double>& along, const std::string& path, std::vector<Complaint>& complaints);

/// A carriage that is put somewhere can't be held by two ropes of given lengths: a complaint, reported once.
void check_hold(const machine::Model& model, int carriage, std::vector<Complaint>& complaints);

}  // namespace taut::study
