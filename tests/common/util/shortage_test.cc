#include "common/util/shortage.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>

#include "absl/strings/str_cat.h"
#include "common/util/exit_codes.h"
#include "common/util/files.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

template <class Thrown>
void ThrowInThread(const Thrown& thrown) {
  EndOnShortage();
  std::thread([&thrown] { throw thrown; }).join();
}

TEST(ShortageDeathTest, EndsWhereNoThreadCanBeMade) {
  const std::system_error error(std::make_error_code(std::errc::resource_unavailable_try_again));
  EXPECT_EXIT(ThrowInThread(error), testing::ExitedWithCode(kExitRetryable),
              "cannot go on: Resource temporarily unavailable; memory or threads are short");
}

TEST(ShortageDeathTest, EndsWhereThereIsNoMemory) {
  EXPECT_EXIT(ThrowInThread(std::bad_alloc()), testing::ExitedWithCode(kExitRetryable), "cannot go on: out of memory");
}

// Ends with whether it can be written.
[[noreturn]] void WriteBeyondLimit(const std::string& path) {
  EndOnShortage();
  rlimit limit = {};
  limit.rlim_cur = limit.rlim_max = 100;
  setrlimit(RLIMIT_FSIZE, &limit);
  _exit(WriteFileAtomically(path, std::string(1000, 'x')).ok() ? kExitDone : kExitRetryable);
}

TEST(ShortageDeathTest, AWriteBeyondTheLimitOfFileSizesFails) {
  const TemporaryFolder folder;
  EXPECT_EXIT(WriteBeyondLimit(folder / "file"), testing::ExitedWithCode(kExitRetryable), "");
}

TEST(ShortageDeathTest, LeavesOtherExceptionsToTheirEnd) {
  EXPECT_EXIT(ThrowInThread(std::logic_error("a fault of its own")), testing::KilledBySignal(SIGABRT),
              "a fault of its own");
}

TEST(ShortageDeathTest, LeavesAnAbortWithoutShortage) {
  const auto abort_at_once = [] {
    EndOnShortage();
    std::abort();
  };
  EXPECT_EXIT(abort_at_once(), testing::KilledBySignal(SIGABRT), "");
}

// As systemd's watchdog sends it.
TEST(ShortageDeathTest, LeavesASignalFromWithout) {
  const auto signal_at_once = [] {
    EndOnShortage();
    kill(getpid(), SIGABRT);
    std::exit(0);
  };
  EXPECT_EXIT(signal_at_once(), testing::KilledBySignal(SIGABRT), "");
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they need room without limit
TEST(ShortageDeathTest, EndsAnAbortForWantOfMemory) {
  const auto abort_in_little_room = [] {
    EndOnShortage();
    const rlimit none = {1, RLIM_INFINITY};
    setrlimit(RLIMIT_AS, &none);
    std::abort();
  };
  EXPECT_EXIT(abort_in_little_room(), testing::ExitedWithCode(kExitRetryable), "cannot go on: out of memory");
}
#endif

TEST(ShortageDeathTest, TakesTheFolderAway) {
  const TemporaryFolder folder;
  for (int i = 0; i < 200; ++i) folder.Write(absl::StrCat("work/jobs/one/", std::string(40, 'b'), i), "blob");
  folder.Write("tiles/kept.ply", "tile");
  std::filesystem::create_directory_symlink(folder / "tiles", folder / "work/jobs/link");
  const auto end = [&] {
    RemoveOnShortage(folder / "tiles");
    RemoveOnShortage(folder / "work");
    ThrowInThread(std::bad_alloc());
  };
  EXPECT_EXIT(end(), testing::ExitedWithCode(kExitRetryable), "out of memory");
  EXPECT_FALSE(std::filesystem::exists(folder / "work"));
  EXPECT_TRUE(std::filesystem::exists(folder / "tiles/kept.ply"));
}

}  // namespace
}  // namespace tilemend
