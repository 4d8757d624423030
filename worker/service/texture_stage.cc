#include "worker/service/texture_stage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/codec/obj.h"
#include "common/image/image.h"
#include "common/rpc/clear_payloads.h"
#include "common/util/colour.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"
#include "common/util/tile_files.h"
#include "worker/materials/textured_surface.h"
#include "worker/materials/tile_look.h"
#include "worker/service/tile_reading.h"
#include "worker/texture/atlas.h"
#include "worker/texture/fill_parts.h"
#include "worker/texture/level_paint.h"
#include "worker/texture/ortho_raster.h"
#include "worker/texture/synthesize.h"

namespace tilemend {
namespace {

constexpr int kJpegQuality = 90;
constexpr double kReach = 60;  // metres around the patch in which tiles are read

Eigen::AlignedBox2d CellBox(const v1::TextureCell& cell) {
  return {Point2(cell.x_min(), cell.y_min()), Point2(cell.x_max(), cell.y_max())};
}

struct LoadedTile {
  std::string root;
  TexturedSurface surface;
  Eigen::AlignedBox2d cell = {};
};

absl::StatusOr<LoadedTile> Load(const v1::TileRef& tile) {
  TILEMEND_ASSIGN_OR_RETURN(std::string bytes, ReadSurveyed(tile));
  const std::string path = PathOf(tile);
  TILEMEND_ASSIGN_OR_RETURN(const MeshFormat format, MeshFormatOf(path));
  if (format != MeshFormat::kObj && format != MeshFormat::kTileTree) {
    TILEMEND_ASSIGN_OR_RETURN(MeshFile file, MeshOf(tile, bytes));
    return LoadedTile{tile.root(), TexturedSurfaceOf({std::move(file), {}}, {})};
  }
  if (!tile.clear().empty()) {
    TILEMEND_ASSIGN_OR_RETURN(ClearedTile cleared, ClearTile(tile, bytes));
    bytes = std::move(cleared.bytes);
  }
  if (format == MeshFormat::kTileTree) {
    TILEMEND_ASSIGN_OR_RETURN(TexturedSurface surface, TexturedSurfaceOfTree(bytes, path));
    return LoadedTile{tile.root(), std::move(surface)};
  }
  TILEMEND_ASSIGN_OR_RETURN(ObjFile obj, ParseTexturedObj(bytes, path, NoFaces::kAccept));
  TILEMEND_ASSIGN_OR_RETURN(const TileLook look, ReadObjLook(tile.root(), tile.path(), obj.textures));
  return LoadedTile{tile.root(), TexturedSurfaceOf(std::move(obj), look)};
}

SpaceTriangle CornersOf(const TriMesh& mesh, int32_t triangle) {
  const Triangle& t = mesh.triangles[static_cast<size_t>(triangle)];
  return {mesh.points[static_cast<size_t>(t[0])], mesh.points[static_cast<size_t>(t[1])],
          mesh.points[static_cast<size_t>(t[2])]};
}

// A corner of the surface at a point of the patch: where its colour is looked up.
struct RimSpotAt {
  int32_t point = 0;  // of the patch
  float u = 0, v = 0;
};

class TextureMaker {
 public:
  TextureMaker(const v1::AssembleInput& input, const TilePatch& added, const CancelToken& cancel)
      : input_(input), added_(added), cancel_(cancel) {}

  absl::StatusOr<FillTexture> Make() {
    TILEMEND_RETURN_IF_ERROR(LoadTiles());
    if (!(TexelOfTile(own_) > 0)) return std::move(result_);
    PlanRasters();
    FindRimSpots();
    rim_.resize(faces_.points.size());
    for (size_t first = 0; first < parts_.frames.size() || first == 0;) {
      if (cancel_.cancelled()) return absl::CancelledError("cancelled");
      first = MakeBatch(first);
    }
    if (IsTileTree(input_.tile().path())) {
      result_.paint = PaintOfLevels();
      return std::move(result_);
    }
    AtlasFaces atlas_faces{faces_.points, faces_.triangles, parts_.of_triangles,
                           SteepColours(faces_, parts_, rim_, made_)};
    Atlas atlas = PackAtlas(atlas_faces, made_);
    TILEMEND_ASSIGN_OR_RETURN(result_.image, EncodeJpeg(atlas.image, kJpegQuality));
    result_.places = std::move(atlas.coordinates);
    result_.corners = std::move(atlas.corners);
    return std::move(result_);
  }

