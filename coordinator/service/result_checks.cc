#include "coordinator/service/result_checks.h"

#include <algorithm>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <span>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/mesh_file.h"
#include "common/codec/mtl.h"
#include "common/mesh/height_tally.h"
#include "common/records/patch_heights.h"
#include "common/rpc/clear_payloads.h"
#include "common/rpc/look_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/rpc/tile_patch.h"
#include "common/store/digest.h"
#include "common/store/fingerprint.h"
#include "common/store/tile_stamp.h"
#include "common/util/file_pack.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/memory_budget.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"
#include "coordinator/check/mesh_outline.h"
#include "coordinator/check/patch_check.h"
#include "coordinator/check/sample_check.h"
#include "coordinator/check/survey_check.h"
#include "coordinator/check/tile_check.h"
#include "coordinator/report/tile_checks.h"
#include "coordinator/service/attempt_folder.h"
#include "coordinator/service/smooth_check.h"
#include "coordinator/service/wrong_result.h"
#include "tilemend/v1/stages.pb.h"

namespace tilemend {
namespace {

// What is read of tiles, at once for all who report results.
struct TileReading {
  explicit TileReading(TileCheck tiles) : how(tiles) {}

  const TileCheck how;
  MemoryBudget memory{int64_t{48} << 20};
  const uint64_t key = uint64_t{std::random_device()()} << 32 | std::random_device()();
};

// Times the size of a tile's file: its bytes, and as a mesh or with its patches.
constexpr int64_t kMemoryOfFile = 2;

constexpr int64_t kPieceBytes = int64_t{1} << 18;

// As the worker was told, without the band, which no check needs.
template <typename Input>
absl::StatusOr<CellHoles> HolesOf(Input& input) {
  input.mutable_holes()->clear_band();
  return FromProto(input.holes());
}

template <typename T>
std::span<const T> Column(const google::protobuf::RepeatedField<T>& values) {
  return {values.data(), static_cast<size_t>(values.size())};
}

std::string PathOf(const v1::TileRef& tile) { return absl::StrCat(tile.root(), "/", tile.path()); }

absl::StatusOr<int64_t> SizeOf(const v1::TileRef& tile) {
  const auto size = SizeOfTile(PathOf(tile));
  return size.ok() ? size : absl::StatusOr<int64_t>(absl::UnavailableError(size.status().message()));
}

// As the worker reads it.
absl::StatusOr<std::string> BytesOf(const v1::TileRef& tile) {
  auto bytes = ReadTileBytes(PathOf(tile));
  return bytes.ok() ? std::move(bytes) : absl::StatusOr<std::string>(absl::UnavailableError(bytes.status().message()));
}

absl::Status CheckTileFile(const v1::TileRef& tile, const std::string& digest, const absl::Status& otherwise) {
  const auto same = TileHasDigest(PathOf(tile), digest);
  if (!same.ok()) return absl::UnavailableError(same.status().message());
  return *same ? absl::OkStatus() : otherwise;
}

absl::StatusOr<int64_t> SizeOfFile(const std::string& path) {
  const auto look = LookAt(path);
  if (!look.ok()) return absl::UnavailableError(look.status().message());
  return look->size;
}

absl::Status CheckFile(const std::string& path, const std::string& digest, const absl::Status& otherwise) {
  const auto same = FileHasDigest(path, digest);
  if (!same.ok()) return absl::UnavailableError(same.status().message());
  return *same ? absl::OkStatus() : otherwise;
}

bool HasOutline(const TriMesh& mesh, uint64_t key) {
  return OutlineSumOf(mesh, key).sum != 0 && !OutlineOf(mesh).empty();
}

// The mesh of a tile with these bytes, without what is taken out of it; `cleared`, if given, gets how much each area
// took.
absl::StatusOr<MeshFile> MeshOf(const v1::TileRef& tile, const std::string& bytes, std::vector<int64_t>* cleared) {
  if (tile.clear().empty()) {
    TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(tile.path()));
    return ParseMesh(format, bytes, PathOf(tile));
  }
  TILEMEND_ASSIGN_OR_RETURN(ClearedTile without, ClearTile(tile, bytes));
  if (cleared != nullptr) *cleared = std::move(without.triangles);
  return std::move(without.file);
}

// Without reading each tile: what only few tiles are said to be, and a look at the tile settles.
absl::Status CheckUnusual(const v1::SurveyInput& input, const SurveyRecord& record, TileReading& reading) {
  const bool closed = record.triangle_count > 0 && record.edges.empty();
  const auto& reach = input.reach();
  const bool outside =
      record.vertex_count > 0 && reach.size() == 4 &&
      (record.lo.x() < reach[0] || record.lo.y() < reach[1] || record.hi.x() > reach[2] || record.hi.y() > reach[3]);
  if (!closed && !outside) return absl::OkStatus();
  const std::string path = PathOf(input.tile());
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, SizeOf(input.tile()));
  const MemoryBudget::Share share(reading.memory, kMemoryOfFile * size);
  const auto bytes = BytesOf(input.tile());
  if (!bytes.ok()) return bytes.status();
  const auto file = MeshOf(input.tile(), *bytes, nullptr);
  if (!file.ok()) return absl::UnavailableError(file.status().message());
  if (closed && HasOutline(file->mesh, reading.key)) return Wrong("no boundary, where the tile has one");
  if (!outside) return absl::OkStatus();
  Eigen::AlignedBox3d bounds;
  for (const Point3& p : file->mesh.points) bounds.extend(p);
  return bounds.min() == record.lo && bounds.max() == record.hi ? absl::OkStatus()
                                                                : Wrong("bounds that are not the tile's");
}

