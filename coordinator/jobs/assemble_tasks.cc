#include "coordinator/jobs/assemble_tasks.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "common/codec/mesh_file.h"
#include "common/rpc/level_payloads.h"
#include "common/rpc/look_payloads.h"
#include "common/rpc/stage_payloads.h"
#include "common/util/status_macros.h"
#include "common/util/tile_files.h"
#include "coordinator/waves/local_numbers.h"

namespace tilemend {
namespace {

bool HasMaterials(const SceneTile& tile) {
  if (tile.path.empty()) return false;  // a new tile is a PLY
  const auto format = MeshFormatOf(tile.path);
  return format.ok() && *format == MeshFormat::kObj;
}

bool GetsTexture(const v1::JobSpec& spec, const SceneTile& tile, const SceneFiles& files) {
  const bool has_images = IsTileTree(tile.path) || (HasMaterials(tile) && files.HasImages(tile.cell));
  return spec.texture() == "synthesize" && has_images;
}

// By the holes' numbers in the work, of which `holes` has the scene's. Groups name materials; where there are none they
// would tell a task from the same task of another plan.
FillColours LocalColours(const AssembleWork& work, const std::vector<int32_t>& holes) {
  FillColours local{{}, work.colours.on_vertices};
  for (const auto& [hole, colour] : work.colours.of_holes) {
    FillColour& own = local.of_holes[LocalNumber(holes, hole)];
    own = colour;
    if (!HasMaterials(*work.tile)) own.group = 0;
  }
  return local;
}

// Returns the files that are new: the image, unless it lies in the tile's own files.
std::set<std::string> SetTexture(const SceneFiles& files, const v1::JobSpec& spec, v1::AssembleInput& input) {
  input.set_texture(files.NewFileFor(input.output(), "jpg"));
  input.set_water_colour(spec.water_colour());
  if (IsTileTree(input.tile().path())) return {};
  return {input.texture()};
}

void SetWantedColours(const v1::JobSpec& spec, const SceneTile& tile, FillColours colours, v1::AssembleInput& input) {
  input.set_without_colours(spec.texture() == "none" && !IsTileTree(tile.path));
  if (input.without_colours()) colours.on_vertices = false;
  SetColours(colours, input);
}

void SetTile(const AssembleWork& work, v1::AssembleInput& input) {
  input.set_output(OutputPath(*work.tile));
  input.set_float32(work.float32);
  input.set_tile_vertices(work.tile_vertices);
}

void SetDelivery(const Grid& grid, const std::string& format, CellId cell, v1::AssembleInput& input) {
  input.set_output_format(format);
  input.set_x_middle(grid.corner.x() + (cell.col + 0.5) * grid.cell_size.x());
  input.set_y_middle(grid.corner.y() + (cell.row + 0.5) * grid.cell_size.y());
}

// The tiles that the texture of a cell's fill is made from: its own and those around it.
template <typename Ref>
absl::Status AddTilesAround(const Scene& scene, CellId cell, const Ref& ref, v1::AssembleInput& input) {
  // They are sorted by it.
  const auto place = [](const SceneTile& tile) { return std::pair(tile.cell.row, tile.cell.col); };
  for (int32_t row = cell.row - 1; row <= cell.row + 1; ++row) {
    auto other = std::ranges::lower_bound(scene.tiles, std::pair(row, cell.col - 1), std::less<>(), place);
    for (; other != scene.tiles.end() && place(*other) <= std::pair(row, cell.col + 1); ++other) {
      const int32_t col = other->cell.col;
      v1::TextureCell& around = *input.add_around();
      TILEMEND_ASSIGN_OR_RETURN(*around.mutable_tile(), ref(*other));
      around.set_x_min(scene.grid.corner.x() + col * scene.grid.cell_size.x());
      around.set_y_min(scene.grid.corner.y() + row * scene.grid.cell_size.y());
      around.set_x_max(scene.grid.corner.x() + (col + 1) * scene.grid.cell_size.x());
      around.set_y_max(scene.grid.corner.y() + (row + 1) * scene.grid.cell_size.y());
    }
  }
  return absl::OkStatus();
}

// The file with the materials of the tile's fill: the tile's own, `library`, or a new one if that is empty.
void SetLibrary(const std::string& path, const std::string& library, const TileContents& contents,
                v1::AssembleInput& input) {
  input.set_new_library(library.empty());
  input.set_library_digest(contents.tiles.FileDigestOf(library));
  input.set_library(library.empty() ? contents.files.NewFileFor(path, "mtl") : library);
}

}  // namespace

absl::StatusOr<NewTask> AssembleTasks::TaskOf(AssembleWork& work) {
  const CellId cell = work.tile->cell;
  v1::AssembleInput input;
  TILEMEND_ASSIGN_OR_RETURN(*input.mutable_tile(), contents_.tiles.Ref(*work.tile));
  SetTile(work, input);
  input.set_attempts(output_->attempts().path());
  if (contents_.fills.HasPatches(cell)) TILEMEND_RETURN_IF_ERROR(SetPatches(work, input));
  SetFiles(*work.tile, input);
  if (input.has_patches() && GetsTexture(spec_, *work.tile, contents_.files)) {
    output_->files().Adopt(SetTexture(contents_.files, spec_, input));
    TILEMEND_RETURN_IF_ERROR(AddTilesAround(
        waves_.scene(), cell, [&](const SceneTile& other) { return contents_.tiles.Ref(other); }, input));
  }
  contents_.fills.Release(cell);
  return NewTask{cell, Stage::kAssemble, input.SerializeAsString()};
}

absl::Status AssembleTasks::SetPatches(AssembleWork& work, v1::AssembleInput& input) {
  const CellId cell = work.tile->cell;
  TILEMEND_ASSIGN_OR_RETURN(*input.mutable_patches(), contents_.fills.PatchesOf(cell));
  SetWantedColours(spec_, *work.tile, LocalColours(work, contents_.fills.HolesOf(cell)), input);
  if (!work.holes) {
    TILEMEND_ASSIGN_OR_RETURN(*input.mutable_vertices(), contents_.fills.RimsOf(cell));
    return absl::OkStatus();
  }
  Localise(*work.holes);
  *input.mutable_vertices() = ToProto(work.holes->vertices);
  input.set_lattice_step(work.holes->lattice_step);
  TILEMEND_ASSIGN_OR_RETURN(const auto moves, contents_.seams.MovePoints(cell, input));
  return AddToGaps(cell, input.vertices(), input.patches(), moves, waves_);
}

void AssembleTasks::SetFiles(const SceneTile& tile, v1::AssembleInput& input) {
  if (HasMaterials(tile)) {
    SetLibrary(OutputPath(tile), contents_.files.LibraryOf(tile.cell), contents_, input);
    output_->files().Adopt({input.library()});
  }
  input.set_output_root(spec_.out());
  if (!tile.delivered.empty()) return SetDelivery(waves_.scene().grid, spec_.output_format(), tile.cell, input);
  const std::vector<std::string> carried = contents_.files.CarriedBy(tile.cell);
  output_->files().Adopt({carried.begin(), carried.end()});
  input.mutable_carried()->Add(carried.begin(), carried.end());
  for (const std::string& path : carried) input.add_carried_digests(contents_.tiles.FileDigestOf(path));
  input.set_link_images(spec_.textures() == "link");
}

absl::Status AssembleTasks::AddHelp(NewTask& task) const {
  TILEMEND_ASSIGN_OR_RETURN(const std::string stamp, contents_.tiles.StampOf(task.cell));
  if (stamp.empty()) return absl::OkStatus();
  v1::AssembleInput help;
  help.set_stamp(stamp);
  help.set_link_tile(spec_.link());
  task.SetInput(task.input + help.SerializeAsString());  // as one message: its other fields stay as they are
  return absl::OkStatus();
}

absl::Status AssembleTasks::Take(CellId cell, const v1::AssembleOutput& output) {
  for (const auto* of : {&output.warnings(), &output.fill_warnings()})
    contents_.files.Warn(cell, {of->begin(), of->end()});
  TILEMEND_ASSIGN_OR_RETURN(const auto levels, FromProto(output.levels()));
  AddLevels(levels, contents_.levels);
  TILEMEND_RETURN_IF_ERROR(waves_.Take(TileWritten{}));
  std::vector<AttemptFile> files;
  for (const v1::WrittenFile& file : output.files()) {
    files.push_back({file.attempt(), file.path(), file.bytes(), file.digest()});
    if (!waves_.survey().tile(cell).delivered.empty()) output_->files().Adopt({file.path()});  // its name was checked
  }
  return output.unchanged() ? output_->files().Keep(files) : output_->files().Place(files, output_->attempts());
}

}  // namespace tilemend
