#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/codec/gltf/gltf_container.h"
#include "tests/common/codec/gltf/gltf_checks.h"
#include "tests/fuzz/gltf_property.h"

namespace tilemend {
namespace {

using testing::HasSubstr;

std::string Changed(std::string_view bytes, const GltfEdit& edit) {
  const absl::StatusOr<std::string> changed = ChangeGltf(bytes, GltfUpAxis::kY, edit, kGltfName);
  EXPECT_TRUE(changed.ok()) << changed.status();
  return changed.ok() ? *changed : "";
}

std::string ChangeRefusal(std::string_view bytes, const GltfEdit& edit) {
  return std::string(ChangeGltf(bytes, GltfUpAxis::kY, edit, kGltfName).status().message());
}

TEST(ChangeGltfTest, KeepsEverythingElseInEverySample) {
  for (const auto& [name, bytes] : GltfSampleFiles()) EXPECT_EQ(GltfPropertyViolation(bytes), "") << name;
}

TEST(ChangeGltfTest, AddsAPatchInTheFrameOfItsNode) {
  for (const auto& [name, bytes] : GltfSampleFiles()) {
    const GltfFile file = ReadGltfSample(bytes);
    GltfEdit edit;
    edit.patches = {GltfTriangle(file, 0)};
    edit.patches[0].points = {file.points[0], file.points[1], file.points[2]};  // on vertices that are there
    const GltfFile after = ReadGltfSample(Changed(bytes, edit));
    ASSERT_EQ(after.points.size(), file.points.size() + 3) << name;
    for (size_t i = 0; i < 3; ++i) EXPECT_EQ(after.points[file.points.size() + i], file.points[i]) << name;
    EXPECT_EQ(after.uv.back(), edit.patches[0].uv.back()) << name;
    EXPECT_EQ(after.nodes.size(), file.nodes.size() + 1) << name;
    EXPECT_EQ(after.images.back().name, "fill.png") << name;
    EXPECT_EQ(after.origin, file.origin) << name;
  }
}

TEST(ChangeGltfTest, WritesTheSameBytesEachTime) {
  const std::string bytes = MeshoptSample().Glb();
  const GltfEdit edit = SampleGltfEdit(ReadGltfSample(bytes));
  EXPECT_EQ(Changed(bytes, edit), Changed(bytes, edit));
}

TEST(ChangeGltfTest, KeepsExtrasAndTheBatchTable) {
  const std::string bytes = GltfSampleFiles().back().second;
  const std::string changed = Changed(bytes, SampleGltfEdit(ReadGltfSample(bytes)));
  const GltfContainer container = ParseGltfContainer(changed, "a").value();
  EXPECT_EQ(container.json["extras"].dump(), R"({"survey":[1,2.5,"three"]})");
  EXPECT_THAT(std::string(container.head), HasSubstr(R"({"name":["house"]})"));
  EXPECT_EQ(changed.size() % 8, 0u);
}

TEST(ChangeGltfTest, FollowsTheShadingOfTheNode) {
  GltfSample sample = SquareSample();
  sample.json["materials"][0]["doubleSided"] = true;
  sample.json["materials"][0]["extensions"]["KHR_materials_unlit"] = OrderedJson::object();
  const std::string bytes = sample.Glb();
  GltfEdit edit;
  edit.patches = {GltfTriangle(ReadGltfSample(bytes), 0)};
  const std::string changed = Changed(bytes, edit);
  const OrderedJson json = ParseGltfContainer(changed, "a")->json;
  EXPECT_TRUE(json["materials"][1]["doubleSided"]);
  EXPECT_TRUE(json["materials"][1]["extensions"].contains("KHR_materials_unlit"));
  EXPECT_EQ(json["extensionsUsed"].dump(), R"(["KHR_materials_unlit"])");
}

TEST(ChangeGltfTest, NewNodesHaveTheHighestNumbers) {
  GltfSample sample = SquareSample();
  sample.json["nodes"] = OrderedJson::parse(R"([{"mesh": 0}, {"children": [0]}, {"mesh": 0}])");
  sample.json["scenes"][0]["nodes"] = OrderedJson::parse("[1, 2]");
  const std::string bytes = sample.Glb();
  GltfEdit edit;
  edit.patches = {GltfTriangle(ReadGltfSample(bytes), 0)};
  const GltfFile after = ReadGltfSample(Changed(bytes, edit));
  ASSERT_EQ(after.nodes.size(), 3u) << "beside the node of the patch, not at the end";
  EXPECT_EQ(after.nodes[0].number, 0);
  EXPECT_EQ(after.nodes[1].number, 3);
  EXPECT_EQ(after.nodes[2].number, 2);
  EXPECT_EQ(after.primitives.at(1).triangle_count, 1);
}

TEST(ChangeGltfTest, TakesOutWholeMeshes) {
  const std::string bytes = SquareSample().Glb();
  const GltfFile file = ReadGltfSample(bytes);
  GltfEdit edit;
  edit.drop = {true, true};
  edit.patches = {GltfTriangle(file, 0)};
  const GltfFile after = ReadGltfSample(Changed(bytes, edit));
  EXPECT_EQ(after.triangles.size(), 1u);
  EXPECT_EQ(after.nodes.size(), 1u);
}

TEST(ChangeGltfTest, TakesOutOnePrimitiveOfTwo) {
  GltfSample sample = SquareSample();
  auto& primitives = sample.json["meshes"][0]["primitives"];
  primitives.push_back(OrderedJson(primitives[0]));
  GltfEdit edit;
  edit.drop = {true, true, false, true};
  const GltfFile after = ReadGltfSample(Changed(sample.Glb(), edit));
  ASSERT_EQ(after.primitives.size(), 1u);
  EXPECT_EQ(after.primitives[0].triangle_count, 1);
}

TEST(ChangeGltfTest, WritesDracoPlainly) {
  const std::string bytes = DracoSample(true).Glb();
  const GltfFile file = ReadGltfSample(bytes);
  GltfEdit edit;
  edit.drop.resize(file.triangles.size());
  edit.drop[5] = true;
  const GltfFile after = ReadGltfSample(Changed(bytes, edit));
  EXPECT_FALSE(after.primitives[0].is_draco);
  EXPECT_EQ(after.points, file.points);
  EXPECT_EQ(after.uv, file.uv);
  EXPECT_EQ(after.triangles.size(), file.triangles.size() - 1);
}

TEST(ChangeGltfTest, KeepsDracoAsItIsWhenOnlyAPatchIsAdded) {
  const std::string bytes = DracoSample(true).Glb();
  GltfEdit edit;
  edit.patches = {GltfTriangle(ReadGltfSample(bytes), 0)};
  EXPECT_TRUE(ReadGltfSample(Changed(bytes, edit)).primitives[0].is_draco);
}

TEST(ChangeGltfTest, RefusesInstancesThatLoseDifferentTriangles) {
  GltfSample sample = SquareSample();
  sample.json["nodes"].push_back({{"mesh", 0}});
  sample.json["scenes"][0]["nodes"] = {0, 2};
  GltfEdit edit;
  edit.drop = {true, false, false, false};
  EXPECT_THAT(ChangeRefusal(sample.Glb(), edit), HasSubstr("two nodes share mesh 0"));
  edit.drop = {true, false, true, false};
  EXPECT_EQ(ReadGltfSample(Changed(sample.Glb(), edit)).triangles.size(), 2u);
}

TEST(ChangeGltfTest, RefusesPatchesThatDoNotFit) {
  const std::string bytes = SquareSample().Glb();
  const GltfPatch good = GltfTriangle(ReadGltfSample(bytes), 0);
  const auto refusal = [&](const auto& change) {
    GltfEdit edit;
    edit.patches = {good};
    change(edit.patches[0]);
    return ChangeRefusal(bytes, edit);
  };
  EXPECT_THAT(refusal([](GltfPatch& patch) { patch.node = 1; }), HasSubstr("a node that the file does not have"));
  EXPECT_THAT(refusal([](GltfPatch& patch) { patch.triangles.clear(); }), HasSubstr("is empty"));
  EXPECT_THAT(refusal([](GltfPatch& patch) { patch.uv.pop_back(); }), HasSubstr("texture coordinates"));
  EXPECT_THAT(refusal([](GltfPatch& patch) { patch.triangles[0][1] = 3; }), HasSubstr("without such a point"));
  EXPECT_THAT(refusal([](GltfPatch& patch) { patch.points[0][0] = 1e200; }), HasSubstr("no finite float32"));
  GltfEdit edit;
  edit.drop = {true};
  EXPECT_THAT(ChangeRefusal(bytes, edit), HasSubstr("1 entries for 2 triangles"));
}

TEST(ChangeGltfTest, RefusesNodesThatFlatten) {
  GltfSample sample = SquareSample();
  sample.json["nodes"][0]["scale"] = {2, 0, 2};
  GltfEdit edit;
  edit.patches = {GltfTriangle(ReadGltfSample(sample.Glb()), 0)};
  EXPECT_THAT(ChangeRefusal(sample.Glb(), edit), HasSubstr("cannot be inverted"));
}

}  // namespace
}  // namespace tilemend
