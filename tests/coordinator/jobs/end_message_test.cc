#include "coordinator/jobs/end_message.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

class EndMessageTest : public testing::Test {
 protected:
  EndMessageTest() {
    plan_.holes.resize(2);
    plan_.holes[1].cell = {1, 0};
    for (PlannedHole& hole : plan_.holes) hole.area = 5;
    input_.plan = &plan_;
    input_.cells = 2;
    input_.outcome.sizes[0] = input_.outcome.sizes[1] = {};
  }
  std::string Message() { return EndMessage(spec_, input_, 0); }

  Plan plan_;
  SceneReportInput input_;
  JobSpec spec_;
};

TEST_F(EndMessageTest, OutlinesAreNotLeftOpen) {
  EXPECT_EQ(Message(), "2 of 2 holes filled");
  plan_.left = {{{0, 0}, "an outline", -1, 4, false}};
  EXPECT_EQ(Message(), "2 of 2 holes filled");
  plan_.left.push_back({{0, 0}, "no loop", -1, 3});
  EXPECT_EQ(Message(), "2 of 2 holes filled; the report lists what is left open");
}

TEST_F(EndMessageTest, CountsTheCellsThatWereChosen) {
  spec_.set_cells("0,0");
  input_.outcome.chosen = {CellId{0, 0}};
  input_.outcome.sizes.erase(1);
  plan_.holes[1].failure = "in another cell";
  plan_.left = {{{1, 0}, "in another cell", 1, 3}};
  EXPECT_EQ(Message(), "1 of 1 hole filled; 1 of 2 holes is in the 1 of 2 cells that was chosen");
  input_.outcome.chosen.insert({1, 0});
  EXPECT_EQ(Message(),
            "1 of 2 holes filled; the report lists what is left open; 2 of 2 holes are in the 2 of 2 cells that were "
            "chosen");
}

TEST_F(EndMessageTest, ADryRunSaysWhatIsToDo) {
  spec_.set_dry_run(true);
  plan_.holes.pop_back();
  EXPECT_EQ(Message(),
            "1 hole found, nothing written: 1 to fill (filling may find some that stay open), 0 that stay open");
}

TEST_F(EndMessageTest, TellsWhatWasTakenOver) {
  input_.tasks = 9;
  input_.taken_over = 4;
  input_.tiles = 3;
  input_.tiles_kept = 2;
  EXPECT_EQ(EndMessage(spec_, input_, 1),
            "2 of 2 holes filled; 2 of 3 tiles kept as they were; 4 of 9 results taken over, 1 of them without a task "
            "for a worker");
}

}  // namespace
}  // namespace tilemend
