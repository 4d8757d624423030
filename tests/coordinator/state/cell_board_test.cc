#include "coordinator/state/cell_board.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tilemend {
namespace {

char At(const CellBoard& board, CellId cell) { return board.Cells().At(cell); }

TEST(CellBoardTest, FollowsACellFromItsSurveyToItsTile) {
  CellBoard board;
  board.TaskAdded({0, 0}, Stage::kSurvey);
  EXPECT_EQ(At(board, {0, 0}), '.');
  board.TaskSettled({0, 0}, Stage::kSurvey, absl::OkStatus());
  board.TaskAdded({0, 0}, Stage::kGround);
  EXPECT_EQ(At(board, {0, 0}), 's');
  board.TaskAdded({1, 0}, Stage::kSampleCluster);
  EXPECT_EQ(At(board, {0, 0}), 'p');
  EXPECT_EQ(At(board, {1, 0}), '.');
  board.TaskAdded({0, 0}, Stage::kFill);
  EXPECT_EQ(At(board, {0, 0}), 'f');
  board.TaskSettled({0, 0}, Stage::kFill, absl::OkStatus());
  EXPECT_EQ(At(board, {0, 0}), 'F');
  board.TaskSettled({0, 0}, Stage::kAssemble, absl::OkStatus());
  EXPECT_EQ(At(board, {0, 0}), 'w');
}

TEST(CellBoardTest, AFailureIsKeptWithItsReasonAndIsFinal) {
  CellBoard board;
  board.TaskSettled({2, 3}, Stage::kFill, absl::InternalError("no memory"));
  board.TaskSettled({2, 3}, Stage::kAssemble, absl::OkStatus());
  EXPECT_EQ(At(board, {2, 3}), 'x');
  ASSERT_EQ(board.failures().size(), 1);
  EXPECT_EQ(board.failures()[0].stage, Stage::kFill);
  EXPECT_EQ(board.failures()[0].reason, "no memory");
}

TEST(CellBoardTest, KeepsABoundedNumberOfReasons) {
  CellBoard board;
  for (int32_t k = 0; k < 1000; ++k) board.TaskSettled({k, 0}, Stage::kSurvey, absl::InternalError("x"));
  EXPECT_EQ(board.failures().size(), kMostCellFailures);
  int cells = 0;
  board.Cells().ForEach([&](CellId, char) { ++cells; });
  EXPECT_EQ(cells, 1000);
}

TEST(CellBoardTest, DoesNotGoBack) {
  CellBoard board;
  board.TaskSettled({0, 0}, Stage::kAssemble, absl::OkStatus());
  board.TaskAdded({0, 0}, Stage::kFill);
  EXPECT_EQ(At(board, {0, 0}), 'w');
}

}  // namespace
}  // namespace tilemend
