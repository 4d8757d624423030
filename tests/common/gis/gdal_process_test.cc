#include "common/gis/gdal_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include "common/gis/area_file.h"
#include "common/gis/vector_message.h"
#include "tests/common/gis/geojson_text.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

// More than a socket holds, both ways.
TEST(AskGdalTest, MessagesMayBeLarge) {
  std::vector<std::string> features;
  for (int i = 0; i < 20000; ++i) features.push_back(FeatureText(PolygonText(SquareAt(i, 0, 0.5))));
  const auto file = ParseWaterFile({CollectionText(features)}, "f", {});
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->areas.size(), features.size());
}

TEST(AskGdalTest, ThreadsMayAskAtOnce) {
  std::vector<std::thread> threads;
  std::vector<std::string> answers(8);
  for (size_t i = 0; i < answers.size(); ++i) {
    threads.emplace_back([&, i] { answers[i] = AskGdal("CEPSG:4326", "crs").value_or("failed"); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::string& answer : answers) EXPECT_THAT(answer, HasSubstr("has degrees"));
}

TEST(AskGdalTest, TheEnvironmentMayNameTheProgram) {
  ASSERT_EQ(::setenv("TILEMEND_GDAL", "/no/such/program", 1), 0);
  const absl::Status status = AskGdal("CEPSG:4326", "crs").status();
  ASSERT_EQ(::unsetenv("TILEMEND_GDAL"), 0);
  EXPECT_THAT(std::string(status.message()), HasSubstr("cannot start /no/such/program"));
}

}  // namespace
}  // namespace tilemend
