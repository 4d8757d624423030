#include "coordinator/jobs/assemble_check.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/rpc/level_payloads.h"
#include "common/rpc/tile_patch.h"
#include "common/store/digest.h"
#include "common/store/file_receipt.h"
#include "common/store/fingerprint.h"
#include "common/store/tile_stamp.h"
#include "common/util/file_pack.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"
#include "coordinator/jobs/delivery_check.h"
#include "coordinator/jobs/files_beside_check.h"
#include "coordinator/jobs/wrong_result.h"
#include "coordinator/store/attempt_folder.h"

namespace tilemend {
namespace {

constexpr int64_t kPieceBytes = int64_t{1} << 18;

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

// The tile as the attempt wrote it: a file, or of a tree the pack of all files, those of the original that were not
// written among them.
absl::StatusOr<std::string> WrittenTile(const v1::AssembleInput& input, const v1::AssembleOutput& output,
                                        const std::string& original) {
  const auto read = [&](const v1::WrittenFile& file) {
    return ReadFile(absl::StrCat(input.attempts(), "/", file.attempt()));
  };
  if (!IsTileTree(input.tile().path())) return read(output.files(0));
  TILEMEND_ASSIGN_OR_RETURN(std::vector<PackedFile> files, UnpackFiles(original, TilePath(input.tile())));
  std::map<std::string, std::string> written;
  for (const v1::WrittenFile& file : output.files()) {
    if (!IsOfTree(input, file.path())) continue;
    TILEMEND_ASSIGN_OR_RETURN(written[file.path()], read(file));
  }
  for (PackedFile& file : files) {
    const auto found = written.find(FileBesideTile(input.tile().path(), file.name));
    if (found != written.end()) file.bytes = found->second;
  }
  return PackFiles(files);
}

// The bytes that the tile is to have: the original with its patches, if it has any, which are put into it here once
// more. `textured` is what the attempt wrote if images may be laid on its patches.
absl::StatusOr<PatchedBytes> ExpectedTile(const v1::AssembleInput& input, const v1::AssembleOutput* textured) {
  const auto not_here = [](const absl::Status& status) { return absl::UnavailableError(status.message()); };
  std::string original;
  if (const std::string path = TilePath(input.tile()); !input.tile().path().empty()) {
    TILEMEND_ASSIGN_OR_RETURN(original, BytesOf(input.tile()));
    if (!TileHasStamp(path, input.stamp()) && !HasFileDigest(original, input.tile().digest())) {
      return Changed(path);
    }
  }
  if (!IsPatched(input)) return PatchedBytes{std::move(original)};
  auto added = TilePatchOf(input);
  if (!added.ok()) return not_here(added.status());
  if (textured != nullptr) {
    const auto bytes = WrittenTile(input, *textured, original);
    if (!bytes.ok()) return not_here(bytes.status());
    const absl::Status taken = TakeTexture(input, original, *bytes, *added);
    if (!taken.ok()) return Wrong("a tile that is not the original with its patches");
  }
  auto expected = PatchedTile(input, *added, original);
  if (added->paint && absl::IsInvalidArgument(expected.status())) {
    return Wrong("a tile that is not the original with its patches");
  }
  return expected.ok() ? std::move(expected) : not_here(expected.status());
}

// That a file of the attempt, and its digest, are those of the bytes that it is to have.
absl::Status CheckWritten(const v1::AssembleInput& input, const v1::WrittenFile& file, std::string_view expected) {
  if (!file.digest().empty() && !HasFileDigest(expected, file.digest()))
    return Wrong("a digest that is not the tile's");
  return CheckBytes(absl::StrCat(input.attempts(), "/", file.attempt()), expected);
}

absl::Status CheckContent(const v1::AssembleInput& input, const v1::AssembleOutput& output, TileReading& reading) {
  const v1::WrittenFile& tile = output.files(0);
  const MemoryBudget::Share share(reading.memory, kMemoryOfFile * tile.bytes());
  TILEMEND_ASSIGN_OR_RETURN(const PatchedBytes expected,
                            ExpectedTile(input, HasTexture(input, output) ? &output : nullptr));
  return CheckWritten(input, tile, expected.bytes);
}

// Of a tree: all of its files are written, each as it is to be.
absl::Status CheckTree(const v1::AssembleInput& input, const v1::AssembleOutput& output, TileReading& reading) {
  if (output.files(0).path() != input.output()) return Wrong("another tile");
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, TileSize(input.tile()));
  const MemoryBudget::Share share(reading.memory, kMemoryOfFile * size);
  PatchedBytes tile;
  std::map<std::string, std::string_view> expected;
  if (reading.how == TileCheck::kContent) {
    TILEMEND_ASSIGN_OR_RETURN(tile, ExpectedTile(input, input.texture().empty() ? nullptr : &output));
    TILEMEND_ASSIGN_OR_RETURN(const std::vector<LevelCounts> levels, FromProto(output.levels()));
    if (levels != tile.levels) return Wrong("other counts of levels of detail");
    TILEMEND_ASSIGN_OR_RETURN(const auto files, UnpackFiles(tile.bytes, TilePath(input.tile())));
    for (const PackedFile& file : files) expected[FileBesideTile(input.tile().path(), file.name)] = file.bytes;
  }
  for (const v1::WrittenFile& file : output.files()) {
    if (!IsOfTree(input, file.path()) || reading.how != TileCheck::kContent) continue;
    TILEMEND_RETURN_IF_ERROR(CheckWritten(input, file, expected[file.path()]));
  }
  return absl::OkStatus();
}

absl::Status CheckTile(const v1::AssembleInput& input, const v1::AssembleOutput& output, TileReading& reading) {
  const v1::WrittenFile& tile = output.files(0);
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
  return reading.how == TileCheck::kContent ? CheckContent(input, output, reading) : absl::OkStatus();
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
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<LevelCounts> levels, FromProto(output.levels()));
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<LevelCounts> known_levels, FromProto(input.known().levels()));
  if (levels != known_levels) return Wrong("other counts of levels of detail than are known");
  for (const v1::WrittenFile& file : known) {
    const std::string path = absl::StrCat(input.output_root(), "/", file.path());
    TILEMEND_ASSIGN_OR_RETURN(const int64_t bytes, SizeOfFile(path));
    if (bytes != file.bytes()) return Wrong("a file that is not as it was written");
    if (how != TileCheck::kContent || file.digest().empty()) continue;
    TILEMEND_RETURN_IF_ERROR(CheckFile(path, file.digest(), Wrong("a file that is not as it was written")));
  }
  return absl::OkStatus();
}

// Whether the file is a hard link of the scene's, which needs no digest.
bool IsLinked(const v1::AssembleInput& input, const v1::WrittenFile& file) {
  const auto original = ReceiptOf(absl::StrCat(input.tile().root(), "/", file.path()));
  const auto written = ReceiptOf(absl::StrCat(input.attempts(), "/", file.attempt()));
  return original.ok() && written.ok() && *original == *written;
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
    if (file.digest().empty() && !IsLinked(input, file)) return Wrong("a file without a digest");
  }
  if (!input.output_format().empty()) return CheckDelivery(input, output, reading.how);
  const bool is_tree = IsTileTree(input.tile().path());
  TILEMEND_RETURN_IF_ERROR(is_tree ? CheckTree(input, output, reading) : CheckTile(input, output, reading));
  return CheckBeside(input, output, reading.how);
}

}  // namespace tilemend
