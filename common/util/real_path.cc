#include "common/util/real_path.h"

#include <sys/stat.h>

#include <algorithm>
#include <string>
#include <system_error>

#include "common/util/object_store.h"

namespace tilemend {

namespace fs = std::filesystem;

fs::path RealPath(const fs::path& path) {
  if (IsObjectPath(path.string())) {
    const std::string normal = path.lexically_normal().string();  // has one slash for two
    return normal.substr(0, normal.find('/')) + "/" + normal.substr(normal.find('/'));
  }
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
  if (IsObjectPath(to.string()) != IsObjectPath(from.string())) return false;
  return place == RealPath(from) || place == RealPlace(from);
}

std::optional<FileId> IdOf(const fs::path& path) {
  struct stat info {};
  if (IsObjectPath(path.string()) || ::stat(path.c_str(), &info) != 0) return std::nullopt;
  return FileId(info.st_dev, info.st_ino);
}

bool IsBelow(const fs::path& folder, const fs::path& path) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

}  // namespace tilemend
