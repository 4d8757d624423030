#include "common/s3/s3_address.h"

#include <gtest/gtest.h>

#include <map>

namespace tilemend {
namespace {

Environment Of(const std::map<std::string, std::string>& values) {
  return [values](const char* name) -> const char* {
    static thread_local std::string kept;
    const auto found = values.find(name);
    if (found == values.end()) return nullptr;
    kept = found->second;
    return kept.c_str();
  };
}

TEST(S3AddressTest, SplitsBucketAndKey) {
  const auto path = ParseS3Path("s3://city/2026/scene.json");
  ASSERT_TRUE(path.ok());
  EXPECT_EQ(path->bucket, "city");
  EXPECT_EQ(path->key, "2026/scene.json");
  EXPECT_EQ(ParseS3Path("s3://city/")->key, "");
  EXPECT_EQ(ParseS3Path("s3://city/out//")->key, "out");
}

TEST(S3AddressTest, RefusesWhatIsNoBucket) {
  for (const char* path :
       {"s3://", "s3:///key", "s3://a b/key", "s3://host:80/key", "s3://user@host/key", "/a/folder"}) {
    EXPECT_EQ(ParseS3Path(path).status().code(), absl::StatusCode::kInvalidArgument) << path;
  }
}

TEST(S3AddressTest, AsksAmazonByHost) {
  const S3Address address = AddressFrom(Of({{"AWS_REGION", "eu-north-1"}}));
  EXPECT_EQ(UrlOf(address, {"city", "a"}), "https://city.s3.eu-north-1.amazonaws.com/a");
  EXPECT_EQ(UrlOf(address, {"my.city", "a"}), "https://s3.eu-north-1.amazonaws.com/my.city/a");
}

TEST(S3AddressTest, AsksOthersByPath) {
  const S3Address address = AddressFrom(Of({{"AWS_ENDPOINT_URL", "http://minio:9000/"}}));
  EXPECT_EQ(address.region, "us-east-1");
  EXPECT_EQ(UrlOf(address, {"city", "a"}), "http://minio:9000/city/a");
}

TEST(S3AddressTest, PrefersTheEndpointOfS3) {
  const S3Address address = AddressFrom(Of({{"AWS_ENDPOINT_URL", "http://all"}, {"AWS_ENDPOINT_URL_S3", "http://s3"}}));
  EXPECT_EQ(address.endpoint, "http://s3");
}

// A plus that is not encoded is taken for a space, and then the signature is wrong.
TEST(S3AddressTest, EncodesKeys) {
  EXPECT_EQ(UrlOf({"http://h", "r"}, {"b", "Tile_+003/a b%.obj"}), "http://h/b/Tile_%2B003/a%20b%25.obj");
}

TEST(S3AddressTest, SortsAndEncodesTheQuery) {
  EXPECT_EQ(UrlOf({"http://h", "r"}, {"b", ""}, {{"prefix", "a/+"}, {"delimiter", "/"}, {"uploads", ""}}),
            "http://h/b?delimiter=%2F&prefix=a%2F%2B&uploads=");
}

}  // namespace
}  // namespace tilemend
