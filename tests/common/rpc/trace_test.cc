#include "common/rpc/trace.h"

#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

TEST(TraceTest, SurvivesTheTripInACall) {
  const std::string trace = NewTrace();
  EXPECT_EQ(trace.size(), 32U);
  EXPECT_NE(trace, NewTrace());
  EXPECT_EQ(TraceOf(TraceParent(trace)), trace);
}

TEST(TraceTest, IsReadFromWhatOthersWrite) {
  EXPECT_EQ(TraceOf("00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01"), "4bf92f3577b34da6a3ce929d0e0e4736");
}

TEST(TraceTest, IsNotTakenFromWhatIsNone) {
  for (const char* text : {"", "00-", "00-4bf92f3577b34da6a3ce929d0e0e4736", "01-4bf92f3577b34da6a3ce929d0e0e4736-x",
                           "00-4BF92F3577B34DA6A3CE929D0E0E4736-00f067aa0ba902b7-01",
                           "00-00000000000000000000000000000000-00f067aa0ba902b7-01",
                           "00-4bf92f3577b34da6a3ce929d0e0e\n736-00f067aa0ba902b7-01"}) {
    EXPECT_EQ(TraceOf(text), "") << text;
  }
}

}  // namespace
}  // namespace tilemend
