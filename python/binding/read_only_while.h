// Arrays of numpy that are read without the GIL.
#ifndef TILEMEND_PYTHON_BINDING_READ_ONLY_WHILE_H_
#define TILEMEND_PYTHON_BINDING_READ_ONLY_WHILE_H_

#include <pybind11/numpy.h>

#include <vector>

namespace tilemend {

// While it lives, an array is read-only: numpy raises a ValueError if code writes to it. So is the array that it is a
// view of, if it has the same memory. At the end those that were writeable are so again. Several may hold one array.
//
// It does not see the following:
// - Other views that were there before can still be written to.
// - A view that is made meanwhile stays read-only, until its caller sets its flag `writeable`.
// - Whatever a caller sets the flag to meanwhile, the array is writeable at the end.
// - resize(refcheck=False) frees the memory meanwhile. So nobody may call it.
//
// Precondition: the GIL is held when it begins and ends, and the array outlives it.
class ReadOnlyWhile {
 public:
  explicit ReadOnlyWhile(const pybind11::array& array);
  ~ReadOnlyWhile();
  ReadOnlyWhile(const ReadOnlyWhile&) = delete;
  ReadOnlyWhile& operator=(const ReadOnlyWhile&) = delete;

 private:
  ReadOnlyWhile() = default;

  std::vector<PyObject*> held_;
};

// In a forked child no other thread reads, so all arrays become writeable again there. Called once, with the GIL.
void WatchForksOfReadOnly();

}  // namespace tilemend

#endif  // TILEMEND_PYTHON_BINDING_READ_ONLY_WHILE_H_
