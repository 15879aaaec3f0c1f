#include "taut/machine/compile/drums.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "taut/base/array.hpp"
#include "taut/machine/links/motion_links.hpp"
namespace taut::machine {
namespace {

class Checker {
 public:
  Checker(const description::Drum& drum, double thickest, ModelFor use, std::vector<Complaint>& complaints)
      : drum_(drum), thickest_(thickest), use_(use), path_("drums." + drum.name), complaints_(complaints) {}

  void check() {
    if (drum_.layers) {
      need(drum_.length_on_drum.has_value(), "'layers: auto' needs the 'length_on_drum'");
      need(drum_.face_width.has_value(), "'layers: auto' needs the 'face_width' between the flanges");
      need(drum_.core_diameter > 0, "'layers: auto' needs a 'core_diameter'");
      if (drum_.layer) complain(".layer", "follows from the length on the drum with 'layers: auto'; give one of them");
    }
    if (drum_.pitch && !drum_.face_width) {
      complain(".pitch", "gives the turns of a layer and needs the 'face_width' between the flanges");
    }
    if (drum_.face_width && *drum_.face_width < thickest_) {
      complain(".face_width",
               fmt::format("a rope of {:.4g} mm has no room on {:.4g} mm", 1e3 * thickest_, 1e3 * *drum_.face_width));
    }
    check_pitch();
    if (drum_.flange_diameter && *drum_.flange_diameter <= drum_.core_diameter) {
      complain(".flange_diameter", "is not larger than the core");
    }
    need(!drum_.brake_torque || drum_.inertia > 0 || use_ == ModelFor::rest,
         "in a motion a brake with a 'brake_torque' needs the 'inertia' of what it stops");
    need(drum_.brake_torque || (drum_.brake_delay == 0 && drum_.brake_rise == 0),
         "'brake_delay' and 'brake_rise' belong to a 'brake_torque'");
    need(drum_.drag == 0 || drum_.inertia > 0, "a drum with a 'drag' needs its 'inertia'");
    const bool turned = drum_.drive && drum_.drive->torque;
    need(!turned || drum_.core_diameter > 0, "a drum with a torque needs a 'core_diameter'");
    need(!drum_.brake_torque || drum_.core_diameter > 0,
         "a 'brake_torque' holds the rope at the radius of the drum: it needs a 'core_diameter'");
  }

 private:
  /// Turns side by side are no nearer than the rope is thick, layers bedded in each other not much nearer than
  /// sqrt(3)/2.
  void check_pitch() {
    constexpr double bedded = 0.8;
    if (drum_.pitch && *drum_.pitch < thickest_) {
      complain(".pitch", fmt::format("the turns of a rope of {:.4g} mm have no room at a pitch of {:.4g} mm",
                                     1e3 * thickest_, 1e3 * *drum_.pitch));
    }
    if (drum_.layer_height && *drum_.layer_height < bedded * thickest_) {
      complain(".layer_height", fmt::format("layers of a rope of {:.4g} mm are no lower than {:.4g} mm",
                                            1e3 * thickest_, 1e3 * bedded * thickest_));
    }
  }

  void complain(const char* key, std::string words) { complaints_.push_back({path_ + key, std::move(words)}); }
  void need(bool there, const char* words) {
    if (!there) complain("", words);
  }

  const description::Drum& drum_;
  double thickest_;  ///< of the ropes on it, m; 0: not known
  ModelFor use_;
  std::string path_;
  std::vector<Complaint>& complaints_;
};

/// The largest diameter of the ropes whose paths begin or end on a drum, m; 0: not known.
double thickest_on(const Machine& machine, const description::Drum& drum) {
  double thickest = 0;
  for (const description::Reeving& reeving : machine.reevings) {
    const bool on_it =
        std::any_of(reeving.path.begin(), reeving.path.end(), [&](const auto& stop) { return stop.drum == drum.name; });
    const auto rope = std::find_if(machine.ropes.begin(), machine.ropes.end(),
                                   [&](const auto& one) { return one.name == reeving.rope; });
    if (on_it && rope != machine.ropes.end()) thickest = std::max(thickest, rope->diameter.value_or(0));
  }
  return thickest;
}

}  // namespace

void check_drums(const Machine& machine, ModelFor use, std::vector<Complaint>& complaints) {
  for (const description::Drum& drum : machine.drums)
    Checker(drum, thickest_on(machine, drum), use, complaints).check();
}

rope::DrumLayers measures_of(const Drum& drum, double rope_diameter) {
  rope::DrumLayers m;
  m.core_diameter = 2 * drum.core_radius;
  m.rope_diameter = rope_diameter;
  m.pitch = drum.pitch;
  m.layer_height = drum.layer_height;
  m.flange_diameter = drum.flange_diameter;
  if (rope_diameter > 0 && drum.core_radius > 0 && drum.width >= rope_diameter) m.width = drum.width;
  return m;
}

double room_of(double length, double diameter, int copies) {
  return copies * std::max(length, 0.0) * diameter * diameter;
}

namespace {

/// Of all ropes whose paths begin or end on the drum, as the deck says what lies there.
double room_on(const EndOnDrum& end) {
  double room = 0;
  for (const description::Reeving& one : end.machine.reevings) {
    const auto data = index_of(end.ropes, one.rope);
    if (!data || one.path.empty()) continue;
    const RopeData& rope = end.ropes[*data];
    const double strain = rope.stiffness > 0 ? end.drum.wound_at.value_or(0) / rope.stiffness : 0;
    for (const auto* element : {&one.path.front(), &one.path.back()}) {
      if (element->drum != end.drum.name) continue;
      room += room_of(*end.drum.length_on_drum * (1 + strain), rope.diameter, one.copies);
    }
  }
  return room;
}

}  // namespace

int layer_of(const EndOnDrum& end) {
  const description::Drum& drum = end.drum;
  if (!drum.layers || !drum.length_on_drum) return drum.layer.value_or(1);
  Drum model;
  model.core_radius = drum.core_diameter / 2;
  model.width = drum.face_width.value_or(0);
  model.pitch = drum.pitch.value_or(0);
  model.layer_height = drum.layer_height.value_or(0);
  const double d = end.rope.diameter;
  const rope::DrumLayers measures = measures_of(model, d);
  return measures.width == 0 ? 1 : rope::on_drum(measures, room_on(end) / (d * d)).layer;
}

double radius_of(const EndOnDrum& end) {
  const double d = end.rope.diameter;
  return (end.drum.core_diameter + d) / 2 + (layer_of(end) - 1) * end.drum.layer_height.value_or(d);
}

std::optional<double> pull_of_torque(const EndOnDrum& end, const Drive& drive, int copies) {
  const double radius = radius_of(end);
  if (drive.kind != DriveKind::torque || !(radius > 0)) return std::nullopt;
  const double torque = at(drive.signal, 0).value;
  return torque > 0 ? std::optional(torque / (radius * copies)) : std::nullopt;
}

}  // namespace taut::machine
