#include "worker/service/scene_stages.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/codec/mesh_file.h"
#include "common/options/job_options.h"
#include "common/records/patch_heights.h"
#include "common/rpc/ground_payloads.h"
#include "common/rpc/level_payloads.h"
#include "common/rpc/look_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/rpc/surface_payloads.h"
#include "common/rpc/tile_patch.h"
#include "common/store/digest.h"
#include "common/store/fingerprint.h"
#include "common/store/tile_stamp.h"
#include "common/util/cores.h"
#include "common/util/file_pack.h"
#include "common/util/files.h"
#include "common/util/folders.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"
#include "tilemend/v1/stages.pb.h"
#include "tilemend/v1/verify.pb.h"
#include "worker/fill/fill_holes.h"
#include "worker/fill/fill_memory.h"
#include "worker/fill/seam/sample_cluster.h"
#include "worker/fill/seam/sample_heights.h"
#include "worker/fill/shape/patch_quality.h"
#include "worker/fill/space/surface_index.h"
#include "worker/ground/rim_objects.h"
#include "worker/materials/write_materials.h"
#include "worker/service/attempt_files.h"
#include "worker/service/delivery_stage.h"
#include "worker/service/fill_options.h"
#include "worker/service/smooth_stage.h"
#include "worker/service/survey_stage.h"
#include "worker/service/task_memory.h"
#include "worker/service/texture_stage.h"
#include "worker/service/tile_reading.h"
#include "worker/service/verify_stage.h"

namespace tilemend {
namespace {

template <typename Message>
absl::StatusOr<Message> Parse(const std::string& bytes) {
  Message message;
  if (!message.ParseFromString(bytes)) return absl::InvalidArgumentError("malformed payload: not the expected message");
  return message;
}

absl::StatusOr<std::string> RunGround(const v1::GroundInput& input, TaskMemory& memory) {
  if (input.position_size() % 3 != 0) return absl::InvalidArgumentError("malformed payload: positions");
  std::vector<Point3> vertices;
  for (int i = 0; i < input.position_size(); i += 3) {
    vertices.emplace_back(input.position(i), input.position(i + 1), input.position(i + 2));
  }
  const HeldMemory held(memory.tasks, GroundMemory(input));
  std::vector<GroundRaster> rasters;
  for (const v1::GroundRasterBlob& blob : input.rasters()) {
    TILEMEND_ASSIGN_OR_RETURN(rasters.emplace_back(), FromProto(blob));
    if (rasters.back().square != rasters[0].square) {
      return absl::InvalidArgumentError("malformed payload: ground rasters of several sizes of squares");
    }
  }
  return ToProto(GroundAtRim(vertices, rasters)).SerializeAsString();
}

absl::StatusOr<FillOptions> OptionsOf(const v1::JobSpec& sent, const CancelToken& cancel) {
  const v1::JobSpec spec = WithDefaults(sent);
  TILEMEND_RETURN_IF_ERROR(CheckOptionsForWorkers(spec));
  FillOptions options = FillOptionsOf(spec);
  options.refine.is_cancelled = [&cancel] { return cancel.cancelled(); };
  return options;
}

absl::StatusOr<std::string> RunSampleCluster(const v1::SampleClusterInput& input, const CancelToken& cancel,
                                             TaskMemory& memory) {
  TILEMEND_ASSIGN_OR_RETURN(const CellHoles holes, FromProto(input.holes()));
  v1::SampleClusterOutput output;
  output.set_cluster(input.cluster());
  TILEMEND_ASSIGN_OR_RETURN(const FillOptions options, OptionsOf(input.options(), cancel));
  const HeldMemory held(memory.tasks, SampleMemory(holes, options));
  if (cancel.cancelled()) return absl::CancelledError("cancelled");
  const std::optional<ClusterSurface> surface = SampleCluster(holes, options);
  if (cancel.cancelled()) return absl::CancelledError("cancelled");
  if (!surface) return output.SerializeAsString();
  if (surface->hold_out) *output.mutable_hold_out() = ToProto(*surface->hold_out);
  for (const SurfaceSample& sample : surface->samples) {
    output.add_seam_vertex(sample.seam_vertex);
    output.add_height(sample.height);
    output.add_laplacian(sample.laplacian);
    output.add_slope_x(sample.slope.x());
    output.add_slope_y(sample.slope.y());
  }
  return output.SerializeAsString();
}

absl::StatusOr<v1::SampleLayerOutput> Sample(const v1::CellHolesBlob& input) {
  TILEMEND_ASSIGN_OR_RETURN(const CellHoles holes, FromProto(input));
  v1::SampleLayerOutput output;
  for (const HeightSample& sample : SampleHeights(holes)) {
    output.add_seam_vertex(sample.seam_vertex);
    output.add_height(sample.height);
  }
  return output;
}

absl::StatusOr<std::string> RunSampleLayer(const v1::SampleLayerInput& input) {
  TILEMEND_ASSIGN_OR_RETURN(const v1::SampleLayerOutput output, Sample(input.holes()));
  return output.SerializeAsString();
}

template <typename T>
std::span<const T> Column(const google::protobuf::RepeatedField<T>& values) {
  return {values.data(), static_cast<size_t>(values.size())};
}

// The surface of tiles, read when it is first asked for.
class TileSurface {
 public:
  TileSurface(const v1::FillInput& input, MemoryBudget& memory) : input_(input), memory_(memory) {}

