#include "client/mesh/mesh_filler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "client/mesh/array_mesh.h"
#include "client/mesh/mesh_options.h"
#include "common/util/files.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

using ::testing::ElementsAreArray;

// The sides of a cube from 0 to 1 without the upper one.
const std::vector<double> kBox = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};
const std::vector<int32_t> kOpenBox = {0, 2, 1, 0, 3, 2, 0, 1, 5, 0, 5, 4, 1, 2, 6,
                                       1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};

MeshFillOptions Defaults() {
  auto spec = SpecFromTexts({{"water", kMeshWater}}, kOfFill);
  return MeshOptionsOf(*spec).value();
}

TEST(MeshFillerTest, ArraysGetWhatAFileGets) {
  auto arrays = ArrayMesh::Make(std::span(kBox), std::span(kOpenBox));
  const MeshView view = arrays->Mesh()->view;
  FilePatch patch;
  patch.new_points.assign(view.points.begin(), view.points.end());
  patch.triangles.assign(view.triangles.begin(), view.triangles.end());
  patch.like.assign(patch.new_points.size(), -1);
  const TemporaryFolder folder;
  const std::string path = folder / "box.ply";
  ASSERT_TRUE(WriteFileAtomically(path, NewPlyFile(patch, NumberType::kFloat64, FaceMark::kNone)).ok());
  const auto of_file = FillMesh(path, Defaults());
  ASSERT_TRUE(of_file.ok()) << of_file.status();
  const auto of_arrays = FillMesh(*arrays, Defaults());
  ASSERT_TRUE(of_arrays.ok()) << of_arrays.status();
  const MeshFile file = ParseMesh(MeshFormat::kPly, of_file->bytes, "filled").value();
  const FilledArrays filled = arrays->Filled();
  const MeshView all(PointRows(std::get<std::vector<double>>(filled.vertices)),
                     TriangleRows(std::span<const int32_t>(filled.faces)));
  EXPECT_THAT(file.mesh.points, ElementsAreArray(all.points.begin(), all.points.end()));
  EXPECT_THAT(file.mesh.triangles, ElementsAreArray(all.triangles.begin(), all.triangles.end()));
  EXPECT_EQ(filled.originals, 10);
  EXPECT_EQ(of_arrays->report.plan->holes.size(), 1);
  EXPECT_TRUE(of_arrays->report.outcome.failures.empty());
}

TEST(MeshFillerTest, CancelledWorkLeavesTheMeshWithoutPatches) {
  auto arrays = ArrayMesh::Make(std::span(kBox), std::span(kOpenBox));
  MeshFillOptions options = Defaults();
  bool is_filling = false;
  options.show = [&](std::string_view step, size_t, size_t) { is_filling = is_filling || step == "fill"; };
  options.fill.refine.is_cancelled = [&] { return is_filling; };
  EXPECT_TRUE(absl::IsCancelled(FillMesh(*arrays, options).status()));
  EXPECT_EQ(arrays->Filled().faces, kOpenBox);
  EXPECT_TRUE(is_filling);
}

}  // namespace
}  // namespace tilemend
