#include "common/util/signals.h"

#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <string_view>
#include <utility>

#include "common/util/exit_codes.h"

namespace tilemend {
namespace {

sigset_t Watched() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

constexpr std::string_view kCancelled = "\ntilemend: cancelled\n";  // the line before may be a bar of progress

// Async-signal-safe.
void EndProcess(int /*signal*/) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kCancelled.data(), kCancelled.size());
  _exit(kExitCancelled);
}

// As EndProcess, where no bar is shown.
void EndProcessPlainly(int /*signal*/) {
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kCancelled.data() + 1, kCancelled.size() - 1);
  _exit(kExitCancelled);
}

}  // namespace

void ExitOnSignal() {
  for (const int signal : {SIGINT, SIGTERM}) {
    struct sigaction action {};
    if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = isatty(STDERR_FILENO) == 1 ? EndProcess : EndProcessPlainly;
    sigaction(signal, &action, nullptr);
  }
}

SignalWatcher::SignalWatcher() {
  const sigset_t set = Watched();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  signal_fd_ = signalfd(-1, &set, SFD_CLOEXEC);
  stop_fd_ = eventfd(0, EFD_CLOEXEC);
}

void SignalWatcher::Start(std::function<void(int)> on_signal) {
  on_signal_ = std::move(on_signal);
  thread_ = std::thread([this] { Run(); });
}

void SignalWatcher::Stop() {
  if (!thread_.joinable()) return;
  const uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = write(stop_fd_, &one, sizeof(one));
  thread_.join();
}

SignalWatcher::~SignalWatcher() {
  Stop();
  close(signal_fd_);
  close(stop_fd_);
  const sigset_t set = Watched();
  // What came too late to be handled must not end the process now that all is done.
  const timespec now{};
  while (sigtimedwait(&set, nullptr, &now) > 0) {
  }
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

void SignalWatcher::Run() {
  std::array<pollfd, 2> fds = {{{signal_fd_, POLLIN, 0}, {stop_fd_, POLLIN, 0}}};
  int count = 0;
  while (true) {
    if (poll(fds.data(), fds.size(), -1) < 0) continue;
    if ((fds[1].revents & POLLIN) != 0) return;
    signalfd_siginfo info{};
    if ((fds[0].revents & POLLIN) != 0 && read(signal_fd_, &info, sizeof(info)) == sizeof(info)) on_signal_(++count);
  }
}

}  // namespace tilemend
