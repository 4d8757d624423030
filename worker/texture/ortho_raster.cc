#include "worker/texture/ortho_raster.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tilemend {
namespace {

constexpr int kMostSamplesAlong = 4;  // of a raster pixel

// The plane of a triangle over the raster: what share each corner has at a pixel.
class Cover {
 public:
  Cover(const SpaceTriangle& corners, const RasterFrame& frame) : frame_(frame) {
    for (size_t k = 0; k < 3; ++k) at_[k] = frame.PixelsOf(corners[k]);
    area_ = Cross(at_[1] - at_[0], at_[2] - at_[0]);
  }

  double area() const { return std::abs(area_); }  // twice that of the triangle, in pixels

  std::array<double, 3> SharesAt(const Point2& p) const {
    const double b = Cross(p - at_[0], at_[2] - at_[0]) / area_;
    const double c = Cross(at_[1] - at_[0], p - at_[0]) / area_;
    return {1 - b - c, b, c};
  }

  // Calls `use(x, y, shares)` for the pixels whose centres lie in the triangle or on its edge.
  template <typename Use>
  void ForEachPixel(const Use& use) const {
    constexpr double kLeastArea = 1e-9;  // upright but for rounding
    if (!(area() > kLeastArea)) return;
    Point2 lo = at_[0].cwiseMin(at_[1]).cwiseMin(at_[2]), hi = at_[0].cwiseMax(at_[1]).cwiseMax(at_[2]);
    lo = lo.cwiseMax(Point2(0, 0));
    hi = hi.cwiseMin(Point2(frame_.width, frame_.height));
    if (!(lo.x() <= hi.x() && lo.y() <= hi.y())) return;
    const auto first_x = static_cast<int32_t>(lo.x()), first_y = static_cast<int32_t>(lo.y());
    const int32_t end_x = std::min(frame_.width, static_cast<int32_t>(hi.x()) + 1);
    const int32_t end_y = std::min(frame_.height, static_cast<int32_t>(hi.y()) + 1);
    for (int32_t y = first_y; y < end_y; ++y) {
      for (int32_t x = first_x; x < end_x; ++x) {
        const std::array<double, 3> s = SharesAt({x + 0.5, y + 0.5});
        if (s[0] >= 0 && s[1] >= 0 && s[2] >= 0) use(x, y, s);
      }
    }
  }

 private:
  static double Cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

  const RasterFrame& frame_;
  std::array<Point2, 3> at_;
  double area_ = 0;
};

float HeightAt(const SpaceTriangle& corners, const std::array<double, 3>& s) {
  return static_cast<float>(s[0] * corners[0].z() + s[1] * corners[1].z() + s[2] * corners[2].z());
}

// The pixel `i` of `count`, the image repeated.
int64_t Repeated(int64_t i, int64_t count) {
  const int64_t rest = i % count;
  return rest < 0 ? rest + count : rest;
}

// Adds the bilinear colour at u, v. Texture coordinates beyond kFarthest are a mistake, and give the corner's pixel.
void AddSample(const Image& image, double u, double v, std::array<double, 3>& sum) {
  constexpr double kFarthest = 1e6;
  const double x = std::clamp(u, -kFarthest, kFarthest) * image.width - 0.5;
  const double y = (1 - std::clamp(v, -kFarthest, kFarthest)) * image.height - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  const std::array<double, 2> along = {1 - (x - left), x - left}, down = {1 - (y - top), y - top};
  for (int j = 0; j < 2; ++j) {
    const int64_t row = Repeated(static_cast<int64_t>(top) + j, image.height);
    for (int i = 0; i < 2; ++i) {
      const int64_t column = Repeated(static_cast<int64_t>(left) + i, image.width);
      const uint8_t* const pixel = &image.pixels[static_cast<size_t>((row * image.width + column) * image.channels)];
      const double weight = along[static_cast<size_t>(i)] * down[static_cast<size_t>(j)];
      for (size_t c = 0; c < 3; ++c) sum[c] += weight * pixel[c];
    }
  }
}

Rgb Rounded(const std::array<double, 3>& sum, double count) {
  const auto channel = [&](double value) { return static_cast<uint8_t>(std::clamp(value / count + 0.5, 0.0, 255.0)); };
  return {channel(sum[0]), channel(sum[1]), channel(sum[2])};
}

double AreaOf(const std::array<float, 2>& a, const std::array<float, 2>& b, const std::array<float, 2>& c) {
  const double ux = double{b[0]} - a[0], uy = double{b[1]} - a[1], vx = double{c[0]} - a[0], vy = double{c[1]} - a[1];
  return std::abs(ux * vy - uy * vx);
}

void DrawFace(const TexturedFace& face, const Image& image, OrthoRaster& raster) {
  const Cover cover(face.corners, raster.frame);
  const double pixels = AreaOf(face.uv[0], face.uv[1], face.uv[2]) * image.width * image.height;
  const int along = static_cast<int>(
      std::clamp(std::ceil(std::sqrt(pixels / cover.area()) - 0.25), 1.0, static_cast<double>(kMostSamplesAlong)));
  const auto colour_at = [&](int32_t x, int32_t y) {
    std::array<double, 3> sum{};
    for (int j = 0; j < along; ++j) {
      for (int i = 0; i < along; ++i) {
        const std::array<double, 3> s = cover.SharesAt({x + (i + 0.5) / along, y + (j + 0.5) / along});
        double u = 0, v = 0;
        for (size_t k = 0; k < 3; ++k) {
          u += s[k] * double{face.uv[k][0]};
          v += s[k] * double{face.uv[k][1]};
        }
        AddSample(image, u, v, sum);
      }
    }
    return Rounded(sum, along * along);
  };
  cover.ForEachPixel([&](int32_t x, int32_t y, const std::array<double, 3>& s) {
    const size_t at = raster.frame.At(x, y);
    const float height = HeightAt(face.corners, s);
    if (!(height > raster.heights[at])) return;
    raster.heights[at] = height;
    raster.known[at] = kImageColour;
    raster.colours[at] = colour_at(x, y);
  });
}

}  // namespace

