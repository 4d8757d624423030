// draco_sample FOLDER: writes a tileset of one model that is compressed with Draco.
#include <cstdio>
#include <filesystem>
#include <string>

#include "common/util/files.h"
#include "tests/support/gltf_samples.h"

int main(int count, char** words) {
  using namespace tilemend;
  if (count != 2) return 2;
  constexpr char kTileset[] = R"({"asset": {"version": "1.1"}, "geometricError": 100, "root": {
      "boundingVolume": {"box": [2, 2, 0, 8, 0, 0, 0, 8, 0, 0, 0, 8]}, "geometricError": 0, "refine": "REPLACE",
      "content": {"uri": "model.glb"}}})";
  const std::filesystem::path folder(words[1]);
  std::filesystem::create_directories(folder);
  absl::Status status = WriteFileAtomically((folder / "model.glb").string(), DracoSample(true).Glb());
  status.Update(WriteFileAtomically((folder / "tileset.json").string(), kTileset));
  if (!status.ok()) return std::fprintf(stderr, "%s\n", std::string(status.message()).c_str()), 1;
  return 0;
}
