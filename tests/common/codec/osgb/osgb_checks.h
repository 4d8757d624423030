// What several tests of the OSGB codec use.
#ifndef TILEMEND_TESTS_COMMON_CODEC_OSGB_OSGB_CHECKS_H_
#define TILEMEND_TESTS_COMMON_CODEC_OSGB_OSGB_CHECKS_H_

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "common/codec/osgb/osgb_file.h"

namespace tilemend {

// The message of the refusal of `bytes`; empty if they are read.
inline std::string OsgbRefusal(std::string_view bytes) {
  const absl::StatusOr<OsgbFile> file = ReadOsgb(bytes, "a.osgb");
  return file.ok() ? "" : std::string(file.status().message());
}

// A new triangle with a texture.
inline OsgbPatch OsgbTriangle(int32_t geode = 0) {
  OsgbPatch patch;
  patch.points = {{10, 20, 30}, {11, 20, 30.5}, {10, 21, -30}};
  patch.uv = {{0, 0}, {0.5, 0}, {0, 0.25}};
  patch.triangles = {{0, 1, 2}};
  patch.image = "\xff\xd8\xff new \xff\xd9";
  patch.image_name = "fill.jpg";
  patch.geode = geode;
  return patch;
}

#ifdef TILEMEND_SHARED_DATA
// The OSGB files of a ContextCapture export that is not part of the project, sorted; none if it is missing. The
// environment variable or CMake variable TILEMEND_SHARED_DATA names its place.
inline std::vector<std::filesystem::path> SharedOsgbFiles() {
  const char* const variable = std::getenv("TILEMEND_SHARED_DATA");
  const auto folder = std::filesystem::path(variable != nullptr ? variable : TILEMEND_SHARED_DATA) / "cc_tiles/osgb";
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == ".osgb") files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

inline constexpr char kNoSharedOsgb[] = "NO OSGB FILES: real exports are not tested; set TILEMEND_SHARED_DATA";
#endif

}  // namespace tilemend

#endif  // TILEMEND_TESTS_COMMON_CODEC_OSGB_OSGB_CHECKS_H_
