#include "taut/calc/shown.hpp"

#include <fmt/format.h>

namespace taut {

bool shown_below(double a, double b) { return a < b && fmt::format("{:.4e}", a) != fmt::format("{:.4e}", b); }

}  // namespace taut
