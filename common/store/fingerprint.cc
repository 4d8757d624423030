#include "common/store/fingerprint.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"

namespace tilemend {

absl::StatusOr<std::string> FingerprintOf(const std::string& path) {
  constexpr int64_t kEnd = 64 << 10;
  TILEMEND_ASSIGN_OR_RETURN(const FileEnds ends, ReadFileEnds(path, kEnd));
  return Sha256Hex(absl::StrCat(ends.size, "\n", ends.first, ends.last));
}

absl::StatusOr<std::string> Sha256OfFile(const std::string& path) {
  Sha256 sha;
  TILEMEND_RETURN_IF_ERROR(ReadInPieces(path, 1 << 18, [&](std::string_view piece) { sha.Update(piece); }));
  return sha.FinishHex();
}

bool HaveSameContent(const std::string& a, const std::string& b) {
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error)) return true;
  if (error || std::filesystem::file_size(a, error) != std::filesystem::file_size(b, error) || error) return false;
  const auto digest = Sha256OfFile(a);
  return digest.ok() && Sha256OfFile(b).value_or("") == *digest;
}

}  // namespace tilemend
