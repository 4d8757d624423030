#include "python/binding/array_view.h"

#include <cstddef>
#include <cstdint>
#include <string>

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

namespace py = pybind11;

[[noreturn]] void ThrowType(const char* name, const py::array& array, const char* expected) {
  throw py::type_error(
      absl::StrCat(name, ": has dtype ", py::str(array.dtype()).cast<std::string>(), "; expected ", expected));
}

// `rows`: what their number is called.
void CheckShape(const char* name, const char* rows, const py::array& array) {
  const bool is_packed = (array.flags() & py::array::c_style) != 0;
  if (array.ndim() == 2 && array.shape(1) == 3 && is_packed) return;
  std::string shape;
  for (py::ssize_t k = 0; k < array.ndim(); ++k) absl::StrAppend(&shape, k > 0 ? ", " : "", array.shape(k));
  throw py::value_error(
      absl::StrCat(name, ": has shape (", shape, "); expected (", rows, ", 3), row after row in memory"));
}

// pybind11's isinstance: same kind, width and byte order, and aligned.
template <typename Number>
bool Holds(const py::array& array) {
  return py::isinstance<py::array_t<Number>>(array) && reinterpret_cast<uintptr_t>(array.data()) % alignof(Number) == 0;
}

template <typename Number>
std::span<const Number> SpanOf(const py::array& array) {
  return {static_cast<const Number*>(array.data()), static_cast<size_t>(array.size())};
}

}  // namespace

VertexNumbers VertexView(const py::array& vertices) {
  CheckShape("vertices", "n", vertices);
  if (Holds<float>(vertices)) return SpanOf<float>(vertices);
  if (Holds<double>(vertices)) return SpanOf<double>(vertices);
  ThrowType("vertices", vertices, "float32 or float64");
}

FaceNumbers FaceView(const py::array& faces) {
  CheckShape("faces", "m", faces);
  if (Holds<int32_t>(faces)) return SpanOf<int32_t>(faces);
  if (Holds<int64_t>(faces)) return SpanOf<int64_t>(faces);
  if (Holds<uint32_t>(faces)) return SpanOf<uint32_t>(faces);
  if (Holds<uint64_t>(faces)) return SpanOf<uint64_t>(faces);
  ThrowType("faces", faces, "int32, int64, uint32 or uint64");
}

}  // namespace tilemend
