#pragma once
#include <optional>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/compile/beam_build.hpp"
#include "taut/machine/description/machine.hpp"

namespace taut::machine {

/// Temperature at which a beam is as long as between its places, K: its own, else that of the machine. Empty: nobody
/// says one.
std::optional<double> reference_of(const Machine& machine, const description::Beam& beam);

/// The beams of a machine before they are built: where each begins and ends, where something is fixed to it, and the
/// numbers of the bodies that its sections will be.
class BeamPlans {
 public:
  /// Complains of ends and sections that are not there. `first_body`: number of the first body that a beam brings.
  BeamPlans(const Machine& machine, int first_body, std::vector<Complaint>& complaints);

  /// Ready for add_beam one after the other: a beam after the one that it stands on.
  const Array<StraightBeam>& in_order() const { return built_; }

  /// Whether a deck may name this in the place of a body: a beam, or a free top "NAME.top".
  bool knows(const std::string& body) const;

  /// A place on a beam: `body` is its name, and `at` counts from its base, or "NAME.top", and it counts from there; in
  /// both cases along the axes of the ground, as the beam is before anything acts. It is fixed to the section beside
  /// it; at the base to what the beam stands on.
  Place place(const std::string& body, const Vector3& at) const;

  /// Whether a beam begins or ends on this body.
  bool hold(int body) const;

  /// The free tops: name and number of the body.
  Array<std::pair<std::string, int>> tops() const;

 private:
  /// A named place: on a rigid body (or the ground), or on a beam.
  struct Spot {
    int body = ground;
    std::optional<int> beam;
    bool top = false;
    Vector3 at = Vector3::Zero();
  };
  struct Plan {
    StraightBeam beam;
    Spot from, to;
    Vector3 start = Vector3::Zero(), way = Vector3::Zero();  ///< m
    int first_body = 0;
    bool valid = false, placed = false;
  };

  std::optional<int> find(const std::string& name) const;
  std::optional<Spot> spot_of(const std::string& name) const;
  Spot spot_on(const std::string& body, const Vector3& at) const;
  std::optional<Vector3> ground_of(const Spot& spot) const;
  bool locate(const Machine& machine, std::size_t i, std::vector<Complaint>& complaints);
  void set_imperfection(const description::Beam& given, Plan& plan, std::vector<Complaint>& complaints) const;
  void add_stations(const Machine& machine);
  void add_station(const std::string& body, const Vector3& at);
  Place place_of(const Spot& spot) const;

  const Machine& machine_;
  Array<Plan> plans_;
  Array<StraightBeam> built_;
};

/// The section of a beam, from the catalogue or by figures, its own weight included; complaints at "beams.NAME".
structure::BeamSection section_of(const description::Beam& given, double gravity, std::vector<Complaint>& complaints);

}  // namespace taut::machine