  std::vector<SpaceTriangle> Near(const Point3& lo, const Point3& hi) {
    std::vector<SpaceTriangle> found;
    if (!held_) status_ = Read();
    for (const SurfaceIndex& tile : tiles_) tile.AppendNear(lo, hi, found);
    return found;
  }

  // Not OK if a tile could not be read: what was found near then counts for nothing.
  const absl::Status& status() const { return status_; }

 private:
  absl::Status Read() {
    int64_t all = 0;
    for (const v1::TileRef& tile : input_.surface()) all += SurfaceMemory(PathOf(tile));
    held_.emplace(memory_, all);
    for (const v1::TileRef& tile : input_.surface()) {
      TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, ReadSurveyed(tile));
      TILEMEND_ASSIGN_OR_RETURN(MeshFile file, MeshOf(tile, bytes));
      tiles_.emplace_back(meshes_.emplace_back(std::move(file.mesh)));
    }
    return absl::OkStatus();
  }

  const v1::FillInput& input_;
  MemoryBudget& memory_;
  std::optional<HeldMemory> held_;  // goes after the tiles
  std::deque<TriMesh> meshes_;
  std::vector<SurfaceIndex> tiles_;
  absl::Status status_;
};

absl::StatusOr<std::string> RunFill(const v1::FillInput& input, const CancelToken& cancel, TaskMemory& memory) {
  TILEMEND_ASSIGN_OR_RETURN(CellHoles holes, FromProto(input.holes()));
  v1::SampleLayerOutput samples;
  if (input.has_sampled()) {
    TILEMEND_ASSIGN_OR_RETURN(samples, Sample(input.sampled()));
    TakeSampledHeights(Column(samples.seam_vertex()), Column(samples.height()), holes);
  }
  TILEMEND_ASSIGN_OR_RETURN(const FillOptions options, OptionsOf(input.options(), cancel));
  const HeldMemory held(memory.tasks, FillMemory(holes, options));
  if (cancel.cancelled()) return absl::CancelledError("cancelled");
  TileSurface surface(input, memory.surfaces);
  const std::vector<HolePatch> patches =
      FillHoles(holes, options, [&](const Point3& lo, const Point3& hi) { return surface.Near(lo, hi); });
  if (cancel.cancelled()) return absl::CancelledError("cancelled");
  TILEMEND_RETURN_IF_ERROR(surface.status());
  v1::FillOutput output = ToProto(patches, holes.vertices, holes.lattice_step);
  *output.mutable_quality() = ToProto(TallyQuality(holes, patches));
  if (input.has_sampled()) *output.mutable_samples() = std::move(samples);
  return output.SerializeAsString();
}

struct Assembled {
  bool as_it_is = false;                           // the original without a change; else:
  std::string bytes = {};                          // of the tile
  std::map<std::string, std::string> beside = {};  // of a tree: its other files that are changed, by path
  std::vector<FillMaterial> materials = {};  // of its filled faces; empty: it has none, or its format has no materials
  std::string image = {};                    // of its filled faces, a JPEG; empty: there is none
  std::vector<std::string> warnings = {};
  std::vector<LevelCounts> levels = {};  // of a tree
};

void SetLevels(const std::vector<LevelCounts>& levels, v1::AssembleOutput& output) {
  for (const LevelCounts& level : levels) *output.add_levels() = ToProto(level);
}

// Takes the files of a changed tree apart.
absl::Status TakeTreeApart(const v1::AssembleInput& input, const std::string& original, Assembled& tile) {
  const std::string pack = std::move(tile.bytes);
  TILEMEND_ASSIGN_OR_RETURN(const auto before, UnpackFiles(original, PathOf(input.tile())));
  TILEMEND_ASSIGN_OR_RETURN(const auto after, UnpackFiles(pack, PathOf(input.tile())));
  tile.bytes = after[0].bytes;
  for (size_t f = 1; f < after.size(); ++f) {
    if (after[f].bytes == before[f].bytes) continue;
    tile.beside[FileBesideTile(input.tile().path(), after[f].name)] = after[f].bytes;
  }
  return absl::OkStatus();
}

// Makes the texture of the patch and lays it on; what is left is its image beside the tile and the warnings.
absl::StatusOr<FillTexture> LayTexture(const v1::AssembleInput& input, const CancelToken& cancel, TaskMemory& memory,
                                       TilePatch& added) {
  TILEMEND_ASSIGN_OR_RETURN(FillTexture texture, TextureOf(input, added, memory, cancel));
  if (!texture.image.empty()) SetTexture(input, std::move(texture.places), std::move(texture.corners), added);
  added.paint = std::move(texture.paint);
  return texture;
}

// The tile in another format.
absl::StatusOr<Delivered> AssembleDelivery(const v1::AssembleInput& input, const CancelToken& cancel,
                                           TaskMemory& memory) {
  TILEMEND_ASSIGN_OR_RETURN(TilePatch added, TilePatchOf(input));
  const bool has_tile = !input.tile().path().empty();
  if (!has_tile) return DeliverTile(input, {"", &added, {}, ""});
  TILEMEND_ASSIGN_OR_RETURN(std::string bytes, ReadSurveyed(input.tile(), input.stamp()));
  TILEMEND_ASSIGN_OR_RETURN(FillTexture texture, LayTexture(input, cancel, memory, added));
  std::vector<LevelCounts> levels;
  std::vector<int32_t> new_geometries;
  std::vector<std::string> warnings = std::move(texture.warnings);
  if (!added.patch.triangles.empty() || !input.tile().clear().empty()) {
    TILEMEND_ASSIGN_OR_RETURN(PatchedBytes patched, PatchedTile(input, added, bytes));
    bytes = std::move(patched.bytes);
    levels = std::move(patched.levels);
    new_geometries = std::move(patched.new_geometries);
    std::ranges::move(patched.warnings, std::back_inserter(warnings));
  }
  TILEMEND_ASSIGN_OR_RETURN(Delivered delivered,
                            DeliverTile(input, {bytes, nullptr, added.materials, texture.image, new_geometries}));
  delivered.levels = std::move(levels);
  std::ranges::move(warnings, std::back_inserter(delivered.warnings));
  return delivered;
}

absl::StatusOr<std::string> RunDelivery(const v1::AssembleInput& input, const CancelToken& cancel, TaskMemory& memory) {
  TILEMEND_ASSIGN_OR_RETURN(const Delivered delivered, AssembleDelivery(input, cancel, memory));
  v1::AssembleOutput output;
  output.mutable_warnings()->Add(delivered.warnings.begin(), delivered.warnings.end());
  SetLevels(delivered.levels, output);
  AttemptFiles files(input.attempts(), input.output_root());
  // The tile last: before its other files are there nobody can read it.
  for (size_t f = delivered.files.size(); f-- > 0;) {
    if (cancel.cancelled()) return absl::CancelledError("cancelled");
    const DeliveryFile& file = delivered.files[f];
    TILEMEND_RETURN_IF_ERROR(files.Write(FileBesideTile(input.output(), file.name), file.bytes));
  }
  for (v1::WrittenFile& file : files.Keep()) *output.add_files() = std::move(file);
  return output.SerializeAsString();
}

// The tile with its patches.
absl::StatusOr<Assembled> AssembleTile(const v1::AssembleInput& input, const CancelToken& cancel, TaskMemory& memory) {
  TILEMEND_ASSIGN_OR_RETURN(TilePatch added, TilePatchOf(input));
  const bool has_tile = !input.tile().path().empty();
  const bool is_cleared = !input.tile().clear().empty();
  if (has_tile && !is_cleared && added.patch.triangles.empty()) return Assembled{.as_it_is = true};
  std::string original;
  if (has_tile) {
    TILEMEND_ASSIGN_OR_RETURN(original, ReadSurveyed(input.tile(), input.stamp()));
  }
  Assembled result;
  TILEMEND_ASSIGN_OR_RETURN(FillTexture texture, LayTexture(input, cancel, memory, added));
  result.warnings = std::move(texture.warnings);
  result.image = std::move(texture.image);
  TILEMEND_ASSIGN_OR_RETURN(PatchedBytes patched, PatchedTile(input, added, original));
  result.bytes = std::move(patched.bytes);
  result.levels = std::move(patched.levels);
  std::ranges::move(patched.warnings, std::back_inserter(result.warnings));
  if (has_tile && IsTileTree(input.tile().path())) {
    TILEMEND_RETURN_IF_ERROR(TakeTreeApart(input, original, result));
  } else {
    result.materials = std::move(added.materials);
  }
  return result;
}

// Of the files beside the tile that were read for the survey, by path.
std::map<std::string, std::string> DigestsBeside(const v1::AssembleInput& input) {
  std::map<std::string, std::string> digests;
  const int known = std::min(input.carried_size(), input.carried_digests_size());
  for (int i = 0; i < known; ++i) digests[input.carried(i)] = input.carried_digests(i);
  digests[input.library()] = input.library_digest();
  return digests;
}

// Writes the material file of the tile's filled faces, and carries what it names.
absl::StatusOr<std::vector<std::string>> WriteFilesBeside(const v1::AssembleInput& input, const Assembled& tile,
                                                          AttemptFiles& files) {
  const std::string& root = input.tile().root();
  const std::vector<FillMaterial>& materials = tile.materials;
  std::vector<std::string> carried;
  for (const std::string& path : input.carried()) {
    if (const auto changed = tile.beside.find(path); changed != tile.beside.end()) {
      TILEMEND_RETURN_IF_ERROR(files.Write(path, changed->second));
    } else {
      carried.push_back(path);
    }
  }
  std::map<std::string, std::string> digests = DigestsBeside(input);
  if (!materials.empty()) {
    const std::string from = input.new_library() ? "" : absl::StrCat(root, "/", input.library());
    TILEMEND_ASSIGN_OR_RETURN(const std::string text, MaterialsAfter(from, materials, input.library_digest()));
    TILEMEND_RETURN_IF_ERROR(files.Write(input.library(), text));
  } else if (!input.new_library() && !input.library().empty()) {
    carried.push_back(input.library());
  }
  const auto carry = [&](const std::string& from, const std::string& path, Carry how) {
    TILEMEND_RETURN_IF_ERROR(files.Carry(from, path, how));
    const std::string& digest = digests[path];
    // A link shows what becomes of the original anyhow.
    const bool as_surveyed = how == Carry::kLink || digest.empty() || files.LastHas(digest);
    return as_surveyed ? absl::OkStatus() : ChangedInJob(from);
  };
  return CarryFiles(root, carried, input.link_images(), carry);
}

// The tile as it is: no byte of it comes here if it is known to be unchanged.
absl::Status CarryTile(const v1::AssembleInput& input, AttemptFiles& files) {
  const std::string path = PathOf(input.tile());
  const bool is_tree = IsTileTree(path);
  if (!TileHasStamp(path, input.stamp())) {
    TILEMEND_ASSIGN_OR_RETURN(const std::string bytes, ReadSurveyed(input.tile()));
    if (!is_tree) return files.Write(input.output(), bytes);
    TILEMEND_ASSIGN_OR_RETURN(const auto unpacked, UnpackFiles(bytes, path));
    return files.Write(input.output(), unpacked[0].bytes);
  }
  const Carry how = input.link_tile() ? Carry::kLink : Carry::kCopy;
  TILEMEND_RETURN_IF_ERROR(files.Carry(path, input.output(), how, is_tree ? "" : input.tile().digest()));
  // A link changes the stamp itself.
  return how == Carry::kLink || TileHasStamp(path, input.stamp()) ? absl::OkStatus() : ChangedInJob(path);
}

// Whether the file of an earlier output is still what this one is to have, and no link to it.
bool IsThere(const v1::AssembleInput& input, const v1::WrittenFile& file) {
  const std::string path = absl::StrCat(input.output_root(), "/", file.path());
  const auto look = LookAt(path, Links::kKeep);
  if (!look.ok() || look->kind != PathKind::kFile) return false;
  // What a task's input says of a tile tells its digest; of other files that are carried it does not.
  if (file.carried() && file.path() != input.output()) {
    return HaveSameContent(absl::StrCat(input.tile().root(), "/", file.path()), path);
  }
  return FileHasDigest(path, file.digest()).value_or(false);
}

bool AreThere(const v1::AssembleInput& input) {
  const auto& files = input.known().files();
  return !files.empty() &&
         std::all_of(files.begin(), files.end(), [&](const v1::WrittenFile& file) { return IsThere(input, file); });
}

absl::StatusOr<std::string> RunAssemble(const v1::AssembleInput& input, const CancelToken& cancel, TaskMemory& memory) {
  if (AreThere(input)) {
    v1::AssembleOutput known = input.known();
    known.set_unchanged(true);
    return known.SerializeAsString();
  }
  const HeldMemory held(memory.tasks, AssembleMemory(input));
  if (!input.output_format().empty()) return RunDelivery(input, cancel, memory);
  TILEMEND_ASSIGN_OR_RETURN(const Assembled tile, AssembleTile(input, cancel, memory));
  if (cancel.cancelled()) return absl::CancelledError("cancelled");
  v1::AssembleOutput output;
  AttemptFiles files(input.attempts(), input.output_root());
  TILEMEND_ASSIGN_OR_RETURN(const auto warnings, WriteFilesBeside(input, tile, files));
  output.mutable_warnings()->Add(warnings.begin(), warnings.end());
  output.mutable_fill_warnings()->Add(tile.warnings.begin(), tile.warnings.end());
  SetLevels(tile.levels, output);
  if (!tile.image.empty()) TILEMEND_RETURN_IF_ERROR(files.Write(input.texture(), tile.image));
  if (cancel.cancelled()) return absl::CancelledError("cancelled");
  TILEMEND_RETURN_IF_ERROR(tile.as_it_is ? CarryTile(input, files) : files.Write(input.output(), tile.bytes));
  for (v1::WrittenFile& file : files.Keep()) *output.add_files() = std::move(file);
  return output.SerializeAsString();
}

absl::StatusOr<std::string> RunStage(Stage stage, const std::string& bytes, const CancelToken& cancel,
                                     TaskMemory& memory) {
  switch (stage) {
    case Stage::kMeasure: {
      TILEMEND_ASSIGN_OR_RETURN(const auto input, Parse<v1::MeasureInput>(bytes));
      return RunMeasure(input, memory);
    }
    case Stage::kSurvey: {
      TILEMEND_ASSIGN_OR_RETURN(const auto input, Parse<v1::SurveyInput>(bytes));
      return RunSurvey(input, memory);
    }
    case Stage::kGround: {
      TILEMEND_ASSIGN_OR_RETURN(const auto input, Parse<v1::GroundInput>(bytes));
      return RunGround(input, memory);
    }
    case Stage::kSampleCluster: {
      TILEMEND_ASSIGN_OR_RETURN(const auto input, Parse<v1::SampleClusterInput>(bytes));
      return RunSampleCluster(input, cancel, memory);
    }
    case Stage::kSampleLayer: {
      TILEMEND_ASSIGN_OR_RETURN(const auto input, Parse<v1::SampleLayerInput>(bytes));
      return RunSampleLayer(input);
    }
    case Stage::kFill: {
      TILEMEND_ASSIGN_OR_RETURN(const auto input, Parse<v1::FillInput>(bytes));
      return RunFill(input, cancel, memory);
    }
    case Stage::kSmoothSeam: {
      TILEMEND_ASSIGN_OR_RETURN(const auto input, Parse<v1::SmoothSeamInput>(bytes));
      return RunSmoothSeam(input);
    }
    case Stage::kAssemble: {
      TILEMEND_ASSIGN_OR_RETURN(const auto input, Parse<v1::AssembleInput>(bytes));
      return RunAssemble(input, cancel, memory);
    }
    case Stage::kVerify:
      break;
  }
  return absl::InvalidArgumentError("unknown stage");
}

absl::StatusOr<std::string> VerifyOrRun(Stage stage, const std::string& bytes, const CancelToken& cancel,
                                        TaskMemory& memory) {
  if (stage != Stage::kVerify) return RunStage(stage, bytes, cancel, memory);
  TILEMEND_ASSIGN_OR_RETURN(const auto input, Parse<v1::VerifyInput>(bytes));
  return RunVerify(input, cancel, memory, [&](Stage repeated, const std::string& repeated_input) {
    return RunStage(repeated, repeated_input, cancel, memory);
  });
}

}  // namespace

StageRunner SceneStageRunner(int64_t memory_bytes) {
  return [memory = std::make_shared<TaskMemory>(memory_bytes)](Stage stage, const std::string& input,
                                                               const CancelToken& cancel) {
    return VerifyOrRun(stage, input, cancel, *memory);
  };
}

}  // namespace tilemend
