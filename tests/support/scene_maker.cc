#include "tests/support/scene_maker.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// Keeps jittered vertices of a row in order, so that no triangle folds.
constexpr double kJitter = 0.55;

// A number in [0, 1) for a place and a purpose; the finaliser of MurmurHash3.
double Random(uint64_t seed, int64_t i, int64_t j, uint64_t purpose) {
  uint64_t h = (static_cast<uint64_t>(i) * 73856093) ^ (static_cast<uint64_t>(j) * 19349663) ^ (seed * 83492791 + 1);
  h += purpose * 0x9e3779b97f4a7c15;
  h = (h ^ (h >> 33)) * 0xff51afd7ed558ccd;
  h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53;
  return static_cast<double>((h ^ (h >> 33)) >> 11) * 0x1p-53;
}

// One octave of value noise in [0, 1], twice differentiable, over a lattice of side 1.
double ValueNoise(uint64_t seed, double x, double y, uint64_t purpose) {
  const double i = std::floor(x);
  const double j = std::floor(y);
  const auto fade = [](double t) { return t * t * t * (t * (6 * t - 15) + 10); };
  const auto corner = [&](int di, int dj) {
    return Random(seed, static_cast<int64_t>(i) + di, static_cast<int64_t>(j) + dj, purpose);
  };
  const double u = fade(x - i);
  const double v = fade(y - j);
  return std::lerp(std::lerp(corner(0, 0), corner(1, 0), u), std::lerp(corner(0, 1), corner(1, 1), u), v);
}

// Octaves of value noise, each half as wide and 0.45 times as high as the one before; about 0 to 1.
double Fractal(uint64_t seed, double x, double y, int octaves, uint64_t purpose) {
  double sum = 0;
  double total = 0;
  double weight = 1;
  for (int k = 0; k < octaves; ++k, weight *= 0.45, x *= 2, y *= 2) {
    sum += weight * ValueNoise(seed, x, y, purpose + k);
    total += weight;
  }
  return sum / total;
}

double FeatureSize(const SceneMakerOptions& o) { return o.feature_size > 0 ? o.feature_size : o.cell_size; }

double Height(const SceneMakerOptions& o, double x, double y) {
  if (o.terrain) return o.terrain(x, y);
  const double scale = 1 / FeatureSize(o);
  const double waves = 0.5 * std::sin(x * scale * 1.7 + 0.3) + 0.3 * std::sin(y * scale * 2.3 + 1.1) +
                       0.2 * std::sin((x + y) * scale * 4.1);
  return o.relief * (0.25 * waves + 0.75 * (Fractal(o.seed, x * scale * 1.3, y * scale * 1.3, 4, 100) - 0.5));
}

// Where the surface is removed.
class Holes {
 public:
  explicit Holes(const SceneMakerOptions& options) : o_(options) {
    width_ = o_.cols * o_.cell_size;
    height_ = o_.rows * o_.cell_size;
    if (o_.lakes) lake_level_ = Level(200, 1 - o_.lake_share);
    if (o_.islands) island_level_ = Level(300, 0.9);
    AddShapes();
  }

  bool Contains(double x, double y) const {
    return InLake(x, y) || InRiver(x, y) || InShape(x, y) || empty_.contains(CellAt({x, y}));
  }

 private:
  double Field(uint64_t purpose, double x, double y) const {
    const double scale = (purpose == 200 ? 0.8 : 4) / FeatureSize(o_);
    return Fractal(o_.seed + 7, x * scale, y * scale, 3, purpose);
  }