 private:
  // Gives the faces of each file their image when the levels of the tile are patched.
  PaintFaces PaintOfLevels() {
    std::map<std::array<double, 3>, Rgb> rim;
    for (size_t v = 0; v < rim_.size(); ++v) {
      const Point3& p = faces_.points[v];
      if (rim_[v]) rim[{p.x(), p.y(), p.z()}] = *rim_[v];
    }
    auto paint = std::make_shared<LevelPaint>(std::move(parts_), std::move(made_), std::move(rim));
    return [paint, cancel = &cancel_](const TreeFaces& faces) -> absl::StatusOr<FacePaint> {
      if (cancel->cancelled()) return absl::CancelledError("cancelled");
      const Atlas atlas = paint->AtlasOf(faces.points, faces.triangles, faces.colours, faces.above_finest);
      FacePaint result;
      TILEMEND_ASSIGN_OR_RETURN(result.image, EncodeJpeg(atlas.image, kJpegQuality));
      for (const Triangle& corners : atlas.corners) {
        auto& places = result.corners.emplace_back();
        for (size_t k = 0; k < 3; ++k) places[k] = atlas.coordinates[static_cast<size_t>(corners[k])];
      }
      return result;
    };
  }

  // The cell's own tile, then those near its patch, in the order of the input.
  absl::Status LoadTiles() {
    TILEMEND_ASSIGN_OR_RETURN(LoadedTile own, Load(input_.tile()));
    SetFaces(own.surface.mesh);
    Eigen::AlignedBox2d reach;
    for (const Point3& p : faces_.points) reach.extend(Point2(p.head<2>()));
    reach = {reach.min() - Point2::Constant(kReach), reach.max() + Point2::Constant(kReach)};
    for (const v1::TextureCell& cell : input_.around()) {
      const bool is_own = cell.tile().path() == input_.tile().path();
      if (!is_own && !reach.intersects(CellBox(cell))) continue;
      cells_.push_back(CellBox(cell));
      site_.extend(cells_.back());
      if (cell.tile().path().empty()) continue;
      if (is_own) own_ = tiles_.size();
      if (is_own) {
        tiles_.push_back(std::move(own));
      } else {
        TILEMEND_ASSIGN_OR_RETURN(tiles_.emplace_back(), Load(cell.tile()));
      }
      tiles_.back().cell = CellBox(cell);
    }
    for (const Point3& p : faces_.points) site_.extend(Point2(p.head<2>()));
    return tiles_.empty() ? absl::InvalidArgumentError("malformed payload: no tile to make a texture from")
                          : absl::OkStatus();
  }

  // The patch, with the vertices that it uses alone.
  void SetFaces(const TriMesh& mesh) {
    std::map<int32_t, int32_t> numbers;
    const auto known = static_cast<int32_t>(mesh.points.size());
    auto run = added_.runs.begin();
    for (size_t t = 0; t < added_.patch.triangles.size(); ++t) {
      while (run + 1 != added_.runs.end() && (run + 1)->first <= static_cast<int64_t>(t)) ++run;
      Triangle corners;
      for (size_t k = 0; k < 3; ++k) {
        const int32_t v = added_.patch.triangles[t][k];
        const auto [it, fresh] = numbers.try_emplace(v, static_cast<int32_t>(faces_.points.size()));
        if (fresh)
          faces_.points.push_back(v < known ? mesh.points[static_cast<size_t>(v)]
                                            : added_.patch.new_points[static_cast<size_t>(v - known)]);
        corners[k] = it->second;
      }
      faces_.triangles.push_back(corners);
      faces_.is_water.push_back(run->is_water ? 1 : 0);
      faces_.flat.push_back(run->colour);
    }
  }

  // The finest of the tiles whose cells meet the place. So it is the same for all cells that share a hole.
  double TexelAround(const Eigen::AlignedBox2d& place) {
    double finest = 0;
    for (size_t i = 0; i < tiles_.size(); ++i) {
      if (!tiles_[i].cell.intersects(place)) continue;
      const double texel = TexelOfTile(i);
      if (texel > 0 && (finest == 0 || texel < finest)) finest = texel;
    }
    return LatticeTexel(finest > 0 ? finest : TexelOfTile(own_));
  }

  double TexelOfTile(size_t tile) {
    const auto [at, is_new] = texels_.try_emplace(tile, 0);
    if (is_new) at->second = TexelOfLargestImage(tiles_[tile]);
    return at->second;
  }

