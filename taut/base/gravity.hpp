#pragma once

namespace taut {

/// Standard acceleration of free fall, m/s2 (3rd CGPM, 1901); exact by definition.
inline constexpr double standard_gravity = 9.80665;

}  // namespace taut