// Of a tile that a worker read otherwise than it is here.
absl::Status Changed(const std::string& path) {
  return absl::UnavailableError(absl::StrCat(path, ": has just been changed, or the worker has another file there"));
}

// That a survey need not be made again.
absl::Status CheckSameSurvey(const v1::SurveyInput& input, const v1::SurveyOutput& output, TileCheck how) {
  absl::Status changed = Changed(PathOf(input.tile()));
  if (!input.has_known() || output.digest() != input.known().digest()) return Wrong("another tile than is known");
  TILEMEND_ASSIGN_OR_RETURN(const int64_t bytes, SizeOf(input.tile()));
  if (bytes != input.known().bytes()) return changed;
  if (how == TileCheck::kSize) return absl::OkStatus();
  return CheckTileFile(input.tile(), output.digest(), changed);
}

absl::Status OtherTile(const std::string& path, const v1::SurveyOutput& output) {
  if (TileHasStamp(path, output.stamp())) return Wrong("a digest that is not the tile's");
  return Changed(path);
}

// That the digest and the record are the tile's, unless that has changed since it was read.
absl::Status CheckSurveyedTile(const v1::SurveyInput& input, const v1::SurveyOutput& output, const SurveyRecord& record,
                               TileReading& reading) {
  const std::string path = PathOf(input.tile());
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, SizeOf(input.tile()));
  const MemoryBudget::Share share(reading.memory, kMemoryOfFile * size);
  const auto bytes = BytesOf(input.tile());
  if (!bytes.ok()) return bytes.status();
  if (!HasFileDigest(*bytes, output.digest())) return OtherTile(path, output);
  std::vector<int64_t> cleared;
  const auto file = MeshOf(input.tile(), *bytes, &cleared);
  if (!file.ok()) return Wrong("a survey of a tile that cannot be read");
  if (!std::ranges::equal(cleared, output.cleared())) return Wrong("other triangles taken out than are asked for");
  return AsWrong(CheckAgainstTile(record, file->mesh, file->number_type == NumberType::kFloat32, reading.key));
}

absl::Status CheckMeasureResult(const std::string& input_bytes, const std::string& output_bytes, TileReading& reading) {
  TILEMEND_ASSIGN_OR_RETURN(const auto input, ParseResult<v1::MeasureInput>(input_bytes));
  TILEMEND_ASSIGN_OR_RETURN(const auto output, ParseResult<v1::MeasureOutput>(output_bytes));
  if (!IsFileDigest(output.digest())) return Wrong("a digest that is none");
  if (output.tallies_size() != input.areas_size()) return Wrong("heights of other polygons");
  for (const v1::HeightTally& tally : output.tallies()) TILEMEND_RETURN_IF_ERROR(AsWrong(FromProto(tally).status()));
  if (reading.how != TileCheck::kContent) return absl::OkStatus();
  const std::string path = PathOf(input.tile());
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, SizeOf(input.tile()));
  const MemoryBudget::Share share(reading.memory, kMemoryOfFile * size);
  const auto bytes = BytesOf(input.tile());
  if (!bytes.ok()) return bytes.status();
  if (!HasFileDigest(*bytes, output.digest())) return Changed(path);
  const auto file = MeshOf(input.tile(), *bytes, nullptr);
  if (!file.ok()) return Wrong("heights of a tile that cannot be read");
  for (int i = 0; i < input.areas_size(); ++i) {
    TILEMEND_ASSIGN_OR_RETURN(const ClearArea area, FromProto(input.areas(i)));
    TILEMEND_ASSIGN_OR_RETURN(const HeightTally told, FromProto(output.tallies(i)));
    if (TallyHeights(file->mesh, area.polygon).area_of_bin != told.area_of_bin) return Wrong("heights of another tile");
  }
  return absl::OkStatus();
}

