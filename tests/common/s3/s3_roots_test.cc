#include <gtest/gtest.h>

#include "common/util/error_info.h"
#include "common/util/real_path.h"
#include "common/util/roots.h"

namespace tilemend {
namespace {

TEST(S3RootsTest, SplitsAFlagAtColonsThatAreOfNoScheme) {
  EXPECT_EQ(RootsInFlag("/a:s3://city/x:/b:s3://c"), (std::vector<std::string>{"/a", "s3://city/x", "/b", "s3://c"}));
  EXPECT_EQ(RootsInFlag(""), std::vector<std::string>());
}

TEST(S3RootsTest, AllowsObjectsBelowAPrefixAlone) {
  const auto roots = Roots::Open({"/tmp", "s3://city/out/"});
  ASSERT_TRUE(roots.ok());
  EXPECT_TRUE((*roots)->Check("s3://city/out").ok());
  EXPECT_TRUE((*roots)->Check("s3://city/out/a/b.obj").ok());
  for (const char* path : {"s3://city/outer", "s3://city", "s3://other/out/a", "s3://city2/out/a"}) {
    EXPECT_EQ(ErrorReason((*roots)->Check(path)), "OUTSIDE_ROOTS") << path;
  }
}

TEST(S3RootsTest, AllowsNoObjectWhereFoldersAloneAreNamed) {
  const auto roots = Roots::Open({"/"});
  ASSERT_TRUE(roots.ok());
  EXPECT_EQ(ErrorReason((*roots)->Check("s3://city/out")), "OUTSIDE_ROOTS");
}

TEST(S3RootsTest, KeepsBothSlashesOfAScheme) {
  EXPECT_EQ(RealPath("s3://city/a/../b").string(), "s3://city/b");
  EXPECT_TRUE(TakesThePlaceOf("s3://city/a", "s3://city/a"));
  EXPECT_FALSE(TakesThePlaceOf("s3://city/a", "s3://city/b"));
}

}  // namespace
}  // namespace tilemend
