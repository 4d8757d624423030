// Materials and textures from the command line: two OBJ tiles with a hole over their border.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "tests/support/image_builders.h"
#include "tests/support/mesh_builders.h"
#include "tests/support/output_checks.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/textured_scene.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;
using Json = nlohmann::json;

class TexturesRunTest : public ::testing::Test {
 protected:
  void SetUp() override { WriteTexturedScene(folder_); }

  Json Run(const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"run", folder_ / "scene", "--out", folder_ / "out"};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = Process(folder_.path(), TILEMEND_CLIENT, words).Wait();
    EXPECT_EQ(ended.code, 0) << ended.err;
    return ReportOf(folder_ / "out");
  }
  std::string Out(const std::string& file) const { return ReadFile(folder_ / ("out/" + file)).value_or("none"); }
  std::map<std::string, std::string> Below(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / name)) {
      if (entry.is_regular_file()) files[entry.path().string()] = ReadFile(entry.path().string()).value();
    }
    return files;
  }

  TemporaryFolder folder_;
};

TEST_F(TexturesRunTest, TheOutputOpensAsTheInputDid) {
  const auto before = Below("scene");
  const Json report = Run();
  EXPECT_EQ(Below("scene"), before);
  for (const char* tile : {"Tile_+000_+000", "Tile_+001_+000"}) {
    const std::string path = absl::StrCat("Data/", tile, "/", tile);
    EXPECT_THAT(Out(path + ".obj"), StartsWith(before.at(folder_ / ("scene/" + path + ".obj"))));
    EXPECT_THAT(Out(path + ".mtl"), StartsWith(before.at(folder_ / ("scene/" + path + ".mtl"))));
  }
  EXPECT_EQ(Out("shared/my ground.jpg"), before.at(folder_ / "scene/shared/my ground.jpg"));
  EXPECT_EQ(Out("metadata.xml"), before.at(folder_ / "scene/metadata.xml"));
  EXPECT_THAT(report["warnings"].dump(), HasSubstr("lost.png is not there"));
}

// What a material file names is carried, and may not take the place of what the job writes.
TEST_F(TexturesRunTest, NoMaterialFilePutsAnOriginalOverAFilledTile) {
  const std::string library = "Data/Tile_+001_+000/Tile_+001_+000.mtl", tile = "Data/Tile_+000_+000/Tile_+000_+000.obj";
  folder_.Write("scene/.tilemend-results", "mine");
  folder_.Write("scene/" + library,
                absl::StrCat("newmtl ground\nmap_Ks ../../", tile, "\nmap_Kd ../../.tilemend-results\n"));
  const Json report = Run();
  EXPECT_THAT(Out(tile), HasSubstr("g tilemend_filled"));
  EXPECT_NE(Out(".tilemend-results"), "mine");
  EXPECT_THAT(report["warnings"].dump(), HasSubstr(library + ": line 2: ../../" + tile + " has the name of a tile"));
  EXPECT_THAT(report["warnings"].dump(), HasSubstr(library + ": line 3: ../../.tilemend-results has the name"));
}

// Somebody else's scene may hold links to files of who runs this.
TEST_F(TexturesRunTest, LinksOutOfTheSceneAreNotFollowed) {
  const std::string tile = "Data/Tile_+000_+000/Tile_+000_+000", image = "shared/my ground.jpg";
  folder_.Write("secret.txt", "a secret");
  for (const std::string& name : {tile + ".mtl", image}) {
    fs::remove(folder_ / ("scene/" + name));
    fs::create_symlink(folder_ / "secret.txt", folder_ / ("scene/" + name));
  }
  const std::string warnings = Run()["warnings"].dump();
  EXPECT_THAT(warnings, HasSubstr(tile + ".obj: Tile_+000_+000.mtl leads out of the scene's folder by a link"));
  EXPECT_THAT(warnings, HasSubstr("my ground.JPG leads out of the scene's folder by a link"));
  for (const auto& [path, bytes] : Below("out")) EXPECT_THAT(bytes, Not(HasSubstr("a secret"))) << path;
}

// What is in the output's folder of before.
TEST_F(TexturesRunTest, LinksInTheOutputAreReplaced) {
  const std::string image = "shared/my ground.jpg";
  fs::create_directories(folder_ / "out/shared");
  for (const bool again : {false, true}) {  // with results of before
    for (const std::string& name : {std::string("metadata.xml"), image}) {
      fs::remove(folder_ / ("out/" + name));
      fs::create_symlink(folder_ / ("scene/" + name), folder_ / ("out/" + name));
    }
    const Json report = Run({"--overwrite"});
    EXPECT_THAT(report["warnings"].dump(), Not(HasSubstr("itself"))) << again;
    for (const std::string& name : {std::string("metadata.xml"), image}) {
      EXPECT_FALSE(fs::is_symlink(folder_ / ("out/" + name))) << name << again;
      EXPECT_EQ(Out(name), ReadFile(folder_ / ("scene/" + name)).value());
    }
  }
}

