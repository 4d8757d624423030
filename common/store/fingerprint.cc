#include "common/store/fingerprint.h"

#include <filesystem>
#include <system_error>

#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "common/util/files.h"
#include "common/util/object_store.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

template <typename Hash>
absl::StatusOr<std::string> DigestBy(const std::string& path) {
  Hash hash;
  TILEMEND_RETURN_IF_ERROR(ReadInPieces(path, 1 << 18, [&](std::string_view piece) { hash.Update(piece); }));
  return hash.FinishHex();
}

}  // namespace

absl::StatusOr<std::string> FingerprintOf(const std::string& path) {
  constexpr int64_t kEnd = 64 << 10;
  TILEMEND_ASSIGN_OR_RETURN(const FileEnds ends, ReadFileEnds(path, kEnd));
  return Sha256Hex(absl::StrCat(ends.size, "\n", ends.first, ends.last));
}

absl::StatusOr<std::string> DigestOfFile(const std::string& path) { return DigestBy<FileHash>(path); }

absl::StatusOr<bool> FileHasDigest(const std::string& path, std::string_view digest) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string own, IsDigest(digest) ? DigestBy<Sha256>(path) : DigestOfFile(path));
  return own == digest;
}

absl::Status ChangedInJob(const std::string& path) {
  return absl::AbortedError(absl::StrCat(path, ": changed while the job ran; run the job again"));
}

bool HaveSameContent(const std::string& a, const std::string& b) {
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error)) return true;
  const bool in_store = IsObjectPath(a) || IsObjectPath(b);
  if (!in_store && (error || std::filesystem::file_size(a, error) != std::filesystem::file_size(b, error) || error))
    return false;
  const auto digest = DigestOfFile(a);
  return digest.ok() && DigestOfFile(b).value_or("") == *digest;
}

}  // namespace tilemend
