#pragma once
#include <pybind11/pybind11.h>

#include <functional>

#include "taut/calc/progress.hpp"

namespace taut::python {

/// What a calculation asks from time to time: false means that it is to end.
using Ask = std::function<bool(const Progress&)>;

/// Calls `work` in a thread of its own, without the interpreter's lock. The calling thread looks a few times a second
/// for signals and calls `progress(what, done, words)` with the latest progress, where it is not None; a returned False
/// ends the work. So the engine never calls Python, and any of its threads may report.
/// Returns the exception of a signal handler (Ctrl-C: KeyboardInterrupt) or of `progress`, else None. It does not raise
/// it: what the work has done until then is kept. Exceptions of `work` are thrown.
pybind11::object watched(const std::function<void(const Ask&)>& work, const pybind11::object& progress);

}  // namespace taut::python
