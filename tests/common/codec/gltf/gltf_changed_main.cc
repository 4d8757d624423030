// Writes changed glTF files for a validator: gltf_changed FOLDER [FILE ...]
//
// For each sample and each given file, FOLDER gets the file itself, one with triangles taken out and patches added, and
// one without any of its triangles. Of a b3dm the glb within is written.
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "common/codec/gltf/gltf_container.h"
#include "common/codec/gltf/gltf_file.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "tests/fuzz/gltf_property.h"
#include "tests/support/gltf_samples.h"

namespace tilemend {
namespace {

absl::Status WriteGlb(const std::string& folder, const std::string& prefix, const std::string& name,
                      const std::string& bytes) {
  TILEMEND_ASSIGN_OR_RETURN(const GltfContainer container, ParseGltfContainer(bytes, name));
  return WriteFileAtomically(folder + "/" + prefix + name + ".glb", bytes.substr(container.head.size()), Sync::kNo);
}

absl::Status WriteChanged(const std::string& folder, const std::string& name, const std::string& bytes) {
  TILEMEND_ASSIGN_OR_RETURN(const GltfFile file, ReadGltf(bytes, GltfUpAxis::kY, name));
  TILEMEND_RETURN_IF_ERROR(WriteGlb(folder, "original_", name, bytes));
  GltfEdit edit = SampleGltfEdit(file);
  TILEMEND_ASSIGN_OR_RETURN(const std::string changed, ChangeGltf(bytes, GltfUpAxis::kY, edit, name));
  TILEMEND_RETURN_IF_ERROR(WriteGlb(folder, "changed_", name, changed));
  edit.drop.assign(file.triangles.size(), true);
  TILEMEND_ASSIGN_OR_RETURN(const std::string replaced, ChangeGltf(bytes, GltfUpAxis::kY, edit, name));
  return WriteGlb(folder, "replaced_", name, replaced);
}

int Main(int argc, char** argv) {
  if (argc < 2) return 2;
  std::vector<std::pair<std::string, std::string>> files = GltfSampleFiles();
  for (int i = 2; i < argc; ++i) {
    const absl::StatusOr<std::string> bytes = ReadFile(argv[i]);
    if (!bytes.ok()) return 2;
    files.emplace_back(std::filesystem::path(argv[i]).filename().string(), *bytes);
  }
  for (const auto& [name, bytes] : files) {
    const absl::Status status = WriteChanged(argv[1], name, bytes);
    if (status.ok()) continue;
    std::fprintf(stderr, "%s\n", status.ToString().c_str());
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace tilemend

int main(int argc, char** argv) { return tilemend::Main(argc, argv); }
