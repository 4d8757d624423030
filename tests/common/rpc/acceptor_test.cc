#include "common/rpc/acceptor.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

namespace tilemend {
namespace {

class Connection {
 public:
  explicit Connection(int port) : fd_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  }
  ~Connection() { close(fd_); }
  // Waits until the other side sends a byte (true) or closes (false).
  bool IsServed() const {
    pollfd waiting{fd_, POLLIN, 0};
    EXPECT_EQ(poll(&waiting, 1, 20'000), 1);
    char byte = 0;
    return recv(fd_, &byte, 1, 0) == 1;
  }

 private:
  const int fd_;
};

void Serve(int fd) {
  EXPECT_EQ(send(fd, "x", 1, MSG_NOSIGNAL), 1);
  close(fd);
}

TEST(AcceptorTest, GivesEveryConnectionToItsTaker) {
  auto acceptor = Acceptor::Listen("127.0.0.1", 0);
  ASSERT_TRUE(acceptor.ok()) << acceptor.status();
  (*acceptor)->Start(1 << 20, Serve);
  for (int i = 0; i < 50; ++i) EXPECT_TRUE(Connection((*acceptor)->port()).IsServed());
}

TEST(AcceptorTest, ClosesWhatIsTooManyAndServesAgainLater) {
  auto acceptor = Acceptor::Listen("localhost", 0);
  ASSERT_TRUE(acceptor.ok()) << acceptor.status();
  Connection first((*acceptor)->port());
  (*acceptor)->Start(0, Serve);
  EXPECT_FALSE(first.IsServed());
  acceptor->reset();
  acceptor = Acceptor::Listen("localhost", 0);
  (*acceptor)->Start(1 << 20, Serve);
  EXPECT_TRUE(Connection((*acceptor)->port()).IsServed());
}

TEST(AcceptorTest, GoesOnAfterItRanOutOfDescriptors) {
  const auto other = Acceptor::Listen("127.0.0.1", 0), acceptor = Acceptor::Listen("127.0.0.1", 0);
  ASSERT_TRUE(other.ok() && acceptor.ok()) << other.status() << acceptor.status();
  (*other)->Start(1 << 20,
                  Serve);  // the sanitizer of undefined behaviour needs descriptors where it sees a type at first
  ASSERT_TRUE(Connection((*other)->port()).IsServed());
  const Connection waiting((*acceptor)->port());
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  rlimit none = before;
  none.rlim_cur = 3;
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  (*acceptor)->Start(1 << 20, Serve);
  pollfd served{};
  poll(&served, 0, 200);  // it fails a few times meanwhile
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_TRUE(waiting.IsServed());
}

TEST(AcceptorTest, SaysThatAPortIsTaken) {
  const auto first = Acceptor::Listen("127.0.0.1", 0);
  ASSERT_TRUE(first.ok()) << first.status();
  EXPECT_TRUE(absl::IsUnavailable(Acceptor::Listen("127.0.0.1", (*first)->port()).status()));
  EXPECT_FALSE(Acceptor::Listen("no such host.invalid", 0).ok());
}

TEST(AcceptorTest, LeavesDescriptorsForTheRest) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  rlimit low = before;
  low.rlim_cur = 64;
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &low), 0);
  EXPECT_EQ(MostDescriptorsOfConnections(), 48);
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
}

}  // namespace
}  // namespace tilemend
