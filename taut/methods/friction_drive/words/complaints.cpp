#include <fmt/format.h>

#include <cmath>

#include "taut/catalogue/rope_words.hpp"
#include "taut/methods/friction_drive/friction_drive.hpp"

namespace taut::friction_drive {

std::vector<Complaint> complaints(const Input& in) {
  std::vector<Complaint> all;
  if (in.take_up) {
    const int given =
        int{in.take_up->weight.has_value()} + int{in.take_up->mass.has_value()} + int{in.take_up->screw.has_value()};
    if (given != 1) all.push_back({"take_up", "give weight, mass or screw, one of them"});
  }
  if (!in.rope) return all;
  const auto rope = catalogue::find_rope_in_words(*in.rope);
  if (!rope) {
    all.push_back({"rope", to_text(rope.error())});
  } else if (in.rope_area && std::abs(*in.rope_area / rope->area - 1) > 0.2) {
    all.push_back(
        {"rope_area", fmt::format("{:.4g} mm^2 is not the metallic area of {}, {:.4g} mm^2: give rope_area or rope",
                                  *in.rope_area * 1e6, rope->id, rope->area * 1e6)});
  }
  return all;
}

}  // namespace taut::friction_drive
