// What several tests of the glTF codec use.
#ifndef TILEMEND_TESTS_COMMON_CODEC_GLTF_GLTF_CHECKS_H_
#define TILEMEND_TESTS_COMMON_CODEC_GLTF_GLTF_CHECKS_H_

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/codec/gltf/gltf_file.h"
#include "tests/support/gltf_samples.h"

namespace tilemend {

inline constexpr char kGltfName[] = "a.glb";

// The file, which must be read.
inline GltfFile ReadGltfSample(std::string_view bytes, GltfUpAxis up = GltfUpAxis::kY) {
  return ReadGltf(bytes, up, kGltfName).value();
}

// The message of the refusal of `bytes`; empty if they are read.
inline std::string GltfRefusal(std::string_view bytes) {
  const absl::StatusOr<GltfFile> file = ReadGltf(bytes, GltfUpAxis::kY, kGltfName);
  return file.ok() ? "" : std::string(file.status().message());
}

// The positions of the corners of all triangles.
inline std::vector<SpaceTriangle> GltfSpaceTriangles(const GltfFile& file) {
  std::vector<SpaceTriangle> triangles;
  for (const Triangle& triangle : file.triangles) {
    SpaceTriangle& out = triangles.emplace_back();
    for (size_t k = 0; k < 3; ++k) out[k] = file.points[static_cast<size_t>(triangle[k])];
  }
  return triangles;
}

#ifdef TILEMEND_SHARED_DATA
// The b3dm files of a tileset that is not part of the project, sorted; none if it is missing. The environment variable
// or CMake variable TILEMEND_SHARED_DATA names its place.
inline std::filesystem::path SharedTilesFolder() {
  const char* const variable = std::getenv("TILEMEND_SHARED_DATA");
  return std::filesystem::path(variable != nullptr ? variable : TILEMEND_SHARED_DATA) / "mars_tiles";
}

inline std::vector<std::filesystem::path> SharedTiles() {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator it(SharedTilesFolder(), error), end; !error && it != end;
       it.increment(error)) {
    if (it->path().extension() == ".b3dm") files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

inline constexpr char kNoSharedTiles[] = "NO 3D TILES: real tiles are not tested; set TILEMEND_SHARED_DATA";
#endif

}  // namespace tilemend

#endif  // TILEMEND_TESTS_COMMON_CODEC_GLTF_GLTF_CHECKS_H_
