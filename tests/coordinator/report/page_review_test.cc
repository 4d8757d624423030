#include "coordinator/report/page_review.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <random>
#include <string>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"

namespace tilemend {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kReview[] = R"({"review": [
  {"hole": 4, "holes": [3, 4], "area_m2": 9, "doubt_m3": 2}, {"hole": 7, "holes": [7], "area_m2": 5, "doubt_m3": 1}]})";

std::string HoleFeature(int hole, const std::string& geometry) {
  return R"({"type": "Feature", "properties": {"cluster": 6, "hole": )" + std::to_string(hole) + R"(}, "geometry": )" +
         geometry + "}";
}

std::string Holes() {
  const std::string ring = "[[0, 0], [4, 0], [4, 4], [0, 0]]";
  return R"({"type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::25832"}},
             "features": [)" +
         HoleFeature(3, R"({"type": "Polygon", "coordinates": [)" + ring + "]}") + "," +
         HoleFeature(4, R"({"type": "MultiPolygon", "coordinates": [[)" + ring + "], [" + ring + "]]}") + "," +
         HoleFeature(5, R"({"type": "Polygon", "coordinates": [)" + ring + "]}") + "," +
         HoleFeature(7, R"({"type": "MultiLineString", "coordinates": [[[0, 0], [4, 0]]]})") + "]}";
}

