#include "common/http/timed_connection.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <string>
#include <thread>

#include "absl/time/clock.h"

namespace tilemend {
namespace {

class TimedConnectionTest : public ::testing::Test {
 protected:
  TimedConnectionTest() { EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends_.data()), 0); }
  ~TimedConnectionTest() override { close(ends_[1]); }
  // How many bytes are read before reads fail, with a reader of single bytes as the web server is.
  static size_t ReadAll(TimedConnection& connection) {
    size_t count = 0;
    char byte = 0;
    while (connection.read(&byte, 1) == 1) ++count;
    return count;
  }
  // Sends `text` as fast as it goes, or with `pause` between, until the other side has gone.
  void SendForEver(const std::string& text, absl::Duration pause) {
    while (send(ends_[1], text.data(), text.size(), MSG_NOSIGNAL) > 0) absl::SleepFor(pause);
  }

  std::array<int, 2> ends_{};  // the first is the connection's
};

constexpr auto kNobodyWaits = [] { return false; };

TEST_F(TimedConnectionTest, ReadsAndWrites) {
  TimedConnection connection(ends_[0], {}, kNobodyWaits);
  ASSERT_EQ(send(ends_[1], "question", 8, 0), 8);
  std::array<char, 3> part{};
  std::string all;
  while (all.size() < 8) {
    const ssize_t count = connection.read(part.data(), part.size());
    ASSERT_GT(count, 0);
    all.append(part.data(), static_cast<size_t>(count));
  }
  EXPECT_EQ(all, "question");
  ASSERT_EQ(connection.write("answer", 6), 6);
  std::array<char, 10> answer{};
  EXPECT_EQ(recv(ends_[1], answer.data(), answer.size(), 0), 6);
  ASSERT_EQ(shutdown(ends_[1], SHUT_WR), 0);
  EXPECT_EQ(connection.read(part.data(), part.size()), 0);
}

TEST_F(TimedConnectionTest, AByteNowAndThenDoesNotMakeItLonger) {
  const absl::Time begin = absl::Now();
  std::thread sender;
  {
    TimedConnection connection(ends_[0], {absl::Milliseconds(200)}, kNobodyWaits);
    sender = std::thread([this] { SendForEver("a", absl::Milliseconds(5)); });
    ReadAll(connection);
  }
  sender.join();
  EXPECT_GE(absl::Now() - begin, absl::Milliseconds(200));
}

TEST_F(TimedConnectionTest, HasLessTimeWhileOthersWait) {
  std::atomic<bool> others_wait{false};
  TimedConnection connection(ends_[0],
                             {.time = absl::Hours(1),
                              .time_while_others_wait = absl::Milliseconds(10),
                              .write_time_while_others_wait = absl::Milliseconds(10)},
                             [&] { return others_wait.load(); });
  std::thread reader([&] { EXPECT_EQ(ReadAll(connection), 0U); });
  others_wait = true;
  reader.join();
  EXPECT_EQ(connection.write("late", 4), -1);
}

TEST_F(TimedConnectionTest, ReadsNoMoreThanItsShare) {
  constexpr size_t kMost = 100'000;
  std::thread sender;
  {
    TimedConnection connection(ends_[0], {absl::Hours(1), absl::Hours(1), kMost}, kNobodyWaits);
    sender = std::thread([this] { SendForEver(std::string(5000, 'a'), absl::ZeroDuration()); });
    const size_t count = ReadAll(connection);
    EXPECT_GE(count, kMost);
    EXPECT_LT(count, kMost + 5000);
  }
  sender.join();
}

TEST_F(TimedConnectionTest, AnAnswerThatNobodyTakesEndsInTime) {
  TimedConnection connection(ends_[0], {absl::Milliseconds(50)}, kNobodyWaits);
  const std::string much(size_t{1} << 24, 'a');
  ssize_t count = 0;
  do {
    count = connection.write(much.data(), much.size());
  } while (count > 0);
  EXPECT_EQ(count, -1);
}

TEST_F(TimedConnectionTest, GivesTheRequestOnceMoreAfterItsAnswerWasHeld) {
  TimedConnection connection(ends_[0], {}, kNobodyWaits);
  ASSERT_EQ(send(ends_[1], "question", 8, 0), 8);
  shutdown(ends_[1], SHUT_WR);
  EXPECT_EQ(ReadAll(connection), 8);
  connection.HoldAnswer();
  EXPECT_EQ(connection.write("early", 5), -1);
  connection.Rewind();
  EXPECT_TRUE(connection.was_rewound());
  EXPECT_EQ(ReadAll(connection), 8);
  EXPECT_EQ(connection.write("answer", 6), 6);
  std::array<char, 16> answer{};
  EXPECT_EQ(recv(ends_[1], answer.data(), answer.size(), 0), 6);
}

}  // namespace
}  // namespace tilemend
