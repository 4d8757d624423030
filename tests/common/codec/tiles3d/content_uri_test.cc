#include "common/codec/tiles3d/content_uri.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

std::string Resolved(std::string_view document, std::string_view uri) {
  const absl::StatusOr<std::string> path = ResolveContentUri(document, uri);
  return path.ok() ? *path : std::string(path.status().message());
}

TEST(ResolveContentUriTest, IsRelativeToTheDocument) {
  EXPECT_EQ(Resolved("tileset.json", "a.glb"), "a.glb");
  EXPECT_EQ(Resolved("Data/B/b.json", "c/d.glb"), "Data/B/c/d.glb");
  EXPECT_EQ(Resolved("Data/b.json", "./c//d.glb"), "Data/c/d.glb");
  EXPECT_EQ(Resolved("b.json", "a%20b%C3%A9.glb"), "a b\xc3\xa9.glb");
}

TEST(ResolveContentUriTest, RefusesWhatLeadsOut) {
  for (const char* uri : {"../a.glb",
                          "a/../../b.glb",
                          "a/..",
                          "%2e%2e/a.glb",
                          "a/%2E%2E/b.glb",
                          "..",
                          ".",
                          "",
                          "/",
                          "/etc/passwd",
                          "%2Fetc/passwd",
                          "//host/a.glb",
                          "http://host/a.glb",
                          "file:a.glb",
                          "C:/a.glb",
                          "a\\..\\b.glb",
                          "a%5Cb.glb",
                          "a%00.glb",
                          "a\n.glb",
                          "a.glb?v=1",
                          "a.glb#x",
                          "a%2",
                          "a%zz",
                          "data:,x",
                          "\xff.glb"}) {
    const absl::StatusOr<std::string> path = ResolveContentUri("Data/b.json", uri);
    EXPECT_EQ(path.status().code(), absl::StatusCode::kInvalidArgument) << uri;
    EXPECT_THAT(std::string(path.status().message()), testing::HasSubstr("is not opened: ")) << uri;
  }
}

TEST(ContentUriOfTest, IsReadAsThePath) {
  EXPECT_EQ(ContentUriOf("Data/T_p000/a-1.glb"), "Data/T_p000/a-1.glb");
  EXPECT_EQ(ContentUriOf("a b+#?%.glb"), "a%20b%2B%23%3F%25.glb");
  for (const char* path : {"a b+#?%.glb", "\xc3\xa4/x.glb"})
    EXPECT_EQ(*ResolveContentUri("t.json", ContentUriOf(path)), path);
}

}  // namespace
}  // namespace tilemend
