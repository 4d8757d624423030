#include "worker/texture/fill_parts.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <utility>

#include "worker/texture/pixel_masks.h"

namespace tilemend {
namespace {

constexpr double kSiteSquare = 0.5;                    // metres
constexpr double kLeastMargin = 6, kMostMargin = 20;   // metres
constexpr double kFrameStep = 4;                       // metres
constexpr double kSteep = 0.70710678118654752;         // cosine of 45 degrees
constexpr double kGroundBlock = 32, kMostOfBlock = 8;  // metres: squares of the ground, and what shares a raster there

SpaceTriangle CornersOf(const FilledFaces& faces, size_t t) {
  const Triangle& f = faces.triangles[t];
  return {faces.points[static_cast<size_t>(f[0])], faces.points[static_cast<size_t>(f[1])],
          faces.points[static_cast<size_t>(f[2])]};
}

// The number of the square that holds a point; -1 outside of the frame.
int32_t NumberAt(const RasterFrame& frame, const std::vector<int32_t>& numbers, const Point3& p) {
  const Point2 at = frame.PixelsOf(p);
  const auto x = static_cast<int64_t>(std::floor(at.x())), y = static_cast<int64_t>(std::floor(at.y()));
  return frame.Has(x, y) ? numbers[frame.At(static_cast<int32_t>(x), static_cast<int32_t>(y))] : -1;
}

// The squares of a site that hold flat faces of the fill, or nothing inside a cell.
class Regions {
 public:
  Regions(const FilledFaces& faces, const OrthoRaster& site, std::span<const Eigen::AlignedBox2d> cells)
      : frame_(site.frame), mask_(frame_.size()) {
    OrthoRaster fill(frame_);
    for (size_t t = 0; t < faces.triangles.size(); ++t) {
      const SpaceTriangle corners = CornersOf(faces, t);
      if (IsSteepFace(corners)) continue;
      DrawShapes(std::span(&corners, 1), fill);
      for (const Point3& p : corners) Mark(p);
      Mark((corners[0] + corners[1] + corners[2]) / 3);
    }
    for (size_t i = 0; i < mask_.size(); ++i) mask_[i] |= fill.heights[i] != kNoSurface ? 1 : 0;
    for (const Eigen::AlignedBox2d& cell : cells) MarkBare(cell, site);
    Label();
  }

  // The region at a point; -1: none.
  int32_t At(const Point3& p) const { return NumberAt(frame_, labels_, p); }

  const RasterFrame& frame() const { return frame_; }
  const std::vector<int32_t>& labels() const { return labels_; }

  const Eigen::AlignedBox2d& BoxOf(int32_t region) const { return boxes_[static_cast<size_t>(region)]; }

 private:
  void Mark(const Point3& p) {
    const Point2 at = frame_.PixelsOf(p);
    const auto x = static_cast<int64_t>(std::floor(at.x())), y = static_cast<int64_t>(std::floor(at.y()));
    if (frame_.Has(x, y)) mask_[frame_.At(static_cast<int32_t>(x), static_cast<int32_t>(y))] = 1;
  }

  void MarkBare(const Eigen::AlignedBox2d& cell, const OrthoRaster& site) {
    const Point2 lo = frame_.PixelsOf({cell.min().x(), cell.min().y(), 0}),
                 hi = frame_.PixelsOf({cell.max().x(), cell.max().y(), 0});
    const auto first = [](double p) { return static_cast<int32_t>(std::max(0.0, std::ceil(p - 0.5))); };
    const auto end = [](double p, int32_t most) {
      return static_cast<int32_t>(std::clamp(std::ceil(p - 0.5), 0.0, double{1} * most));
    };
    for (int32_t y = first(lo.y()); y < end(hi.y(), frame_.height); ++y) {
      for (int32_t x = first(lo.x()); x < end(hi.x(), frame_.width); ++x) {
        if (site.heights[frame_.At(x, y)] == kNoSurface) mask_[frame_.At(x, y)] = 1;
      }
    }
  }

