#include "common/codec/osgb/osgb_patch_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/common/codec/osgb/osgb_checks.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

std::string FaultOf(const OsgbPatch& patch, const Point3& translation = Point3::Zero()) {
  return std::string(CheckOsgbPatch(patch, translation, 4, "a.osgb").message());
}

TEST(CheckOsgbPatchTest, NamesWhatIsWrong) {
  EXPECT_EQ(FaultOf(OsgbTriangle()), "");
  OsgbPatch patch = OsgbTriangle();
  patch.triangles[0][0] = -1;
  EXPECT_THAT(FaultOf(patch), HasSubstr("new geometry 4: vertex index -1"));
  patch = OsgbTriangle();
  patch.uv.pop_back();
  EXPECT_THAT(FaultOf(patch), HasSubstr("2 texture coordinates for 3 vertices"));
  patch = OsgbTriangle();
  patch.points[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(FaultOf(patch), HasSubstr("at most 1e9 m"));
  EXPECT_THAT(FaultOf(OsgbTriangle(), Point3(0, 0, 2e9)), HasSubstr("at most 1e9 m"));
}

TEST(BytesOfOsgbPatchTest, AreThoseOfImageVerticesAndTriangles) {
  const OsgbPatch patch = OsgbTriangle();
  EXPECT_EQ(BytesOfOsgbPatch(patch), patch.image.size() + 3 * 20 + 12);
}

}  // namespace
}  // namespace tilemend
