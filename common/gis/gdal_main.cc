// tilemend-gdal: reads one vector file, or looks at one CRS, in a process of its own (gdal_process.h). Its input is a
// request, its output the answer.
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include "common/gis/package_writing.h"
#include "common/gis/vector_file.h"
#include "common/gis/vector_message.h"

namespace tilemend {
namespace {

constexpr int kOutOfMemory = 1;

// Limits, far above what files take (300,000 polygons of GeoJSON, 60 MB: 5 s), and below what anyone waits for: the
// DXF driver of GDAL 3.6 never ends on some drawings that are cut off.
constexpr rlim_t kBaseBytes = rlim_t{2} << 30;  // of address space: GDAL's libraries alone take 0.6 GB
constexpr rlim_t kBytesForAByte = 64;
constexpr rlim_t kBaseSeconds = 20;
constexpr rlim_t kBytesForASecond = 1 << 18;

void Limit(decltype(RLIMIT_AS) what, rlim_t most) {
  rlimit limit{};
  ::getrlimit(what, &limit);
  if (limit.rlim_max < most) return;  // RLIM_INFINITY is the largest
  limit = {most, most};
  ::setrlimit(what, &limit);
}

void LimitFor(size_t bytes) {
#ifndef __SANITIZE_ADDRESS__  // whose shadow of memory takes terabytes of address space
  Limit(RLIMIT_AS, kBaseBytes + kBytesForAByte * bytes);
#endif
  Limit(RLIMIT_CPU, kBaseSeconds + bytes / kBytesForASecond);
}

// A process that nothing can be got out of: no network (where users may have a namespace), no files, no core.
void Confine() {
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  (void)::unshare(CLONE_NEWUSER | CLONE_NEWNET);  // refused in some containers
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
