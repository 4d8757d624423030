#include "common/gis/gdal_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "absl/strings/str_cat.h"
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

// Stops early where the other side has gone: how it ended says why.
void SendAll(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) break;
    bytes.remove_prefix(static_cast<size_t>(sent));
  }
  ::shutdown(socket, SHUT_WR);
}

std::string ReceiveAll(int socket) {
  std::string all;
  std::array<char, 1 << 16> piece;
  for (;;) {
    const ssize_t read = ::recv(socket, piece.data(), piece.size(), 0);
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) return all;
    all.append(piece.data(), static_cast<size_t>(read));
  }
}

// How a process ended, as an error of the file.
absl::Status EndOf(pid_t process, const std::string& name) {
  int how = 0;
  while (::waitpid(process, &how, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(how) && WEXITSTATUS(how) == 0) return absl::OkStatus();
  if (WIFSIGNALED(how) && (WTERMSIG(how) == SIGXCPU || WTERMSIG(how) == SIGKILL)) {
    return absl::InvalidArgumentError(absl::StrCat(name, ": takes too long to be read for its size"));
  }
  if (WIFSIGNALED(how)) {
    return absl::InvalidArgumentError(
        absl::StrCat(name, ": GDAL crashes when it reads it (signal ", WTERMSIG(how), ")"));
  }
  return absl::InvalidArgumentError(absl::StrCat(name, ": takes too much memory to be read for its size"));
}

}  // namespace

absl::StatusOr<std::string> AskGdal(std::string_view request, const std::string& name) {
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
  SendAll(mine.get(), request);
  std::string answer = ReceiveAll(mine.get());
  TILEMEND_RETURN_IF_ERROR(EndOf(*process, name));
  return answer;
}

}  // namespace tilemend
