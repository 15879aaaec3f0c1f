#pragma once
#include <stdexcept>

namespace taut::python {

/// A file that can't be read or written: taut.FileError in Python, an OSError.
struct FileTrouble : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace taut::python
