#include "tests/support/scene_maker.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/mesh/rounding.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "tests/support/made_holes.h"
#include "tests/support/value_noise.h"

namespace tilemend {
namespace {

// Keeps jittered vertices of a row in order, so that no triangle folds.
constexpr double kJitter = 0.55;

double Height(const SceneMakerOptions& o, double x, double y) {
  if (o.terrain) return o.terrain(x, y);
  const double scale = 1 / FeatureSize(o);
  const double waves = 0.5 * std::sin(x * scale * 1.7 + 0.3) + 0.3 * std::sin(y * scale * 2.3 + 1.1) +
                       0.2 * std::sin((x + y) * scale * 4.1);
  return o.relief * (0.25 * waves + 0.75 * (FractalNoise(o.seed, x * scale * 1.3, y * scale * 1.3, 4, 100) - 0.5));
}

// A vertex by its column and row on its sheet.
struct GridIndex {
  int64_t i = 0;
  int64_t j = 0;
  auto operator<=>(const GridIndex&) const = default;
};

// What is triangulated in one go: the whole scene, or a piece of a tile that shares no vertex with another.
struct Sheet {
  Point2 lo{0, 0};
  Point2 step{0, 0};
  std::array<int64_t, 2> squares{};
  // Every so many columns and rows the vertices stay on their line.
  std::array<int64_t, 2> straight{};
  uint64_t seed = 0;
};

int64_t SquaresIn(double length, double spacing) { return std::max<int64_t>(1, std::llround(length / spacing)); }

Sheet WholeScene(const SceneMakerOptions& o) {
  const int64_t n = SquaresIn(o.cell_size, o.spacing);
  const double step = o.cell_size / static_cast<double>(n);
  Sheet sheet{{0, 0}, {step, step}, {o.cols * n, o.rows * n}, {n, n}, o.seed};
  if (o.cut == Cut::kRagged) sheet.straight = sheet.squares;
  return sheet;
}

// The piece in column i and row j of the tile of `cell`.
Sheet Piece(const SceneMakerOptions& o, CellId cell, int32_t i, int32_t j) {
  const double size = o.cell_size / o.pieces;
  const double length = size + 2 * o.margin;
  const int64_t n = SquaresIn(length, o.spacing);
  const int64_t column = int64_t{cell.col} * o.pieces + i;
  const int64_t row = int64_t{cell.row} * o.pieces + j;
  const Point2 lo = size * Point2(static_cast<double>(column), static_cast<double>(row));
  const double step = length / static_cast<double>(n);
  const auto seed = static_cast<uint64_t>(HashedNumber(o.seed, column, row, 500) * 0x1p53);
  return {lo - Point2(o.margin, o.margin), {step, step}, {n, n}, {n, n}, seed};
}

// The full surface of a sheet, vertex by vertex and triangle by triangle.
class Surface {
 public:
  Surface(const SceneMakerOptions& options, const Sheet& sheet) : o_(options), sheet_(sheet) {}

  Point3 Vertex(GridIndex at) const {
    const auto jitter = [&](int64_t index, int axis) {
      return index % sheet_.straight[axis] == 0 ? 0 : kJitter * (HashedNumber(sheet_.seed, at.i, at.j, 1 + axis) - 0.5);
    };
    const double x = sheet_.lo.x() + (static_cast<double>(at.i) + jitter(at.i, 0)) * sheet_.step.x();
    const double y = sheet_.lo.y() + (static_cast<double>(at.j) + jitter(at.j, 1)) * sheet_.step.y();
    const double z = Height(o_, x, y) + o_.noise * (HashedNumber(sheet_.seed, at.i, at.j, 3) - 0.5);
    return RoundedTo(NumberType::kFloat32, Point3(x, y, z));
  }

  // The two triangles of the square whose low corner is `at`, counter-clockwise from above.
  std::array<std::array<GridIndex, 3>, 2> Square(GridIndex at) const {
    const GridIndex a = at, b{at.i + 1, at.j}, c{at.i + 1, at.j + 1}, d{at.i, at.j + 1};
    if (HashedNumber(sheet_.seed, at.i, at.j, 4) > 0.5) return {{{a, b, c}, {a, c, d}}};
    return {{{a, b, d}, {b, c, d}}};
  }