std::string Unzipped(const Json& base64) {
  std::string zipped, text(32 << 20, '\0');
  EXPECT_TRUE(absl::Base64Unescape(base64.get<std::string>(), &zipped));
  z_stream stream{};
  inflateInit2(&stream, 15 + 16);
  stream.next_in = reinterpret_cast<Bytef*>(zipped.data());
  stream.avail_in = static_cast<uInt>(zipped.size());
  stream.next_out = reinterpret_cast<Bytef*>(text.data());
  stream.avail_out = static_cast<uInt>(text.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  text.resize(stream.total_out);
  inflateEnd(&stream);
  return text;
}

TEST(PageReviewTest, AnItemHasThePolygonsOfAllItsHoles) {
  Scene scene;
  scene.origin = {0, 0, 120};
  const auto review = PageReview(Json::parse(kReview), Holes(), &scene);
  ASSERT_TRUE(review.ok()) << review.status();
  EXPECT_EQ((*review)["count"], 2);
  EXPECT_EQ((*review)["z"], 120);
  EXPECT_EQ((*review)["items"][0]["hole"], 4);
  EXPECT_EQ((*review)["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::25832");
  const Json outlines = Json::parse(Unzipped((*review)["outlines"]));
  ASSERT_EQ(outlines["4"].size(), 2U) << "one for each hole: what touches is no valid MultiPolygon";
  EXPECT_EQ(outlines["4"][0]["hole"], 3);
  EXPECT_EQ(outlines["4"][0]["geometry"]["coordinates"][0][1], Json({4, 0}));
  EXPECT_EQ(outlines["4"][1]["geometry"]["type"], "MultiPolygon");
  EXPECT_EQ(outlines["4"][1]["cluster"], 6);
  EXPECT_FALSE(outlines.contains("5"));
  EXPECT_TRUE(outlines["7"].is_null()) << "a boundary that is not closed has no polygon";
}

TEST(PageReviewTest, OtherHolesWithAFillHaveTheirPolygons) {
  Json report = Json::parse(kReview);
  report["per_hole"] = Json::parse(R"([{"id": 4, "outcome": "filled"}, {"id": 5, "outcome": "filled"},
                                       {"id": 7, "outcome": "filled"}, {"id": 8, "outcome": "left"}])");
  Json holes = Json::parse(Holes());
  holes["tilemend_scene"] = {{"name", "city"}};
  holes["features"].push_back(holes["features"][0]);
  holes["features"].back()["properties"]["hole"] = 8;
  const auto review = PageReview(report, holes.dump(), nullptr);
  ASSERT_TRUE(review.ok()) << review.status();
  const Json others = Json::parse(Unzipped((*review)["others"]));
  ASSERT_EQ(others.size(), 1U) << others;
  EXPECT_EQ(others["5"]["cluster"], 6);
  EXPECT_EQ(others["5"]["geometry"]["type"], "Polygon");
  EXPECT_EQ((*review)["scene"], Json({{"name", "city"}}));
  EXPECT_EQ((*review)["without_outline"], Json::array()) << "hole 7 belongs to an item";
}

// As holes.geojson has it.
std::string LongOutline(int hole, int cluster, size_t positions) {
  std::minstd_rand random(static_cast<unsigned>(hole + 1));
  std::uniform_real_distribution<double> step(0, 0.5);
  double x = 500000, y = 4100000;
  std::string ring;
  for (size_t i = 0; i < positions; ++i) {
    absl::StrAppendFormat(&ring, "%s[%.3f, %.3f]", i == 0 ? "" : ", ", x += step(random), y += step(random));
  }
  return absl::StrCat(R"({"type": "Feature", "properties": {"cluster": )", cluster, R"(, "hole": )", hole,
                      R"(}, "geometry": {"type": "Polygon", "coordinates": [[)", ring, "]]}}");
}

TEST(PageReviewTest, OutlinesOfOtherHolesAreBoundedInSize) {
  constexpr size_t kTenth = kMostOutlinePositions / 10;
  const auto row = [](int id, int cluster, double area) {
    return Json{{"id", id}, {"cluster", cluster}, {"area_m2", area}, {"outcome", "filled"}};
  };
  const Json report = {
      {"per_hole",
       {row(0, -1, 90), row(1, 3, 50), row(2, 3, 50), row(3, -1, 80), row(4, -1, 9), row(5, -1, 7), row(6, -1, 6)}}};
  const std::string holes =
      absl::StrCat(R"({"features": [)", LongOutline(0, -1, 4 * kTenth), ",", LongOutline(1, 3, 2 * kTenth), ",",
                   LongOutline(2, 3, 3 * kTenth), ",", LongOutline(3, -1, 2 * kTenth), ",", LongOutline(4, -1, kTenth),
                   ",", LongOutline(5, -1, 1), "]}");
  const auto review = PageReview(report, holes, nullptr);
  ASSERT_TRUE(review.ok()) << review.status();
  const Json others = Json::parse(Unzipped((*review)["others"]));
  EXPECT_TRUE(others.contains("1")) << "its cluster is the largest fill";
  EXPECT_TRUE(others.contains("2"));
  EXPECT_TRUE(others.contains("0"));
  EXPECT_FALSE(others.contains("3")) << "too long for what is left";
  EXPECT_TRUE(others.contains("4"));
  EXPECT_FALSE(others.contains("5"));
  EXPECT_EQ((*review)["without_outline"], Json({3, 5, 6}));
  EXPECT_LT(review->dump().size(), 10'000'000U);
}

TEST(FillsToDecideOnTest, CountsTheRowsOfTheQueue) {
  EXPECT_EQ(FillsToDecideOn(Json::parse(kReview)), 2U);
  EXPECT_EQ(FillsToDecideOn(Json::parse(R"({"review": 7})")), 0U);
  EXPECT_EQ(FillsToDecideOn(Json()), 0U);
}

// Else the next run would undo them.
TEST(PageReviewTest, EarlierDecisionsAreKeptAsTheyWereMade) {
  const auto decided = [](const std::string& properties, const std::string& geometry) {
    return R"({"type": "Feature", "properties": {)" + properties + R"(}, "geometry": )" + geometry + "}";
  };
  const std::string polygon = R"({"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 0]]]})";
  const std::string holes =
      R"({"features": [)" +
      decided(R"("hole": 8, "cluster": 2, "decision": "water", "level_m": 10.7958984375, "sigma_m": null)", polygon) +
      "," + decided(R"("hole": 10, "decision": "water", "level_m": 11.25, "sigma_m": 1.3)", polygon) + "," +
      decided(R"("hole": 9, "decision": "open", "level_m": 3)", polygon) + "," +
      decided(R"("hole": 7, "decision": null)", polygon) + "," +
      decided(R"("hole": 6, "decision": "accept")", R"({"type": "MultiLineString", "coordinates": []})") + "]}";
  const auto review = PageReview(Json::parse(kReview), holes, nullptr);
  ASSERT_TRUE(review.ok()) << review.status();
  const Json earlier = Json::parse(Unzipped((*review)["earlier"]));
  ASSERT_EQ(earlier.size(), 3U);
  EXPECT_EQ((*review)["decided"], 3);
  EXPECT_EQ(earlier[0]["properties"],
            Json({{"hole", 8}, {"cluster", 2}, {"decision", "water"}, {"level_m", 10.7958984375}}));
  EXPECT_EQ(earlier[0]["geometry"], Json::parse(polygon));
  EXPECT_EQ(earlier[1]["properties"]["decision"], "water");
  EXPECT_TRUE(earlier[1]["properties"]["level_m"].is_null()) << "its shore told the level, and may tell another one";
  EXPECT_EQ(earlier[2]["properties"]["decision"], "open");
  EXPECT_TRUE(earlier[2]["properties"]["level_m"].is_null()) << "a level says something of water alone";
  EXPECT_EQ(Json::parse(Unzipped((*review)["outlines"])).count("7"), 1U);
}

TEST(PageReviewTest, AReportOfAnotherFormHasNoQueue) {
  for (const char* report : {"{}", R"({"review": 7})", R"({"review": [3, {"hole": "x", "holes": 2}]})"}) {
    const auto review = PageReview(Json::parse(report), Holes(), nullptr);
    ASSERT_TRUE(review.ok()) << review.status();
    EXPECT_TRUE((*review)["z"].is_null());
    EXPECT_EQ(Unzipped((*review)["outlines"]), "{}");
  }
  EXPECT_FALSE(PageReview(Json::parse(kReview), "[", nullptr).ok());
}

TEST(PageReviewTest, EndsWhenItIsToStop) {
  std::stop_source source;
  source.request_stop();
  const auto review = PageReview(Json::parse(kReview), Holes(), nullptr, source.get_token());
  EXPECT_TRUE(absl::IsCancelled(review.status())) << review.status();
}

}  // namespace
}  // namespace tilemend
