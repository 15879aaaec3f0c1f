#pragma once
#include <initializer_list>
#include <string>
#include <vector>

#include "taut/base/array.hpp"
#include "taut/machine/description/machine.hpp"
#include "taut/machine/links/beam_links.hpp"
#include "taut/machine/model.hpp"

namespace taut::machine {

/// What a name of a deck may stand for.
enum class Thing { point, body, carriage, sheave, drum };

/// A named thing and where it is.
struct Target {
  Thing thing = Thing::point;
  std::string name;
  int index = 0;  ///< among its kind; supports after the sheaves
  Place place;
};

/// All names of a machine. A beam is known by places on it and by its free top, "NAME.top", a body.
class Links {
 public:
  /// Complains of bodies that points and sheaves name and that are not there.
  Links(const Machine& machine, std::vector<Complaint>& complaints);

  /// The thing of that name, of the first of these kinds that has it; nullptr, with a complaint at `path` that says
  /// what else it is or what may be meant, when there is none, or when another of these kinds has the name at another
  /// place.
  const Target* find(const std::string& name, std::initializer_list<Thing> kinds, const DeckPlace& path,
                     std::vector<Complaint>& complaints) const;

  /// Points and markers, then sheaves and supports, then drums.
  Array<NamedPlace> places() const;

  const BeamPlans& beams() const { return beams_; }

 private:
  /// The place `at` on the body, carriage or beam of that name; on the ground, with a complaint, where there is none.
  Place place_on(const Machine& machine, const std::string& body, const Vector3& at, const std::string& path,
                 std::vector<Complaint>& complaints) const;

  BeamPlans beams_;
  Array<Target> all_;
};

/// A vector of a deck.
inline Vector3 vector_of(const Triple& t) { return {t[0], t[1], t[2]}; }

}  // namespace taut::machine
