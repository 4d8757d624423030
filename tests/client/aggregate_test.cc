#include "client/aggregate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/codec/mesh_file.h"
#include "common/util/files.h"
#include "tests/support/mesh_builders.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

class AggregateTest : public testing::Test {
 protected:
  // Two cells of `size` squares; a hole of two by two lies across the line between them.
  Scene TwoCells(int32_t size) {
    Scene scene;
    scene.root = folder_ / "";
    scene.cols = 2;
    scene.rows = 1;
    scene.grid.cell_size = Point2(size, size);
    const int32_t middle = size / 2;
    for (int32_t cell = 0; cell < 2; ++cell) {
      const auto keep = [&](int32_t i, int32_t j) { return i < size - 1 || i > size || j < middle || j > middle + 1; };
      const TriMesh mesh = SquaresMesh(cell * size, (cell + 1) * size, 0, size, keep);
      FilePatch file;
      file.new_points = mesh.points;
      file.like.assign(mesh.points.size(), -1);
      file.triangles = mesh.triangles;
      const std::string name = cell == 0 ? "a.ply" : "b.ply";
      EXPECT_TRUE(WriteFileAtomically(folder_ / name, NewPlyFile(file, NumberType::kFloat32)).ok());
      scene.tiles.push_back({{cell, 0}, name});
    }
    return scene;
  }

  const TemporaryFolder folder_;
  AggregateOptions options_{folder_ / "joined.ply"};
};

TEST_F(AggregateTest, OpenHolesBecomeOneClosedHole) {
  auto filled = AggregateAndFill(TwoCells(8), options_);
  ASSERT_TRUE(filled.ok()) << filled.status();
  ASSERT_EQ(filled->report.plan->holes.size(), 1u);
  EXPECT_TRUE(filled->report.outcome.failures.empty());
  const auto joined = ReadMeshFile(options_.joined);
  ASSERT_TRUE(joined.ok());
  EXPECT_EQ(joined->mesh.triangles.size(), 2u * (2 * 8 * 8 - 4));
  const auto mesh = ParseMesh(MeshFormat::kPly, filled->bytes, "filled");
  ASSERT_TRUE(mesh.ok());
  EXPECT_GT(mesh->mesh.triangles.size(), joined->mesh.triangles.size());
}

TEST_F(AggregateTest, TellsHowFarItIs) {
  std::vector<std::string> told;
  options_.watcher = [&](std::string_view step, size_t done, size_t all, std::string_view unit) {
    told.push_back(absl::StrCat(std::string(step), " ", done, "/", all, " ", std::string(unit)));
  };
  ASSERT_TRUE(AggregateAndFill(TwoCells(8), options_).ok());
  ASSERT_GE(told.size(), 4u);
  EXPECT_EQ(told[0], "join the tiles 0/2 tile");
  EXPECT_EQ(told[1], "join the tiles 1/2 tile");
  EXPECT_EQ(told.back(), "fill 1/1 hole");
}

TEST_F(AggregateTest, MarksWhatItFillsAlone) {
  auto filled = AggregateAndFill(TwoCells(8), options_);
  ASSERT_TRUE(filled.ok()) << filled.status();
  const std::string joined = ReadFile(options_.joined).value();
  EXPECT_EQ(joined.find("tilemend_filled"), std::string::npos);
  EXPECT_NE(filled->bytes.find("tilemend_filled"), std::string::npos);
}

TEST_F(AggregateTest, LeavesALoopThatIsTooLong) {
  options_.longest_loop = 7;
  const auto filled = AggregateAndFill(TwoCells(8), options_);
  ASSERT_TRUE(filled.ok()) << filled.status();
  EXPECT_EQ(filled->report.outcome.failures.size(), 1u);
}

TEST_F(AggregateTest, SaysHowFarItCameWithTheMemoryThatItMayTake) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer takes more address space than any limit";
#endif
  const Scene scene = TwoCells(400);
  options_.memory_bytes = 1 << 20;
  const auto fill = [&] {
    const absl::Status status = AggregateAndFill(scene, options_).status();
    const bool told = absl::IsResourceExhausted(status) && status.message().find("tiles joined") != std::string::npos;
    std::_Exit(told ? 0 : 1);
  };
  EXPECT_EXIT(fill(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace tilemend
