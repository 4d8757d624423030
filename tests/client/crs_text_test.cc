#include "client/crs_text.h"

#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

TEST(CrsTextTest, WktIsShownByItsNameAndCode) {
  EXPECT_EQ(CrsText(R"w(PROJCS["ETRS89 / UTM zone 32N",GEOGCS["ETRS89",DATUM["European (1989)",SPHEROID["GRS 1980",)w"
                    R"w(6378137,298.25]],AUTHORITY["EPSG","4258"]],UNIT["metre",1],AUTHORITY["EPSG","25832"]])w"),
            "ETRS89 / UTM zone 32N (EPSG:25832)");
  EXPECT_EQ(CrsText("PROJCRS[\"RGF93 / CC48\",\n  BASEGEOGCRS[\"RGF93\",ID[\"EPSG\",4171]],\n  ID[\"EPSG\",3948]]\n"),
            "RGF93 / CC48 (EPSG:3948)");
  EXPECT_EQ(CrsText(R"w(LOCAL_CS["site, north [3]"])w"), "site, north [3]");
  EXPECT_EQ(CrsText(R"w(COMPD_CS["a + b",PROJCS["a",AUTHORITY["EPSG","1"]],VERT_CS["b",AUTHORITY["EPSG","2"]]])w"),
            "a + b");
}

TEST(CrsTextTest, AnythingElseIsShownAsItIs) {
  for (const char* text : {"", "EPSG:25832+7837", "ENU:48.1,11.5", "+proj=utm +zone=32", "PROJCS", "PROJCS[", "CS[]",
                           "PROJCS[\"\"]", "x y[\"a\"]", "[]]]"}) {
    EXPECT_EQ(CrsText(text), text);
  }
  EXPECT_EQ(CrsText("PROJCS[\"open"), "PROJCS[\"open");
}

TEST(CrsTextTest, DeepAndLongTextsTakeNoTime) {
  std::string deep = "PROJCS[\"x\",";
  for (int i = 0; i < 100000; ++i) deep += "A[";
  EXPECT_EQ(CrsText(deep), "x");
  EXPECT_EQ(CrsText("PROJCS[\"x\"" + std::string(100000, ']')), "x");
}

}  // namespace
}  // namespace tilemend
