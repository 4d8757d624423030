#include "tests/support/process.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>

#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "common/util/files.h"

namespace tilemend {
namespace {

constexpr absl::Duration kPollInterval = absl::Milliseconds(2);

// In the child, between fork and exec: system calls only.
[[noreturn]] void Become(char* const* argv, const char* out, const char* err) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  dup2(open(out, O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
  dup2(open(err, O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
  execv(argv[0], argv);
  _exit(127);
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int64_t kMostBytes = INT64_MAX;
#else
constexpr int64_t kMostBytes = int64_t{512} << 20;
#endif

}  // namespace

void ExpectFrugal(const Ended& ended) {
  EXPECT_LT(ended.seconds, 20);
  EXPECT_LT(ended.peak_bytes, kMostBytes);
}

Process::Process(const std::string& folder, const std::string& program, const std::vector<std::string>& words)
    : start_(absl::Now()) {
  static std::atomic<int> count{0};
  const int number = ++count;
  out_ = absl::StrCat(folder, "/stdout-", number);
  err_ = absl::StrCat(folder, "/stderr-", number);
  std::vector<std::string> all = {program};
  all.insert(all.end(), words.begin(), words.end());
  std::vector<char*> argv;
  for (std::string& word : all) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_ = fork();
  if (pid_ == 0) Become(argv.data(), out_.c_str(), err_.c_str());
  EXPECT_GT(pid_, 0);
}

Process::~Process() {
  if (pid_ <= 0) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

void Process::Signal(int signal) {
  if (pid_ > 0) kill(pid_, signal);
}

bool Process::Runs() const {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0;
}

Ended Process::Wait(absl::Duration limit) {
  Ended ended;
  if (pid_ <= 0) return ended;
  const bool in_time = Await([this] { return !Runs(); }, limit);
  EXPECT_TRUE(in_time) << "killed after " << limit;
  if (!in_time) kill(pid_, SIGKILL);
  int status = 0;
  rusage usage{};
  wait4(pid_, &status, 0, &usage);
  pid_ = -1;
  ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  ended.out = ReadFile(out_).value_or("");
  ended.err = ReadFile(err_).value_or("");
  ended.seconds = absl::ToDoubleSeconds(absl::Now() - start_);
  ended.peak_bytes = int64_t{1024} * usage.ru_maxrss;
  return ended;
}

std::string Process::AwaitLine(const std::string& text) {
  std::string rest;
  const bool said = Await([&] {
    const bool runs = Runs();  // before the look, so that nothing is missed
    const std::string lines = ReadFile(err_).value_or("");
    const size_t at = lines.find(text);
    const size_t end = at == std::string::npos ? at : lines.find('\n', at);
    if (end == std::string::npos) return !runs;
    rest = lines.substr(at + text.size(), end - at - text.size());
    return true;
  });
  EXPECT_TRUE(said) << "did not say within a minute: " << text;
  return rest;
}

bool Await(const std::function<bool()>& done, absl::Duration limit) {
  const absl::Time give_up = absl::Now() + limit;
  while (!done()) {
    if (absl::Now() > give_up) return false;
    absl::SleepFor(kPollInterval);
  }
  return true;
}

}  // namespace tilemend
