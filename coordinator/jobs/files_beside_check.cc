#include "coordinator/jobs/files_beside_check.h"

#include <algorithm>
#include <set>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/codec/mesh_file.h"
#include "common/codec/mtl.h"
#include "common/rpc/look_payloads.h"
#include "common/rpc/tile_patch.h"
#include "common/store/digest.h"
#include "common/store/fingerprint.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"
#include "coordinator/jobs/checked_files.h"
#include "coordinator/jobs/wrong_result.h"

namespace tilemend {

bool HasPatch(const v1::AssembleInput& input) {
  const auto& patches = input.patches().patches();
  return std::any_of(patches.begin(), patches.end(),
                     [](const v1::PatchExtent& patch) { return patch.triangles() > 0; });
}

bool IsPatched(const v1::AssembleInput& input) {
  return input.tile().path().empty() || !input.tile().clear().empty() || HasPatch(input);
}

bool IsOfTree(const v1::AssembleInput& input, const std::string& path) {
  const std::string& tile = input.tile().path();
  return !tile.empty() && IsTileTree(tile) && IsFileOfTree(tile, path);
}

bool HasTexture(const v1::AssembleInput& input, const v1::AssembleOutput& output) {
  return !input.texture().empty() && std::any_of(output.files().begin(), output.files().end(),
                                                 [&](const auto& file) { return file.path() == input.texture(); });
}

namespace {

bool IsAsSurveyed(const std::string& bytes, const std::string& digest) {
  return digest.empty() || HasFileDigest(bytes, digest);
}

// The digest of a carried file; empty if no survey read it.
std::string SurveyedDigest(const v1::AssembleInput& input, const std::string& path) {
  if (path == input.library()) return input.library_digest();
  for (int i = 0; i < std::min(input.carried_size(), input.carried_digests_size()); ++i) {
    if (input.carried(i) == path) return input.carried_digests(i);
  }
  return "";
}

// The material file of a tile with patches.
absl::StatusOr<std::string> LibraryOf(const v1::AssembleInput& input, bool has_texture) {
  TILEMEND_ASSIGN_OR_RETURN(const FillColours colours, ColoursOf(input));
  std::string original;
  if (!input.new_library()) {
    const std::string path = absl::StrCat(input.tile().root(), "/", input.library());
    const auto read = ReadFile(path);
    if (!read.ok()) return absl::UnavailableError(read.status().message());
    original = *read;
    if (!IsAsSurveyed(original, input.library_digest())) return Changed(path);
  }
  if (has_texture) {
    TilePatch textured;
    SetTexture(input, {}, {}, textured);
    return AppendToMtl(original, textured.materials);
  }
  std::vector<FillMaterial> materials;
  std::set<std::string> names;
  for (const v1::PatchExtent& patch : input.patches().patches()) {
    const auto colour = colours.of_holes.find(patch.hole());
    if (!patch.failure().empty() || colour == colours.of_holes.end()) continue;
    const std::string name = MaterialName(colour->second);
    if (names.insert(name).second) materials.push_back({name, colour->second.colour});
  }
  return AppendToMtl(original, materials);
}

absl::Status CheckLibrary(const v1::AssembleInput& input, const v1::WrittenFile& file, bool has_texture) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string expected, LibraryOf(input, has_texture));
  const auto written = ReadFile(absl::StrCat(input.attempts(), "/", file.attempt()));
  if (!written.ok()) return absl::UnavailableError(written.status().message());
  return *written == expected ? absl::OkStatus() : Wrong("a material file that is not that of the patches");
}

absl::Status CheckCarried(const v1::AssembleInput& input, const v1::WrittenFile& file, TileCheck how) {
  const std::string original = absl::StrCat(input.tile().root(), "/", file.path());
  TILEMEND_ASSIGN_OR_RETURN(const int64_t bytes, SizeOfFile(original));
  bool same = file.bytes() == bytes;
  if (same && how == TileCheck::kContent) {
    const auto theirs = DigestOfFile(absl::StrCat(input.attempts(), "/", file.attempt())), own = DigestOfFile(original);
    if (!theirs.ok() || !own.ok()) return absl::UnavailableError("a file beside the tile cannot be read");
    same = *theirs == *own;
  }
  const std::string digest = SurveyedDigest(input, file.path());
  same = same && (digest.empty() || file.digest().empty() || file.digest() == digest);
  if (same) return absl::OkStatus();
  const bool changed = !digest.empty() && !FileHasDigest(original, digest).value_or(false);
  return changed ? Changed(original) : Wrong("a file that is not the original");
}

// The image of the filled faces: which pixels it should have is not computed here.
absl::Status CheckTexture(const v1::AssembleInput& input, const v1::WrittenFile& file, TileCheck how) {
  if (!HasPatch(input)) return Wrong("an image without a patch");
  if (!IsFileDigest(file.digest())) return Wrong("a digest that is none");
  if (how != TileCheck::kContent) return absl::OkStatus();
  return CheckFile(absl::StrCat(input.attempts(), "/", file.attempt()), file.digest(),
                   Wrong("an image that is not as it was written"));
}

}  // namespace

// The files beside the tile: each is expected, once; what is left out has a warning.
absl::Status CheckBeside(const v1::AssembleInput& input, const v1::AssembleOutput& output, TileCheck how) {
  std::set<std::string> carried(input.carried().begin(), input.carried().end());
  const auto format = MeshFormatOf(input.output());
  bool has_library = HasPatch(input) && format.ok() && *format == MeshFormat::kObj && !input.without_colours();
  if (!has_library && !input.new_library() && !input.library().empty()) carried.insert(input.library());
  bool has_texture = HasTexture(input, output);
  const bool is_textured = has_texture;
  for (int i = 1; i < output.files_size(); ++i) {
    const v1::WrittenFile& file = output.files(i);
    if (has_texture && file.path() == input.texture()) {
      has_texture = false;
      TILEMEND_RETURN_IF_ERROR(CheckTexture(input, file, how));
      continue;
    }
    if (has_library && file.path() == input.library()) {
      has_library = false;
      TILEMEND_RETURN_IF_ERROR(CheckLibrary(input, file, is_textured));
      continue;
    }
    if (carried.erase(file.path()) == 0) return Wrong("a file that is not asked for");
    if (!IsOfTree(input, file.path()) || !IsPatched(input)) {
      TILEMEND_RETURN_IF_ERROR(CheckCarried(input, file, how));
    }
  }
  if (has_library) return Wrong("the material file of the patches is missing");
  return static_cast<int>(carried.size()) <= output.warnings_size() ? absl::OkStatus() : Wrong("a file is missing");
}

}  // namespace tilemend
