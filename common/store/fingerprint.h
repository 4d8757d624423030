// What a file looks like, without reading all of it.
#ifndef TILEMEND_COMMON_STORE_FINGERPRINT_H_
#define TILEMEND_COMMON_STORE_FINGERPRINT_H_

#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace tilemend {

// A SHA-256 over the size of a regular file and its first and last 64 KiB. It is the same on all machines that see the
// file, and for copies of it. Errors as ReadFile.
absl::StatusOr<std::string> FingerprintOf(const std::string& path);

// FileDigest of a whole file; holds a quarter of a MiB of it at a time. Errors as ReadFile.
absl::StatusOr<std::string> DigestOfFile(const std::string& path);

// HasFileDigest of a whole file, as DigestOfFile.
absl::StatusOr<bool> FileHasDigest(const std::string& path, std::string_view digest);

// Of a file of the input that is not as it was surveyed: kAborted.
absl::Status ChangedInJob(const std::string& path);

// Whether two regular files are there and have the same bytes. Two names of one file do without reading it.
bool HaveSameContent(const std::string& a, const std::string& b);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_STORE_FINGERPRINT_H_