 private:
  const SceneMakerOptions& o_;
  const Sheet sheet_;
};

// Squares of a sheet, from `first` up to but without `last`.
struct SquareRange {
  GridIndex first, last;
};

// Builds the mesh of one tile.
class TileBuilder {
 public:
  TileBuilder(const SceneMakerOptions& options, const MadeHoles& holes, CellId cell)
      : o_(options), holes_(holes), cell_(cell) {}

  // Adds the triangles of `range` that belong to the tile. Appends the vertices that only the removed surface has to
  // `removed`.
  void Add(const Surface& surface, const SquareRange& range, std::vector<Point3>* removed) {
    index_.clear();
    gone_.clear();
    for (int64_t j = range.first.j; j < range.last.j; ++j) {
      for (int64_t i = range.first.i; i < range.last.i; ++i) {
        for (const std::array<GridIndex, 3>& corners : surface.Square({i, j})) AddTriangle(surface, corners);
      }
    }
    for (const auto& [at, point] : gone_) {
      if (!index_.contains(at)) removed->push_back(point);
    }
  }

  TriMesh Take() { return std::move(mesh_); }

 private:
  void AddTriangle(const Surface& surface, const std::array<GridIndex, 3>& corners) {
    std::array<Point3, 3> points;
    for (int k = 0; k < 3; ++k) points[k] = surface.Vertex(corners[k]);
    const Point3 centroid = (points[0] + points[1] + points[2]) / 3;
    const CellId home{static_cast<int32_t>(std::floor(centroid.x() / o_.cell_size)),
                      static_cast<int32_t>(std::floor(centroid.y() / o_.cell_size))};
    if (o_.cut != Cut::kOverlap && home != cell_) return;
    const bool gone = holes_.Contains(centroid.x(), centroid.y());
    Triangle triangle;
    for (int k = 0; k < 3; ++k) {
      if (gone) {
        gone_.emplace(corners[k], points[k]);
        continue;
      }
      const auto [at, fresh] = index_.emplace(corners[k], static_cast<int32_t>(mesh_.points.size()));
      if (fresh) mesh_.points.push_back(points[k]);
      triangle[k] = at->second;
    }
    if (!gone) mesh_.triangles.push_back(triangle);
  }

