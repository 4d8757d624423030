// Small glTF files for tests, written field by field; shares nothing with the codec but the JSON type.
#ifndef TILEMEND_TESTS_SUPPORT_GLTF_SAMPLES_H_
#define TILEMEND_TESTS_SUPPORT_GLTF_SAMPLES_H_

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tilemend {

// A document with its binary chunk.
struct GltfSample {
  nlohmann::ordered_json json;
  std::string bin;

  std::string Glb() const;
};

// A PNG of one pixel.
std::string OnePixelPng();

std::string GlbOf(std::string_view json, std::string_view bin);
// Tables are padded with blanks, as the specification demands.
std::string B3dmOf(const std::string& glb, std::string feature_table, std::string batch_table = "");

// A square of two triangles with texture, in the xz plane with y up. It reaches from (0, 0, 0) to (2, 0, -2) but for
// the corner at (2, 1, -2). Its node moves it by (10, 20, 30) and is the child of a node that scales it by 2.
GltfSample SquareSample();
// The same with 16-bit positions that the node's matrix scales, and texture coordinates that KHR_texture_transform
// scales.
GltfSample QuantizedSample();
// A grid of 4 x 4 squares of 1 m, compressed.
GltfSample DracoSample(bool is_edgebreaker);
// A grid of 4 x 4 squares of 1 m, plain.
GltfSample GridSample();
// The same, compressed.
GltfSample MeshoptSample();

// All of the above as files, and a b3dm, with their names.
std::vector<std::pair<std::string, std::string>> GltfSampleFiles();

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_GLTF_SAMPLES_H_