  // Of the image that lies on most of the tile's triangles, among those that can be read. 0 if there is none.
  double TexelOfLargestImage(const LoadedTile& tile) {
    std::vector<const TexturedSurface::Group*> groups;
    for (const TexturedSurface::Group& group : tile.surface.groups) {
      if (!group.image.empty()) groups.push_back(&group);
    }
    std::stable_sort(groups.begin(), groups.end(),
                     [](const auto* a, const auto* b) { return a->triangles.size() > b->triangles.size(); });
    for (const TexturedSurface::Group* group : groups) {
      if (const double texel = TexelOfGroup(tile, *group); texel > 0) return texel;
    }
    return 0;
  }

  double TexelOfGroup(const LoadedTile& tile, const TexturedSurface::Group& group) {
    const std::optional<Image> image = ImageAt(tile, group.image);
    if (!image) return 0;
    std::vector<TexturedFace> faces;
    for (const int32_t t : group.triangles)
      faces.push_back({CornersOf(tile.surface.mesh, t), tile.surface.PlacesOf(t)});
    return TexelOf(faces, image->width, image->height);
  }

  // Nothing, and a warning, if it cannot be read. A JPEG of kFullPixels takes 201 MB while there are only rasters of 8
  // bytes a pixel: no more than Synthesize takes later, without an image.
  std::optional<Image> ImageAt(const LoadedTile& tile, const std::string& path) {
    const auto held = tile.surface.encoded.find(path);
    absl::StatusOr<std::string> bytes = held != tile.surface.encoded.end()
                                            ? absl::StatusOr<std::string>(held->second)
                                            : ReadFile(absl::StrCat(tile.root, "/", path));
    absl::StatusOr<Image> image =
        bytes.ok() ? DecodeImage(*bytes, path, JpegSize::kLarge) : absl::StatusOr<Image>(bytes.status());
    if (image.ok()) return *std::move(image);
    if (warned_.insert(path).second) {
      result_.warnings.push_back(
          absl::StrCat(Printable(std::string(image.status().message())), ": no texture is made from it"));
    }
    return std::nullopt;
  }

  void PlanRasters() {
    OrthoRaster site = SiteRaster(site_);
    for (const LoadedTile& tile : tiles_) {
      for (size_t t = 0; t < tile.surface.mesh.triangles.size(); ++t) {
        const SpaceTriangle corners = CornersOf(tile.surface.mesh, static_cast<int32_t>(t));
        DrawShapes(std::span(&corners, 1), site);
      }
    }
    parts_ = PlanParts(faces_, site, cells_, [this](const Eigen::AlignedBox2d& place) { return TexelAround(place); });
  }

  // For each point of a steep face, the first triangle of the tiles with a corner there.
  void FindRimSpots() {
    std::map<std::array<double, 3>, int32_t> wanted;
    for (const int32_t v : SteepPoints(faces_, parts_)) {
      const Point3& p = faces_.points[static_cast<size_t>(v)];
      wanted[{p.x(), p.y(), p.z()}] = v;
    }
    for (size_t i = 0; i < tiles_.size() && !wanted.empty(); ++i) {
      const TexturedSurface& surface = tiles_[i].surface;
      for (size_t g = 0; g < surface.groups.size(); ++g) {
        if (surface.groups[g].image.empty()) continue;
        for (const int32_t t : surface.groups[g].triangles) {
          const SpaceTriangle corners = CornersOf(surface.mesh, t);
          for (size_t k = 0; k < 3; ++k) {
            const auto found = wanted.find({corners[k].x(), corners[k].y(), corners[k].z()});
            if (found == wanted.end()) continue;
            spots_[{i, g}].push_back(SpotIn(surface.PlacesOf(t), k, found->second));
            wanted.erase(found);
          }
        }
      }
    }
  }

  // A little inside of the corner: images end there.
  static RimSpotAt SpotIn(const std::array<std::array<float, 2>, 3>& places, size_t corner, int32_t point) {
    constexpr float kInside = 0.1F;
    const auto at = [&](size_t axis) {
      const float other = places[(corner + 1) % 3][axis] + places[(corner + 2) % 3][axis];
      return (1 - 2 * kInside) * places[corner][axis] + kInside * other;
    };
    return {point, at(0), at(1)};
  }

