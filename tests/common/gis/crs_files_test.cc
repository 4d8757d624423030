#include "common/gis/crs_files.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(FileNamedInTest, FindsFilesOfProjStringsAndWkt) {
  for (const char* crs :
       {"+proj=utm +zone=32 +nadgrids=/etc/passwd", "+proj=utm +zone=32 +NADGRIDS = @/etc/passwd,null",
        "+nadgrids=@null,/etc/passwd", "+proj=longlat +geoidgrids=./a.gtx", "+init=/tmp/file:1",
        "+proj=pipeline +step +proj=defmodel +file=/a", "+proj=deformation +xy_grids=/a",
        R"(BOUNDCRS[SOURCECRS[x],PARAMETERFILE["Datum file","/tmp/pipe"]])", R"(PARAMETERFILE ( "a" , "b" ))",
        R"(PROJCS["x",EXTENSION["PROJ4","+proj=merc +nadgrids=a.gsb"]])"}) {
    EXPECT_NE(FileNamedIn(crs), "") << crs;
  }
  EXPECT_EQ(FileNamedIn("+nadgrids=/etc/passwd +x_0=1"), "grids=/etc/passwd");
}

TEST(FileNamedInTest, OrdinaryTextsNameNone) {
  for (const char* crs :
       {"", "EPSG:25832", "ENU:48.1,11.5", "+proj=merc +a=6378137 +nadgrids=@null +wktext", "+init=epsg:25832",
        "proj=merc nadgrids=@null a=6378137", "+proj=utm +zone=32 +ellps=GRS80", "PARAMETERFILE", "PARAMETERFILE[\"a\"",
        R"(PROJCS["x",EXTENSION["PROJ4","+proj=merc +nadgrids=@null +wktext"]])",
        R"(PROJCRS["ETRS89 / UTM zone 32N",BASEGEOGCRS["ETRS89"]])"}) {
    EXPECT_EQ(FileNamedIn(crs), "") << crs;
  }
}

}  // namespace
}  // namespace tilemend
