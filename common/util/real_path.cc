#include "common/util/real_path.h"

#include <algorithm>
#include <system_error>

namespace tilemend {

namespace fs = std::filesystem;

fs::path RealPath(const fs::path& path) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path, error);
  return error ? path.lexically_normal() : real;
}

fs::path RealPlace(const fs::path& path) {
  const fs::path folder = path.parent_path();
  return RealPath(folder.empty() ? "." : folder) / path.filename();
}

bool TakesThePlaceOf(const fs::path& from, const fs::path& to) {
  const fs::path place = RealPlace(to);
  return place == RealPath(from) || place == RealPlace(from);
}

bool IsBelow(const fs::path& folder, const fs::path& path) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace tilemend
