// Where paths lead over links.
#ifndef TILEMEND_COMMON_UTIL_REAL_PATH_H_
#define TILEMEND_COMMON_UTIL_REAL_PATH_H_

#include <cstdint>
#include <filesystem>
#include <optional>
#include <utility>

namespace tilemend {

// The path without links, as far as it is there.
std::filesystem::path RealPath(const std::filesystem::path& path);

// The same, but what is named itself may be a link: where a file is put that is renamed to `path`.
std::filesystem::path RealPlace(const std::filesystem::path& path);

// Whether a file with the content of `from`, renamed to `to`, would take the place of `from`. That is either the file,
// or the link to it. A link at `to` is replaced itself.
bool TakesThePlaceOf(const std::filesystem::path& from, const std::filesystem::path& to);

// What names a file or folder by whatever path, as over a second mount of its folder: its device and number. None of
// what is not there or in a store.
using FileId = std::pair<uint64_t, uint64_t>;
std::optional<FileId> IdOf(const std::filesystem::path& path);

// Whether `path` is `folder` or lies below it. Both are real.
bool IsBelow(const std::filesystem::path& folder, const std::filesystem::path& path);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_REAL_PATH_H_
