#include "client/mesh/mesh_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "common/util/error_info.h"

namespace tilemend {
namespace {

// What is wrong with options that are given by field, "" if nothing is.
std::string Fault(const std::map<std::string, std::string>& texts) {
  const auto spec = SpecFromTexts(texts, kOfFill);
  if (!spec.ok()) return std::string(spec.status().message());
  const absl::Status status =
      CheckMeshOptions(*spec, [&](const Option& option) { return texts.contains(option.field); });
  EXPECT_EQ(ErrorReason(status), status.ok() ? "" : "INVALID_SPEC");
  return std::string(status.message());
}

TEST(MeshOptionsTest, NamesTheFieldThatHasNoEffect) {
  EXPECT_EQ(Fault({}), "");
  EXPECT_EQ(Fault({{"surface", "wang"}, {"filler", "minimum-area"}}),
            "filler: the surface wang fills closed holes in its own way; leave one of the two out");
  EXPECT_EQ(Fault({{"tension", "1"}, {"filler", "minimum-area"}}),
            "tension: the filler minimum-area has none; leave it out, or choose auto");
  EXPECT_EQ(Fault({{"allow_creases", "true"}, {"surface", "wang"}}),
            "allow_creases: published methods fill with creases as they are published; leave one of the two out");
  const std::map<std::string, std::string> front = {{"filler", "advancing-front-normal"}, {"gradation", "2"}};
  EXPECT_EQ(Fault(front), "");
  std::map<std::string, std::string> dry = front;
  dry["water"] = "off";
  EXPECT_EQ(Fault(dry),
            "gradation: the triangles of advancing-front-normal are as large as the boundary's; leave it out");
}

TEST(MeshOptionsTest, TakesTheOptionsOfOneMesh) {
  const auto spec = SpecFromTexts({{"weld", "0.5"},
                                   {"largest_hole", "7"},
                                   {"fill_outlines", "true"},
                                   {"dislocation_width", "2"},
                                   {"water", "off"},
                                   {"water_colour", "1,2,3"}},
                                  kOfFill);
  const auto options = MeshOptionsOf(*spec);
  ASSERT_TRUE(options.ok()) << options.status();
  EXPECT_EQ(options->weld, 0.5);
  EXPECT_EQ(options->holes.largest_hole, 7);
  EXPECT_TRUE(options->holes.fill_outlines);
  EXPECT_EQ(options->holes.dislocation_width, 2);
  EXPECT_EQ(options->water_colour, (Rgb{1, 2, 3}));
}

TEST(MeshOptionsTest, AFileThatIsMissingIsNamed) {
  const auto spec = SpecFromTexts({{"water", "/no/such/file.geojson"}}, kOfFill);
  const absl::Status status = MeshOptionsOf(*spec).status();
  EXPECT_TRUE(absl::IsNotFound(status)) << status;
  EXPECT_THAT(std::string(status.message()), testing::HasSubstr("/no/such/file.geojson"));
}

}  // namespace
}  // namespace tilemend
