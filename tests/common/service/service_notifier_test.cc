#include "common/service/service_notifier.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <semaphore>
#include <string>

#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

// The end of systemd.
class ServiceNotifierTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fd_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string path = folder_ / "notify";
    ASSERT_LT(path.size(), sizeof(address.sun_path));
    std::strncpy(address.sun_path, path.c_str(), sizeof(address.sun_path) - 1);
    ASSERT_EQ(bind(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    setenv("NOTIFY_SOCKET", path.c_str(), 1);
    unsetenv("WATCHDOG_PID");
    unsetenv("WATCHDOG_USEC");
  }
  void TearDown() override {
    close(fd_);
    unsetenv("NOTIFY_SOCKET");
    unsetenv("WATCHDOG_USEC");
  }
  // The next message, waited for.
  std::string Next() { return Receive(0); }
  bool IsQuiet() { return Receive(MSG_DONTWAIT).empty(); }
  std::string Receive(int flags) {
    std::array<char, 512> message;
    const ssize_t n = recv(fd_, message.data(), message.size(), flags);
    return n < 0 ? "" : std::string(message.data(), static_cast<size_t>(n));
  }

  TemporaryFolder folder_;
  int fd_ = -1;
};

TEST_F(ServiceNotifierTest, SaysThatTheProgramIsReadyWhatItDoesAndThatItEnds) {
  {
    const ServiceNotifier notifier([] { return "2 jobs"; });
    EXPECT_EQ(Next(), "READY=1");
    EXPECT_EQ(Next(), "WATCHDOG=1\nSTATUS=2 jobs");
  }
  EXPECT_EQ(Next(), "STOPPING=1");
  EXPECT_TRUE(IsQuiet());
}

TEST_F(ServiceNotifierTest, BeatsAsOftenAsTheWatchdogWants) {
  setenv("WATCHDOG_USEC", "20000", 1);
  std::atomic<int> beats{0};
  const ServiceNotifier notifier([&beats] { return std::to_string(++beats); });
  EXPECT_EQ(Next(), "READY=1");
  for (int beat = 1; beat <= 5; ++beat) EXPECT_EQ(Next(), "WATCHDOG=1\nSTATUS=" + std::to_string(beat));
}

TEST_F(ServiceNotifierTest, FallsSilentWhenTheProgramHangs) {
  setenv("WATCHDOG_USEC", "2000", 1);
  std::binary_semaphore hangs(0), goes_on(0);
  std::atomic<int> beats{0};
  const ServiceNotifier notifier([&] {
    if (++beats == 2) {
      hangs.release();
      goes_on.acquire();
    }
    return "";
  });
  EXPECT_EQ(Next(), "READY=1");
  EXPECT_EQ(Next(), "WATCHDOG=1\nSTATUS=");
  hangs.acquire();
  EXPECT_TRUE(IsQuiet());
  goes_on.release();
  EXPECT_EQ(Next(), "WATCHDOG=1\nSTATUS=");
}

TEST_F(ServiceNotifierTest, DoesNothingWithoutAServiceManager) {
  unsetenv("NOTIFY_SOCKET");
  bool asked = false;
  {
    const ServiceNotifier notifier([&asked] {
      asked = true;
      return "";
    });
  }
  EXPECT_FALSE(asked);
  EXPECT_TRUE(IsQuiet());
}

}  // namespace
}  // namespace tilemend
