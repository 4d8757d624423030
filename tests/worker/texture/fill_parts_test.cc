#include "worker/texture/fill_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/worker/texture/raster_builders.h"

namespace tilemend {
namespace {

using testing::ElementsAre;

// A square of two triangles from (x, y), and a wall on its eastern side if asked for.
void AddSquare(double x, double y, double side, bool is_water, FilledFaces& faces) {
  const auto first = static_cast<int32_t>(faces.points.size());
  for (const Point3& p :
       {Point3(x, y, 0), Point3(x + side, y, 0), Point3(x + side, y + side, 0), Point3(x, y + side, 0)}) {
    faces.points.push_back(p);
  }
  faces.triangles.push_back({first, first + 1, first + 2});
  faces.triangles.push_back({first, first + 2, first + 3});
  faces.is_water.insert(faces.is_water.end(), 2, is_water ? 1 : 0);
  faces.flat.insert(faces.flat.end(), 2, is_water ? Rgb{1, 2, 3} : Rgb{9, 9, 9});
}

// Surface everywhere in the box but in a hole.
OrthoRaster SiteWithHole(const Eigen::AlignedBox2d& box, const Eigen::AlignedBox2d& hole) {
  OrthoRaster site = SiteRaster(box);
  for (int32_t y = 0; y < site.frame.height; ++y) {
    for (int32_t x = 0; x < site.frame.width; ++x) {
      const Point2 centre = BoxOf(site.frame).min() + Point2(x + 0.5, y + 0.5) * site.frame.texel;
      if (!hole.contains(centre)) site.heights[site.frame.At(x, y)] = 0;
    }
  }
  return site;
}

const Eigen::AlignedBox2d kLeft(Point2(0, 0), Point2(100, 100)), kRight(Point2(100, 0), Point2(200, 100));
const Eigen::AlignedBox2d kBoth(Point2(0, 0), Point2(200, 100));

TexelOfPlace Everywhere(double texel) {
  return [texel](const Eigen::AlignedBox2d&) { return texel; };
}

TEST(FillPartsTest, TwoCellsThatShareAHoleGetTheSameFrame) {
  const OrthoRaster site = SiteWithHole(kBoth, {Point2(90, 40), Point2(110, 60)});
  FilledFaces left, right;
  AddSquare(90, 40, 10, false, left);
  AddSquare(100, 45, 10, false, right);
  const std::vector<Eigen::AlignedBox2d> cells = {kLeft, kRight};
  const FillParts a = PlanParts(left, site, cells, Everywhere(0.25)),
                  b = PlanParts(right, site, cells, Everywhere(0.25));
  ASSERT_EQ(a.frames.size(), 1U);
  ASSERT_EQ(b.frames.size(), 1U);
  EXPECT_EQ(BoxOf(a.frames[0]).min(), BoxOf(b.frames[0]).min());
  EXPECT_EQ(BoxOf(a.frames[0]).max(), BoxOf(b.frames[0]).max());
  EXPECT_EQ(BoxOf(a.frames[0]).min(), Point2(68, 20));
  EXPECT_THAT(a.of_triangles, ElementsAre(0, 0));
}

TEST(FillPartsTest, APartHasTheTexelOfItsRegion) {
  const OrthoRaster site = SiteWithHole(kBoth, {Point2(90, 40), Point2(110, 60)});
  FilledFaces left;
  AddSquare(90, 40, 10, false, left);
  AddSquare(20, 20, 2, false, left);
  const std::vector<Eigen::AlignedBox2d> cells = {kLeft, kRight};
  const auto finer_in_the_east = [](const Eigen::AlignedBox2d& place) { return place.intersects(kRight) ? 0.25 : 0.5; };
  const FillParts parts = PlanParts(left, site, cells, finer_in_the_east);
  ASSERT_EQ(parts.frames.size(), 2U);
  for (const int32_t t : {0, 2}) {
    const auto part = static_cast<size_t>(parts.of_triangles[static_cast<size_t>(t)]);
    EXPECT_EQ(parts.frames[part].texel, t == 0 ? 0.25 : 0.5);
  }
}

TEST(FillPartsTest, HolesApartArePartsAndWallsAreNone) {
  const OrthoRaster site = SiteWithHole(kBoth, {});
  FilledFaces faces;
  AddSquare(90, 40, 4, false, faces);
  AddSquare(20, 20, 2, true, faces);
  faces.points.emplace_back(94, 44, 6);
  faces.triangles.push_back({1, 4, 2});
  faces.triangles[4] = {1, 8, 2};
  faces.is_water.push_back(0);
  faces.flat.push_back({5, 5, 5});
  const FillParts parts = PlanParts(faces, site, std::vector{kLeft}, Everywhere(0.25));
  EXPECT_EQ(parts.frames.size(), 2U);
  EXPECT_THAT(parts.of_triangles, ElementsAre(1, 1, 0, 0, -1));
  EXPECT_THAT(SteepPoints(faces, parts), ElementsAre(1, 2, 8));
  EXPECT_EQ(parts.At({92, 42, 0}), 1);
  EXPECT_EQ(parts.At({50, 50, 0}), -1);
  EXPECT_EQ(parts.At({5000, 50, 0}), -1);
  EXPECT_EQ(LookOf(faces, parts, 0).water, (Rgb{1, 2, 3}));
  EXPECT_EQ(LookOf(faces, parts, 1).ground, (Rgb{9, 9, 9}));
}

TEST(FillPartsTest, SmallHolesOfASquareOf32MetresShareARaster) {
  FilledFaces faces;
  AddSquare(2, 2, 1, false, faces);
  AddSquare(20, 20, 4, false, faces);
  AddSquare(40, 2, 1, false, faces);   // in another square
  AddSquare(10, 10, 1, true, faces);   // water has a level of its own
  AddSquare(2, 40, 20, false, faces);  // large
  const FillParts parts = PlanParts(faces, SiteWithHole(kLeft, {}), std::vector{kLeft}, Everywhere(0.25));
  EXPECT_THAT(parts.of_triangles, ElementsAre(0, 0, 0, 0, 3, 3, 1, 1, 2, 2));
  EXPECT_THAT(parts.triangles,
              ElementsAre(ElementsAre(0, 1, 2, 3), ElementsAre(6, 7), ElementsAre(8, 9), ElementsAre(4, 5)));
  EXPECT_EQ(BoxOf(parts.frames[0]).min(), Point2(-8, -8)) << "twice the larger hole's size around both";
}

TEST(FillPartsTest, LargePartsHaveCoarserTexels) {
  const Eigen::AlignedBox2d cell(Point2(0, 0), Point2(2000, 2000));
  FilledFaces faces;
  AddSquare(100, 100, 1800, true, faces);
  const FillParts parts = PlanParts(faces, SiteWithHole(cell, {}), std::vector{cell}, Everywhere(0.0625));
  ASSERT_EQ(parts.frames.size(), 1U);
  EXPECT_EQ(parts.frames[0].texel, 1);
  EXPECT_LE(parts.frames[0].size(), static_cast<size_t>(kMostRasterPixels));
}

TEST(FillPartsTest, PixelsAreOfTheirPart) {
  FilledFaces faces;
  AddSquare(2, 2, 4, false, faces);
  AddSquare(8, 2, 4, true, faces);
  const FillParts parts{{{1, 0, 0, 16, 8}, {1, 0, 0, 16, 8}}, {0, 0, 1, 1}, {{0, 1}, {2, 3}}, {}, {}};
  OrthoRaster raster = RasterOf(parts.frames[0], [](int64_t, int64_t) { return Rgb{}; });
  raster.heights[raster.frame.At(15, 7)] = kNoSurface;
  const std::vector<FillPixel> first = FillMapOf(faces, parts, 0, raster).pixels,
                               second = FillMapOf(faces, parts, 1, raster).pixels;
  EXPECT_EQ(first[raster.frame.At(3, 3)], FillPixel::kGround);
  EXPECT_EQ(first[raster.frame.At(9, 3)], FillPixel::kForeign);
  EXPECT_EQ(second[raster.frame.At(9, 3)], FillPixel::kWater);
  EXPECT_EQ(first[raster.frame.At(0, 0)], FillPixel::kNone);
  EXPECT_EQ(first[raster.frame.At(15, 7)], FillPixel::kForeign);
}

TEST(FillPartsTest, WallsTakeTheColourThatTheyHangFrom) {
  FilledFaces faces;
  faces.points = {{0, 0, 9}, {4, 0, 9}, {0, 0, 4}, {4, 0, 4}, {0, 0, 0}, {4, 0, 0}};
  faces.triangles = {{2, 1, 0}, {2, 3, 1}, {4, 3, 2}, {4, 5, 3}};
  faces.is_water.assign(4, 0);
  faces.flat.assign(4, Rgb{7, 7, 7});
  const FillParts parts{{}, {-1, -1, -1, -1}, {}, {}, {}};
  std::vector<std::optional<Rgb>> rim(6);
  rim[0] = rim[1] = Rgb{0, 200, 0};
  for (const Rgb c : SteepColours(faces, parts, rim, {})) EXPECT_EQ(c, (Rgb{0, 200, 0}));
  for (const Rgb c : SteepColours(faces, parts, std::vector<std::optional<Rgb>>(6), {})) EXPECT_EQ(c, (Rgb{7, 7, 7}));
}

}  // namespace
}  // namespace tilemend