  // Regions of squares that touch at a side or a corner, in the order of their first squares.
  void Label() {
    labels_.assign(mask_.size(), -1);
    std::vector<std::pair<int32_t, int32_t>> open;
    for (int32_t y = 0; y < frame_.height; ++y) {
      for (int32_t x = 0; x < frame_.width; ++x) {
        if (mask_[frame_.At(x, y)] == 0 || labels_[frame_.At(x, y)] >= 0) continue;
        const auto region = static_cast<int32_t>(boxes_.size());
        boxes_.emplace_back();
        open.assign(1, {x, y});
        labels_[frame_.At(x, y)] = region;
        while (!open.empty()) {
          const auto [px, py] = open.back();
          open.pop_back();
          Visit(px, py, region, open);
        }
      }
    }
  }

  void Visit(int32_t px, int32_t py, int32_t region, std::vector<std::pair<int32_t, int32_t>>& open) {
    const Point2 corner(static_cast<double>(frame_.column + px), static_cast<double>(frame_.row + py));
    boxes_[static_cast<size_t>(region)].extend(Point2(corner * frame_.texel));
    boxes_[static_cast<size_t>(region)].extend(Point2((corner + Point2(1, 1)) * frame_.texel));
    for (int32_t y = std::max(0, py - 1); y <= std::min(frame_.height - 1, py + 1); ++y) {
      for (int32_t x = std::max(0, px - 1); x <= std::min(frame_.width - 1, px + 1); ++x) {
        const size_t at = frame_.At(x, y);
        if (mask_[at] == 0 || labels_[at] >= 0) continue;
        labels_[at] = region;
        open.emplace_back(x, y);
      }
    }
  }