  // The value that `share` of the scene lies below.
  double Level(uint64_t purpose, double share) const {
    constexpr int kSamples = 64;
    std::vector<double> values;
    for (int j = 0; j < kSamples; ++j) {
      for (int i = 0; i < kSamples; ++i) {
        values.push_back(Field(purpose, (i + 0.5) / kSamples * width_, (j + 0.5) / kSamples * height_));
      }
    }
    const auto at = values.begin() + static_cast<ptrdiff_t>(std::clamp(share, 0.0, 1.0) * (values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  }

  void AddShapes() {
    for (const EllipseHole& ellipse : o_.ellipses) AddEllipse(ellipse);
    empty_.insert(o_.empty.begin(), o_.empty.end());
    const auto count = static_cast<int64_t>(std::llround(o_.small_per_cell * o_.cols * o_.rows));
    for (int64_t k = 0; k < count; ++k) {
      const auto random = [&](uint64_t purpose) { return Random(o_.seed + 5, k, 0, purpose); };
      const double radius = o_.spacing * (1.5 + 4.5 * random(2));
      AddEllipse({{random(0) * width_, random(1) * height_}, {radius, radius * (0.4 + 0.6 * random(3))}});
    }
  }

  // Files the ellipse under every cell that it may reach: looking through all small holes of a scene would take too
  // long.
  void AddEllipse(const EllipseHole& ellipse) {
    const CellId first = CellAt(ellipse.centre - ellipse.radii);
    const CellId last = CellAt(ellipse.centre + ellipse.radii);
    for (int32_t row = std::max(first.row, 0); row <= std::min(last.row, o_.rows - 1); ++row) {
      for (int32_t col = std::max(first.col, 0); col <= std::min(last.col, o_.cols - 1); ++col) {
        ellipses_[{col, row}].push_back(ellipse);
      }
    }
  }

  CellId CellAt(const Point2& p) const {
    return {static_cast<int32_t>(std::floor(p.x() / o_.cell_size)),
            static_cast<int32_t>(std::floor(p.y() / o_.cell_size))};
  }

  bool InLake(double x, double y) const {
    if (!o_.lakes || Field(200, x, y) <= lake_level_) return false;
    return !o_.islands || Field(300, x, y) < island_level_;
  }

  bool InRiver(double x, double y) const {
    if (!o_.river) return false;
    const double size = FeatureSize(o_);
    const double t = x / size;
    const double phase = 6.28 * Random(o_.seed, 0, 0, 400);
    const double middle = height_ / 2 + size * (0.3 * std::sin(1.1 * t + phase) + 0.08 * std::sin(3.7 * t));
    return std::abs(y - middle) < size * (0.1 + 0.03 * std::sin(2.3 * t + phase));
  }

  bool InShape(double x, double y) const {
    const auto in_ellipse = [x, y](const EllipseHole& e) {
      return (Point2(x, y) - e.centre).cwiseQuotient(e.radii).squaredNorm() < 1;
    };
    const auto in_box = [x, y](const BoxHole& b) {
      return x > b.lo.x() && x < b.hi.x() && y > b.lo.y() && y < b.hi.y();
    };
    if (std::any_of(o_.boxes.begin(), o_.boxes.end(), in_box)) return true;
    const auto at = ellipses_.find(CellAt({x, y}));
    return at != ellipses_.end() && std::any_of(at->second.begin(), at->second.end(), in_ellipse);
  }

  SceneMakerOptions o_;
  double width_ = 0, height_ = 0, lake_level_ = 0, island_level_ = 0;
  std::map<CellId, std::vector<EllipseHole>> ellipses_;
  std::set<CellId> empty_;
};

// A vertex by its column and row in the whole scene.
struct GridIndex {
  int64_t i = 0;
  int64_t j = 0;
  auto operator<=>(const GridIndex&) const = default;
};

// The full surface, vertex by vertex and triangle by triangle.
class Surface {
 public:
  explicit Surface(const SceneMakerOptions& options)
      : o_(options), per_cell_(std::max<int64_t>(1, std::llround(options.cell_size / options.spacing))) {}

  int64_t per_cell() const { return per_cell_; }

  Point3 Vertex(GridIndex at) const {
    // Vertices on the scene's rim, and of a clipped cut all on grid lines, stay there.
    const auto moves = [this](int64_t index, int64_t cells) {
      return o_.cut == Cut::kClipped ? index % per_cell_ != 0 : index != 0 && index != cells * per_cell_;
    };
    const double step = o_.cell_size / static_cast<double>(per_cell_);
    const double dx = moves(at.i, o_.cols) ? kJitter * (Random(o_.seed, at.i, at.j, 1) - 0.5) : 0;
    const double dy = moves(at.j, o_.rows) ? kJitter * (Random(o_.seed, at.i, at.j, 2) - 0.5) : 0;
    const double x = (static_cast<double>(at.i) + dx) * step;
    const double y = (static_cast<double>(at.j) + dy) * step;
    const double z = Height(o_, x, y) + o_.noise * (Random(o_.seed, at.i, at.j, 3) - 0.5);
    return Point3(x, y, z).cast<float>().cast<double>();
  }

  // The two triangles of the square whose low corner is `at`, counter-clockwise from above.
  std::array<std::array<GridIndex, 3>, 2> Square(GridIndex at) const {
    const GridIndex a = at, b{at.i + 1, at.j}, c{at.i + 1, at.j + 1}, d{at.i, at.j + 1};
    if (Random(o_.seed, at.i, at.j, 4) > 0.5) return {{{a, b, c}, {a, c, d}}};
    return {{{a, b, d}, {b, c, d}}};
  }

 private:
  SceneMakerOptions o_;
  int64_t per_cell_;
};

// Builds the mesh of one tile.
class TileBuilder {
 public:
  TileBuilder(const SceneMakerOptions& options, const Surface& surface, const Holes& holes, CellId cell)
      : o_(options), surface_(surface), holes_(holes), cell_(cell) {}

  // Appends the vertices that only the removed surface has to `removed`.
  TriMesh Build(std::vector<Point3>* removed) {
    const int64_t n = surface_.per_cell();
    // The triangles of a ragged tile may lie in squares just over its borders.
    const int64_t margin = o_.cut == Cut::kRagged ? 1 : 0;
    const auto first = [&](int32_t index) { return std::max<int64_t>(index * n - margin, 0); };
    const auto last = [&](int32_t index, int32_t cells) { return std::min((index + 1) * n + margin, cells * n); };
    for (int64_t j = first(cell_.row); j < last(cell_.row, o_.rows); ++j) {
      for (int64_t i = first(cell_.col); i < last(cell_.col, o_.cols); ++i) {
        for (const std::array<GridIndex, 3>& corners : surface_.Square({i, j})) AddTriangle(corners);
      }
    }
    for (const auto& [at, point] : gone_) {
      if (!index_.contains(at)) removed->push_back(point);
    }
    return std::move(mesh_);
  }

 private:
  void AddTriangle(const std::array<GridIndex, 3>& corners) {
    std::array<Point3, 3> points;
    for (int k = 0; k < 3; ++k) points[k] = surface_.Vertex(corners[k]);
    const Point3 centroid = (points[0] + points[1] + points[2]) / 3;
    const CellId home{static_cast<int32_t>(std::floor(centroid.x() / o_.cell_size)),
                      static_cast<int32_t>(std::floor(centroid.y() / o_.cell_size))};
    if (home != cell_) return;
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
  const Surface& surface_;
  const Holes& holes_;
  CellId cell_;
  TriMesh mesh_;
  std::map<GridIndex, int32_t> index_;
  std::map<GridIndex, Point3> gone_;
};

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
  const auto holes = std::make_shared<const Holes>(options);
  scene.height = [options](double x, double y) { return Height(options, x, y); };
  scene.is_in_hole = [holes](double x, double y) { return holes->Contains(x, y); };
  const Surface surface(options);
  const std::set<CellId> away(options.out_of_area.begin(), options.out_of_area.end());
  for (int32_t row = 0; row < options.rows; ++row) {
    for (int32_t col = 0; col < options.cols; ++col) {
      if (away.contains({col, row})) continue;
      TileBuilder builder(options, surface, *holes, {col, row});
      scene.tiles.push_back({{col, row}, builder.Build(&scene.removed)});
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
