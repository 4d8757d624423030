#include "worker/materials/file_witness.h"

#include <algorithm>
#include <filesystem>

#include "absl/strings/str_cat.h"
#include "common/store/fingerprint.h"
#include "worker/materials/scene_file.h"

namespace tilemend {

bool Holds(const std::string& root, const FileWitness& witness) {
  const auto leads_there = [&](const FileWitness::Lookup& lookup) {
    const auto file = FindSceneFile(root, lookup.folder, lookup.name);
    return file.ok() && file->path == lookup.path && file->problem == lookup.problem;
  };
  const auto is_same = [&](const FileWitness::Read& read) {
    const std::string name = std::filesystem::path(read.path).filename().string();
    const auto file = FindSceneFile(root, FolderOf(read.path), name);
    if (!file.ok()) return false;
    if (file->path != read.path) return read.digest.empty();
    const auto same = FileHasDigest(absl::StrCat(root, "/", read.path), read.digest);
    return same.ok() ? *same : read.digest.empty();
  };
  return std::all_of(witness.lookups.begin(), witness.lookups.end(), leads_there) &&
         std::all_of(witness.reads.begin(), witness.reads.end(), is_same);
}

}  // namespace tilemend
