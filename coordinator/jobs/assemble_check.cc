#include "coordinator/jobs/assemble_check.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/codec/mesh_file.h"
#include "common/codec/mtl.h"
#include "common/rpc/look_payloads.h"
#include "common/rpc/tile_patch.h"
#include "common/store/digest.h"
#include "common/store/fingerprint.h"
#include "common/store/tile_stamp.h"
#include "common/util/file_pack.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"
#include "coordinator/jobs/wrong_result.h"
#include "coordinator/store/attempt_folder.h"

namespace tilemend {
namespace {

constexpr int64_t kPieceBytes = int64_t{1} << 18;

bool HasPatch(const v1::AssembleInput& input) {
  const auto& patches = input.patches().patches();
  return std::any_of(patches.begin(), patches.end(),
                     [](const v1::PatchExtent& patch) { return patch.triangles() > 0; });
}

// Whether the tile is to be another than the original.
bool IsPatched(const v1::AssembleInput& input) {
  return input.tile().path().empty() || !input.tile().clear().empty() || HasPatch(input);
}

// Whether a file of the attempt has these bytes.
absl::Status CheckBytes(const std::string& path, std::string_view expected) {
  bool same = true;
  const absl::Status read = ReadInPieces(path, kPieceBytes, [&](std::string_view piece) {
    same = same && expected.substr(0, piece.size()) == piece;
    expected.remove_prefix(std::min(piece.size(), expected.size()));
  });
  if (!read.ok()) return absl::UnavailableError(read.message());
  return same && expected.empty() ? absl::OkStatus() : Wrong("a tile that is not the original with its patches");
}

// The bytes that the tile is to have: the original with its patches, if it has any, which are put into it here once
// more.
absl::StatusOr<std::string> ExpectedTile(const v1::AssembleInput& input) {
  const auto not_here = [](const absl::Status& status) { return absl::UnavailableError(status.message()); };
  std::string original;
  if (const std::string path = TilePath(input.tile()); !input.tile().path().empty()) {
    TILEMEND_ASSIGN_OR_RETURN(original, BytesOf(input.tile()));
    if (!TileHasStamp(path, input.stamp()) && !HasFileDigest(original, input.tile().digest())) {
      return Changed(path);
    }
  }
  if (!IsPatched(input)) return original;
  const auto added = TilePatchOf(input);
  if (!added.ok()) return not_here(added.status());
  auto expected = PatchedTile(input, *added, original);
  return expected.ok() ? std::move(expected) : not_here(expected.status());
}

// That a file of the attempt, and its digest, are those of the bytes that it is to have.
absl::Status CheckWritten(const v1::AssembleInput& input, const v1::WrittenFile& file, std::string_view expected) {
  if (!file.digest().empty() && !HasFileDigest(expected, file.digest()))
    return Wrong("a digest that is not the tile's");
  return CheckBytes(absl::StrCat(input.attempts(), "/", file.attempt()), expected);
}

absl::Status CheckContent(const v1::AssembleInput& input, const v1::WrittenFile& tile, TileReading& reading) {
  const MemoryBudget::Share share(reading.memory, kMemoryOfFile * tile.bytes());
  TILEMEND_ASSIGN_OR_RETURN(const std::string expected, ExpectedTile(input));
  return CheckWritten(input, tile, expected);
}

// Whether a file of the output belongs to a tile that is a tree of files.
bool IsOfTree(const v1::AssembleInput& input, const std::string& path) {
  const std::string& tile = input.tile().path();
  return !tile.empty() && IsTileTree(tile) && IsFileOfTree(tile, path);
}

// Of a tree: all of its files are written, each as it is to be.
absl::Status CheckTree(const v1::AssembleInput& input, const v1::AssembleOutput& output, TileReading& reading) {
  if (output.files(0).path() != input.output()) return Wrong("another tile");
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, TileSize(input.tile()));
  const MemoryBudget::Share share(reading.memory, kMemoryOfFile * size);
  std::string pack;
  std::map<std::string, std::string_view> expected;
  if (reading.how == TileCheck::kContent) {
    TILEMEND_ASSIGN_OR_RETURN(pack, ExpectedTile(input));
    TILEMEND_ASSIGN_OR_RETURN(const auto files, UnpackFiles(pack, TilePath(input.tile())));
    for (const PackedFile& file : files) expected[FileBesideTile(input.tile().path(), file.name)] = file.bytes;
  }
  for (const v1::WrittenFile& file : output.files()) {
    if (!IsOfTree(input, file.path())) continue;
    const std::string written = absl::StrCat(input.attempts(), "/", file.attempt());
    if (reading.how == TileCheck::kContent) {
      TILEMEND_RETURN_IF_ERROR(CheckWritten(input, file, expected[file.path()]));
    } else if (reading.how == TileCheck::kDigest && !file.digest().empty()) {
      TILEMEND_RETURN_IF_ERROR(CheckFile(written, file.digest(), Wrong("a tile that is not as it was written")));
    }
  }
  return absl::OkStatus();
}

absl::Status CheckTile(const v1::AssembleInput& input, const v1::WrittenFile& tile, TileReading& reading) {
  if (tile.path() != input.output()) return Wrong("another tile");
  if (!IsFileDigest(tile.digest())) return Wrong("a digest that is none");
  const bool patched = IsPatched(input);
  if (!input.tile().path().empty()) {
    TILEMEND_ASSIGN_OR_RETURN(const int64_t original, TileSize(input.tile()));
    const bool grows = patched && input.tile().clear().empty();
    if (grows ? tile.bytes() <= original : !patched && tile.bytes() != original)
      return Wrong("a tile that is not the original with its patches");
    if (!patched && tile.digest() != input.tile().digest()) return Wrong("a tile that is not the original");
  }
  if (reading.how == TileCheck::kSize) return absl::OkStatus();
  if (reading.how == TileCheck::kContent) return CheckContent(input, tile, reading);
  return CheckFile(absl::StrCat(input.attempts(), "/", tile.attempt()), tile.digest(),
                   Wrong("a tile that is not as it was written"));
}

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
absl::StatusOr<std::string> LibraryOf(const v1::AssembleInput& input) {
  TILEMEND_ASSIGN_OR_RETURN(const FillColours colours, ColoursOf(input));
  std::string original;
  if (!input.new_library()) {
    const std::string path = absl::StrCat(input.tile().root(), "/", input.library());
    const auto read = ReadFile(path);
    if (!read.ok()) return absl::UnavailableError(read.status().message());
    original = *read;
    if (!IsAsSurveyed(original, input.library_digest())) return Changed(path);
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

absl::Status CheckLibrary(const v1::AssembleInput& input, const v1::WrittenFile& file) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string expected, LibraryOf(input));
  const auto written = ReadFile(absl::StrCat(input.attempts(), "/", file.attempt()));
  if (!written.ok()) return absl::UnavailableError(written.status().message());
  return *written == expected ? absl::OkStatus() : Wrong("a material file that is not that of the patches");
}

absl::Status CheckCarried(const v1::AssembleInput& input, const v1::WrittenFile& file, TileCheck how) {
  const std::string original = absl::StrCat(input.tile().root(), "/", file.path());
  TILEMEND_ASSIGN_OR_RETURN(const int64_t bytes, SizeOfFile(original));
  bool same = file.bytes() == bytes;
  if (same && how != TileCheck::kSize) {
    const auto theirs = DigestOfFile(absl::StrCat(input.attempts(), "/", file.attempt())), own = DigestOfFile(original);
    if (!theirs.ok() || !own.ok()) return absl::UnavailableError("a file beside the tile cannot be read");
    same = *theirs == *own;
  }
  if (same) return absl::OkStatus();
  const std::string digest = SurveyedDigest(input, file.path());
  const bool changed = !digest.empty() && !FileHasDigest(original, digest).value_or(false);
  return changed ? Changed(original) : Wrong("a file that is not the original");
}

// The files beside the tile: each is expected, once; what is left out has a warning.
absl::Status CheckBeside(const v1::AssembleInput& input, const v1::AssembleOutput& output, TileCheck how) {
  std::set<std::string> carried(input.carried().begin(), input.carried().end());
  const auto format = MeshFormatOf(input.output());
  bool has_library = HasPatch(input) && format.ok() && *format == MeshFormat::kObj;
  if (!has_library && !input.new_library() && !input.library().empty()) carried.insert(input.library());
  for (int i = 1; i < output.files_size(); ++i) {
    const v1::WrittenFile& file = output.files(i);
    if (has_library && file.path() == input.library()) {
      has_library = false;
      TILEMEND_RETURN_IF_ERROR(CheckLibrary(input, file));
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

// That nothing had to be written.
absl::Status CheckSameFiles(const v1::AssembleInput& input, const v1::AssembleOutput& output, TileCheck how) {
  const auto& known = input.known().files();
  const auto same = [](const v1::WrittenFile& a, const v1::WrittenFile& b) {
    return a.path() == b.path() && a.bytes() == b.bytes() && a.digest() == b.digest();
  };
  if (!std::equal(known.begin(), known.end(), output.files().begin(), output.files().end(), same)) {
    return Wrong("other files than are known");
  }
  for (const v1::WrittenFile& file : known) {
    const std::string path = absl::StrCat(input.output_root(), "/", file.path());
    TILEMEND_ASSIGN_OR_RETURN(const int64_t bytes, SizeOfFile(path));
    if (bytes != file.bytes()) return Wrong("a file that is not as it was written");
    if (how == TileCheck::kSize || file.digest().empty()) continue;
    TILEMEND_RETURN_IF_ERROR(CheckFile(path, file.digest(), Wrong("a file that is not as it was written")));
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status CheckAssembleResult(const std::string& input_bytes, const v1::AssembleOutput& output,
                                 TileReading& reading) {
  TILEMEND_ASSIGN_OR_RETURN(const auto input, ParseResult<v1::AssembleInput>(input_bytes));
  if (output.files().empty()) return Wrong("no tile");
  if (output.unchanged()) return CheckSameFiles(input, output, reading.how);
  for (const v1::WrittenFile& file : output.files()) {
    const absl::Status there = AttemptFolder::Check(input.attempts(), {file.attempt(), file.path(), file.bytes()});
    TILEMEND_RETURN_IF_ERROR(absl::IsInvalidArgument(there) ? AsWrong(there) : there);
  }
  const bool is_tree = IsTileTree(input.tile().path());
  TILEMEND_RETURN_IF_ERROR(is_tree ? CheckTree(input, output, reading) : CheckTile(input, output.files(0), reading));
  return CheckBeside(input, output, reading.how);
}

}  // namespace tilemend
