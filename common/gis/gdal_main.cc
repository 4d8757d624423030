// tilemend-gdal: reads one vector file, or looks at one CRS, in a process of its own (gdal_process.h). Its input is a
// request, its output the answer.
#include <fcntl.h>
#include <linux/landlock.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "common/gis/gdal_limits.h"
#include "common/gis/package_writing.h"
#include "common/gis/vector_file.h"
#include "common/gis/vector_message.h"

#ifdef __SANITIZE_ADDRESS__
// A confined process cannot look for leaks, and fails when it tries.
extern "C" const char* __asan_default_options() { return "detect_leaks=0"; }
#endif

namespace tilemend {
namespace {

constexpr int kOutOfMemory = 1;

void Limit(decltype(RLIMIT_AS) what, rlim_t most) {
  rlimit limit{};
  ::getrlimit(what, &limit);
  if (limit.rlim_max < most) return;  // RLIM_INFINITY is the largest
  limit = {most, most};
  ::setrlimit(what, &limit);
}

void LimitFor(size_t bytes) {
// The shadow of memory of both takes terabytes of address space.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  Limit(RLIMIT_AS, GdalMemory(bytes));
#endif
  Limit(RLIMIT_CPU, GdalCpuSeconds(bytes));
  ::alarm(static_cast<unsigned>(GdalClockSeconds(bytes)));
}

// Lets a ruleset allow what lies beneath a folder to be read.
void AllowToRead(int64_t ruleset, const std::string& folder) {
  const int opened = ::open(folder.c_str(), O_PATH | O_CLOEXEC);
  if (opened < 0) return;
  const landlock_path_beneath_attr beneath{LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR, opened};
  ::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &beneath, 0);
  ::close(opened);
}

// From here on only files of installed programs can be opened: PROJ's database and grids, GDAL's tables, character
// sets. A CRS or a drawing that names another file, wherever it hides the name, gets none. Kernels before 5.13, or
// without Landlock, do not limit that.
void ConfineToInstalledFiles() {
  const landlock_ruleset_attr all{LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR |
                                  LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_EXECUTE |
                                  LANDLOCK_ACCESS_FS_MAKE_REG};
  const int64_t ruleset = ::syscall(SYS_landlock_create_ruleset, &all, sizeof all, 0);
  if (ruleset < 0) return;
  std::error_code error;  // of the program's own path: then it is not installed elsewhere
  const std::string program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path().string();
  for (const std::string& folder :
       {std::string("/usr"), std::string("/lib"), program + "/../lib", program + "/../share"}) {
    AllowToRead(ruleset, folder);
  }
  for (const char* variable : {"PROJ_DATA", "PROJ_LIB", "GDAL_DATA"}) {
    if (const char* folder = std::getenv(variable); folder != nullptr) AllowToRead(ruleset, folder);
  }
  ::syscall(SYS_landlock_restrict_self, ruleset, 0);
  ::close(static_cast<int>(ruleset));
}

// A process that nothing can be got out of: no network (where users may have a namespace), no files, no core. It ends
// with the thread that started it.
void Confine() {
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  (void)::unshare(CLONE_NEWUSER | CLONE_NEWNET);  // refused in some containers
  ConfineToInstalledFiles();
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // last of these: a new namespace takes it back
  Limit(RLIMIT_CORE, 0);
  Limit(RLIMIT_FSIZE, 0);
}

std::string ReadInput() {
  std::string all;
  std::array<char, 1 << 16> piece;
  for (;;) {
    const ssize_t read = ::read(STDIN_FILENO, piece.data(), piece.size());
    if (read < 0 && errno == EINTR) continue;
    if (read <= 0) return all;
    all.append(piece.data(), static_cast<size_t>(read));
  }
}

// Whether who asked had ended before this process was to end with it.
bool HasNobodyToAnswer() {
  pollfd output{STDOUT_FILENO, 0, 0};
  return ::poll(&output, 1, 0) > 0 && (output.revents & POLLHUP) != 0;
}

bool WriteOutput(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<size_t>(written));
  }
  return true;
}

// The points behind their number of bytes, and behind these the CRS; empty if there is no answer.
std::string LonLatAnswer(std::string_view input) {
  size_t bytes = 0;
  if (input.size() < sizeof(bytes)) return "";
  std::memcpy(&bytes, input.data(), sizeof(bytes));
  input.remove_prefix(sizeof(bytes));
  if (bytes > input.size() || bytes % sizeof(Point2) != 0) return "";
  std::vector<Point2> points(bytes / sizeof(Point2));
  std::memcpy(static_cast<void*>(points.data()), input.data(), bytes);
  if (!ToLonLat(std::string(input.substr(bytes)), points)) return "";
  return {reinterpret_cast<const char*>(points.data()), bytes};
}

// Precondition: `input` is of this build.
std::string Answer(std::string_view input) {
  if (input.empty()) return "";
  const auto task = static_cast<GdalTask>(input.front());
  input.remove_prefix(1);
  if (task == GdalTask::kFaultOfCrs) return FaultOfCrs(std::string(input));
  if (task == GdalTask::kLonLat) return LonLatAnswer(input);
  if (task == GdalTask::kWritePackage) {
    const size_t end = std::min(input.find('\n'), input.size());
    return PackageOf(std::string(input.substr(std::min(end + 1, input.size()))), std::string(input.substr(0, end)));
  }
  VectorRequest request;
  if (task != GdalTask::kReadVectors || !Decode(input, request)) return "";
  return Encode(ReadVectors(request));
}

int Main() {
  Confine();
  const std::string input = ReadInput();
  if (HasNobodyToAnswer()) return 0;
  LimitFor(input.size());
  return WriteOutput(Answer(input)) ? 0 : kOutOfMemory;
}

}  // namespace
}  // namespace tilemend

int main() {
  try {
    return tilemend::Main();
  } catch (const std::bad_alloc&) {
    return tilemend::kOutOfMemory;
  }
}
