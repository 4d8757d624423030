// What must hold for any bytes that parse as glTF: geometry can be appended and triangles can be taken out. Everything
// else is as it was.
#ifndef TILEMEND_TESTS_FUZZ_GLTF_PROPERTY_H_
#define TILEMEND_TESTS_FUZZ_GLTF_PROPERTY_H_

#include <string>
#include <string_view>

#include "common/codec/gltf/gltf_file.h"

namespace tilemend {

// A triangle with a texture near the first point of `file`, for its node `node`.
GltfPatch GltfTriangle(const GltfFile& file, int32_t node);

// Drops every third triangle and adds a patch to the first and to the last node.
GltfEdit SampleGltfEdit(const GltfFile& file);

// "" if the property holds, else what is wrong.
std::string GltfPropertyViolation(std::string_view bytes);

}  // namespace tilemend

#endif  // TILEMEND_TESTS_FUZZ_GLTF_PROPERTY_H_