  // Makes parts from `first` on, as many as fit into kMostRasterPixels, one at least; the first that is left.
  size_t MakeBatch(size_t first) {
    std::vector<OrthoRaster> rasters;
    size_t pixels = 0, end = first;
    while (end < parts_.frames.size()) {
      pixels += parts_.frames[end].size();
      if (end > first && pixels > static_cast<size_t>(kMostRasterPixels)) break;
      rasters.emplace_back(parts_.frames[end++]);
    }
    for (size_t i = 0; i < tiles_.size(); ++i) {
      for (size_t g = 0; g < tiles_[i].surface.groups.size(); ++g) DrawGroup(i, g, rasters);
    }
    for (size_t k = 0; k < rasters.size(); ++k) {
      const auto part = static_cast<int32_t>(first + k);
      FillLook look = LookOf(faces_, parts_, part);
      if (!input_.water_colour().empty()) look.given_water = ParseColour(input_.water_colour());
      const FillMap fill = FillMapOf(faces_, parts_, part, rasters[k]);
      made_.push_back({rasters[k].frame, Synthesize(rasters[k], fill, look)});
    }
    return std::max(end, first + 1);
  }

  void DrawGroup(size_t tile, size_t number, std::vector<OrthoRaster>& rasters) {
    const TexturedSurface& surface = tiles_[tile].surface;
    const TexturedSurface::Group& group = surface.groups[number];
    const auto spots = spots_.extract({tile, number});
    const std::vector<std::vector<TexturedFace>> near = FacesNear(surface, group, rasters);
    const bool is_seen = std::any_of(near.begin(), near.end(), [](const auto& faces) { return !faces.empty(); });
    std::optional<Image> image;
    if (!group.image.empty() && (is_seen || !spots.empty())) image = ImageAt(tiles_[tile], group.image);
    for (size_t k = 0; k < rasters.size(); ++k) {
      if (image) {
        DrawFaces(near[k], *image, rasters[k]);
      } else {
        for (const TexturedFace& face : near[k]) DrawShapes(std::span(&face.corners, 1), rasters[k], group.colour);
      }
    }
    if (spots.empty() || !image) return;
    for (const RimSpotAt& spot : spots.mapped()) {
      rim_[static_cast<size_t>(spot.point)] = TexelAt(*image, double{spot.u}, double{spot.v});
    }
  }

  // For each raster the faces of the group whose boxes meet it.
  static std::vector<std::vector<TexturedFace>> FacesNear(const TexturedSurface& surface,
                                                          const TexturedSurface::Group& group,
                                                          const std::vector<OrthoRaster>& rasters) {
    std::vector<std::vector<TexturedFace>> near(rasters.size());
    std::vector<Eigen::AlignedBox2d> boxes;
    Eigen::AlignedBox2d all;
    for (const OrthoRaster& raster : rasters) all.extend(boxes.emplace_back(BoxOf(raster.frame)));
    for (const int32_t t : group.triangles) {
      const SpaceTriangle corners = CornersOf(surface.mesh, t);
      Eigen::AlignedBox2d own;
      for (const Point3& p : corners) own.extend(Point2(p.head<2>()));
      if (!own.intersects(all)) continue;
      for (size_t k = 0; k < rasters.size(); ++k) {
        if (!own.intersects(boxes[k])) continue;
        near[k].push_back({corners, {}});
        if (!group.image.empty()) near[k].back().uv = surface.PlacesOf(t);
      }
    }
    return near;
  }

  const v1::AssembleInput& input_;
  const TilePatch& added_;
  const CancelToken& cancel_;
  FillTexture result_;
  std::vector<LoadedTile> tiles_;
  size_t own_ = 0;
  std::map<size_t, double> texels_;  // by tile; 0: it has no image that can be read
  std::vector<Eigen::AlignedBox2d> cells_;
  Eigen::AlignedBox2d site_;
  FilledFaces faces_;
  FillParts parts_;
  std::map<std::pair<size_t, size_t>, std::vector<RimSpotAt>> spots_;  // by tile and group
  std::vector<std::optional<Rgb>> rim_;                                // of the points of steep faces
  std::vector<MadeRaster> made_;
  std::set<std::string> warned_;
};

}  // namespace

absl::StatusOr<FillTexture> TextureOf(const v1::AssembleInput& input, const TilePatch& added, TaskMemory& memory,
                                      const CancelToken& cancel) {
  if (input.texture().empty() || added.patch.triangles.empty()) return FillTexture{};
  int64_t bytes = kBytesPerPixel * kMostRasterPixels;
  for (const v1::TextureCell& cell : input.around()) {
    if (!cell.tile().path().empty()) bytes += SurfaceMemory(PathOf(cell.tile()));
  }
  const HeldMemory held(memory.surfaces, bytes);
  return TextureMaker(input, added, cancel).Make();
}

}  // namespace tilemend
