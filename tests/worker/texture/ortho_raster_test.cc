#include "worker/texture/ortho_raster.h"

#include <gtest/gtest.h>

#include <span>

namespace tilemend {
namespace {

// 2 x 2 pixels: red and green above, blue and white below.
Image FourColours() { return {2, 2, 3, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}}; }

// The square from (x, y) with an image over it, at a height.
std::vector<TexturedFace> Square(double x, double y, double side, double z) {
  const Point3 a(x, y, z), b(x + side, y, z), c(x + side, y + side, z), d(x, y + side, z);
  return {{{a, b, c}, {{{0, 0}, {1, 0}, {1, 1}}}}, {{a, c, d}, {{{0, 0}, {1, 1}, {0, 1}}}}};
}

TEST(OrthoRasterTest, TheImageLiesOnTheLatticeWithNorthUp) {
  OrthoRaster raster({0.5, -8, 4, 4, 4});
  DrawFaces(Square(-4, 2, 1, 7), FourColours(), raster);
  EXPECT_EQ(raster.colours[raster.frame.At(0, 0)], (Rgb{0, 0, 255}));
  EXPECT_EQ(raster.colours[raster.frame.At(1, 0)], (Rgb{255, 255, 255}));
  EXPECT_EQ(raster.colours[raster.frame.At(0, 1)], (Rgb{255, 0, 0}));
  EXPECT_EQ(raster.colours[raster.frame.At(1, 1)], (Rgb{0, 255, 0}));
  EXPECT_EQ(raster.known[raster.frame.At(2, 0)], 0);
  EXPECT_EQ(raster.heights[raster.frame.At(2, 0)], kNoSurface);
  EXPECT_EQ(raster.heights[raster.frame.At(1, 1)], 7);
}

TEST(OrthoRasterTest, TheHighestSurfaceIsSeen) {
  OrthoRaster raster({0.5, 0, 0, 2, 2});
  const Image grey{1, 1, 3, {9, 9, 9}};
  DrawFaces(Square(0, 0, 1, 3), grey, raster);
  DrawFaces(Square(0, 0, 1, 2), FourColours(), raster);
  EXPECT_EQ(raster.colours[0], (Rgb{9, 9, 9}));
  const std::vector<TexturedFace> roof = Square(0, 0, 1, 4);
  const std::vector<SpaceTriangle> shapes = {roof[0].corners, roof[1].corners};
  DrawShapes(shapes, raster);
  EXPECT_EQ(raster.known[0], 0);
  EXPECT_EQ(raster.heights[0], 4);
  const std::vector<TexturedFace> higher = Square(0, 0, 1, 5);
  DrawShapes(std::span(&higher[0].corners, 1), raster, Rgb{1, 2, 3});
  DrawShapes(std::span(&higher[1].corners, 1), raster, Rgb{1, 2, 3});
  EXPECT_EQ(raster.known[0], kPlainColour);
  EXPECT_EQ(raster.colours[0], (Rgb{1, 2, 3}));
}

TEST(OrthoRasterTest, UprightAndFarFacesCoverNothing) {
  OrthoRaster raster({1, 0, 0, 4, 4});
  const SpaceTriangle upright = {Point3(0, 0, 0), Point3(3, 3, 0), Point3(3, 3, 5)};
  const SpaceTriangle far = {Point3(1e8, 0, 0), Point3(1e8 + 5, 0, 0), Point3(1e8, 5, 0)};
  DrawShapes(std::span(&upright, 1), raster);
  DrawShapes(std::span(&far, 1), raster);
  for (const float height : raster.heights) EXPECT_EQ(height, kNoSurface);
}

TEST(OrthoRasterTest, ManyImagePixelsInOneAreAveraged) {
  Image stripes{16, 1, 3, {}};
  for (int i = 0; i < 16; ++i)
    stripes.pixels.insert(stripes.pixels.end(), 3, static_cast<uint8_t>(i % 2 == 0 ? 0 : 200));
  OrthoRaster raster({1, 0, 0, 4, 4});
  DrawFaces(Square(0, 0, 4, 0), stripes, raster);
  for (const Rgb c : raster.colours) EXPECT_NEAR(c.r, 100, 3);
}

TEST(OrthoRasterTest, TwoWindowsOfTheLatticeAgree) {
  OrthoRaster whole({0.25, 0, 0, 40, 40}), part({0.25, 13, 7, 11, 9});
  for (OrthoRaster* raster : {&whole, &part}) {
    DrawFaces(Square(0.3, 0.2, 8.1, 1), FourColours(), *raster);
    DrawFaces(Square(4.3, 2.2, 3.7, 2), FourColours(), *raster);
  }
  for (int32_t y = 0; y < 9; ++y) {
    for (int32_t x = 0; x < 11; ++x) {
      EXPECT_EQ(part.colours[part.frame.At(x, y)], whole.colours[whole.frame.At(x + 13, y + 7)]);
    }
  }
}

TEST(OrthoRasterTest, FramesCoverTheirBox) {
  const RasterFrame frame = FrameOf({Point2(-0.3, 1.1), Point2(2.2, 1.9)}, 0.5);
  EXPECT_EQ(frame.column, -1);
  EXPECT_EQ(frame.row, 2);
  EXPECT_EQ(frame.width, 6);
  EXPECT_EQ(frame.height, 2);
  EXPECT_EQ(BoxOf(frame).min(), Point2(-0.5, 1));
  EXPECT_EQ(BoxOf(frame).max(), Point2(2.5, 2));
}

TEST(OrthoRasterTest, TexelIsTheMedianByArea) {
  std::vector<TexturedFace> faces = Square(0, 0, 8, 0);
  for (int i = 0; i < 9; ++i) faces.push_back(Square(10, 0, 1, 0)[0]);
  EXPECT_NEAR(TexelOf(faces, 16, 16), 0.5, 1e-9);
  EXPECT_EQ(TexelOf({}, 16, 16), 0);
}

TEST(OrthoRasterTest, LatticeTexelsArePowersOfTwoNotBelowFiveCentimetres) {
  EXPECT_EQ(LatticeTexel(0.11), 0.125);
  EXPECT_EQ(LatticeTexel(0.016), 0.0625);
  EXPECT_EQ(LatticeTexel(0.3), 0.25);
  EXPECT_EQ(LatticeTexel(1), 1);
}

}  // namespace
}  // namespace tilemend