TEST_F(TexturesRunTest, AFolderOfTheOutputThatIsALinkIsRefusedBeforeTheFirstTile) {
  fs::create_directories(folder_ / "out");
  fs::create_directory_symlink(folder_ / "scene/shared", folder_ / "out/shared");
  const Ended ended =
      Process(folder_.path(), TILEMEND_CLIENT, {"run", folder_ / "scene", "--out", folder_ / "out", "--overwrite"})
          .Wait();
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.err, HasSubstr(folder_ / "out/shared: a link"));
  EXPECT_FALSE(fs::exists(folder_ / "out/Data"));
}

TEST_F(TexturesRunTest, ASceneFileThatIsALinkToNothingIsAnError) {
  for (const std::string name : {"metadata.xml", "scene.json"}) {
    fs::remove(folder_ / ("scene/" + name));
    fs::create_symlink("gone", folder_ / ("scene/" + name));
    const Ended ended =
        Process(folder_.path(), TILEMEND_CLIENT, {"run", folder_ / "scene", "--out", folder_ / "out"}).Wait();
    EXPECT_EQ(ended.code, 4);
    EXPECT_THAT(ended.err, HasSubstr(folder_ / ("scene/" + name) + ": a link"));
    EXPECT_FALSE(fs::exists(folder_ / "out"));
  }
}

TEST_F(TexturesRunTest, BothTilesHaveTheColourOfTheRimAndDefineIt) {
  const Json report = Run();
  std::set<std::string> materials;
  for (const Json& hole : report["per_hole"]) {
    EXPECT_EQ(hole["colour"], ColourText(kGreen));
    materials.insert(hole["material"]);
  }
  ASSERT_THAT(materials, SizeIs(1));
  for (const char* tile : {"Tile_+000_+000", "Tile_+001_+000"}) {
    const std::string path = absl::StrCat("Data/", tile, "/", tile);
    EXPECT_THAT(Out(path + ".obj"), HasSubstr("usemtl " + *materials.begin() + "\n"));
    EXPECT_THAT(Out(path + ".mtl"), HasSubstr("newmtl " + *materials.begin() + "\n"));
  }
}

TEST_F(TexturesRunTest, LinksOrLeavesImagesIfAsked) {
  Run({"--textures", "link"});
  EXPECT_EQ(fs::hard_link_count(folder_ / "scene/shared/my ground.jpg"), 2U);
  EXPECT_EQ(fs::hard_link_count(folder_ / "scene/Data/Tile_+000_+000/Tile_+000_+000.mtl"), 1U);
  fs::remove_all(folder_ / "out");
  Run({"--textures", "off"});
  EXPECT_FALSE(fs::exists(folder_ / "out/shared"));
  EXPECT_THAT(Out("Data/Tile_+000_+000/Tile_+000_+000.obj"), HasSubstr("mtllib Tile_+000_+000_tilemend.mtl\n"));
  EXPECT_THAT(Out("Data/Tile_+000_+000/Tile_+000_+000_tilemend.mtl"), StartsWith("newmtl tilemend_fill_0"));
}

TEST_F(TexturesRunTest, TheOutputCanBeFilledAgain) {
  Run();
  fs::rename(folder_ / "out", folder_ / "first");
  fs::remove_all(folder_ / "scene");
  fs::rename(folder_ / "first", folder_ / "scene");
  folder_.Write("scene/scene.json", R"({"cell_size": 10, "cols": 2, "rows": 1, "tiles": [
    {"col": 0, "row": 0, "path": "Data/Tile_+000_+000/Tile_+000_+000.obj"},
    {"col": 1, "row": 0, "path": "Data/Tile_+001_+000/Tile_+001_+000.obj"}]})");
  const auto before = Below("scene/Data");
  Run();
  for (const auto& [path, bytes] : before) {
    EXPECT_EQ(Out(fs::path(path).lexically_relative(folder_ / "scene").string()), bytes) << path;
  }
}

// A broken image is no reason to fail: the fill has the colour that stands for ground.
TEST_F(TexturesRunTest, ABrokenImageIsAWarning) {
  for (const std::string& bytes :
       {std::string(), std::string("\xff\xd8\xff\xe0", 4), std::string("\x89PNG\r\n\x1a\n")}) {
    folder_.Write("scene/shared/my ground.jpg", bytes);
    const Json report = Run({"--overwrite"});
    EXPECT_THAT(report["warnings"].dump(), HasSubstr("my ground.jpg"));
    EXPECT_EQ(report["per_hole"][0]["colour"], "#8c8a82");
    EXPECT_EQ(Out("shared/my ground.jpg"), bytes) << "it is carried as it is";
  }
}

TEST_F(TexturesRunTest, AWrongColourIsAUsageError) {
  for (const char* colour : {"blue", "1,2,300"}) {
    Process run(folder_.path(), TILEMEND_CLIENT,
                {"run", folder_ / "scene", "--out", folder_ / "out", "--water-colour", colour});
    const Ended ended = run.Wait();
    EXPECT_EQ(ended.code, 2) << colour;
    EXPECT_THAT(ended.err, HasSubstr("0 to 255")) << colour;
  }
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace
}  // namespace tilemend
