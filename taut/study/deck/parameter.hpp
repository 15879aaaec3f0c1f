#pragma once
#include <functional>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "taut/calc/field.hpp"
#include "taut/calc/outcome.hpp"

namespace taut::study {

/// One number of a described struct, found by its path in the deck.
struct Parameter {
  const Field* field = nullptr;     ///< the described number, its unit and range
  Unit unit;                        ///< of the value: the field's; of the angle of a vector rad
  double value = 0;                 ///< now; NaN where nothing is set
  std::function<void(double)> set;  ///< puts another value into the struct, which must outlive this
  std::string path;                 ///< as it was asked for: "reevings.sky.length", "reevings[0].length"
  std::string place;                ///< the same for all spellings of the path, "reevings[0].length"

  /// That a value must lie in; the range of a vector's field is that of its components, not of its angle.
  Range range() const;
};

/// The number at a path as `--set` has it, of which 'machine.' may be left away: "temperature", "loads[0].mass" or
/// "loads.0.mass", "carriages.car.mass",
/// "reevings.skyline.length" (an entry of a list by its name, its rope or the body it is at), "points.head[2]" or
/// "points.head.z" (a component; what stands for a field alone may leave its key away), "loads[0].force.angle" (the
/// direction of a vector in the plane of x and z, from x towards z, its length and y kept). Else what is wrong with it.
tl::expected<Parameter, std::string> find_parameter(const Description& description, void* object,
                                                    const std::string& path);

/// The same at a whole path: "machine.loads[0].mass" of a struct with a `machine`.
tl::expected<Parameter, std::string> parameter_at(const Description& description, void* object,
                                                  const std::string& path);

/// A path without the 'machine.' that it may begin with.
std::string below_machine(const std::string& path);

/// Puts a number where the parameter is; infeasible outside what its field allows.
Outcome put(const Parameter& parameter, double value);

/// A value of a parameter, SI; nothing with a complaint at `path` where it is none.
std::optional<double> value_of(const std::string& text, const Parameter& parameter, const std::string& path,
                               std::vector<Complaint>& complaints);

}  // namespace taut::study
