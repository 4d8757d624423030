#include "python/binding/interpreter_exit.h"

#include <atomic>
#include <chrono>
#include <thread>

namespace tilemend {
namespace {

namespace py = pybind11;

constexpr auto kBetweenLooks = std::chrono::milliseconds(1);

std::atomic<bool> interpreter_ends = false;
std::atomic<int> holders = 0;

// A thread that begins work holds the GIL from its look at `interpreter_ends` until it is one of `holders`. So who has
// the GIL here misses none.
void EndWork() {
  interpreter_ends = true;
  while (holders > 0) {
    const py::gil_scoped_release release;
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

}  // namespace

void WatchInterpreterExit() {
  py::module_::import("atexit").attr("register")(py::cpp_function(&EndWork));
  // The threads that hold the exit of the parent are not in the child.
  py::module_::import("os").attr("register_at_fork")(py::arg("after_in_child") = py::cpp_function([] { holders = 0; }));
}

bool InterpreterEnds() { return interpreter_ends; }

void ThrowIfInterpreterEnds() {
  if (!InterpreterEnds()) return;
  PyErr_SetString(PyExc_SystemExit, "the interpreter ends");
  throw py::error_already_set();
}

HoldsExit::HoldsExit() { ++holders; }
HoldsExit::~HoldsExit() { --holders; }

WithoutGil::WithoutGil() : state_(InterpreterEnds() ? nullptr : PyEval_SaveThread()) {}

WithoutGil::~WithoutGil() {
  if (state_ != nullptr) PyEval_RestoreThread(state_);
}

}  // namespace tilemend
