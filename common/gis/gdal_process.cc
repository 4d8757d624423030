#include "common/gis/gdal_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "absl/strings/str_cat.h"
#include "common/gis/gdal_limits.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr char kProgram[] = "tilemend-gdal";
constexpr char kNamedBy[] = "TILEMEND_GDAL";  // variable of the environment

// Closes a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { ::close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }

 private:
  const int number_;
};

// Beside the program that runs; a Python interpreter has it elsewhere, so the environment may name it.
absl::StatusOr<std::string> ProgramPath() {
  if (const char* named = std::getenv(kNamedBy); named != nullptr && named[0] != 0) return std::string(named);
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const std::filesystem::path& path :
       {folder / kProgram, folder / "../bin" / kProgram, folder / "../lib/tilemend" / kProgram}) {
    if (::access(path.c_str(), X_OK) == 0) return path.string();
  }
  return absl::InternalError(
      absl::StrCat("cannot find ", kProgram, ", which reads files of polygons, beside ", folder.string(),
                   " or in ../lib/tilemend; install the package tilemend, or name its path in ", kNamedBy));
}

// Starts the program with `end` as its input and its output.
absl::StatusOr<pid_t> Start(const std::string& path, int end) {
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO}) ::posix_spawn_file_actions_adddup2(&actions, end, standard);
  std::string name = kProgram;
  std::array<char*, 2> arguments = {name.data(), nullptr};
  pid_t process = 0;
  const int fault = ::posix_spawn(&process, path.c_str(), &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (fault != 0) return absl::InternalError(absl::StrCat("cannot start ", path, ": ", std::strerror(fault)));
  return process;
}

using Clock = std::chrono::steady_clock;

// The bytes that go to a process and come from it, until a time.
class Conversation {
 public:
  Conversation(int socket, Clock::time_point end) : socket_(socket), end_(end) {}

  // Stops early where the other side has gone: how it ended says why.
  void SendAll(std::string_view bytes) {
    while (!bytes.empty() && Await(POLLOUT)) {
      const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
      if (sent < 0) break;
      bytes.remove_prefix(static_cast<size_t>(sent));
    }
    ::shutdown(socket_, SHUT_WR);
  }

  std::string ReceiveAll() {
    std::string all;
    std::array<char, 1 << 16> piece;
    while (Await(POLLIN)) {
      const ssize_t read = ::recv(socket_, piece.data(), piece.size(), MSG_DONTWAIT);
      if (read < 0 && (errno == EINTR || errno == EAGAIN)) continue;
      if (read <= 0) break;
      all.append(piece.data(), static_cast<size_t>(read));
    }
    return all;
  }

  bool is_late() const { return is_late_; }

 private:
  // False if the time is over.
  bool Await(int16_t event) {
    pollfd poll{socket_, event, 0};
    for (;;) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(end_ - Clock::now()).count();
      is_late_ = left <= 0;
      if (is_late_) return false;
      if (::poll(&poll, 1, static_cast<int>(left)) > 0) return true;
    }
  }

  const int socket_;
  const Clock::time_point end_;
  bool is_late_ = false;
};

// How a process ended, as an error of the file.
absl::Status EndOf(pid_t process, const std::string& name) {
  int how = 0;
  while (::waitpid(process, &how, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(how) && WEXITSTATUS(how) == 0) return absl::OkStatus();
  if (WIFSIGNALED(how) && (WTERMSIG(how) == SIGXCPU || WTERMSIG(how) == SIGALRM || WTERMSIG(how) == SIGKILL)) {
    return absl::InvalidArgumentError(absl::StrCat(name, ": takes too long to be read for its size"));
  }
  if (WIFSIGNALED(how)) {
    return absl::InvalidArgumentError(
        absl::StrCat(name, ": GDAL crashes when it reads it (signal ", WTERMSIG(how), ")"));
  }
  return absl::InvalidArgumentError(absl::StrCat(name, ": takes too much memory to be read for its size"));
}

}  // namespace

absl::StatusOr<std::string> AskGdal(std::string_view request, const std::string& name, const std::stop_token& stop) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string path, ProgramPath());
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    return absl::ResourceExhaustedError(absl::StrCat("cannot talk to ", kProgram, ": ", std::strerror(errno)));
  }
  const Descriptor mine(ends[0]);
  absl::StatusOr<pid_t> process = absl::InternalError("");
  {
    const Descriptor other(ends[1]);
    process = Start(path, other.get());
  }
  TILEMEND_RETURN_IF_ERROR(process.status());
  // Ends the waiting below. What the process would still send is of no use.
  const std::stop_callback on_stop(stop, [&] { ::shutdown(mine.get(), SHUT_RDWR); });
  // A second more than the process gives itself, so that it says itself that it took too long.
  Conversation talk(mine.get(), Clock::now() + std::chrono::seconds(GdalClockSeconds(request.size()) + 1));
  talk.SendAll(request);
  std::string answer = talk.ReceiveAll();
  const bool is_stopped = stop.stop_requested();
  if (is_stopped || talk.is_late()) ::kill(*process, SIGKILL);
  const absl::Status end = EndOf(*process, name);
  if (is_stopped) return absl::CancelledError(absl::StrCat(name, ": reading it was stopped"));
  TILEMEND_RETURN_IF_ERROR(end);
  return answer;
}

}  // namespace tilemend
