#include "worker/materials/survey_look.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/image_builders.h"
#include "tests/support/osgb_scene.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(SurveyWithLookTest, SeesTheTexelsOfAnObj) {
  const TemporaryFolder folder;
  folder.Write("T.mtl", "newmtl a\nmap_Kd T.jpg\n");
  folder.Write("T.jpg", PngImage(4, 4, [](int32_t, int32_t) { return Rgb{9, 8, 7}; }));
  const auto survey =
      SurveyWithLook(folder.path(), "T.obj", "mtllib T.mtl\n" + kSquare + "vt 0.5 0.5\nusemtl a\nf 1/1 2/1 3/1 4/1\n",
                     MeshFormat::kObj);
  ASSERT_TRUE(survey.ok()) << survey.status();
  EXPECT_THAT(survey->record.edges, SizeIs(4));
  EXPECT_THAT(survey->record.colours, testing::AllOf(SizeIs(4), Each(Rgb{9, 8, 7})));
  EXPECT_THAT(survey->files.libraries, ElementsAre("T.mtl"));
  EXPECT_THAT(survey->files.images, ElementsAre("T.jpg"));
}

TEST(SurveyWithLookTest, SeesTheColoursOfAPly) {
  const FilePatch square = {
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {-1, -1, -1}, {{0, 1, 2}}, {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}}};
  const auto survey = SurveyWithLook("/nowhere", "T.ply", NewPlyFile(square, NumberType::kFloat32), MeshFormat::kPly);
  ASSERT_TRUE(survey.ok()) << survey.status();
  EXPECT_THAT(survey->record.colours, ElementsAre(Rgb{1, 1, 1}, Rgb{2, 2, 2}, Rgb{3, 3, 3}));
}

TEST(SurveyWithLookTest, SeesTheColoursOfTheVerticesOfAnObj) {
  const std::string text = "v 0 0 0 0.2 0.6 0.4\nv 1 0 0 0.2 0.6 0.4\nv 0 1 0 0 0 1\nf 1 2 3\n";
  const auto survey = SurveyWithLook("/nowhere", "T.obj", text, MeshFormat::kObj);
  ASSERT_TRUE(survey.ok()) << survey.status();
  EXPECT_THAT(survey->record.colours, ElementsAre(Rgb{51, 153, 102}, Rgb{51, 153, 102}, Rgb{0, 0, 255}));
}

TEST(SurveyWithLookTest, SeesTheColoursOfTheFacesOfAPly) {
  const auto survey = SurveyWithLook(
      "/nowhere", "T.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 1 2 3\n3 0 2 3 4 5 6\n",
      MeshFormat::kPly);
  ASSERT_TRUE(survey.ok()) << survey.status();
  EXPECT_THAT(survey->record.colours, ElementsAre(Rgb{1, 2, 3}, Rgb{1, 2, 3}, Rgb{4, 5, 6}, Rgb{4, 5, 6}))
      << "of the face at the edge that begins there";
}

TEST(SurveyWithLookTest, APlainMeshHasNeither) {
  for (const auto& [text, format] :
       {std::pair{kSquare + "f 1 2 3 4\n", MeshFormat::kObj},
        std::pair{std::string("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), MeshFormat::kOff}}) {
    const auto survey = SurveyWithLook("/nowhere", "T", text, format);
    ASSERT_TRUE(survey.ok()) << survey.status();
    EXPECT_FALSE(survey->record.edges.empty());
    EXPECT_THAT(survey->record.colours, IsEmpty());
    EXPECT_THAT(survey->files.warnings, IsEmpty());
  }
}

TEST(SurveyWithLookTest, DamagedMeshesAreErrorsThatNameTheFile) {
  const auto survey = SurveyWithLook("/scene", "T.obj", "mtllib a.mtl\nv 0 0\n", MeshFormat::kObj);
  EXPECT_EQ(survey.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(survey.status().message()), testing::StartsWith("/scene/T.obj: line 2"));
}

TEST(ParseWithWarningsTest, TellsOfFilesThatAreMissingWithoutLookingAtColours) {
  const std::string text = "mtllib none.mtl\n" + kSquare + "f 1 2 3 4\n";
  const auto obj = ParseWithWarnings("/nowhere", "T.obj", text, MeshFormat::kObj);
  ASSERT_TRUE(obj.ok()) << obj.status();
  EXPECT_THAT(obj->file.mesh.triangles, SizeIs(2));
  EXPECT_EQ(obj->warnings, SurveyWithLook("/nowhere", "T.obj", text, MeshFormat::kObj)->files.warnings);
  EXPECT_THAT(obj->warnings, ElementsAre(testing::HasSubstr("none.mtl")));
  const std::string pack = OsgbScene().Pack(0, "_L2_3.osgb");
  const auto tree = ParseWithWarnings("/nowhere", "T.osgb", pack, MeshFormat::kTileTree);
  ASSERT_TRUE(tree.ok()) << tree.status();
  EXPECT_EQ(tree->file.mesh.triangles, ParseMesh(MeshFormat::kTileTree, pack, "T.osgb")->mesh.triangles);
  EXPECT_THAT(tree->warnings, ElementsAre(testing::HasSubstr("a file that this tile names is missing")));
}

}  // namespace
}  // namespace tilemend