// Of a tree: the files that it says to have are those of its folder. No other tile may name such files: they would be
// written over that tile.
absl::Status CheckFilesOfTree(const v1::SurveyInput& input, const v1::TileFiles& files) {
  const std::string& tile = input.tile().path();
  for (const auto* list : {&files.libraries(), &files.images()}) {
    for (const std::string& path : *list) {
      if (!IsTileTree(path)) continue;
      const bool is_own = IsTileTree(tile) && path == FileBesideTile(tile, path.substr(path.rfind('/') + 1));
      if (!is_own || path == tile) return Wrong("a file of another tile");
    }
  }
  return absl::OkStatus();
}

absl::Status CheckSurveyResult(const std::string& input_bytes, const std::string& output_bytes, TileReading& reading) {
  TILEMEND_ASSIGN_OR_RETURN(const auto input, ParseResult<v1::SurveyInput>(input_bytes));
  TILEMEND_ASSIGN_OR_RETURN(const auto output, ParseResult<v1::SurveyOutput>(output_bytes));
  if (!IsFileDigest(output.digest())) return Wrong("a digest that is none");
  if (output.unchanged()) return CheckSameSurvey(input, output, reading.how);
  if (output.cleared_size() != input.tile().clear_size()) return Wrong("counts of other areas");
  if (output.witness().digest() != output.digest()) return Wrong("a witness of another tile");
  TILEMEND_RETURN_IF_ERROR(AsWrong(FromProto(output.files()).status()));
  TILEMEND_RETURN_IF_ERROR(CheckFilesOfTree(input, output.files()));
  const auto record = FromProto(output);
  if (!record.ok()) return AsWrong(record.status());
  TILEMEND_ASSIGN_OR_RETURN(const int64_t bytes, SizeOf(input.tile()));
  TILEMEND_RETURN_IF_ERROR(AsWrong(CheckSurvey(*record, bytes)));
  if (reading.how == TileCheck::kContent) return CheckSurveyedTile(input, output, *record, reading);
  if (reading.how == TileCheck::kDigest) {
    const std::string path = PathOf(input.tile());
    TILEMEND_RETURN_IF_ERROR(CheckTileFile(input.tile(), output.digest(), OtherTile(path, output)));
  }
  return CheckUnusual(input, *record, reading);
}

absl::Status CheckGroundResult(const std::string& input_bytes, const std::string& output_bytes) {
  TILEMEND_ASSIGN_OR_RETURN(const auto input, ParseResult<v1::GroundInput>(input_bytes));
  TILEMEND_ASSIGN_OR_RETURN(const auto output, ParseResult<v1::GroundOutput>(output_bytes));
  const int n = input.position_size() / 3;
  if (output.on_object_size() == n && output.ground_size() == n) return absl::OkStatus();
  return Wrong("not a value for each boundary vertex");
}

absl::Status CheckClusterResult(const std::string& input_bytes, const std::string& output_bytes) {
  TILEMEND_ASSIGN_OR_RETURN(auto input, ParseResult<v1::SampleClusterInput>(input_bytes));
  TILEMEND_ASSIGN_OR_RETURN(const auto output, ParseResult<v1::SampleClusterOutput>(output_bytes));
  TILEMEND_ASSIGN_OR_RETURN(const CellHoles asked, HolesOf(input));
  if (output.cluster() != input.cluster()) return Wrong("another cluster");
  if (output.has_hold_out()) TILEMEND_RETURN_IF_ERROR(AsWrong(FromProto(output.hold_out()).status()));
  return AsWrong(
      CheckClusterSamples(asked, {Column(output.seam_vertex()), Column(output.height()), Column(output.laplacian()),
                                  Column(output.slope_x()), Column(output.slope_y())}));
}

