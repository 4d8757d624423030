#include "worker/service/attempt_files.h"

#include <algorithm>
#include <random>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"
#include "common/rpc/receipt_payloads.h"
#include "common/store/digest.h"
#include "common/store/file_receipt.h"
#include "common/store/fingerprint.h"
#include "common/util/cores.h"
#include "common/util/error_info.h"
#include "common/util/folders.h"
#include "common/util/object_store.h"
#include "common/util/real_path.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

std::string NewName() {
  std::random_device random;
  return absl::StrFormat("%08x%08x%08x%08x", random(), random(), random(), random());
}

// What is wrong with the place to write to is wrong on this machine; another may do better.
absl::Status OfThisMachine(const absl::Status& status) {
  if (status.ok() || absl::IsResourceExhausted(status)) return status;
  return WithErrorInfo(absl::UnavailableError(status.message()), {"FOLDER_NOT_SEEN", {}});
}

// Whether these are two names of one file, as a hard link is.
bool IsSameFile(const std::string& a, const std::string& b) {
  if (IsObjectPath(a) || IsObjectPath(b)) return false;
  const auto first = ReceiptOf(a), second = ReceiptOf(b);
  return first.ok() && second.ok() && *first == *second;
}

}  // namespace

AttemptFiles::AttemptFiles(std::string attempts, std::string output)
    : attempts_(std::move(attempts)), output_(std::move(output)), name_(NewName()) {}

AttemptFiles::~AttemptFiles() {
  for (const v1::WrittenFile& file : files_) RemoveFile(PathOf(file)).IgnoreError();
}

v1::WrittenFile AttemptFiles::NewFile(const std::string& path) const {
  v1::WrittenFile file;
  file.set_path(path);
  file.set_attempt(absl::StrCat(name_, "-", files_.size()));
  return file;
}

std::string AttemptFiles::PathOf(const v1::WrittenFile& file) const {
  return absl::StrCat(attempts_, "/", file.attempt());
}

absl::Status AttemptFiles::Add(v1::WrittenFile file) {
  const auto receipt = ReceiptOf(PathOf(file));
  if (!receipt.ok()) return OfThisMachine(receipt.status());
  *file.mutable_receipt() = ToProto(*receipt);
  files_.push_back(std::move(file));
  return absl::OkStatus();
}

absl::Status AttemptFiles::Write(const std::string& path, std::string_view bytes) {
  v1::WrittenFile file = NewFile(path);
  {
    const LentCore lent;
    TILEMEND_RETURN_IF_ERROR(OfThisMachine(WriteNewFile(PathOf(file), bytes)));
  }
  file.set_bytes(static_cast<int64_t>(bytes.size()));
  file.set_digest(FileDigest(bytes));
  return Add(std::move(file));
}

absl::Status AttemptFiles::Carry(const std::string& from, const std::string& path, ::tilemend::Carry how,
                                 const std::string& digest) {
  if (TakesThePlaceOf(from, absl::StrCat(output_, "/", path))) {
    return absl::InvalidArgumentError(absl::StrCat(from, ": would be written over itself"));
  }
  v1::WrittenFile file = NewFile(path);
  const auto size = [&] {
    const LentCore lent;
    return CarryToNewFile(from, PathOf(file), how);
  }();
  if (!size.ok()) {
    return CanWriteIn(attempts_) ? size.status() : OfThisMachine(size.status());
  }
  file.set_bytes(*size);
  file.set_carried(true);
  file.set_digest(digest);
  TILEMEND_RETURN_IF_ERROR(Add(std::move(file)));
  if (!digest.empty() || IsSameFile(from, PathOf(files_.back()))) return absl::OkStatus();
  const LentCore lent;
  TILEMEND_ASSIGN_OR_RETURN(*files_.back().mutable_digest(), DigestOfFile(PathOf(files_.back())));
  return absl::OkStatus();
}

bool AttemptFiles::LastHas(const std::string& digest) const {
  if (files_.empty()) return false;
  if (files_.back().digest() == digest) return true;
  const LentCore lent;
  return FileHasDigest(PathOf(files_.back()), digest).value_or(false);
}

std::vector<v1::WrittenFile> AttemptFiles::Keep() {
  std::vector<v1::WrittenFile> files = std::exchange(files_, {});
  std::reverse(files.begin(), files.end());
  return files;
}

void RemoveKept(Stage stage, const std::string& input_bytes, const std::string& output_bytes) {
  v1::AssembleInput input;
  v1::AssembleOutput output;
  if (stage != Stage::kAssemble || !input.ParseFromString(input_bytes) || !output.ParseFromString(output_bytes)) return;
  if (output.unchanged()) return;
  for (const v1::WrittenFile& file : output.files()) {
    RemoveFile(absl::StrCat(input.attempts(), "/", file.attempt())).IgnoreError();
  }
}

}  // namespace tilemend
