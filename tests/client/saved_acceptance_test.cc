#include "client/saved_acceptance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using Json = nlohmann::ordered_json;

Acceptance WithOpenEdges(size_t places) {
  Acceptance acceptance;
  acceptance.findings = {
      {"crossed_fills", "one crossing", "crossings", true, 0, {}},
      {"open_edges", "new open edge", "new open edges", true, static_cast<int64_t>(places), {}},
      {"left_open", "hole left open, as reported", "holes left open, as reported", false, 1, {{{0, 0}, {}, "why"}}}};
  for (size_t k = 0; k < places; ++k) acceptance.findings[1].places.push_back({{1, 2}, Point3(3, 4, 5), "", 20});
  return acceptance;
}

TEST(SavedAcceptanceTest, ThePageGetsFaultsWithTheirFirstPlaces) {
  TemporaryFolder folder;
  ASSERT_TRUE(SaveAcceptance(folder.path(), WithOpenEdges(30), absl::UnixEpoch()).ok());
  const auto saved = SavedAcceptance(folder.path());
  ASSERT_TRUE(saved.ok()) << saved.status();
  EXPECT_EQ((*saved)["accepted"], false);
  EXPECT_EQ((*saved)["verdict"], "not accepted: 30 new open edges");
  EXPECT_EQ((*saved)["date"], "1970-01-01T00:00:00Z");
  ASSERT_THAT((*saved)["faults"], SizeIs(1));
  EXPECT_EQ((*saved)["faults"][0]["what"], "new open edges");
  EXPECT_EQ((*saved)["faults"][0]["count"], 30);
  EXPECT_THAT((*saved)["faults"][0]["places"], SizeIs(20));
  EXPECT_EQ((*saved)["faults"][0]["places"][0], Json::parse(R"({"cell": [1, 2], "at": [3.0, 4.0, 5.0], "hole": 20})"));
}

TEST(SavedAcceptanceTest, AnAcceptedOutputHasNoFaults) {
  TemporaryFolder folder;
  ASSERT_TRUE(SaveAcceptance(folder.path(), WithOpenEdges(0), absl::UnixEpoch()).ok());
  const auto saved = SavedAcceptance(folder.path());
  ASSERT_TRUE(saved.ok()) << saved.status();
  EXPECT_EQ((*saved)["accepted"], true);
  EXPECT_THAT((*saved)["faults"], SizeIs(0));
}

TEST(SavedAcceptanceTest, AnOutputThatWasNotCheckedHasNone) {
  TemporaryFolder folder;
  const auto saved = SavedAcceptance(folder.path());
  ASSERT_TRUE(saved.ok()) << saved.status();
  EXPECT_TRUE(saved->is_null());
}

TEST(SavedAcceptanceTest, AnotherFileIsNamed) {
  TemporaryFolder folder;
  for (const char* text : {"", "[1]", R"({"accepted": "yes"})", R"({"accepted": true, "findings": 3})"}) {
    folder.Write("acceptance.json", text);
    const auto saved = SavedAcceptance(folder.path());
    EXPECT_EQ(saved.status().code(), absl::StatusCode::kInvalidArgument) << text;
    EXPECT_THAT(saved.status().message(), HasSubstr("acceptance.json: not what `tilemend check` writes")) << text;
  }
  folder.Write("acceptance.json",
               R"({"accepted": true, "findings": {"open_edges": 3, "x": {"fault": true, "count": 1}}})");
  const auto damaged = SavedAcceptance(folder.path());
  ASSERT_TRUE(damaged.ok()) << damaged.status();
  EXPECT_EQ((*damaged)["faults"], Json::parse(R"([{"what": null, "count": 1, "places": []}])"));
}

}  // namespace
}  // namespace tilemend
