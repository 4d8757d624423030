#include "python/binding/read_only_while.h"

#include <map>

namespace tilemend {
namespace {

namespace py = pybind11;

constexpr int kWriteable = py::detail::npy_api::NPY_ARRAY_WRITEABLE_;

// Of arrays that were writeable: how many hold them. Under the GIL.
std::map<PyObject*, int>& Holders() {
  static std::map<PyObject*, int> holders;
  return holders;
}

int& FlagsOf(PyObject* array) { return py::detail::array_proxy(array)->flags; }

// Null if it is a view of no other array, or of a part.
PyObject* ArrayWithSameMemory(PyObject* array) {
  PyObject* const base = py::detail::array_proxy(array)->base;
  if (base == nullptr || !py::isinstance<py::array>(base)) return nullptr;
  const auto part = py::reinterpret_borrow<py::array>(array), all = py::reinterpret_borrow<py::array>(base);
  return part.data() == all.data() && part.nbytes() == all.nbytes() ? base : nullptr;
}

}  // namespace

// Delegates, so that the destructor runs if an exception leaves the loop.
ReadOnlyWhile::ReadOnlyWhile(const py::array& array) : ReadOnlyWhile() {
  for (PyObject* held = array.ptr(); held != nullptr; held = ArrayWithSameMemory(held)) {
    const bool is_held = Holders().contains(held);
    if (!is_held && (FlagsOf(held) & kWriteable) == 0) continue;
    held_.reserve(held_.size() + 1);
    ++Holders()[held];
    FlagsOf(held) &= ~kWriteable;
    held_.push_back(held);
  }
}

ReadOnlyWhile::~ReadOnlyWhile() {
  for (PyObject* const held : held_) {
    const auto known = Holders().find(held);
    if (known == Holders().end() || --known->second > 0) continue;
    FlagsOf(held) |= kWriteable;
    Holders().erase(known);
  }
}

void WatchForksOfReadOnly() {
  py::module_::import("os").attr("register_at_fork")(py::arg("after_in_child") = py::cpp_function([] {
                                                       for (const auto& [held, count] : Holders()) {
                                                         FlagsOf(held) |= kWriteable;
                                                       }
                                                       Holders().clear();
                                                     }));
}

}  // namespace tilemend
