#pragma once
#include <optional>
#include <string>

#include "taut/methods/friction_drive/friction_drive.hpp"

/// What the grip of the driving sheave allows, in plain numbers: for messages, sweeps and plots.
namespace taut::friction_drive {

/// Part of the wrap that works: (1 - k)/(mu k + 1) K_fill/K_fill_max.
double working_share(const Input& in);

/// e = exp(mu phi).
double grip_ratio(const Input& in);

/// Wrap, friction and fill ratio that would bring e to `ratio`, the others as given; nothing when none in the field's
/// range does.
std::optional<double> wrap_for(const Input& in, double ratio);
std::optional<double> friction_for(const Input& in, double ratio);
std::optional<double> fill_for(const Input& in, double ratio);

/// What to change when e does not exceed the idler's loss.
std::string how_to_get_grip(const Input& in);

/// Largest cutting force that `pull` on the idler (N, without the centrifugal share) passes on with the reserve `m`:
/// pull (e - 1)/(e - 1 + 2 m). Zero when the pull is.
double transmissible_force(double pull, double e, double m);

/// The pull on the idler for a cutting force: the inverse of transmissible_force.
double pull_for(double cutting_force, double e, double m);

}  // namespace taut::friction_drive
