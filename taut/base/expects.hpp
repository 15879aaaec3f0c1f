#pragma once
#include <stdexcept>
#include <string>
#include <string_view>

namespace taut {

/// A broken promise of the program itself, never of the user's file. Carries where it was found.
class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Throws ContractViolation with the caller's place when `condition` does not hold.
/// Use it for our own bugs only; a mistake in a deck is a Diagnostic, a physical impossibility an Outcome.
/// The place is taken by itself; std::source_location would say it too, but libc++ before 16 has none.
void expects(bool condition, std::string_view what, const char* file = __builtin_FILE(), int line = __builtin_LINE());

}  // namespace taut