RasterFrame FrameOf(const Eigen::AlignedBox2d& box, double texel) {
  RasterFrame frame;
  frame.texel = texel;
  frame.column = static_cast<int64_t>(std::floor(box.min().x() / texel));
  frame.row = static_cast<int64_t>(std::floor(box.min().y() / texel));
  frame.width = static_cast<int32_t>(static_cast<int64_t>(std::floor(box.max().x() / texel)) + 1 - frame.column);
  frame.height = static_cast<int32_t>(static_cast<int64_t>(std::floor(box.max().y() / texel)) + 1 - frame.row);
  return frame;
}

Eigen::AlignedBox2d BoxOf(const RasterFrame& frame) {
  const Point2 lo = Point2(static_cast<double>(frame.column), static_cast<double>(frame.row)) * frame.texel;
  return {lo, lo + Point2(frame.width, frame.height) * frame.texel};
}

OrthoRaster::OrthoRaster(const RasterFrame& of)
    : frame(of), colours(of.size()), heights(of.size(), kNoSurface), known(of.size()) {}

void DrawFaces(std::span<const TexturedFace> faces, const Image& image, OrthoRaster& raster) {
  for (const TexturedFace& face : faces) DrawFace(face, image, raster);
}

void DrawShapes(std::span<const SpaceTriangle> shapes, OrthoRaster& raster, std::optional<Rgb> colour) {
  for (const SpaceTriangle& corners : shapes) {
    Cover(corners, raster.frame).ForEachPixel([&](int32_t x, int32_t y, const std::array<double, 3>& s) {
      const size_t at = raster.frame.At(x, y);
      const float height = HeightAt(corners, s);
      if (!(height > raster.heights[at])) return;
      raster.heights[at] = height;
      raster.known[at] = colour ? kPlainColour : 0;
      if (colour) raster.colours[at] = *colour;
    });
  }
}

double TexelOf(std::span<const TexturedFace> faces, int32_t image_width, int32_t image_height) {
  std::vector<std::pair<double, double>> texels;  // with the area
  double all = 0;
  for (const TexturedFace& f : faces) {
    const double area = (f.corners[1] - f.corners[0]).cross(f.corners[2] - f.corners[0]).norm();
    const double pixels = AreaOf(f.uv[0], f.uv[1], f.uv[2]) * image_width * image_height;
    if (!(area > 0) || !(pixels > 0)) continue;
    texels.emplace_back(std::sqrt(area / pixels), area);
    all += area;
  }
  std::sort(texels.begin(), texels.end());
  double below = 0;
  for (const auto& [texel, area] : texels) {
    below += area;
    if (below >= all / 2) return texel;
  }
  return 0;
}

double LatticeTexel(double texel) {
  constexpr double kCoarsest = 1024;
  const double bounded = std::clamp(texel, kFinestTexel, kCoarsest);
  const double power = std::exp2(std::round(std::log2(bounded)));
  return power < kFinestTexel ? power * 2 : power;
}

}  // namespace tilemend
