// `tilemend fill` and `tilemend inspect` on single meshes.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/util/files.h"
#include "tests/support/output_checks.h"
#include "tests/support/process.h"
#include "tests/support/space_meshes.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Json = nlohmann::json;

// A wavy sheet of 12 x 12 squares without the 4 x 4 in the middle: one hole, one outline.
TriMesh SheetWithAHole() {
  constexpr int kSide = 13;
  TriMesh mesh;
  for (int r = 0; r < kSide; ++r) {
    for (int c = 0; c < kSide; ++c) mesh.points.emplace_back(c, r, 0.3 * std::sin(0.7 * c) * std::cos(0.6 * r));
  }
  for (int r = 0; r + 1 < kSide; ++r) {
    for (int c = 0; c + 1 < kSide; ++c) {
      if (r >= 4 && r < 8 && c >= 4 && c < 8) continue;
      const int a = r * kSide + c;
      mesh.triangles.push_back({a, a + 1, a + 1 + kSide});
      mesh.triangles.push_back({a, a + 1 + kSide, a + kSide});
    }
  }
  return mesh;
}

std::string StlText(const TriMesh& mesh) {
  std::string text = "solid sheet\n";
  for (const Triangle& t : mesh.triangles) {
    text += "facet normal 0 0 1\nouter loop\n";
    for (const int32_t v : t) {
      const Point3& p = mesh.points[v];
      absl::StrAppendFormat(&text, "vertex %.17g %.17g %.17g\n", p.x(), p.y(), p.z());
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid sheet\n";
}

std::string Text(const TriMesh& mesh, MeshFormat format) {
  if (format == MeshFormat::kStl) return StlText(mesh);
  std::string text = format == MeshFormat::kOff
                         ? absl::StrFormat("OFF\n%d %d 0\n", mesh.points.size(), mesh.triangles.size())
                         : "# a sheet\nmtllib sheet.mtl\n";
  const char* const vertex = format == MeshFormat::kOff ? "" : "v ";
  for (const Point3& p : mesh.points)
    absl::StrAppendFormat(&text, "%s%.17g %.17g %.17g\n", vertex, p.x(), p.y(), p.z());
  if (format == MeshFormat::kObj) text += "usemtl grass\n";
  for (const Triangle& t : mesh.triangles) {
    const int first = format == MeshFormat::kOff ? 0 : 1;
    absl::StrAppendFormat(&text, "%s %d %d %d\n", first == 0 ? "3" : "f", t[0] + first, t[1] + first, t[2] + first);
  }
  return text;
}

struct FormatCase {
  const char* extension;
  MeshFormat format;
};

class FillTest : public ::testing::TestWithParam<FormatCase> {
 protected:
  Ended Tilemend(const std::vector<std::string>& words) {
    return Process(folder_.path(), TILEMEND_CLIENT, words).Wait();
  }
  std::string WriteSheet() {
    const TriMesh mesh = SheetWithAHole();
    const bool ply = GetParam().format == MeshFormat::kPly;
    return folder_.Write(absl::StrCat("in", GetParam().extension),
                         ply ? PlyBytes(mesh) : Text(mesh, GetParam().format));
  }
  std::string Out() const { return folder_ / absl::StrCat("out", GetParam().extension); }

  TemporaryFolder folder_;
};

TEST_P(FillTest, FillsTheHoleAndKeepsTheMesh) {
  const std::string in = WriteSheet(), before = *ReadFile(in);
  const Ended ended = Tilemend({"fill", in, "--out", Out()});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("1 of 1 hole filled"));
  EXPECT_EQ(*ReadFile(in), before);
  const auto a = ReadMeshFile(in), b = ReadMeshFile(Out());
  ASSERT_TRUE(a.ok() && b.ok()) << a.status() << b.status();
  EXPECT_GT(b->mesh.triangles.size(), a->mesh.triangles.size());
  ASSERT_GE(b->mesh.points.size(), a->mesh.points.size());
  EXPECT_TRUE(std::equal(a->mesh.points.begin(), a->mesh.points.end(), b->mesh.points.begin()));
  EXPECT_TRUE(std::equal(a->mesh.triangles.begin(), a->mesh.triangles.end(), b->mesh.triangles.begin()));
  if (GetParam().format == MeshFormat::kObj) {
    EXPECT_THAT(*ReadFile(Out()), StartsWith(before));
  }
}

TEST_P(FillTest, InspectWritesTheHolesThatItWouldFill) {
  const std::string in = WriteSheet(), holes = folder_ / "holes.geojson";
  const Ended ended = Tilemend({"inspect", in, "--holes", holes});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("1 hole to fill, 0 that stay open"));
  const Json json = Json::parse(*ReadFile(holes), nullptr, false);
  ASSERT_EQ(json["features"].size(), 1u);
  EXPECT_EQ(json["features"][0]["geometry"]["type"], "Polygon");
  EXPECT_EQ(json["features"][0]["properties"]["outcome"], "to fill");
  EXPECT_FALSE(json["features"][0]["properties"].contains("method"));
  EXPECT_EQ(Tilemend({"inspect", in, "--holes", holes}).code, 4);
  EXPECT_EQ(Tilemend({"inspect", in, "--holes", holes, "--overwrite"}).code, 0);
}

