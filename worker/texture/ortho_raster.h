// A picture of textured surface from above, on a lattice of texels that is the same for all cells that share a hole.
#ifndef TILEMEND_WORKER_TEXTURE_ORTHO_RASTER_H_
#define TILEMEND_WORKER_TEXTURE_ORTHO_RASTER_H_

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "common/image/image.h"
#include "common/mesh/tri_mesh.h"
#include "common/util/colour.h"

namespace tilemend {

// A window of the lattice. Pixel (x, y) is the square from ((column + x) * texel, (row + y) * texel) on; y is north.
struct RasterFrame {
  double texel = 1;  // metres, a power of two: positions of pixels are exact
  int64_t column = 0;
  int64_t row = 0;
  int32_t width = 0;
  int32_t height = 0;

  size_t size() const { return static_cast<size_t>(width) * static_cast<size_t>(height); }
  size_t At(int32_t x, int32_t y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  }
  bool Has(int64_t x, int64_t y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  // In pixels from the frame's corner.
  Point2 PixelsOf(const Point3& p) const {
    return {p.x() / texel - static_cast<double>(column), p.y() / texel - static_cast<double>(row)};
  }
};

// The frame of the pixels that meet `box`.
RasterFrame FrameOf(const Eigen::AlignedBox2d& box, double texel);
// The box that a frame covers.
Eigen::AlignedBox2d BoxOf(const RasterFrame& frame);

inline constexpr float kNoSurface = -std::numeric_limits<float>::infinity();

inline constexpr uint8_t kImageColour = 1, kPlainColour = 2;  // a plain colour has no grain

// 8 bytes a pixel.
struct OrthoRaster {
  explicit OrthoRaster(const RasterFrame& frame);

  RasterFrame frame;
  std::vector<Rgb> colours;
  std::vector<float> heights;  // of the highest surface, metres; kNoSurface: none
  std::vector<uint8_t> known;  // 0: that surface has no colour; else it has one: kImageColour or kPlainColour
};

// A triangle with the place of each corner in an image: u to the right, v upward.
struct TexturedFace {
  SpaceTriangle corners;
  std::array<std::array<float, 2>, 3> uv;
};

// Draws the faces where they are the highest surface at a pixel's centre. Of equal heights the first that is drawn
// stays. Colours are means of bilinear samples, as many as image pixels lie in a raster pixel, 16 at most. Upright
// faces cover no pixel. Preconditions: finite numbers; the image has pixels. Cost: linear in the faces and in the
// pixels that they cover.
void DrawFaces(std::span<const TexturedFace> faces, const Image& image, OrthoRaster& raster);

// Draws surface that has no image, of a plain colour or of none.
void DrawShapes(std::span<const SpaceTriangle> shapes, OrthoRaster& raster, std::optional<Rgb> colour = {});

// The side of a square that an image pixel covers on the surface, in metres: the median over the faces' area. It is 0
// without faces that have an area. Cost: O(n log n).
double TexelOf(std::span<const TexturedFace> faces, int32_t image_width, int32_t image_height);

// The power of two metres next to `texel`, and not below kFinestTexel.
inline constexpr double kFinestTexel = 0.05;
double LatticeTexel(double texel);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_TEXTURE_ORTHO_RASTER_H_
