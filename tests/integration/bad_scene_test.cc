// Damaged scenes and outputs that cannot be: the exit code, one line that names the file and the place, nothing
// written, nothing of the user's changed, in little time and memory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "common/util/files.h"
#include "tests/support/output_checks.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Json = nlohmann::json;

constexpr char kTile[] = "/tiles/Tile_+000_+000.ply";

SceneMakerOptions TwoByTwo() {
  SceneMakerOptions options;
  options.cols = options.rows = 2;
  options.cell_size = 20;
  options.spacing = 2;
  options.ellipses = {{{20, 20}, {5, 4}}};
  return options;
}

void Put(const std::string& path, const std::string& bytes) {
  const absl::Status status = WriteFileAtomically(path, bytes, Sync::kNo);
  EXPECT_TRUE(status.ok()) << status;
}

using Damage = std::function<void(const std::string& scene)>;

Damage Edit(const std::function<void(Json&)>& edit) {
  return [edit](const std::string& scene) {
    Json json = Json::parse(ReadFile(scene + "/scene.json").value_or(""));
    edit(json);
    Put(scene + "/scene.json", json.dump());
  };
}

Damage SetField(const std::string& field, const Json& value) {
  return Edit([field, value](Json& json) { json[field] = value; });
}

Damage SetOfTile(const std::string& field, const Json& value) {
  return Edit([field, value](Json& json) { json["tiles"][0][field] = value; });
}

Damage SceneText(const std::string& text) {
  return [text](const std::string& scene) { Put(scene + "/scene.json", text); };
}

Damage TileBytes(const std::string& bytes) {
  return [bytes](const std::string& scene) { Put(scene + kTile, bytes); };
}

Damage EditTile(const std::function<void(std::string&)>& edit) {
  return [edit](const std::string& scene) {
    std::string bytes = ReadFile(scene + kTile).value_or("");
    edit(bytes);
    Put(scene + kTile, bytes);
  };
}

Damage FirstX(float x) {
  return EditTile([x](std::string& bytes) { std::memcpy(&bytes[bytes.find("end_header\n") + 11], &x, sizeof(x)); });
}

std::string PlyHeader(const std::string& vertices, const std::string& faces) {
  return absl::StrCat("ply\nformat binary_little_endian 1.0\nelement vertex ", vertices,
                      "\nproperty float x\nproperty float y\nproperty float z\nelement face ", faces,
                      "\nproperty list uchar int vertex_indices\nend_header\n");
}

struct BadScene {
  std::string name;
  Damage damage;
  int code = 4;
  std::string message;
};

void PrintTo(const BadScene& scene, std::ostream* out) { *out << scene.name; }

std::vector<BadScene> BadTiles() {
  return {
      {"MissingFile", [](const auto& scene) { fs::remove(scene + kTile); }, 3, "cell +000_+000: "},
      {"TruncatedFile", EditTile([](auto& bytes) { bytes.resize(bytes.size() - 10); }), 4, "found end of file"},
      {"EmptyFile", TileBytes(""), 4, "Tile_+000_+000.ply: line 1: expected 'ply'"},
      {"IndexOutOfRange", EditTile([](auto& bytes) { bytes[bytes.size() - 1] = 0x7f; }), 4, "expected a vertex index"},
      {"NotANumber", FirstX(std::nanf("")), 4, "byte 173: expected a coordinate"},
      {"Infinite", FirstX(HUGE_VALF), 4, "byte 173: expected a coordinate"},
      {"TooFar", FirstX(1e30F), 4, "at most 1e9 m"},
      {"OutsideItsCell", FirstX(500), 4, "outside its cell +000_+000"},
      {"HugeCount", TileBytes(PlyHeader("4000000000", "1")), 4, "expected 4000000000 records of element vertex"},
      {"CountBeyondNumbers", TileBytes(PlyHeader("99999999999999999999", "1")), 4, "line 3"},
      {"NoVertices", TileBytes(PlyHeader("0", "0")), 4, "no vertices"},
      {"NotAMesh", TileBytes(std::string(1000, '\xff')), 4, "Tile_+000_+000.ply: line 1"},
      {"AFolder", [](const auto& scene) { fs::remove(scene + kTile), fs::create_directory(scene + kTile); }, 4,
       "not a file"},
      {"APipe", [](const auto& scene) { fs::remove(scene + kTile), mkfifo((scene + kTile).c_str(), 0600); }, 4,
       "not a file"},
      {"ALinkToItself",
       [](const auto& scene) { fs::remove(scene + kTile), fs::create_symlink(scene + kTile, scene + kTile); }, 3,
       "no such file"},
      {"SwappedTiles",
       [](const auto& scene) {
         fs::rename(scene + kTile, scene + "/t");
         fs::rename(scene + "/tiles/Tile_+001_+000.ply", scene + kTile);
         fs::rename(scene + "/t", scene + "/tiles/Tile_+001_+000.ply");
       },
       4, "outside its cell"},
  };
}

