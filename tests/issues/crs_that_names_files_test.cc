// PROJ opened any file that the text of a CRS named, and waited for ever where that was a pipe.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/gis/area_file.h"
#include "tests/common/gis/geojson_text.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

constexpr double kMostSeconds = 10;  // the pipe would hold it until the limit of a minute

class CrsThatNamesFilesTest : public ::testing::Test {
 protected:
  CrsThatNamesFilesTest() : pipe_(folder_ / "pipe") { EXPECT_EQ(::mkfifo(pipe_.c_str(), 0600), 0); }
  ~CrsThatNamesFilesTest() override {
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start_;
    EXPECT_LT(took.count(), kMostSeconds);
  }

  std::string ProjString() const {
    return absl::StrCat("+proj=utm +zone=32 +ellps=GRS80 +nadgrids=", pipe_, " +units=m");
  }

  // A CRS as a shapefile has it, bound to WGS 84 by a grid.
  std::string BoundCrs() const {
    constexpr char kBase[] =
        R"(GEOGCRS["bound",DATUM["D",ELLIPSOID["GRS 1980",6378137,298.257222101]],CS[ellipsoidal,2],)"
        R"(AXIS["longitude",east],AXIS["latitude",north],UNIT["degree",0.0174532925199433]])";
    constexpr char kTarget[] =
        R"(GEOGCRS["WGS 84",DATUM["World Geodetic System 1984",ELLIPSOID["WGS 84",6378137,298.257223563]],)"
        R"(CS[ellipsoidal,2],AXIS["latitude",north],AXIS["longitude",east],UNIT["degree",0.0174532925199433]])";
    return absl::StrCat("BOUNDCRS[SOURCECRS[", kBase, "],TARGETCRS[", kTarget,
                        R"(],ABRIDGEDTRANSFORMATION["by grid",METHOD["NTv2",ID["EPSG",9615]],)",
                        R"(PARAMETERFILE["Latitude and longitude difference file",")", pipe_, R"("]]])");
  }

  const TemporaryFolder folder_;
  const std::string pipe_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

SceneFrame Utm32() {
  SceneFrame frame{"EPSG:25832", {690000, 5335000, 0}};
  frame.hi = {100, 100};
  return frame;
}

TEST_F(CrsThatNamesFilesTest, OfASceneIsRefused) {
  for (const std::string& crs : {ProjString(), BoundCrs()}) {
    Scene scene;
    scene.crs = crs;
    const auto fault = CrsFaultOf(scene);
    ASSERT_TRUE(fault.ok()) << fault.status();
    std::cout << *fault << '\n';
    EXPECT_THAT(*fault, HasSubstr("names a file"));
    SceneFrame frame = Utm32();
    frame.crs = crs;
    const std::string lakes = CollectionText({FeatureText(PolygonText(SquareAt(11.57, 48.13, 0.001)))}, "EPSG:4326");
    EXPECT_TRUE(absl::IsInvalidArgument(ParseWaterFile({lakes, {}}, "lakes.geojson", frame).status()));
  }
}

TEST_F(CrsThatNamesFilesTest, OfGeoJsonIsRefused) {
  const std::string lakes = CollectionText({FeatureText(PolygonText(SquareAt(11.57, 48.13, 0.001)))}, ProjString());
  const absl::Status status = ParseWaterFile({lakes, {}}, "lakes.geojson", Utm32()).status();
  std::cout << status << '\n';
  EXPECT_THAT(std::string(status.message()), HasSubstr("names a file"));
}

// The .dbf beside it: one column of one letter, and one row.
std::string OneRow() {
  std::string bytes = {3, 126, 1, 1, 1, 0, 0, 0, 65, 0, 2, 0};
  bytes.resize(32);
  bytes += "id";
  bytes.resize(43);
  bytes += 'C';
  bytes.resize(48);
  bytes += '\1';
  bytes.resize(64);
  return bytes + "\r 1\x1a";
}

// Of a shapefile with one square, in the order of its format.
class ShapefileBytes {
 public:
  explicit ShapefileBytes(std::vector<Point2> ring) {
    ring.push_back(ring.front());
    const int32_t content = 44 + 4 + 16 * static_cast<int32_t>(ring.size());
    constexpr int32_t kFileCode = 9994, kVersion = 1000, kPolygon = 5, kHeader = 100;
    Put(kFileCode, true);
    for (int i = 0; i < 5; ++i) Put(int32_t{0});
    Put((kHeader + 8 + content) / 2, true);
    Put(kVersion);
    Put(kPolygon);
    PutBox(ring);
    for (int i = 0; i < 4; ++i) Put(0.0);
    Put(int32_t{1}, true);  // number of the record
    Put(content / 2, true);
    Put(kPolygon);
    PutBox(ring);
    Put(int32_t{1});  // parts
    Put(static_cast<int32_t>(ring.size()));
    Put(int32_t{0});
    for (auto it = ring.rbegin(); it != ring.rend(); ++it) Put(it->x()), Put(it->y());  // clockwise
  }
  const std::string& bytes() const { return bytes_; }

 private:
  template <typename T>
  void Put(T value, bool big_endian = false) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big_endian) std::reverse(bytes.begin(), bytes.end());
    bytes_ += bytes;
  }
  void PutBox(const std::vector<Point2>& ring) {
    for (const Point2& corner : {ring[0], ring[2]}) Put(corner.x()), Put(corner.y());
  }
  std::string bytes_;
};

TEST_F(CrsThatNamesFilesTest, OfAShapefileIsRefused) {
  const std::string projected =
      R"(PROJCS["x",GEOGCS["D",DATUM["D",SPHEROID["GRS 1980",6378137,298.257222101]],PRIMEM["Greenwich",0],)"
      R"(UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],PARAMETER["central_meridian",9],)"
      R"(PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],UNIT["metre",1],EXTENSION["PROJ4",")" +
      ProjString() + R"("]])";
  for (const std::string& crs : {projected, BoundCrs()}) {
    const ShapefileBytes lakes(SquareAt(690010, 5335010, 20));
    const auto file = ParseWaterFile({lakes.bytes(), {{"dbf", OneRow()}, {"prj", crs}}}, "lakes.shp", Utm32());
    std::cout << file.status() << (file.ok() && !file->warnings.empty() ? file->warnings.front() : "") << '\n';
    if (file.ok()) {  // GDAL itself may not take it for a CRS
      EXPECT_THAT(file->warnings, ::testing::Contains(HasSubstr("names no CRS that is known")));
    } else {
      EXPECT_THAT(std::string(file.status().message()), HasSubstr("names a file"));
    }
  }
}

}  // namespace
}  // namespace tilemend
