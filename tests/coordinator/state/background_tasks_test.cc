#include "coordinator/state/task_choice.h"
#include "tests/coordinator/state/state_fixture.h"

namespace tilemend {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// Tasks that verify what others wrote.
class BackgroundTasksTest : public StateTest {
 protected:
  void AddVerification(const std::vector<std::string>& avoid) {
    Do(TasksAdded{"a", {{{9, 9}, Stage::kVerify, "files", {}, {}, avoid}}});
  }
};

TEST_F(BackgroundTasksTest, ComeAfterAllOthersOfTheJob) {
  See("w", 1);
  AddJob("a", 0);
  AddVerification({});
  AddTasks("a", 1);
  EXPECT_THAT(Choose("w"), ElementsAre(Key("a", 2)));
  Complete(Key("a", 2), "w", Lease(Key("a", 2), "w"));
  EXPECT_THAT(Choose("w"), ElementsAre(Key("a", 1)));
  Complete(Key("a", 1), "w", Lease(Key("a", 1), "w"));
  EXPECT_EQ(Counts("a").pending, 0);
}

TEST_F(BackgroundTasksTest, GoBackToTheirPlace) {
  See("w", 1);
  AddJob("a", 0);
  AddVerification({});
  const uint64_t token = Lease(Key("a", 1), "w");
  Return(Key("a", 1), "w", token);
  now_ += absl::Minutes(1);
  See("w", 1);
  AddTasks("a", 1);
  EXPECT_THAT(Choose("w"), ElementsAre(Key("a", 2)));
}

TEST_F(BackgroundTasksTest, AreForAnotherThanTheOneThatWroteIfThereIsOne) {
  See("writer", 1);
  AddJob("a", 0);
  AddVerification({"writer"});
  EXPECT_THAT(Choose("writer"), ElementsAre(Key("a", 1))) << "nobody else is there";
  See("other", 1);
  EXPECT_THAT(Choose("writer"), IsEmpty());
  EXPECT_THAT(Choose("other"), ElementsAre(Key("a", 1)));
}

TEST_F(BackgroundTasksTest, ADrainingWorkerIsNoOther) {
  AddJob("a", 0);
  See("w", 1);
  See("leaving", 1, true);
  EXPECT_FALSE(HasOtherWorker(state_, "w", "a", MayAlways));
  See("staying", 1);
  EXPECT_TRUE(HasOtherWorker(state_, "w", "a", MayAlways));
  EXPECT_FALSE(HasOtherWorker(state_, "w", "a", [](const auto&, const auto&) { return false; }));
}

}  // namespace
}  // namespace tilemend
