#pragma once
#include <pybind11/pybind11.h>

namespace taut::python {

/// Makes the class NativeCases, the function of numbers that a deck is, and the functions `study` and `calibrate`.
void bind_cases(pybind11::module_& m);

}  // namespace taut::python