void LinkTilesetOut(const std::string& scene) {
  fs::rename(scene + "/scene.json", scene + "/../outside.json");
  fs::create_symlink("../outside.json", scene + "/tileset.json");
}

std::vector<BadScene> BadGrids() {
  return {
      {"CellSizeZero", SetField("cell_size", 0), 4, "scene.json: cell_size: must be finite and greater than 0"},
      {"CellSizeNegative", SetField("cell_size", {20, -20}), 4, "scene.json: cell_size: must be"},
      {"CellSizeNull", SetField("cell_size", nullptr), 4, "scene.json: cell_size: missing"},
      {"CellSizeText", SetField("cell_size", "20"), 4, "scene.json: cell_size: expected a number"},
      {"CellSizeHuge", SetField("cell_size", 1e300), 4, "scene.json: cell_size: must be at most"},
      {"CellSizeTiny", SetField("cell_size", 1e-300), 4, "outside its cell"},
      {"CellSizeWrong", SetField("cell_size", 10), 4, "outside its cell"},
      {"CellSizeNotANumber", SceneText(R"({"cell_size": NaN})"), 4, "not JSON: byte 15"},
      {"CornerFarAway", SetField("grid_corner", {1e12, 0}), 4, "scene.json: grid_corner: must be"},
      {"TooManyColumns", SetField("cols", 1000000000), 4, "scene.json: cols: expected 1 to 100000"},
      {"NoRows", SetField("rows", 0), 4, "scene.json: rows: expected"},
      {"Empty", SceneText(""), 4, "scene.json: not JSON: byte 1"},
      {"CutOff", SceneText(R"({"cell_size": 20,)"), 4, "scene.json: not JSON"},
      {"NotAnObject", SceneText("[]"), 4, "scene.json: expected an object"},
      {"NotUtf8", SceneText("\xff\xfe{}"), 4, "scene.json: not JSON"},
      {"Deep", SceneText(std::string(200000, '[')), 4, "scene.json: not JSON"},
      {"NoTilesListed", SetField("tiles", Json::array()), 4, "scene.json: tiles: no cell is listed"},
      {"ColumnOutside", SetOfTile("col", 7), 4, "tiles[0].col: expected 0 to 1, found 7"},
      {"ColumnNegative", SetOfTile("col", -1), 4, "tiles[0].col"},
      {"ColumnNotWhole", SetOfTile("col", 0.5), 4, "tiles[0].col: expected an integer"},
      {"TwoTilesForACell", SetOfTile("col", 1), 4, "are both cell +001_+000"},
      {"OneFileForTwoCells", SetOfTile("path", "tiles/Tile_+001_+001.ply"), 4, "both the file"},
      {"PathAbove", SetOfTile("path", "../x.ply"), 4, "tiles[0].path: \"../x.ply\" leaves the scene's folder"},
      {"PathAbsolute", SetOfTile("path", "/etc/x.ply"), 4, "is absolute"},
      {"PathOfAnotherFormat", SetOfTile("path", "tiles/x.b3dm"), 4, "format \".b3dm\" is not read"},
      {"PathOfNoFormat", SetOfTile("path", "tiles/x"), 4, "tiles are .ply, .obj, .osgb or a tileset.json"},
      {"OutputsClash", Edit([](Json& json) {
         json["tiles"][0]["path"] = "tiles/Tile_+001_+000.ply";
         json["tiles"][1]["path"] = nullptr;
       }),
       4, "which is the file of tiles[0]"},
      {"TilesetElsewhere", LinkTilesetOut, 4, "tileset.json: it leads out of the folder"},
      {"NothingThere", [](const auto& scene) { fs::remove_all(scene); }, 3, "no such "},
      {"NoTiles", [](const auto& scene) { fs::remove_all(scene), fs::create_directory(scene); }, 3,
       "no tile named like"},
  };
}

class BadSceneTest : public ::testing::TestWithParam<BadScene> {
 protected:
  void ExpectRefused(const Ended& ended) {
    EXPECT_EQ(ended.code, GetParam().code) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(GetParam().message));
    EXPECT_THAT(ended.err, HasSubstr(folder_.path()));
    ExpectFrugal(ended);
  }

  TemporaryFolder folder_;
};

TEST_P(BadSceneTest, IsRefusedWithItsPlaceAndNothingIsWritten) {
  const std::string scene = WriteMade(TwoByTwo(), folder_ / "in/scene");
  GetParam().damage(scene);
  const auto tree = [&] {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "in")) names.push_back(entry.path());
    std::sort(names.begin(), names.end());
    return names;
  };
  const auto before = tree();
  const Ended run = Process(folder_.path(), TILEMEND_CLIENT, {"run", scene, "--out", folder_ / "out"}).Wait();
  ExpectRefused(run);
  // Progress, then one line.
  const std::string line = run.err.substr(run.err.rfind("tilemend: "));
  EXPECT_EQ(std::count(line.begin(), line.end(), '\n'), 1) << line;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  ExpectRefused(Process(folder_.path(), TILEMEND_CLIENT, {"inspect", scene}).Wait());
  EXPECT_EQ(tree(), before);
}

