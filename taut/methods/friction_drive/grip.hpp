#pragma once
#include <optional>
#include <string>

#include "taut/methods/friction_drive/friction_drive.hpp"
#include "taut/units/display.hpp"

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
std::string how_to_get_grip(const Input& in, const Display& display);

/// Largest cutting force that `pull` on the idler (N, without the centrifugal share) passes on with the reserve `m`:
/// pull (e - 1)/(e - 1 + 2 m). Zero when the pull is.
double transmissible_force(double pull, double e, double m);

/// The slack branch that a pull on the idler leaves, N, with the loss of (14), T_1 = r T_2 + P_p: T_1 + T_2 - 2 c is
/// the pull. Lower than c, or below 0: there is no such drive, the rope slips.
template <class T>
T slack_branch_under(const T& pull, const T& P_p, const T& r, const T& c) {
  return (pull + 2 * c - P_p) / (r + 1);
}

/// What the slack branch can carry over the pull of the sheave: the reserve of the grip, as m. Below 1 the rope slips.
template <class T>
T reserve_of(const T& T_1, const T& T_2, const T& e, const T& c) {
  return (e - 1) * (T_2 - c) / (T_1 - T_2);
}

/// The reserve of a take-up that pulls the idler with `pull`, N. `out`: its e and c.
double reserve_under(double pull, const Input& in, const Output& out);

/// Whether a drive with this reserve holds; at the limit of slip it does.
bool holds(double reserve);
/// Whether it has the reserve m as well.
bool keeps(double reserve, double m);

/// The cutting force that such a take-up passes on at the limit of slip, beside the idler loss, N.
double cutting_force_under(double pull, const Input& in, const Output& out);

/// The pull on the idler for a cutting force: the inverse of transmissible_force.
double pull_for(double cutting_force, double e, double m);

}  // namespace taut::friction_drive
