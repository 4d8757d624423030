// What Dispatch does around a command.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <string>

#include "client/commands.h"
#include "common/util/exit_codes.h"
#include "tests/support/temporary_folder.h"

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

TEST(DispatchTest, HelpShowsOptionsOfPapersOnlyIfAsked) {
  const auto help = [](const std::vector<std::string>& words) {
    testing::internal::CaptureStdout();
    EXPECT_EQ(Dispatch(ServiceCommands(), words), kExitDone);
    return testing::internal::GetCapturedStdout();
  };
  const std::string some = help({"run", "--help"}), all = help({"run", "--help-all"});
  EXPECT_EQ(some, help({"help", "run"}));
  EXPECT_EQ(some.find("--closure"), std::string::npos);
  EXPECT_NE(all.find("--closure"), std::string::npos);
  EXPECT_NE(some.find("  tilemend run scene --out out\n"), std::string::npos);
}

TEST(DispatchTest, HelpHasAtMostTenEverydayFlagsAndTwoExamples) {
  for (const Command& command : ServiceCommands()) {
    const auto everyday = std::ranges::count(command.flags, FlagGroup::kEveryday, &FlagSpec::group);
    EXPECT_LE(everyday, 10) << command.name;
    EXPECT_EQ(command.examples.size(), 2U) << command.name;
  }
}

// As under sudo -u, with the folder of who was there before.
TEST(DispatchDeathTest, GoesOnWithoutSettingsOfAnotherUser) {
  if (::geteuid() != 0) GTEST_SKIP() << "root alone can become another user";
  const TemporaryFolder folder;
  folder.Write("tilemend.conf", "no settings at all");
  std::filesystem::permissions(folder / "tilemend.conf", std::filesystem::perms::owner_read);
  const auto as_another = [&](const char* variable, const std::string& value) {
    Command command;
    command.name = "get";
    command.run = [](const Args&) -> int { return kExitDone; };
    ::setenv(variable, value.c_str(), 1);
    constexpr uid_t kNobody = 65534;
    if (::setuid(kNobody) != 0) std::abort();
    std::exit(Dispatch({command}, {"get"}));
  };
  EXPECT_EXIT(as_another("XDG_CONFIG_HOME", folder.path()), testing::ExitedWithCode(kExitDone),
              "warning: .*tilemend.conf.*; its settings are not used");
  EXPECT_EXIT(as_another("TILEMEND_CONFIG", folder / "tilemend.conf"), testing::ExitedWithCode(kExitUsage),
              "tilemend.conf: cannot open");
}

}  // namespace
}  // namespace tilemend
