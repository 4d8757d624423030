#include "common/http/held_connections.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <condition_variable>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <vector>

namespace tilemend {
namespace {

class HeldConnectionsTest : public ::testing::Test {
 protected:
  ~HeldConnectionsTest() override {
    for (const int fd : others_) close(fd);
  }
  // A new one; the test's end of it is others_.back().
  std::shared_ptr<TimedConnection> NewConnection() {
    std::array<int, 2> ends{};
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
    others_.push_back(ends[1]);
    return std::make_shared<TimedConnection>(ends[0], ConnectionLimits(), [] { return false; });
  }
  void Take(std::shared_ptr<TimedConnection> connection) {
    const std::lock_guard<std::mutex> lock(mutex_);
    left_.push_back(std::move(connection));
    changed_.notify_all();
  }
  void AwaitLeft(size_t count) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [&] { return left_.size() >= count; });
  }
  bool IsClosed(size_t k) {
    char byte = 0;
    return recv(others_[k], &byte, 1, MSG_DONTWAIT) == 0;
  }

  std::vector<int> others_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::shared_ptr<TimedConnection>> left_;
};

TEST_F(HeldConnectionsTest, LeavesOnceWhenItIsWokenAndLetsGoOfTheWait) {
  const auto kept = std::make_shared<int>(0);
  std::function<void()> wake;
  HeldConnections held(2, [&](auto connection) {
    EXPECT_EQ(kept.use_count(), 1);
    Take(connection);
  });
  held.Hold(NewConnection(), [&](std::function<void()> given) {
    wake = std::move(given);
    return kept;
  });
  EXPECT_EQ(kept.use_count(), 2);
  wake();
  wake();
  AwaitLeft(1);
  held.Close();
  wake();
  EXPECT_EQ(left_.size(), 1);
}

TEST_F(HeldConnectionsTest, MayBeWokenBeforeItIsHeld) {
  HeldConnections held(2, [&](auto connection) { Take(connection); });
  held.Hold(NewConnection(), [](const std::function<void()>& wake) {
    wake();
    return nullptr;
  });
  AwaitLeft(1);
}

TEST_F(HeldConnectionsTest, TheFirstMakesRoomAndWhoComesBesideAFullQueueIsClosed) {
  std::promise<void> entered, go_on;
  std::shared_future<void> may_go_on = go_on.get_future();
  std::once_flag first;
  HeldConnections held(1, [&](auto connection) {
    std::call_once(first, [&] { entered.set_value(); });
    may_go_on.wait();
    Take(connection);
  });
  const HeldConnections::Wait forever = [](const std::function<void()>&) { return nullptr; };
  for (int i = 0; i < 2; ++i) held.Hold(NewConnection(), forever);
  entered.get_future().wait();                                      // the first leaves, and does not get away
  for (int i = 0; i < 2; ++i) held.Hold(NewConnection(), forever);  // of four, one leaves, one is woken, one is held
  for (size_t k = 0; k < 4; ++k) EXPECT_EQ(IsClosed(k), k == 3) << k;
  go_on.set_value();
  AwaitLeft(2);
  for (const auto& connection : left_) EXPECT_TRUE(connection->made_room());
}

TEST_F(HeldConnectionsTest, ClosesAllInTheEnd) {
  HeldConnections held(2, [&](auto connection) { Take(connection); });
  held.Hold(NewConnection(), [](const std::function<void()>&) { return nullptr; });
  EXPECT_FALSE(IsClosed(0));
  held.Close();
  EXPECT_TRUE(IsClosed(0));
  held.Hold(NewConnection(), [](const std::function<void()>&) { return nullptr; });
  EXPECT_TRUE(IsClosed(1));
  EXPECT_TRUE(left_.empty());
}

}  // namespace
}  // namespace tilemend
