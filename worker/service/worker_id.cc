#include "worker/service/worker_id.h"

#include <unistd.h>

#include <array>
#include <random>

#include "absl/strings/str_format.h"

namespace tilemend {

std::string NewWorkerId() {
  std::array<char, 256> host{};
  if (gethostname(host.data(), host.size() - 1) != 0) host[0] = '?';
  return absl::StrFormat("%s-%d-%06x", host.data(), getpid(), std::random_device()() & 0xffffff);
}

std::string NewSecret() {
  std::random_device random;
  return absl::StrFormat("%08x%08x%08x%08x", random(), random(), random(), random());
}

}  // namespace tilemend