INSTANTIATE_TEST_SUITE_P(Tiles, BadSceneTest, ::testing::ValuesIn(BadTiles()),
                         [](const auto& scene) { return scene.param.name; });
INSTANTIATE_TEST_SUITE_P(Grids, BadSceneTest, ::testing::ValuesIn(BadGrids()),
                         [](const auto& scene) { return scene.param.name; });

// Where an output cannot be. OUT is the argument; `prepare` gets the folder of the test, with the scene in it.
struct BadOutput {
  std::string name;
  std::string out;  // below the folder of the test, or absolute
  int code = 4;
  std::string message;
  std::function<void(const std::string& folder)> prepare = [](const std::string& /*folder*/) {};
};

void PrintTo(const BadOutput& output, std::ostream* out) { *out << output.name; }

class BadOutputTest : public ::testing::TestWithParam<BadOutput> {};

TEST_P(BadOutputTest, IsRefusedAlsoWithOverwriteAndNothingChanges) {
  const TemporaryFolder folder, logs;
  const std::string scene = WriteMade(TwoByTwo(), folder / "scene");
  folder.Write("file", "mine");
  GetParam().prepare(folder.path());
  const auto before = FilesBelow(folder.path());
  const std::string& out = GetParam().out;
  for (const bool overwrite : {false, true}) {
    std::vector<std::string> words = {"run", scene, "--out", absl::StartsWith(out, "/") ? out : folder / out};
    if (overwrite) words.push_back("--overwrite");
    const Ended ended = Process(logs.path(), TILEMEND_CLIENT, words).Wait();
    EXPECT_EQ(ended.code, GetParam().code) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(overwrite ? GetParam().message : "tilemend: "));
    EXPECT_EQ(FilesBelow(folder.path()), before);
  }
}

std::vector<BadOutput> BadOutputs() {
  const std::string over = "among the tiles of the scene";
  return {
      {"TheScene", "scene", 4, over},
      {"TheSceneByAnotherName", "scene/../scene/", 4, over},
      {"TheTiles", "scene/tiles", 4, over},
      {"AmongTheTiles", "scene/tiles/out", 4, over},
      {"ALinkToTheScene", "link", 4, over, [](const auto& f) { fs::create_symlink(f + "/scene", f + "/link"); }},
      {"ALinkToTheTilesInside", "out", 4, over,
       [](const auto& f) {
         fs::create_directory(f + "/out");
         Put(f + "/out/mine.txt", "mine");
         fs::create_symlink(f + "/scene/tiles", f + "/out/tiles");
       }},
      {"AFile", "file", 4, "a file, not a folder"},
      {"BelowAFile", "file/out", 4, "choose another --out"},
      {"AName", std::string(300, 'x'), 4, "choose another --out"},
      {"NoFileSystem", "/proc/out", 6, "choose another --out"},
      {"ADevice", "/dev/null", 4, "a file, not a folder"},
  };
}

INSTANTIATE_TEST_SUITE_P(Outputs, BadOutputTest, ::testing::ValuesIn(BadOutputs()),
                         [](const auto& output) { return output.param.name; });

TEST(BadFlagsTest, AreUsageErrors) {
  const TemporaryFolder folder;
  const std::string scene = WriteMade(TwoByTwo(), folder / "scene"), out = folder / "out";
  const std::vector<std::vector<std::string>> cases = {{"frob"},
                                                       {"run"},
                                                       {"run", scene},
                                                       {"run", scene, scene, "--out", out},
                                                       {"run", ""},
                                                       {"inspect", ""},
                                                       {"get"},
                                                       {"fill", scene},
                                                       {"help", "frob"},
                                                       {"--frob"},
                                                       {"list", "--coordinator", "nohost"}};
  for (const auto& words : cases) {
    const Ended ended = Process(folder.path(), TILEMEND_CLIENT, words).Wait();
    EXPECT_EQ(ended.code, 2) << words[0] << ended.err;
    EXPECT_EQ(ended.out, "");
    EXPECT_THAT(ended.err, HasSubstr("tilemend: "));
  }
  for (const char* flag :
       {"--workers=0", "--workers=-1", "--workers=99999", "--workers=two", "--workers=1.5", "--bogus", "--surface=x",
        "--gradation=nan", "--gradation=0", "--size-limit=inf", "--overwrite=1", "--output=xml", "--seam-smoothing=2",
        "--seam-smoothing=0.5", "--workers"}) {
    const Ended ended = Process(folder.path(), TILEMEND_CLIENT, {"run", scene, "--out", out, flag}).Wait();
    EXPECT_EQ(ended.code, 2) << flag << ended.err;
  }
  EXPECT_FALSE(fs::exists(out));
}

}  // namespace
}  // namespace tilemend
