#include "common/util/signals.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <future>
#include <vector>

#include "common/util/exit_codes.h"

namespace tilemend {
namespace {

// Signals go to the process, as those of a user do. Every thread of this test has them blocked while a watcher lives.
void Send(int signal) { ASSERT_EQ(::kill(::getpid(), signal), 0); }

TEST(SignalWatcherTest, CountsSignalsOfBothKinds) {
  SignalWatcher watcher;
  std::promise<void> first, second;
  std::vector<int> counts;
  watcher.Start([&](int count) {
    counts.push_back(count);
    (count == 1 ? first : second).set_value();
  });
  Send(SIGINT);
  first.get_future().wait();
  Send(SIGTERM);
  second.get_future().wait();
  watcher.Stop();
  EXPECT_EQ(counts, (std::vector<int>{1, 2}));
}

TEST(SignalWatcherTest, TellsOfASignalThatCameBeforeTheStart) {
  SignalWatcher watcher;
  Send(SIGTERM);
  std::promise<int> count;
  watcher.Start([&](int n) { count.set_value(n); });
  EXPECT_EQ(count.get_future().get(), 1);
}

TEST(SignalWatcherTest, DropsWhatComesAfterTheStop) {
  int calls = 0;
  {
    SignalWatcher watcher;
    watcher.Start([&](int) { ++calls; });
    watcher.Stop();
    watcher.Stop();
    Send(SIGINT);
    Send(SIGTERM);
  }
  EXPECT_EQ(calls, 0);  // and the process is alive
}

TEST(SignalWatcherTest, GivesTheSignalsBackWhenItEnds) {
  { SignalWatcher watcher; }
  EXPECT_EXIT(Send(SIGTERM), ::testing::KilledBySignal(SIGTERM), "");
}

TEST(ExitOnSignalTest, EndsWithACodeUnlessTheSignalIsWatched) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const auto end = [&] {
      ExitOnSignal();
      { SignalWatcher watcher; }
      Send(signal);
    };
    EXPECT_EXIT(end(), ::testing::ExitedWithCode(kExitCancelled), "tilemend: cancelled");
    const auto watch = [&] {
      ExitOnSignal();
      {
        SignalWatcher watcher;
        Send(signal);
      }
      ::_exit(kExitDone);
    };
    EXPECT_EXIT(watch(), ::testing::ExitedWithCode(kExitDone), "");
  }
}

TEST(ExitOnSignalTest, ASignalThatIsIgnoredStaysSo) {
  const auto ignore = [] {
    ::signal(SIGINT, SIG_IGN);
    ExitOnSignal();
    Send(SIGINT);
    ::_exit(kExitDone);
  };
  EXPECT_EXIT(ignore(), ::testing::ExitedWithCode(kExitDone), "");
}

}  // namespace
}  // namespace tilemend
