#include "worker/service/task_memory.h"

#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <string>
#include <thread>

#include "common/util/cores.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

TEST(HeldMemoryTest, AnotherHasTheCoreWhileItWaits) {
  MemoryBudget budget(10);
  Cores cores(1);
  auto first = std::make_unique<MemoryBudget::Share>(budget, 7);
  std::promise<void> has_core;
  std::thread second([&] {
    const Cores::Held core(cores);
    has_core.set_value();
    const HeldMemory held(budget, 4);
  });
  has_core.get_future().wait();
  { const Cores::Held core(cores); }  // else this would wait for ever
  first.reset();
  second.join();
}

TEST(HeldMemoryTest, IsGivenBack) {
  MemoryBudget budget(100 * kMegabyte);
  { const HeldMemory large(budget, 90 * kMegabyte); }
  const HeldMemory again(budget, 90 * kMegabyte);
}

TEST(TaskMemoryTest, TasksAndSurfacesHaveTheirOwn) {
  TaskMemory memory(100);
  const HeldMemory task(memory.tasks, 75), surface(memory.surfaces, 25);
}

TEST(TileMemoryTest, GrowsWithTheFile) {
  const TemporaryFolder folder;
  folder.Write("a.ply", std::string(1000, 'a'));
  folder.Write("b.ply", std::string(3000, 'b'));
  EXPECT_GE(SurveyMemory(folder / "a.ply"), 1000);
  EXPECT_EQ(SurveyMemory(folder / "b.ply"), 3 * SurveyMemory(folder / "a.ply"));
  EXPECT_EQ(SurfaceMemory(folder / "b.ply"), 3 * SurfaceMemory(folder / "a.ply"));
  EXPECT_EQ(SurveyMemory(folder / "none.ply"), 0);
}

TEST(AssembleMemoryTest, IsOfTheTileAndItsPatches) {
  const TemporaryFolder folder;
  folder.Write("a.ply", std::string(1000, 'a'));
  v1::AssembleInput input;
  input.mutable_tile()->set_root(folder.path());
  input.mutable_tile()->set_path("a.ply");
  EXPECT_EQ(AssembleMemory(input), 0);  // a copy
  input.mutable_patches()->add_patches()->set_triangles(10);
  const int64_t with_tile = AssembleMemory(input);
  EXPECT_GE(with_tile, 2000);
  input.mutable_tile()->clear_path();  // a cell without surface
  EXPECT_LE(AssembleMemory(input), with_tile - 2000);
  EXPECT_GT(AssembleMemory(input), 0);
}

}  // namespace
}  // namespace tilemend
