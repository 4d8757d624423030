// numpy arrays as spans of numbers, without a copy.
#ifndef TILEMEND_PYTHON_BINDING_ARRAY_VIEW_H_
#define TILEMEND_PYTHON_BINDING_ARRAY_VIEW_H_

#include <pybind11/numpy.h>

#include <span>

#include "client/mesh/array_mesh.h"

namespace tilemend {

// Both check the shape, (n, 3) and (m, 3), and the type again: the Python code converts before, but anybody may call
// the module. TypeError or ValueError says what was expected. The array outlives the span.
VertexNumbers VertexView(const pybind11::array& vertices);  // float32 or float64
FaceNumbers FaceView(const pybind11::array& faces);         // int32, int64, uint32 or uint64

}  // namespace tilemend

#endif  // TILEMEND_PYTHON_BINDING_ARRAY_VIEW_H_
