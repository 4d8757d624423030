#include "tests/support/fill_pipeline.h"

#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

#include "common/assemble/assemble.h"
#include "common/mesh/position_index.h"
#include "common/records/patch_heights.h"
#include "coordinator/waves/scene_waves.h"
#include "worker/fill/seam/sample_cluster.h"
#include "worker/fill/seam/sample_heights.h"
#include "worker/fill/seam/smooth_seam.h"
#include "worker/ground/rim_objects.h"
#include "worker/papers/published_ways.h"

namespace tilemend {
namespace {

void Append(const FilePatch& patch, TriMesh& tile) {
  tile.points.insert(tile.points.end(), patch.new_points.begin(), patch.new_points.end());
  tile.triangles.insert(tile.triangles.end(), patch.triangles.begin(), patch.triangles.end());
}

// Does each piece of work at once.
class LocalStages {
 public:
  LocalStages(const SurveyedScene& scene, const PipelineOptions& options, SceneWaves& waves, FilledScene& filled)
      : scene_(scene), options_(options), waves_(waves), filled_(filled) {}

  absl::Status operator()(const MeasureWork&) { return absl::InternalError("records are no meshes to measure"); }

  absl::Status operator()(const SurveyWork& work) {
    return waves_.Take(SurveyInMemory(work.tile->cell, scene_.records.at(work.tile->cell)));
  }

  absl::Status operator()(const GroundWork& work) {
    std::vector<Point3> vertices;
    for (const BoundaryVertex& v : scene_.records.at(work.cell).vertices) vertices.push_back(v.position);
    std::vector<GroundRaster> rasters;
    for (const CellId cell : work.around) rasters.push_back(scene_.records.at(cell).lowest);
    return waves_.Take(CellGround{work.cell, GroundAtRim(vertices, rasters)});
  }

  absl::Status operator()(const ClusterWork& work) {
    ClusterSamples samples{work.cluster, {}, {}};
    if (const auto surface = SampleCluster(work.holes, options_.fill)) {
      samples.hold_out = surface->hold_out;
      for (const SurfaceSample& s : surface->samples)
        samples.samples.push_back({s.seam_vertex, s.height, s.laplacian, s.slope});
    }
    return waves_.Take(std::move(samples));
  }

  absl::Status operator()(const LayerWork& work) {
    std::vector<SeamSample> samples;
    for (const HeightSample& s : SampleHeights(work.holes)) {
      samples.push_back({work.holes.cell, s.seam_vertex, s.height});
    }
    return waves_.Take(LayerSamples{std::move(samples)});
  }

  absl::Status operator()(const FillWork& given) {
    FillWork work = given;
    CellPatches result;
    if (work.sampled) {
      std::vector<int32_t> vertices;
      std::vector<double> heights;
      for (const HeightSample& s : SampleHeights(*work.sampled)) {
        result.samples.push_back({work.holes.cell, s.seam_vertex, s.height});
        vertices.push_back(s.seam_vertex);
        heights.push_back(s.height);
      }
      TakeSampledHeights(vertices, heights, work.holes);
    }
    FillOptions options = options_.fill;
    options.published = AllPublishedWays();
    const std::vector<HolePatch> patches = FillHoles(work.holes, options);
    for (const HolePatch& p : patches) {
      result.patches.push_back({p.hole, p.failure, std::ssize(p.new_points), std::ssize(p.triangles), p.hold_out});
      filled_.patches[p.hole] = p;
    }
    vertices_[work.holes.cell] = work.holes.vertices;
    patches_[work.holes.cell] = patches;
    return waves_.Take(CellFill{work.holes.cell, std::move(result)});
  }

  absl::Status operator()(const SmoothWork& work) {
    const auto side = [&](int k) {
      return SeamSide{work.sides[k].vertices, patches_[work.sides[k].cell], work.holes[k]};
    };
    const WangOptions& wang = options_.fill.wang;
    SmoothedPatches smoothed = SmoothSeam(side(0), side(1), {work.vertices, work.heights},
                                          {wang.seam_smoothing, wang.seam_buffer, work.sides[0].lattice_step});
    moves_[work.sides[0].cell].push_back(std::move(smoothed.a));
    moves_[work.sides[1].cell].push_back(std::move(smoothed.b));
    return waves_.Take(SmoothedSeam{work.cells, work.vertices, std::move(smoothed.heights)});
  }

  absl::Status operator()(const AssembleWork& work) {
    const CellId cell = work.tile->cell;
    if (work.holes) {
      vertices_[cell] = work.holes->vertices;
      MoveSmoothedPoints(moves_[cell], work.holes->lattice_step, patches_[cell]);
      for (const HolePatch& p : patches_[cell]) filled_.patches[p.hole] = p;
    }
    const FilePatch patch =
        MergePatches(vertices_[cell], patches_[cell], cell, static_cast<int32_t>(work.tile_vertices), work.colours);
    TriMesh& tile = filled_.tiles[cell];
    if (work.tile->path.empty()) tile = TriMesh{};
    Append(patch, tile);
    return waves_.Take(TileWritten{});
  }

 private:
  const SurveyedScene& scene_;
  const PipelineOptions& options_;
  SceneWaves& waves_;
  FilledScene& filled_;
  std::map<CellId, std::vector<RimVertex>> vertices_;
  std::map<CellId, std::vector<HolePatch>> patches_;
  std::map<CellId, std::vector<std::vector<SmoothedPoint>>> moves_;
};

}  // namespace

FilledScene FillScene(const SurveyedScene& scene, const PipelineOptions& options) {
  WaveOptions wave_options;
  wave_options.plan = options.plan;
  wave_options.surface = options.fill.surface;
  wave_options.wang = options.fill.wang;
  if (options.fill.surface == Surface::kWang) wave_options.plan.seam_points = options.fill.wang.seam_points;
  SceneWaves waves(scene.AsScene(), std::move(wave_options));
  FilledScene filled;
  filled.tiles = scene.tiles;
  LocalStages stages(scene, options, waves, filled);
  while (const std::optional<SceneWork> work = waves.Next()) {
    const absl::Status status = std::visit(stages, *work);
    if (!status.ok()) throw std::logic_error(status.ToString());
  }
  filled.plan = waves.plan();
  filled.heights = waves.heights();
  return filled;
}

TriMesh WeldTiles(const std::map<CellId, TriMesh>& tiles) {
  TriMesh welded;
  PositionIndex index;
  for (const auto& [cell, tile] : tiles) {
    for (const Triangle& t : tile.triangles) {
      welded.triangles.push_back(
          {index.Insert(tile.points[t[0]]), index.Insert(tile.points[t[1]]), index.Insert(tile.points[t[2]])});
    }
  }
  welded.points = index.positions();
  return welded;
}

}  // namespace tilemend
