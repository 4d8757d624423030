#include "worker/papers/front/front_loops.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace tilemend {
namespace {

std::vector<int32_t> LoopFrom(const FrontLoops& loops, int32_t node) {
  std::vector<int32_t> vertices;
  int32_t n = node;
  do {
    vertices.push_back(loops[n].vertex);
    EXPECT_EQ(loops[loops[n].after].before, n);
    n = loops[n].after;
  } while (n != node);
  return vertices;
}

class FrontLoopsTest : public testing::Test {
 protected:
  FrontLoops loops_{std::vector<std::vector<int32_t>>{{10, 11, 12, 13, 14, 15}, {20, 21, 22}}};
};

TEST_F(FrontLoopsTest, CutsOffANode) {
  loops_.CutOff(2);
  EXPECT_EQ(LoopFrom(loops_, 0), (std::vector<int32_t>{10, 11, 13, 14, 15}));
  EXPECT_FALSE(loops_[2].alive);
  EXPECT_EQ(loops_.Alive().size(), 8u);
}

TEST_F(FrontLoopsTest, ATriangleIsClosedByOneStep) {
  loops_.CutOff(7);
  const std::set<int32_t> alive(loops_.Alive().begin(), loops_.Alive().end());
  EXPECT_EQ(alive, (std::set<int32_t>{0, 1, 2, 3, 4, 5}));
}

TEST_F(FrontLoopsTest, InsertsBeforeANode) {
  const int32_t added = loops_.Insert(0, 30);
  EXPECT_EQ(LoopFrom(loops_, 0), (std::vector<int32_t>{10, 11, 12, 13, 14, 15, 30}));
  EXPECT_EQ(loops_.VertexAfter(added), 10);
  EXPECT_EQ(loops_.VertexBefore(added), 15);
}

TEST_F(FrontLoopsTest, JoiningWithinALoopPartsIt) {
  const int32_t added = loops_.Join(1, 4);  // the edge 10 -> 11 sees 14
  EXPECT_EQ(LoopFrom(loops_, 0), (std::vector<int32_t>{10, 14, 15}));
  EXPECT_EQ(LoopFrom(loops_, 1), (std::vector<int32_t>{11, 12, 13, 14}));
  EXPECT_EQ(loops_[added].vertex, 14);
}

TEST_F(FrontLoopsTest, JoiningTwoLoopsMakesOne) {
  loops_.Join(1, 7);
  EXPECT_EQ(LoopFrom(loops_, 0), (std::vector<int32_t>{10, 21, 22, 20, 21, 11, 12, 13, 14, 15}));
}

TEST_F(FrontLoopsTest, JoiningWithTheNextNodeCutsOff) {
  loops_.Join(1, 2);
  EXPECT_EQ(LoopFrom(loops_, 0), (std::vector<int32_t>{10, 12, 13, 14, 15}));
  EXPECT_EQ(loops_.Alive().size(), 8u);
}

}  // namespace
}  // namespace tilemend
