// osgb_sample FOLDER: writes the made scene of OSGB tiles (osgb_scene.h) with an image that can be decoded.
#include <cstdio>
#include <filesystem>
#include <string>

#include "common/util/files.h"
#include "tests/support/image_builders.h"
#include "tests/support/osgb_scene.h"

int main(int count, char** words) {
  using namespace tilemend;
  if (count != 2) return 2;
  const std::string image = PngImage(64, 64, [](int32_t column, int32_t row) -> Rgb {
    return (column + row) % 16 < 8 ? Rgb{70, 110, 60} : Rgb{110, 140, 80};
  });
  for (const auto& [path, bytes] : OsgbScene(OsgbScene::Pond::kHole, 80, image).Files()) {
    const std::filesystem::path file = std::filesystem::path(words[1]) / path;
    std::filesystem::create_directories(file.parent_path());
    const absl::Status status = WriteFileAtomically(file.string(), bytes);
    if (!status.ok()) return std::fprintf(stderr, "%s\n", std::string(status.message()).c_str()), 1;
  }
  return 0;
}
