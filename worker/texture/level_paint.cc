#include "worker/texture/level_paint.h"

#include <cmath>
#include <optional>
#include <utility>

namespace tilemend {
namespace {

// Rounds down.
int64_t Half(int64_t value) { return value >> 1; }

// The means of four pixels.
MadeRaster Halved(const MadeRaster& fine) {
  MadeRaster coarse;
  coarse.frame.texel = 2 * fine.frame.texel;
  coarse.frame.column = Half(fine.frame.column);
  coarse.frame.row = Half(fine.frame.row);
  coarse.frame.width = static_cast<int32_t>(Half(fine.frame.column + fine.frame.width - 1) + 1 - coarse.frame.column);
  coarse.frame.height = static_cast<int32_t>(Half(fine.frame.row + fine.frame.height - 1) + 1 - coarse.frame.row);
  std::vector<std::array<int32_t, 4>> sums(coarse.frame.size());  // of the channels, and how many pixels
  for (int32_t y = 0; y < fine.frame.height; ++y) {
    for (int32_t x = 0; x < fine.frame.width; ++x) {
      const auto to_x = static_cast<int32_t>(Half(fine.frame.column + x) - coarse.frame.column),
                 to_y = static_cast<int32_t>(Half(fine.frame.row + y) - coarse.frame.row);
      std::array<int32_t, 4>& sum = sums[coarse.frame.At(to_x, to_y)];
      const Rgb c = fine.colours[fine.frame.At(x, y)];
      sum = {sum[0] + c.r, sum[1] + c.g, sum[2] + c.b, sum[3] + 1};
    }
  }
  for (const std::array<int32_t, 4>& sum : sums) {
    const auto mean = [&](size_t k) { return static_cast<uint8_t>((2 * sum[k] + sum[3]) / (2 * sum[3])); };
    coarse.colours.push_back({mean(0), mean(1), mean(2)});
  }
  return coarse;
}

Point3 CentreOf(const RasterFrame& frame, int32_t x, int32_t y) {
  return {(static_cast<double>(frame.column + x) + 0.5) * frame.texel,
          (static_cast<double>(frame.row + y) + 0.5) * frame.texel, 0};
}

std::optional<size_t> PixelAt(const RasterFrame& frame, const Point3& p) {
  const Point2 at = frame.PixelsOf(p);
  const auto x = static_cast<int64_t>(std::floor(at.x())), y = static_cast<int64_t>(std::floor(at.y()));
  if (!frame.Has(x, y)) return std::nullopt;
  return frame.At(static_cast<int32_t>(x), static_cast<int32_t>(y));
}

}  // namespace

LevelPaint::LevelPaint(FillParts parts, std::vector<MadeRaster> rasters, std::map<std::array<double, 3>, Rgb> rim)
    : parts_(std::move(parts)), rim_(std::move(rim)) {
  rasters_[0] = std::move(rasters);
}

Atlas LevelPaint::AtlasOf(std::span<const Point3> points, std::span<const Triangle> triangles,
                          std::span<const Rgb> colours, int32_t above_finest) {
  FilledFaces faces{{points.begin(), points.end()},
                    {triangles.begin(), triangles.end()},
                    std::vector<uint8_t>(triangles.size()),
                    {colours.begin(), colours.end()}};
  FillParts parts;
  for (const Triangle& t : triangles) {
    const SpaceTriangle corners = {points[static_cast<size_t>(t[0])], points[static_cast<size_t>(t[1])],
                                   points[static_cast<size_t>(t[2])]};
    parts.of_triangles.push_back(IsSteepFace(corners) ? -1 : PartOf((corners[0] + corners[1] + corners[2]) / 3));
  }
  std::vector<std::optional<Rgb>> rim(points.size());
  for (const int32_t v : SteepPoints(faces, parts)) {
    const Point3& p = points[static_cast<size_t>(v)];
    if (const auto known = rim_.find({p.x(), p.y(), p.z()}); known != rim_.end()) {
      rim[static_cast<size_t>(v)] = known->second;
    }
  }
  const std::vector<MadeRaster>& rasters = RastersAt(above_finest);
  std::vector<Rgb> steep = SteepColours(faces, parts, rim, rasters);
  return PackAtlas({faces.points, faces.triangles, std::move(parts.of_triangles), std::move(steep)}, rasters);
}

const std::vector<MadeRaster>& LevelPaint::RastersAt(int32_t above_finest) {
  const auto [at, fresh] = rasters_.try_emplace(above_finest);
  if (!fresh) return at->second;
  const std::vector<MadeRaster> finer = above_finest == 1 ? Joined() : RastersAt(above_finest - 1);
  for (const MadeRaster& raster : finer) at->second.push_back(Halved(raster));
  return at->second;
}

// The rasters with the colours of other parts where these are.
std::vector<MadeRaster> LevelPaint::Joined() const {
  const std::vector<MadeRaster>& made = rasters_.at(0);
  std::vector<MadeRaster> joined = made;
  for (size_t part = 0; part < joined.size(); ++part) {
    const RasterFrame& frame = joined[part].frame;
    for (int32_t y = 0; y < frame.height; ++y) {
      for (int32_t x = 0; x < frame.width; ++x) {
        const Point3 centre = CentreOf(frame, x, y);
        const int32_t other = parts_.At(centre);
        if (other < 0 || static_cast<size_t>(other) == part) continue;
        const MadeRaster& of_other = made[static_cast<size_t>(other)];
        if (const auto pixel = PixelAt(of_other.frame, centre)) {
          joined[part].colours[frame.At(x, y)] = of_other.colours[*pixel];
        }
      }
    }
  }
  return joined;
}

// That which lies there, or the first whose raster has the place; -1: none.
int32_t LevelPaint::PartOf(const Point3& middle) const {
  if (const int32_t part = parts_.At(middle); part >= 0) return part;
  const std::vector<MadeRaster>& made = rasters_.at(0);
  for (size_t part = 0; part < made.size(); ++part) {
    if (PixelAt(made[part].frame, middle)) return static_cast<int32_t>(part);
  }
  return -1;
}

}  // namespace tilemend
