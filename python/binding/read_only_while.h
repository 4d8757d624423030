// Arrays of numpy that are read without the GIL.
#ifndef TILEMEND_PYTHON_BINDING_READ_ONLY_WHILE_H_
#define TILEMEND_PYTHON_BINDING_READ_ONLY_WHILE_H_

#include <pybind11/numpy.h>

#include <vector>

namespace tilemend {

// While it lives, an array is read-only: who writes to it gets numpy's ValueError. So is the array that it is a view
// of, if it has the same memory. Other views that were there before can still be written to. Several may hold one
// array. Precondition: the GIL is held when it begins and ends, and the array outlives it.
class ReadOnlyWhile {
 public:
  explicit ReadOnlyWhile(const pybind11::array& array);
  ~ReadOnlyWhile();
  ReadOnlyWhile(const ReadOnlyWhile&) = delete;
  ReadOnlyWhile& operator=(const ReadOnlyWhile&) = delete;

 private:
  std::vector<PyObject*> held_;
};

// Has a forked child, in which no other thread reads, get its arrays back writeable. Called once, with the GIL.
void WatchForksOfReadOnly();

}  // namespace tilemend

#endif  // TILEMEND_PYTHON_BINDING_READ_ONLY_WHILE_H_