  const SceneMakerOptions& o_;
  const MadeHoles& holes_;
  CellId cell_;
  TriMesh mesh_;
  std::map<GridIndex, int32_t> index_;
  std::map<GridIndex, Point3> gone_;
};

// The squares of the whole scene in which triangles of the cell may lie: of a ragged cut also those just over its
// borders.
SquareRange SquaresOf(const SceneMakerOptions& o, const Sheet& whole, CellId cell) {
  const int64_t n = whole.squares[0] / o.cols;
  const int64_t beyond = o.cut == Cut::kRagged ? 1 : 0;
  const auto first = [&](int32_t index) { return std::max<int64_t>(index * n - beyond, 0); };
  const auto last = [&](int32_t index, int axis) { return std::min((index + 1) * n + beyond, whole.squares[axis]); };
  return {{first(cell.col), first(cell.row)}, {last(cell.col, 0), last(cell.row, 1)}};
}

TriMesh MakeTile(const SceneMakerOptions& o, const MadeHoles& holes, CellId cell, std::vector<Point3>* removed) {
  TileBuilder builder(o, holes, cell);
  if (o.cut != Cut::kOverlap) {
    const Sheet whole = WholeScene(o);
    builder.Add(Surface(o, whole), SquaresOf(o, whole, cell), removed);
    return builder.Take();
  }
  for (int32_t j = 0; j < o.pieces; ++j) {
    for (int32_t i = 0; i < o.pieces; ++i) {
      const Sheet piece = Piece(o, cell, i, j);
      builder.Add(Surface(o, piece), {{0, 0}, {piece.squares[0], piece.squares[1]}}, removed);
    }
  }
  return builder.Take();
}

bool LessPoint(const Point3& a, const Point3& b) {
  return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
}

// Appends the little-endian bytes of a number of 4 bytes.
template <typename T>
void AppendBytes(T value, std::string* out) {
  const auto bits = std::bit_cast<uint32_t>(value);
  for (int shift = 0; shift < 32; shift += 8) out->push_back(static_cast<char>(bits >> shift & 255));
}

}  // namespace

MadeScene MakeScene(const SceneMakerOptions& options) {
  MadeScene scene;
  scene.grid.cell_size = Point2(options.cell_size, options.cell_size);
  scene.cols = options.cols;
  scene.rows = options.rows;
  const auto holes = std::make_shared<const MadeHoles>(options);
  scene.height = [options](double x, double y) { return Height(options, x, y); };
  scene.is_in_hole = [holes](double x, double y) { return holes->Contains(x, y); };
  const std::set<CellId> away(options.out_of_area.begin(), options.out_of_area.end());
  for (int32_t row = 0; row < options.rows; ++row) {
    for (int32_t col = 0; col < options.cols; ++col) {
      if (away.contains({col, row})) continue;
      scene.tiles.push_back({{col, row}, MakeTile(options, *holes, {col, row}, &scene.removed)});
    }
  }
  std::vector<Point3>& removed = scene.removed;
  std::sort(removed.begin(), removed.end(), LessPoint);
  removed.erase(std::unique(removed.begin(), removed.end()), removed.end());
  return scene;
}

TriMesh MergeTiles(const MadeScene& scene) {
  TriMesh merged;
  std::map<Point3, int32_t, decltype(&LessPoint)> index(&LessPoint);
  for (const MadeTile& tile : scene.tiles) {
    for (Triangle triangle : tile.mesh.triangles) {
      for (int32_t& corner : triangle) {
        const auto [at, fresh] = index.emplace(tile.mesh.points[corner], static_cast<int32_t>(merged.points.size()));
        if (fresh) merged.points.push_back(at->first);
        corner = at->second;
      }
      merged.triangles.push_back(triangle);
    }
  }
  return merged;
}

Scene Describe(const MadeScene& made) {
  Scene scene;
  scene.crs = "EPSG:32650";
  scene.origin = Point3(500000, 4100000, 0);
  scene.grid = made.grid;
  scene.cols = made.cols;
  scene.rows = made.rows;
  scene.area_known = true;
  for (const MadeTile& tile : made.tiles) {
    const std::string path = absl::StrCat("tiles/Tile_", ToString(tile.cell), ".ply");
    scene.tiles.push_back({tile.cell, tile.mesh.triangles.empty() ? "" : path});
  }
  return scene;
}

std::string PlyBytes(const TriMesh& mesh) {
  std::string bytes = absl::StrCat("ply\nformat binary_little_endian 1.0\nelement vertex ", mesh.points.size(),
                                   "\nproperty float x\nproperty float y\nproperty float z\nelement face ",
                                   mesh.triangles.size(), "\nproperty list uchar int vertex_indices\nend_header\n");
  for (const Point3& point : mesh.points) {
    for (int k = 0; k < 3; ++k) AppendBytes(static_cast<float>(point[k]), &bytes);
  }
  for (const Triangle& triangle : mesh.triangles) {
    bytes.push_back(3);
    for (const int32_t corner : triangle) AppendBytes(corner, &bytes);
  }
  return bytes;
}

absl::Status WriteScene(const MadeScene& made, const std::string& folder) {
  const Scene scene = Describe(made);
  for (size_t i = 0; i < made.tiles.size(); ++i) {
    if (scene.tiles[i].path.empty()) continue;
    const std::string file = absl::StrCat(folder, "/", scene.tiles[i].path);
    TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(file, PlyBytes(made.tiles[i].mesh), Sync::kNo));
  }
  std::string truth = "x,y,z\n";
  for (const Point3& p : made.removed) absl::StrAppendFormat(&truth, "%.9g,%.9g,%.9g\n", p.x(), p.y(), p.z());
  TILEMEND_RETURN_IF_ERROR(WriteFileAtomically(folder + "/truth.csv", truth, Sync::kNo));
  return WriteFileAtomically(folder + "/scene.json", SceneJson(scene), Sync::kNo);
}

}  // namespace tilemend
