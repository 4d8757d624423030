// The program tilemend-gdal, as others start it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "common/gis/area_file.h"
#include "common/gis/gdal_process.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;

TEST(GdalMainTest, AnswersWhatItIsAsked) {
  const auto known = AskGdal("CEPSG:25832", "crs"), unknown = AskGdal("Crubbish", "crs");
  ASSERT_TRUE(known.ok() && unknown.ok()) << known.status() << unknown.status();
  EXPECT_EQ(*known, "");
  EXPECT_THAT(*unknown, HasSubstr("PROJ knows no such CRS"));
  EXPECT_EQ(*AskGdal("", "nothing"), "");
  EXPECT_EQ(*AskGdal("Rrubbish", "nothing"), "");
}

TEST(GdalMainTest, WhatTakesTooMuchIsAnErrorOfTheFile) {
  std::string shp(100, '\0');  // a header that promises 4 GB, with a shape of a billion points
  shp.replace(0, 4, std::string("\0\0\x27\x0a", 4));
  shp.replace(24, 4, std::string("\x7f\xff\xff\xff", 4));
  shp.replace(28, 4, std::string("\xe8\x03\0\0", 4));
  shp.replace(32, 4, std::string("\x05\0\0\0", 4));
  shp += std::string("\0\0\0\1\x3f\xff\xff\xff\5\0\0\0", 12) + std::string(32, '\0') +
         std::string("\1\0\0\0\xff\xff\xff\x3f", 8);
  const auto file = ParseWaterFile({shp}, "bomb.shp", {});
  EXPECT_THAT(std::string(file.status().message()), HasSubstr("bomb.shp"));
}

}  // namespace
}  // namespace tilemend
