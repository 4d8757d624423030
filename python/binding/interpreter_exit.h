// The end of the interpreter while other threads are in this module. Python lets the threads that are neither the main
// one nor waited for end by pthread_exit when they next take the GIL, which would unwind frames of this module.
#ifndef TILEMEND_PYTHON_BINDING_INTERPRETER_EXIT_H_
#define TILEMEND_PYTHON_BINDING_INTERPRETER_EXIT_H_

#include <pybind11/pybind11.h>

namespace tilemend {

// Has the end of the interpreter, and a forked child, prepared by this module. Called once, when it is loaded, with the
// GIL.
void WatchInterpreterExit();

// Whether the interpreter ends: work is to stop, and none may begin. Any thread may ask.
bool InterpreterEnds();

// Raises SystemExit if the interpreter ends. It ends a thread of Python without a message. Precondition: the GIL is
// held.
void ThrowIfInterpreterEnds();

// While it lives, the interpreter does not get past its handlers of atexit.
class HoldsExit {
 public:
  HoldsExit();
  ~HoldsExit();
  HoldsExit(const HoldsExit&) = delete;
  HoldsExit& operator=(const HoldsExit&) = delete;
};

// Lets go of the GIL while it lives. Once the interpreter ends, it keeps the GIL, which might not come back.
// Precondition: the GIL is held.
class WithoutGil {
 public:
  WithoutGil();
  ~WithoutGil();
  WithoutGil(const WithoutGil&) = delete;
  WithoutGil& operator=(const WithoutGil&) = delete;

 private:
  const HoldsExit holds_exit_;
  PyThreadState* const state_;  // null if the GIL is kept
};

}  // namespace tilemend

#endif  // TILEMEND_PYTHON_BINDING_INTERPRETER_EXIT_H_