TEST_P(FillTest, TheReportHasSecondsByStageAndPeakMemory) {
  const Ended ended = Tilemend({"fill", WriteSheet(), "--out", Out(), "--surface", "thin-plate", "-o", "json"});
  const Json json = Json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << ended.err;
  for (const char* stage : {"read", "survey", "fill", "assemble", "write"}) {
    ASSERT_TRUE(json["seconds"].contains(stage)) << stage;
    EXPECT_GE(json["seconds"][stage], 0) << stage;
  }
  EXPECT_GT(json["peak_rss_bytes"], 1 << 20);
}

// What was filled has no hole any more: filling it again copies it.
TEST_P(FillTest, AFilledMeshStaysAsItIs) {
  const std::string in = WriteSheet(), again = folder_ / absl::StrCat("again", GetParam().extension);
  ASSERT_EQ(Tilemend({"fill", in, "--out", Out()}).code, 0);
  const Ended inspected = Tilemend({"inspect", Out(), "-o", "json"});
  const Json json = Json::parse(inspected.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << inspected.err;
  EXPECT_EQ(json["holes"]["closed"], 0);
  EXPECT_EQ(json["outer_rims"], 1);
  EXPECT_EQ(json["nonmanifold_edges"], 0);
  EXPECT_EQ(Tilemend({"fill", Out(), "--out", again}).code, 0);
  EXPECT_EQ(*ReadFile(again), *ReadFile(Out()));
}

TEST_P(FillTest, AnExistingFileNeedsOverwrite) {
  const std::string in = WriteSheet();
  folder_.Write(absl::StrCat("out", GetParam().extension), "mine");
  const Ended refused = Tilemend({"fill", in, "--out", Out()});
  EXPECT_EQ(refused.code, 4);
  EXPECT_THAT(refused.err, HasSubstr("--overwrite"));
  EXPECT_EQ(*ReadFile(Out()), "mine");
  EXPECT_EQ(Tilemend({"fill", in, "--out", Out(), "--overwrite"}).code, 0);
  EXPECT_NE(*ReadFile(Out()), "mine");
}

TEST_P(FillTest, TheInputIsNeverWrittenOver) {
  const std::string in = WriteSheet(), before = *ReadFile(in);
  std::filesystem::create_symlink(in, folder_ / absl::StrCat("link", GetParam().extension));
  for (const std::string& out : {in, folder_ / absl::StrCat("link", GetParam().extension)}) {
    EXPECT_EQ(Tilemend({"fill", in, "--out", out, "--overwrite"}).code, 4);
    EXPECT_EQ(*ReadFile(in), before);
  }
}

TEST_P(FillTest, JsonIsAReport) {
  const Ended ended = Tilemend({"fill", WriteSheet(), "--out", Out(), "-o", "json"});
  const Json json = Json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << ended.out << ended.err;
  EXPECT_EQ(json["holes"]["closed"], 1);
  EXPECT_EQ(json["filled"]["closed"], 1);
}

// The mesh may be an output of before, with materials of filled faces in a file of the same name.
TEST(FillMaterialsTest, ALibraryOfTheMeshStaysInTheOneOfItsName) {
  const TemporaryFolder folder;
  std::string text = Text(SheetWithAHole(), MeshFormat::kObj);
  text.replace(text.find("sheet.mtl"), 9, "a_tilemend.mtl");
  folder.Write("in/a.obj", text);
  folder.Write("in/a_tilemend.mtl", "newmtl grass\nKd 0 1 0\n");
  for (const char* overwrite : {"", "--overwrite"}) {
    std::vector<std::string> words = {"fill", folder / "in/a.obj", "--out", folder / "out/a.obj"};
    if (*overwrite != '\0') words.emplace_back(overwrite);
    const Ended ended = Process(folder.path(), TILEMEND_CLIENT, words).Wait();
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_THAT(ended.err, Not(HasSubstr("a_tilemend.mtl")));
    EXPECT_THAT(*ReadFile(folder / "out/a_tilemend.mtl"), StartsWith("newmtl grass\nKd 0 1 0\nnewmtl tilemend_fill_0"));
  }
  EXPECT_EQ(*ReadFile(folder / "in/a_tilemend.mtl"), "newmtl grass\nKd 0 1 0\n");
}

TEST(FillMaterialsTest, AFillThatCannotWriteTheMeshLeavesNoLibrary) {
  const TemporaryFolder folder, logs;
  const std::string in = folder.Write("in/a.obj", Text(SheetWithAHole(), MeshFormat::kObj));
  const std::string fill = absl::StrCat(TILEMEND_CLIENT, " fill ", in, " --out ", folder / "out/a.obj");
  // Room for the material file, not for the mesh.
  const Ended full = Process(logs.path(), "/bin/sh", {"-c", absl::StrCat("ulimit -f 4; exec ", fill)}).Wait();
  EXPECT_GT(full.code, 0) << full.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  folder.Write("out/a_tilemend.mtl", "mine");
  EXPECT_EQ(Process(logs.path(), "/bin/sh", {"-c", fill}).Wait().code, 4);
  EXPECT_EQ(*ReadFile(folder / "out/a_tilemend.mtl"), "mine");
  std::filesystem::remove_all(folder / "out");
  const Ended ended = Process(logs.path(), "/bin/sh", {"-c", fill}).Wait();
  EXPECT_EQ(ended.code, 0) << ended.err;
}

// A sheet in two halves, 0.01 apart; the right one has two vertices for one along the seam, and a hole.
TriMesh SheetWithACrack() {
  TriMesh mesh = SquaresMesh(0, 4, 0, 8, [](int32_t, int32_t) { return true; });
  TriMesh right = SquaresMesh(0, 12, 0, 16, [](int32_t i, int32_t j) { return i < 5 || i > 8 || j < 5 || j > 8; });
  for (Point3& p : right.points) p = Point3(4.01 + p.x() / 2, p.y() / 2, 0);
  AddMesh(right, mesh);
  return mesh;
}

TEST_P(FillTest, WeldsBoundariesIfAskedAndReportsEachMerge) {
  const TriMesh mesh = SheetWithACrack();
  const bool ply = GetParam().format == MeshFormat::kPly;
  const std::string in =
      folder_.Write(absl::StrCat("in", GetParam().extension), ply ? PlyBytes(mesh) : Text(mesh, GetParam().format));
  const Ended ended = Tilemend({"fill", in, "--out", Out(), "--weld", "0.02", "-o", "json"});
  const Json json = Json::parse(ended.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << ended.err;
  EXPECT_EQ(json["options"]["weld"], 0.02);
  EXPECT_EQ(json["filled"]["closed"], 1);
  ASSERT_EQ(json["weld"]["welded"].size(), 9U);
  EXPECT_EQ(json["weld"]["split"].size(), 8U);
  EXPECT_EQ(json["weld"]["refused"].size(), 0U);
  const auto a = ReadMeshFile(in), b = ReadMeshFile(Out());
  ASSERT_TRUE(a.ok() && b.ok()) << a.status() << b.status();
  for (const Json& row : json["weld"]["welded"]) {
    const Point3 &from = a->mesh.points[row["vertices"][0]], &into = a->mesh.points[row["vertices"][1]];
    EXPECT_NEAR(row["distance"], (from - into).norm(), 1e-12);
    EXPECT_NEAR(row["distance"], 0.01, 1e-6);
  }
  if (GetParam().format != MeshFormat::kStl) {
    EXPECT_TRUE(std::equal(a->mesh.points.begin(), a->mesh.points.end(), b->mesh.points.begin())) << "moved";
  }
  const Json found = Json::parse(Tilemend({"check", Out(), "-o", "json"}).out, nullptr, false);
  EXPECT_EQ(found["outlines"], 1);
  for (const auto& [name, defect] : found["defects"].items()) EXPECT_EQ(defect["count"], 0) << name;
  // Each is asked for with a number.
  for (const char* bad : {"0", "-1", "wide"}) EXPECT_EQ(Tilemend({"fill", in, "--out", Out(), "--weld", bad}).code, 2);
}

INSTANTIATE_TEST_SUITE_P(Formats, FillTest,
                         ::testing::Values(FormatCase{".ply", MeshFormat::kPly}, FormatCase{".obj", MeshFormat::kObj},
                                           FormatCase{".off", MeshFormat::kOff}, FormatCase{".stl", MeshFormat::kStl}),
                         [](const auto& format) { return std::string(format.param.extension + 1); });

// The rim of the hole tells nothing of the body that goes through it: the mesh is read again for it, here and by
// workers.
TEST(FillCommandTest, LeavesAHoleThatEveryPatchOfCrossesTheSurface) {
  TriMesh mesh = WithoutHole(BoxMesh(6), [](const Point3& p) { return p.norm() < 2.5; });
  for (Point3& p : mesh.points) p += Point3(10, 10, 5);
  TriMesh with_body = mesh;
  AddMesh(Needle(Point3(10.5, 10.5, 5.5)), with_body);
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "scene");
  const Json scene = {{"origin", {0, 0, 0}},
                      {"cell_size", 30},
                      {"cols", 1},
                      {"rows", 1},
                      {"tiles", {{{"col", 0}, {"row", 0}, {"path", "box.ply"}}}}};
  folder.Write("scene/scene.json", scene.dump());
  for (const bool body : {false, true}) {
    folder.Write("scene/box.ply", PlyBytes(body ? with_body : mesh));
    const Ended fill = Process(folder.path(), TILEMEND_CLIENT,
                               {"fill", folder / "scene/box.ply", "--out", folder / "out.ply", "--overwrite"})
                           .Wait();
    EXPECT_EQ(fill.code, body ? 100 : 0) << fill.err;
    EXPECT_EQ(absl::StrContains(fill.err, "passes through itself or the surface"), body) << fill.err;
    const Ended run = Process(folder.path(), TILEMEND_CLIENT,
                              {"run", folder / "scene", "--out", folder / "out", "--overwrite", "-o", "json"})
                          .Wait();
    EXPECT_EQ(run.code, 100) << run.err << ": of the cell around the box nothing tells the height";
    EXPECT_EQ(
        absl::StrContains(ReadFile(folder / "out/report.json").value_or(""), "passes through itself or the surface"),
        body);
  }
}

TEST(CheckCommandTest, SaysWhatIsWrongUntilItIsMended) {
  const TemporaryFolder folder;
  const std::string in = folder.Write("in.off", Text(SheetWithAHole(), MeshFormat::kOff)), out = folder / "out.off";
  const auto tilemend = [&](const std::vector<std::string>& words) {
    return Process(folder.path(), TILEMEND_CLIENT, words).Wait();
  };
  const Ended before = tilemend({"check", in, "-o", "json"});
  EXPECT_EQ(before.code, 100) << before.err;
  const Json json = Json::parse(before.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << before.out;
  EXPECT_EQ(json["faults"], 1);
  EXPECT_EQ(json["holes"]["single"]["simple"], 1);
  EXPECT_EQ(json["holes"]["at"].size(), 1U);
  EXPECT_EQ(json["holes"]["at"][0].size(), 3U);
  EXPECT_EQ(json["outlines"], 1);
  EXPECT_EQ(json["defects"]["self_intersections"]["count"], 0);
  ASSERT_EQ(tilemend({"fill", in, "--out", out}).code, 0);
  const Ended after = tilemend({"check", out});
  EXPECT_EQ(after.code, 0) << after.out;
  EXPECT_THAT(after.out, HasSubstr("0  holes"));
  EXPECT_EQ(tilemend({"check", folder / "none.off"}).code, 3);
  EXPECT_EQ(tilemend({"check", in, "--crease-angle", "0"}).code, 2);
  folder.Write("cancelled/.tilemend-job", "");
  EXPECT_EQ(tilemend({"check", folder / "cancelled"}).code, 3);
  folder.Write("strange/report.json", R"({"cells": 3, "scene": 7, "options": 4})");
  EXPECT_EQ(tilemend({"check", folder / "strange"}).code, 3);
}

// Another process that writes the same file holds it with a lock on the file beside it.
TEST(FillCommandTest, TwoAtOnceDoNotWriteOneFile) {
  const TemporaryFolder folder;
  const std::string in = folder.Write("in.obj", Text(SheetWithAHole(), MeshFormat::kObj)), out = folder / "new/out.obj";
  const auto fill = [&] { return Process(folder.path(), TILEMEND_CLIENT, {"fill", in, "--out", out}).Wait(); };
  const std::string lock = folder.Write("new/.out.obj.tilemend-lock", "");
  const int held = ::open(lock.c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_GE(held, 0);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  const Ended refused = fill();
  EXPECT_EQ(refused.code, 5);
  EXPECT_THAT(refused.err, HasSubstr("another command is writing it"));
  EXPECT_FALSE(std::filesystem::exists(out));
  ::close(held);
  EXPECT_EQ(fill().code, 0);
  EXPECT_FALSE(std::filesystem::exists(lock));
}

TEST(FillCommandTest, NeverReplacesAPipe) {
  const TemporaryFolder folder;
  const std::string in = folder.Write("in.off", Text(SheetWithAHole(), MeshFormat::kOff)), out = folder / "out.off";
  ASSERT_EQ(::mkfifo(out.c_str(), 0600), 0);
  const Ended ended = Process(folder.path(), TILEMEND_CLIENT, {"fill", in, "--out", out, "--overwrite"}).Wait();
  EXPECT_EQ(ended.code, 4);
  EXPECT_THAT(ended.err, HasSubstr("is there and is no file"));
  EXPECT_TRUE(std::filesystem::is_fifo(out));
}

TEST(FillCommandTest, ExitCodes) {
  const TemporaryFolder folder;
  const std::string in = folder.Write("in.obj", Text(SheetWithAHole(), MeshFormat::kObj));
  const auto code = [&](const std::vector<std::string>& words) {
    return Process(folder.path(), TILEMEND_CLIENT, words).Wait().code;
  };
  std::filesystem::create_directory(folder / "folder.obj");
  EXPECT_EQ(code({"fill", in}), 2);
  EXPECT_EQ(code({"fill", in, "--out", folder / "o.obj", "--gradation", "0"}), 2);
  EXPECT_EQ(code({"fill", in, "--out", folder / "o.obj", "--surface", "wang", "--tension", "1"}), 2);
  EXPECT_EQ(code({"run", in, "--out", folder / "o", "--surface", "wang", "--tension", "1"}), 2);
  EXPECT_EQ(code({"fill", in, "--out", folder / "o.obj", "--surface", "wang", "--filler", "minimum-area"}), 2);
  EXPECT_EQ(code({"fill", folder / "none.obj", "--out", folder / "o.obj"}), 3);
  EXPECT_EQ(code({"fill", in, "--out", folder / "o.ply"}), 4);
  EXPECT_EQ(code({"fill", in, "--out", folder / "o"}), 4);
  EXPECT_EQ(code({"fill", in, "--out", folder / "folder.obj", "--overwrite"}), 4);
  EXPECT_EQ(code({"fill", in, "--out", in + "/o.obj"}), 4);
  EXPECT_EQ(code({"fill", in, "--out", folder / "o.obj", "--uniform", "--gradation", "2"}), 2);
  EXPECT_EQ(code({"fill", in, "--out", folder / "o.obj", "--filler", "svm-laplacian", "--size-limit", "2"}), 2);
  EXPECT_EQ(code({"fill", in, "--out", folder / "o.obj", "--filler", "minimum-area", "--allow-creases"}), 2);
  EXPECT_EQ(code({"fill", in, "--out", folder / "o.obj", "--water-profile", "usgs"}), 2) << "water is off";
  EXPECT_EQ(code({"run", in, "--out", folder / "o", "--front-steps", "printed"}), 2) << "auto has no front";
  EXPECT_EQ(code({"fill", folder.Write("empty.obj", ""), "--out", folder / "o.obj"}), 4);
  EXPECT_EQ(code({"fill", folder.Write("bad.obj", "v 0 0 0\nf -1 -2 -3\n"), "--out", folder / "o.obj"}), 4);
  EXPECT_EQ(code({"fill", in, "--out", "/proc/o.obj"}), 6);
  EXPECT_FALSE(std::filesystem::exists(folder / "o.obj"));
}

TEST(FillCommandTest, SaysThatThereIsNoSurface) {
  const TemporaryFolder folder;
  const std::string in = folder.Write("line.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  const auto end = Process(folder.path(), TILEMEND_CLIENT, {"fill", in, "--out", folder / "o.off"}).Wait();
  EXPECT_EQ(end.code, 0);
  EXPECT_THAT(end.err, testing::HasSubstr("none of its 1 triangles has an area"));
}

TEST(FillCommandTest, SaysWhoFilledAndWhatToDoWhereItCannotWrite) {
  const TemporaryFolder folder;
  const std::string in = folder.Write("in.obj", Text(SheetWithAHole(), MeshFormat::kObj));
  const auto fill = [&](const std::string& out) {
    return Process(folder.path(), TILEMEND_CLIENT, {"fill", in, "--out", out, "--filler", "advancing-front-normal"})
        .Wait();
  };
  EXPECT_THAT(fill(folder / "o.obj").out, testing::HasSubstr("filled by advancing-front-normal with"));
  EXPECT_THAT(fill("/proc/o.obj").err, testing::HasSubstr("choose another --out"));
  EXPECT_THAT(fill("/proc/x/o.obj").err, testing::HasSubstr("choose another --out"));
}

}  // namespace
}  // namespace tilemend