absl::Status CheckLayerResult(const std::string& input_bytes, const std::string& output_bytes) {
  TILEMEND_ASSIGN_OR_RETURN(auto input, ParseResult<v1::SampleLayerInput>(input_bytes));
  TILEMEND_ASSIGN_OR_RETURN(const auto output, ParseResult<v1::SampleLayerOutput>(output_bytes));
  TILEMEND_ASSIGN_OR_RETURN(const CellHoles asked, HolesOf(input));
  return AsWrong(CheckLayerSamples(asked, Column(output.seam_vertex()), Column(output.height())));
}

absl::Status CheckFillResult(const std::string& input_bytes, const std::string& output_bytes) {
  TILEMEND_ASSIGN_OR_RETURN(auto input, ParseResult<v1::FillInput>(input_bytes));
  TILEMEND_ASSIGN_OR_RETURN(const auto output, ParseResult<v1::FillOutput>(output_bytes));
  TILEMEND_ASSIGN_OR_RETURN(CellHoles asked, HolesOf(input));
  if (output.has_samples() != input.has_sampled()) return Wrong("samples without their holes, or none");
  if (input.has_sampled()) {
    TILEMEND_ASSIGN_OR_RETURN(const CellHoles sampled, FromProto(input.sampled()));
    const auto seam_vertex = Column(output.samples().seam_vertex());
    const auto height = Column(output.samples().height());
    TILEMEND_RETURN_IF_ERROR(AsWrong(CheckLayerSamples(sampled, seam_vertex, height)));
    TakeSampledHeights(seam_vertex, height, asked);
  }
  const auto patches = FromProto(output, asked.vertices.size());
  if (!patches.ok()) return AsWrong(patches.status());
  const auto quality = FromProto(output.quality());
  if (!quality.ok()) return AsWrong(quality.status());
  return AsWrong(CheckPatches(asked, *patches, *quality));
}

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
  if (const std::string path = PathOf(input.tile()); !input.tile().path().empty()) {
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
  if (tile.empty() || !IsTileTree(tile) || !IsTileTree(path)) return false;
  return path == FileBesideTile(tile, path.substr(path.rfind('/') + 1));
}

// Of a tree: all of its files are written, each as it is to be.
absl::Status CheckTree(const v1::AssembleInput& input, const v1::AssembleOutput& output, TileReading& reading) {
  if (output.files(0).path() != input.output()) return Wrong("another tile");
  TILEMEND_ASSIGN_OR_RETURN(const int64_t size, SizeOf(input.tile()));
  const MemoryBudget::Share share(reading.memory, kMemoryOfFile * size);
  std::string pack;
  std::map<std::string, std::string_view> expected;
  if (reading.how == TileCheck::kContent) {
    TILEMEND_ASSIGN_OR_RETURN(pack, ExpectedTile(input));
    TILEMEND_ASSIGN_OR_RETURN(const auto files, UnpackFiles(pack, PathOf(input.tile())));
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
    TILEMEND_ASSIGN_OR_RETURN(const int64_t original, SizeOf(input.tile()));
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

absl::Status CheckAssembleResult(const std::string& input_bytes, const std::string& output_bytes,
                                 TileReading& reading) {
  TILEMEND_ASSIGN_OR_RETURN(const auto input, ParseResult<v1::AssembleInput>(input_bytes));
  TILEMEND_ASSIGN_OR_RETURN(const auto output, ParseResult<v1::AssembleOutput>(output_bytes));
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

}  // namespace

ResultCheck SceneResultCheck(TileCheck tiles) {
  return [reading = std::make_shared<TileReading>(tiles)](Stage stage, const std::string& input,
                                                          const std::string& output) {
    switch (stage) {
      case Stage::kMeasure:
        return CheckMeasureResult(input, output, *reading);
      case Stage::kSurvey:
        return CheckSurveyResult(input, output, *reading);
      case Stage::kGround:
        return CheckGroundResult(input, output);
      case Stage::kSampleCluster:
        return CheckClusterResult(input, output);
      case Stage::kSampleLayer:
        return CheckLayerResult(input, output);
      case Stage::kFill:
        return CheckFillResult(input, output);
      case Stage::kSmoothSeam:
        return CheckSmoothResult(input, output);
      case Stage::kAssemble:
        return CheckAssembleResult(input, output, *reading);
    }
    return absl::InternalError("unknown stage");
  };
}

}  // namespace tilemend
