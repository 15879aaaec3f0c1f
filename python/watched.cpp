#include "python/watched.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace taut::python {
namespace {

namespace py = pybind11;

/// How long Python waits for its signals and its progress: shorter than a person notices, and no load on the machine.
constexpr std::chrono::milliseconds look_again{50};

/// What the two threads share.
struct Watch {
  std::mutex turn;
  std::condition_variable told;
  std::optional<Progress> latest;
  bool finished = false;
  std::atomic<bool> ended = false;
  std::exception_ptr trouble;
};

void work_in(Watch& watch, const std::function<void(const Ask&)>& work) {
  try {
    work([&watch](const Progress& progress) {
      const std::lock_guard lock(watch.turn);
      watch.latest = progress;
      return !watch.ended;
    });
  } catch (...) {
    watch.trouble = std::current_exception();
  }
  const std::lock_guard lock(watch.turn);
  watch.finished = true;
  watch.told.notify_one();
}

/// With the interpreter's lock: signals, then the progress. Returns the exception that ends the work.
py::object look(Watch& watch, const std::optional<Progress>& latest, const py::object& progress) {
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (latest && !progress.is_none()) {
      const py::object answer = progress(latest->what, latest->done, latest->words);
      if (answer.is(py::bool_(false))) watch.ended = true;
    }
  } catch (py::error_already_set& error) {
    watch.ended = true;
    py::object value = error.value();
    if (error.trace()) PyException_SetTraceback(value.ptr(), error.trace().ptr());
    return value;
  }
  return py::none();
}

}  // namespace

py::object watched(const std::function<void(const Ask&)>& work, const py::object& progress) {
  Watch watch;
  py::object raised = py::none();
  std::thread thread([&] { work_in(watch, work); });
  {
    const py::gil_scoped_release released;
    std::unique_lock lock(watch.turn);
    while (!watch.told.wait_for(lock, look_again, [&] { return watch.finished; })) {
      const std::optional<Progress> latest = std::exchange(watch.latest, std::nullopt);
      lock.unlock();
      if (!watch.ended) {
        const py::gil_scoped_acquire held;
        raised = look(watch, latest, progress);
      }
      lock.lock();
    }
    lock.unlock();
    thread.join();
  }
  if (watch.trouble) std::rethrow_exception(watch.trouble);
  return raised;
}

}  // namespace taut::python
