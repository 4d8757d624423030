#include "coordinator/jobs/assemble_check.h"

#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <string>

#include "common/options/job_options.h"
#include "common/store/digest.h"
#include "common/util/files.h"
#include "common/util/tile_files.h"
#include "coordinator/jobs/scene_pipeline.h"
#include "tests/support/image_builders.h"
#include "tests/support/osgb_scene.h"
#include "tests/support/output_checks.h"
#include "tests/support/temporary_folder.h"
#include "worker/service/scene_stages.h"

namespace tilemend {
namespace {

// A scene of two trees of OSGB files with a hole over their border; a sound worker writes them.
class AssembleCheckTest : public ::testing::Test {
 protected:
  using See = std::function<void(const v1::AssembleInput&, const v1::AssembleOutput&)>;

  void Run(const See& see, const OsgbScene& scene = OsgbScene()) {
    for (const auto& [path, bytes] : scene.Files()) folder_.Write("scene/" + path, bytes);
    const std::string left = OsgbScene::TileName(0), right = OsgbScene::TileName(1);
    folder_.Write("scene/scene.json", R"({"origin": [0, 0, 0], "cell_size": 64, "cols": 2, "rows": 1, "tiles": [
        {"col": 0, "row": 0, "path": "Data/)" +
                                          left + "/" + left + R"(.osgb"},
        {"col": 1, "row": 0, "path": "Data/)" +
                                          right + "/" + right + R"(.osgb"}]})");
    JobSpec spec = WithDefaults({});
    spec.set_scene(folder_ / "scene");
    spec.set_out(folder_ / "out");
    auto pipeline = ScenePipelineFactory()(spec, {});
    ASSERT_TRUE(pipeline.ok()) << pipeline.status();
    auto tasks = (*pipeline)->Start();
    ASSERT_TRUE(tasks.ok()) << tasks.status();
    std::deque<NewTask> open(tasks->begin(), tasks->end());
    while (!open.empty()) {
      const NewTask task = open.front();
      open.pop_front();
      auto output = SceneStageRunner()(task.stage, WholeInput(task).value(), CancelToken());
      ASSERT_TRUE(output.ok()) << output.status();
      if (task.stage == Stage::kAssemble) See1(task.input, *output, see);
      tasks = (*pipeline)->OnTaskDone({task.cell, task.stage, *std::move(output)});
      ASSERT_TRUE(tasks.ok()) << tasks.status();
      open.insert(open.end(), tasks->begin(), tasks->end());
    }
  }

  static absl::Status Check(TileCheck how, const v1::AssembleInput& input, const v1::AssembleOutput& output) {
    TileReading reading(how);
    return CheckAssembleResult(input.SerializeAsString(), output, reading);
  }

  const TemporaryFolder folder_;

 private:
  static void See1(const std::string& input_bytes, const std::string& output_bytes, const See& see) {
    v1::AssembleInput input;
    v1::AssembleOutput output;
    ASSERT_TRUE(input.ParseFromString(input_bytes) && output.ParseFromString(output_bytes));
    see(input, output);
  }
};

constexpr TileCheck kAll[] = {TileCheck::kSize, TileCheck::kContent};

TEST_F(AssembleCheckTest, TakesATreeOfASoundWorker) {
  int seen = 0;
  Run([&](const v1::AssembleInput& input, const v1::AssembleOutput& output) {
    ++seen;
    EXPECT_EQ(output.files_size(), 6) << "the tile and its finer files";
    for (const TileCheck how : kAll) EXPECT_TRUE(Check(how, input, output).ok()) << Check(how, input, output);
  });
  EXPECT_EQ(seen, 2);
}

TEST_F(AssembleCheckTest, AChangedFileOfATreeIsSeen) {
  int seen = 0;
  Run([&](const v1::AssembleInput& input, const v1::AssembleOutput& output) {
    for (int f = 0; f < output.files_size(); ++f) {
      v1::AssembleOutput lie = output;
      v1::WrittenFile& file = *lie.mutable_files(f);
      const std::string path = input.attempts() + "/" + file.attempt(), sound = *ReadFile(path);
      std::string other = sound;
      other.back() = static_cast<char>(other.back() ^ 1);
      ASSERT_TRUE(WriteFileAtomically(path, other).ok());
      EXPECT_FALSE(Check(TileCheck::kContent, input, lie).ok()) << file.path();
      file.set_digest(FileDigest(other));
      EXPECT_TRUE(absl::IsDataLoss(Check(TileCheck::kContent, input, lie))) << file.path();
      ASSERT_TRUE(WriteFileAtomically(path, sound).ok());
      ++seen;
    }
  });
  EXPECT_EQ(seen, 12);
}

// An image of its own lies in each file with new geometry.
TEST_F(AssembleCheckTest, TakesATexturedTree) {
  int seen = 0;
  const auto colour = [](int32_t x, int32_t y) {
    return Rgb{static_cast<uint8_t>(9 * x), 120, static_cast<uint8_t>(9 * y)};
  };
  Run(
      [&](const v1::AssembleInput& input, const v1::AssembleOutput& output) {
        ++seen;
        EXPECT_FALSE(input.texture().empty());
        for (const TileCheck how : kAll) EXPECT_TRUE(Check(how, input, output).ok()) << Check(how, input, output);
        const std::string path = input.attempts() + "/" + output.files(0).attempt(), sound = *ReadFile(path);
        const size_t name = sound.find("_tilemend.jpg");
        ASSERT_NE(name, std::string::npos) << "a painted fill";
        std::string other = sound;
        other[name] = '-';
        ASSERT_TRUE(WriteFileAtomically(path, other).ok());
        EXPECT_TRUE(absl::IsDataLoss(Check(TileCheck::kContent, input, output)));
        ASSERT_TRUE(WriteFileAtomically(path, sound).ok());
      },
      OsgbScene(OsgbScene::Pond::kHole, 80, JpegImage(16, 16, colour)));
  EXPECT_EQ(seen, 2);
}

TEST_F(AssembleCheckTest, AFileThatIsMissingOrTooMuchIsSeen) {
  Run([&](const v1::AssembleInput& input, const v1::AssembleOutput& output) {
    v1::AssembleOutput fewer = output;
    fewer.mutable_files()->RemoveLast();
    v1::AssembleOutput elsewhere = output;
    elsewhere.mutable_files(1)->set_path("Data/Tile_+005_+000/Tile_+005_+000.osgb");
    for (const TileCheck how : kAll) {
      EXPECT_TRUE(absl::IsDataLoss(Check(how, input, fewer)));
      EXPECT_TRUE(absl::IsDataLoss(Check(how, input, elsewhere)));
    }
  });
}

}  // namespace
}  // namespace tilemend
