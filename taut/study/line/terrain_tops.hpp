#pragma once
#include <optional>

#include "taut/base/array.hpp"
#include "taut/machine/model.hpp"
#include "taut/solve/equilibrium.hpp"

namespace taut::study {

/// A place on the way of a carriage with its height there, m.
struct WayPlace {
  double x = 0;         ///< of the carriage along its way
  double chainage = 0;  ///< along the terrain
  double z = 0;
  double clearance = 0;  ///< above the ground; NaN without terrain there
};

/// The place of a carriage in a state, at x of its way. Without an answer its numbers are NaN.
WayPlace way_place(const machine::Model& model, int carriage, double x, const solve::EquilibriumResult& state);

/// The tops of the ground between two neighbouring places of a way: the corners that stand above the line between
/// their neighbours, and the ends of the terrain. A carriage between the places is nearest to the ground over one of
/// them, but for the bend of its own way, as ground between tops is straight or hollow.
///
/// A top is worth a place of its own where the way, drawn between the places that are known, may be lower over it than
/// at each of these. Such a top is looked at, the lowest first, and then is a known place itself. So the search ends
/// when no top between the places is nearer to the way than a place that was looked at, and that is mostly after one:
/// of a survey with many points in each step only those are looked at that come nearest.
class TopsBetween {
 public:
  /// `bend`: how much the slope of the way grows per m, 1/m, at most: the way is below its chords by that.
  TopsBetween(const machine::Model& model, const WayPlace& from, const WayPlace& to, double bend = 0);

  /// The x of the next top to look at, each once; none where the way is nowhere lower than at a known place.
  std::optional<double> next();

  /// A place between the two that is known now.
  void take(const WayPlace& place);

  /// The known places in the order of the way. Their heights may be replaced by those with another load.
  Array<WayPlace>& places() { return places_; }

 private:
  double height_at(double x) const;

  Array<WayPlace> places_;
  Array<machine::GroundPoint> tops_;  ///< at the x of the carriage, those that were not looked at
  double bend_;
};

/// The bend of a way at its step from place i to i + 1, from the heights at equal steps of x: the larger one of those
/// at both ends. At least 0.
double bend_of_step(const Array<WayPlace>& way, std::size_t i);

}  // namespace taut::study