  const RasterFrame frame_;
  PixelMask mask_;
  std::vector<int32_t> labels_;
  std::vector<Eigen::AlignedBox2d> boxes_;
};

// `largest` is the size of the largest region in the box.
RasterFrame FrameAround(const Eigen::AlignedBox2d& region, double largest, double texel) {
  const Point2 margin = Point2::Constant(std::clamp(2 * largest, kLeastMargin, kMostMargin));
  const auto down = [](double v) { return std::floor(v / kFrameStep) * kFrameStep; };
  const auto up = [](double v) { return std::ceil(v / kFrameStep) * kFrameStep; };
  const Point2 lo = (region.min() - margin).unaryExpr(down), hi = (region.max() + margin).unaryExpr(up);
  const auto pixels = [&] { return (hi.x() - lo.x()) / texel * ((hi.y() - lo.y()) / texel); };
  while (pixels() > static_cast<double>(kMostRasterPixels)) texel *= 2;
  // The last pixel ends at the upper corner.
  return FrameOf({lo, hi - Point2::Constant(texel / 2)}, texel);
}

// Gives points of steep faces the colours of points that have one, ring by ring. A point takes the first colour that
// its faces have, in their order.
void HandOn(const FilledFaces& faces, const std::vector<size_t>& steep, std::vector<std::optional<Rgb>>& colours) {
  for (bool spreads = true; spreads;) {
    std::vector<std::pair<int32_t, Rgb>> ring;
    for (const size_t t : steep) {
      const Triangle& f = faces.triangles[t];
      const auto known =
          std::find_if(f.begin(), f.end(), [&](int32_t v) { return colours[static_cast<size_t>(v)].has_value(); });
      if (known == f.end()) continue;
      for (const int32_t v : f) {
        if (!colours[static_cast<size_t>(v)]) ring.emplace_back(v, *colours[static_cast<size_t>(*known)]);
      }
    }
    spreads = !ring.empty();
    for (auto it = ring.rbegin(); it != ring.rend(); ++it) colours[static_cast<size_t>(it->first)] = it->second;
  }
}

}  // namespace

bool IsSteepFace(const SpaceTriangle& c) {
  const Point3 normal = (c[1] - c[0]).cross(c[2] - c[0]);
  return !(normal.z() >= kSteep * normal.norm()) || normal.z() == 0;
}

OrthoRaster SiteRaster(const Eigen::AlignedBox2d& box) {
  double square = kSiteSquare;
  while (box.volume() / (square * square) > static_cast<double>(kMostRasterPixels)) square *= 2;
  return OrthoRaster(FrameOf(box, square));
}

namespace {

// What shares a raster: small regions of ground in a block of the lattice, or one region alone (block and region).
struct Sharing {
  int64_t block_row = 0, block_column = 0;
  int32_t region = -1;
  auto operator<=>(const Sharing&) const = default;
};

Sharing SharingOf(int32_t region, const Eigen::AlignedBox2d& box, bool has_water) {
  if (has_water || box.sizes().maxCoeff() > kMostOfBlock) return {0, 0, region};
  const Point2 block = (box.center() / kGroundBlock).unaryExpr([](double v) { return std::floor(v); });
  return {static_cast<int64_t>(block.y()), static_cast<int64_t>(block.x()), -1};
}

// The block, or the region in `box`. Not the box of small regions: two cells do not see the same ones.
Eigen::AlignedBox2d PlaceOf(const Sharing& sharing, const Eigen::AlignedBox2d& box) {
  if (sharing.region >= 0) return box;
  const Point2 lo = Point2(static_cast<double>(sharing.block_column), static_cast<double>(sharing.block_row));
  return {lo * kGroundBlock, (lo + Point2(1, 1)) * kGroundBlock};
}

}  // namespace

FillParts PlanParts(const FilledFaces& faces, const OrthoRaster& site, std::span<const Eigen::AlignedBox2d> cells,
                    const TexelOfPlace& texel) {
  const Regions regions(faces, site, cells);
  std::map<int32_t, bool> has_water;  // by region
  std::vector<int32_t> region_of;
  for (size_t t = 0; t < faces.triangles.size(); ++t) {
    const SpaceTriangle corners = CornersOf(faces, t);
    region_of.push_back(IsSteepFace(corners) ? -1 : regions.At((corners[0] + corners[1] + corners[2]) / 3));
    if (region_of.back() >= 0) has_water[region_of.back()] |= faces.is_water[t] != 0;
  }
  std::map<Sharing, std::vector<int32_t>> shared;
  for (const auto& [region, water] : has_water) {
    shared[SharingOf(region, regions.BoxOf(region), water)].push_back(region);
  }
  FillParts parts;
  std::map<int32_t, int32_t> part_of_region;
  for (const auto& [key, members] : shared) {
    Eigen::AlignedBox2d box;
    double largest = 0;
    for (const int32_t region : members) {
      part_of_region[region] = static_cast<int32_t>(parts.frames.size());
      box.extend(regions.BoxOf(region));
      largest = std::max(largest, regions.BoxOf(region).sizes().maxCoeff());
    }
    parts.frames.push_back(FrameAround(box, largest, texel(PlaceOf(key, box))));
  }
  parts.triangles.resize(parts.frames.size());
  for (size_t t = 0; t < region_of.size(); ++t) {
    const int32_t part = region_of[t] < 0 ? -1 : part_of_region.at(region_of[t]);
    parts.of_triangles.push_back(part);
    if (part >= 0) parts.triangles[static_cast<size_t>(part)].push_back(static_cast<int32_t>(t));
  }
  parts.site = regions.frame();
  for (const int32_t region : regions.labels()) {
    const auto part = part_of_region.find(region);
    parts.of_squares.push_back(part == part_of_region.end() ? -1 : part->second);
  }
  return parts;
}

int32_t FillParts::At(const Point3& place) const { return NumberAt(site, of_squares, place); }

FillMap FillMapOf(const FilledFaces& faces, const FillParts& parts, int32_t part, const OrthoRaster& raster) {
  FillMap map{std::vector<FillPixel>(raster.frame.size(), FillPixel::kNone),
              std::vector<float>(raster.frame.size(), kNoSurface)};
  std::vector<FillPixel>& pixels = map.pixels;
  for (size_t i = 0; i < pixels.size(); ++i) {
    if (raster.heights[i] == kNoSurface) pixels[i] = FillPixel::kForeign;
  }
  const Eigen::AlignedBox2d box = BoxOf(raster.frame);
  for (const FillPixel layer : {FillPixel::kForeign, FillPixel::kGround, FillPixel::kWater}) {
    OrthoRaster fill(raster.frame);
    for (size_t other = 0; other < parts.frames.size(); ++other) {
      const bool is_own = other == static_cast<size_t>(part);
      if (is_own == (layer == FillPixel::kForeign) || !BoxOf(parts.frames[other]).intersects(box)) continue;
      for (const int32_t t : parts.triangles[other]) {
        const bool is_water = faces.is_water[static_cast<size_t>(t)] != 0;
        if (is_own && is_water != (layer == FillPixel::kWater)) continue;
        const SpaceTriangle corners = CornersOf(faces, static_cast<size_t>(t));
        DrawShapes(std::span(&corners, 1), fill);
      }
    }
    for (size_t i = 0; i < pixels.size(); ++i) {
      if (fill.heights[i] == kNoSurface) continue;
      pixels[i] = layer;
      map.heights[i] = fill.heights[i];
    }
  }
  return map;
}

FillLook LookOf(const FilledFaces& faces, const FillParts& parts, int32_t part) {
  FillLook look;
  std::vector<double> levels;
  for (const int32_t triangle : parts.triangles[static_cast<size_t>(part)]) {
    const auto t = static_cast<size_t>(triangle);
    (faces.is_water[t] != 0 ? look.water : look.ground) = faces.flat[t];
    if (faces.is_water[t] == 0) continue;
    for (const Point3& p : CornersOf(faces, t)) levels.push_back(p.z());
  }
  if (levels.empty()) return look;
  const auto middle = levels.begin() + static_cast<std::ptrdiff_t>(levels.size() / 2);
  std::nth_element(levels.begin(), middle, levels.end());
  look.water_level = *middle;
  return look;
}

std::vector<int32_t> SteepPoints(const FilledFaces& faces, const FillParts& parts) {
  std::vector<int32_t> points;
  for (size_t t = 0; t < faces.triangles.size(); ++t) {
    if (parts.of_triangles[t] < 0) points.insert(points.end(), faces.triangles[t].begin(), faces.triangles[t].end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

std::vector<Rgb> SteepColours(const FilledFaces& faces, const FillParts& parts, std::span<const std::optional<Rgb>> rim,
                              std::span<const MadeRaster> rasters) {
  std::vector<std::optional<Rgb>> colours(rim.begin(), rim.end());
  std::vector<size_t> steep;
  for (size_t t = 0; t < faces.triangles.size(); ++t) {
    if (parts.of_triangles[t] < 0) steep.push_back(t);
  }
  HandOn(faces, steep, colours);
  const auto from_above = [&](const Point3& p) -> std::optional<Rgb> {
    for (const MadeRaster& raster : rasters) {
      const Point2 at = raster.frame.PixelsOf(p);
      const auto x = static_cast<int64_t>(std::floor(at.x())), y = static_cast<int64_t>(std::floor(at.y()));
      if (raster.frame.Has(x, y))
        return raster.colours[raster.frame.At(static_cast<int32_t>(x), static_cast<int32_t>(y))];
    }
    return std::nullopt;
  };
  std::vector<Rgb> result(3 * faces.triangles.size());
  for (const size_t t : steep) {
    for (size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<size_t>(faces.triangles[t][k]);
      if (!colours[v]) colours[v] = from_above(faces.points[v]).value_or(faces.flat[t]);
      result[3 * t + k] = *colours[v];
    }
  }
  return result;
}

}  // namespace tilemend
