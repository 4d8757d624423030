#include "common/gis/vector_bytes.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "common/gis/gdal_limits.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr char kGeodatabase[] = ".gdb";

// Which files belong to a file with this suffix: those with the same stem.
struct Family {
  std::string_view suffix;
  std::array<std::string_view, 4> others;
};
constexpr std::array<Family, 4> kFamilies = {{{".shp", {".dbf", ".shx", ".prj", ".cpg"}},
                                              {".tab", {".dat", ".map", ".id", ".ind"}},
                                              {".mif", {".mid"}},
                                              {".gml", {".xsd"}}}};

std::string SuffixOf(const std::filesystem::path& path) { return absl::AsciiStrToLower(path.extension().string()); }

absl::StatusOr<std::vector<std::filesystem::path>> FilesIn(const std::filesystem::path& folder) {
  std::error_code error;
  std::vector<std::filesystem::path> files;
  for (auto it = std::filesystem::directory_iterator(folder, error); !error && it != std::filesystem::end(it);
       it.increment(error)) {
    if (it->is_regular_file(error)) files.push_back(it->path());
  }
  if (error) return absl::InternalError(absl::StrCat(folder.string(), ": ", error.message()));
  std::sort(files.begin(), files.end());
  return files;
}

// Reads one more file of those that belong together.
absl::StatusOr<std::string> ReadPart(const std::string& path, const VectorBytes& read) {
  int64_t size = std::ssize(read.bytes);
  for (const SideFile& side : read.beside) size += std::ssize(side.bytes);
  return ReadFileUpTo(path, kMostVectorBytes - size);
}

absl::StatusOr<VectorBytes> ReadGeodatabase(const std::string& path) {
  VectorBytes read;
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<std::filesystem::path> files, FilesIn(path));
  for (const std::filesystem::path& file : files) {
    TILEMEND_ASSIGN_OR_RETURN(std::string bytes, ReadPart(file.string(), read));
    read.beside.push_back({file.filename().string(), std::move(bytes)});
  }
  return read;
}

absl::Status AddSideFiles(const std::filesystem::path& path, const Family& family, VectorBytes& read) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  TILEMEND_ASSIGN_OR_RETURN(const std::vector<std::filesystem::path> files, FilesIn(folder));
  for (const std::string_view other : family.others) {
    const auto file = std::find_if(files.begin(), files.end(), [&](const std::filesystem::path& candidate) {
      return !other.empty() && candidate.stem() == path.stem() && SuffixOf(candidate) == other;
    });
    if (file == files.end()) continue;
    TILEMEND_ASSIGN_OR_RETURN(std::string bytes, ReadPart(file->string(), read));
    read.beside.push_back({std::string(other.substr(1)), std::move(bytes)});
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<VectorBytes> ReadAreaFile(const std::string& path) {
  if (path.find('\0') != std::string::npos) {
    return absl::InvalidArgumentError(absl::StrCat(Printable(path), ": is no path: it has a NUL"));
  }
  if (path.find("://") != std::string::npos) {
    return absl::InvalidArgumentError(absl::StrCat(path, ": a URL; download the file first"));
  }
  std::error_code error;
  if (std::filesystem::is_directory(path, error) && SuffixOf(std::filesystem::path(path)) == kGeodatabase) {
    return ReadGeodatabase(path);
  }
  const std::string log = path + "-wal";
  if (const auto size = std::filesystem::file_size(log, error); !error && size > 0) {
    return absl::InvalidArgumentError(absl::StrCat(path, ": has changes that are still in ", log,
                                                   "; close the program that has it open, or save to another file"));
  }
  VectorBytes read;
  TILEMEND_ASSIGN_OR_RETURN(read.bytes, ReadPart(path, read));
  const auto family = std::ranges::find(kFamilies, SuffixOf(std::filesystem::path(path)), &Family::suffix);
  if (family != kFamilies.end()) TILEMEND_RETURN_IF_ERROR(AddSideFiles(path, *family, read));
  return read;
}

std::string ContentOf(const VectorBytes& file) {
  std::string content = file.bytes;
  for (const SideFile& side : file.beside) {
    absl::StrAppend(&content, "\n", side.name, " ", side.bytes.size(), "\n", side.bytes);
  }
  return content;
}

}  // namespace tilemend
