#include "common/http/waiting_room.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <semaphore>
#include <string>

namespace tilemend {
namespace {

// A connection: what is written to `ours` comes to `theirs`, which the room takes.
struct Pair {
  Pair() {
    std::array<int, 2> fds{};
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, fds.data()), 0);
    ours = fds[0];
    theirs = fds[1];
  }
  ~Pair() { close(ours); }
  void Say(const std::string& text) const {
    EXPECT_EQ(write(ours, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  // Waits for the end of the other side.
  bool IsClosed() const {
    char byte = 0;
    return read(ours, &byte, 1) == 0;
  }

  int ours = -1, theirs = -1;
};

class WaitingRoomTest : public ::testing::Test {
 protected:
  std::function<void(int)> Leave() {
    return [this](int fd) {
      left_ = fd;
      close(fd);
      leave_.release();
    };
  }
  // Beside a connection that says nothing.
  void ExpectLeavesWith(const std::string& first, const std::string& rest) {
    const Pair idle, asking;
    WaitingRoom room({}, Leave());  // ends before their other sides do, which would let them leave
    room.Add(idle.theirs);
    room.Add(asking.theirs);
    asking.Say(first);
    EXPECT_FALSE(leave_.try_acquire_for(std::chrono::milliseconds(50)));
    asking.Say(rest);
    leave_.acquire();
    EXPECT_EQ(left_, asking.theirs);
  }
  std::binary_semaphore leave_{0};
  std::atomic<int> left_ = -1;
};

TEST_F(WaitingRoomTest, AConnectionLeavesWhenItsRequestIsThere) {
  ExpectLeavesWith("GET / HTTP/1.1\r\nHost: x\r\n", "\r\n");
}

TEST_F(WaitingRoomTest, ABodyIsWaitedForWithoutAThread) {
  ExpectLeavesWith("POST / HTTP/1.1\r\ncontent-LENGTH: 4\r\n\r\nbod", "y");
}

TEST_F(WaitingRoomTest, ABodyThatIsTooLongIsNotWaitedFor) {
  WaitingRoom room({}, Leave());
  for (const char* length : {"100000", "99999999999999999999", "-1", "x"}) {
    const Pair asking;
    room.Add(asking.theirs);
    asking.Say(std::string("POST / HTTP/1.1\r\nContent-Length: ") + length + "\r\n\r\n");
    leave_.acquire();
    EXPECT_EQ(left_, asking.theirs);
  }
}

TEST_F(WaitingRoomTest, AHeadIsWaitedForWithoutAThread) {
  const std::string cookies = "Cookie: " + std::string(7000, 'a') + "\r\n";
  ExpectLeavesWith("GET / HTTP/1.1\r\n" + cookies + cookies, "\r\n");
}

TEST_F(WaitingRoomTest, AHeadThatIsTooLongIsRefused) {
  for (const char* end : {"", "\r\n\r\n"}) {
    WaitingRoom room({}, Leave());
    const Pair asking;
    room.Add(asking.theirs);
    asking.Say("GET / HTTP/1.1\r\nX: " + std::string(17000, 'a') + end);
    std::string answer;
    std::array<char, 1000> part{};
    for (ssize_t count = 1; count > 0; answer.append(part.data(), static_cast<size_t>(std::max<ssize_t>(count, 0)))) {
      count = read(asking.ours, part.data(), part.size());
    }
    EXPECT_EQ(answer.substr(0, 13), "HTTP/1.1 431 ");
    const std::string body = answer.substr(answer.find("\r\n\r\n") + 4);
    EXPECT_NE(answer.find("Content-Length: " + std::to_string(body.size()) + "\r\n"), std::string::npos) << answer;
    EXPECT_FALSE(leave_.try_acquire());
  }
}

TEST_F(WaitingRoomTest, OverTlsTheFirstByteIsEnough) {
  WaitingRoom room({.whole_request = false}, Leave());
  const Pair asking;
  room.Add(asking.theirs);
  asking.Say("x");
  leave_.acquire();
  EXPECT_EQ(left_, asking.theirs);
}

TEST_F(WaitingRoomTest, WhoCameFirstIsClosedWhenThereAreTooMany) {
  WaitingRoom room({.connections = 2, .time = absl::InfiniteDuration()}, Leave());
  const Pair first, second, third;
  for (const Pair* pair : {&first, &second, &third}) room.Add(pair->theirs);
  EXPECT_TRUE(first.IsClosed());
  third.Say("\r\n\r\n");
  leave_.acquire();
  EXPECT_EQ(left_, third.theirs);
}

TEST_F(WaitingRoomTest, ClosesWhatAsksNothingInTime) {
  WaitingRoom room({.time = absl::Milliseconds(1)}, Leave());
  const Pair idle;
  room.Add(idle.theirs);
  EXPECT_TRUE(idle.IsClosed());
}

TEST_F(WaitingRoomTest, ClosesAllInTheEnd) {
  WaitingRoom room({.time = absl::InfiniteDuration()}, Leave());
  const Pair early, late;
  room.Add(early.theirs);
  room.Close();
  room.Add(late.theirs);
  EXPECT_TRUE(early.IsClosed());
  EXPECT_TRUE(late.IsClosed());
}

}  // namespace
}  // namespace tilemend
