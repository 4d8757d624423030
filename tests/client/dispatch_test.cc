// What Dispatch does around a command.
#include <gtest/gtest.h>

#include <new>

#include "client/commands.h"
#include "common/util/exit_codes.h"

namespace tilemend {
namespace {

TEST(DispatchTest, WantOfMemoryIsAnErrorThatMayPass) {
  Command command;
  command.name = "fill";
  command.run = [](const Args&) -> int { throw std::bad_alloc(); };
  testing::internal::CaptureStderr();
  EXPECT_EQ(Dispatch({command}, {"fill"}), kExitRetryable);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("fill: out of memory"), std::string::npos);
}

}  // namespace
}  // namespace tilemend
