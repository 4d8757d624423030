#include "common/s3/s3_store.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "common/s3/local_copies.h"
#include "common/s3/s3_answers.h"
#include "common/s3/s3_parts.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

// Source: Amazon S3 user guide, "Amazon S3 multipart upload limits".
constexpr int64_t kMostObjectBytes = int64_t{5} << 40;
constexpr int64_t kLeastPartMegabytes = 5;
constexpr int64_t kMostPartMegabytes = 5120;

class S3Store : public ObjectStore {
 public:
  S3Store(const Environment& environment, S3Limits limits, S3Patience patience)
      : requests_(environment, patience), copies_("", limits.most_copied), part_bytes_(limits.part_bytes) {}

  absl::StatusOr<ObjectLook> Look(const std::string& path) override {
    TILEMEND_ASSIGN_OR_RETURN(const S3Path object, ParseS3Path(path));
    if (object.key.empty()) return absl::NotFoundError(absl::StrCat(path, ": a bucket, not an object"));
    const auto answer = requests_.Send({"HEAD", object}, path);
    if (absl::IsPermissionDenied(answer.status())) return WhyRefused(object, path, answer.status());
    TILEMEND_RETURN_IF_ERROR(answer.status());
    return ObjectLook{answer->size, answer->etag};
  }

  absl::StatusOr<int> Open(const std::string& path) override {
    TILEMEND_ASSIGN_OR_RETURN(const ObjectLook look, Look(path));
    if (const int kept = copies_.Find(NameOfCopy(path, look)); kept >= 0) return kept;
    TILEMEND_ASSIGN_OR_RETURN(const S3Path object, ParseS3Path(path));
    TILEMEND_ASSIGN_OR_RETURN(const int file, copies_.NewFile());
    S3Request request{"GET", object};
    request.to_file = file;
    const auto answer = requests_.Send(request, path);
    if (!answer.ok()) {
      ::close(file);
      return answer.status();
    }
    const int64_t size = ::lseek(file, 0, SEEK_CUR);
    copies_.Keep(NameOfCopy(path, {size, answer->etag}), file, size);
    return file;
  }

  absl::Status Put(const std::string& path, std::string_view bytes) override {
    TILEMEND_ASSIGN_OR_RETURN(const S3Path object, ParseObject(path));
    const auto size = static_cast<int64_t>(bytes.size());
    TILEMEND_RETURN_IF_ERROR(CheckSize(path, size));
    if (size > part_bytes_) return PutInParts(requests_, object, path, bytes, PartBytes(size, part_bytes_));
    S3Request request{"PUT", object};
    request.body = bytes;
    return requests_.Send(request, path).status();
  }

  absl::Status Copy(const std::string& from, const ObjectLook& look, const std::string& to) override {
    TILEMEND_ASSIGN_OR_RETURN(const S3Path source, ParseObject(from));
    TILEMEND_ASSIGN_OR_RETURN(const S3Path object, ParseObject(to));
    const std::string name = absl::StrCat(from, " to ", to);
    if (look.size > part_bytes_) {
      return CopyInParts(requests_, source, look, object, name, PartBytes(look.size, part_bytes_));
    }
    S3Request request{"PUT", object};
    request.headers = {CopySource(source)};
    return requests_.Send(request, name).status();
  }

  absl::Status Remove(const std::string& path) override {
    TILEMEND_ASSIGN_OR_RETURN(const S3Path object, ParseObject(path));
    const absl::Status status = requests_.Send({"DELETE", object}, path).status();
    return absl::IsNotFound(status) ? absl::OkStatus() : status;
  }

  absl::StatusOr<std::vector<ObjectEntry>> List(const std::string& folder) override {
    TILEMEND_ASSIGN_OR_RETURN(const S3Path below, ParseS3Path(folder));
    const std::string prefix = below.key.empty() ? "" : below.key + "/";
    std::vector<ObjectEntry> entries;
    bool has_any = below.key.empty();  // a bucket is there without an object, too
    std::map<std::string, std::string> query = {{"delimiter", "/"}, {"list-type", "2"}, {"prefix", prefix}};
    do {
      TILEMEND_ASSIGN_OR_RETURN(const S3Answer answer,
                                requests_.Send({.method = "GET", .path = {below.bucket, ""}, .query = query}, folder));
      TILEMEND_ASSIGN_OR_RETURN(S3Page page, ReadListing(answer.body, prefix));
      std::move(page.entries.begin(), page.entries.end(), std::back_inserter(entries));
      query["continuation-token"] = page.next;
    } while (!query["continuation-token"].empty());
    has_any = has_any || !entries.empty();
    if (!has_any) return absl::NotFoundError(absl::StrCat(folder, ": no object there, or below it"));
    std::sort(entries.begin(), entries.end(),
              [](const ObjectEntry& a, const ObjectEntry& b) { return a.name < b.name; });
    return entries;
  }

 private:
  // The answer to a HEAD has no body, and so no reason. That to a GET has.
  absl::Status WhyRefused(const S3Path& object, const std::string& path, const absl::Status& refused) {
    TILEMEND_ASSIGN_OR_RETURN(const int file, copies_.NewFile());
    S3Request request{"GET", object};
    request.to_file = file;  // if it is not refused after all
    const absl::Status status = requests_.Send(request, path).status();
    ::close(file);
    return status.ok() ? refused : status;
  }

  static std::string NameOfCopy(const std::string& path, const ObjectLook& look) {
    return absl::StrCat(look.etag, " ", look.size, " ", path);
  }

  static absl::StatusOr<S3Path> ParseObject(const std::string& path) {
    TILEMEND_ASSIGN_OR_RETURN(S3Path object, ParseS3Path(path));
    if (!object.key.empty()) return object;
    return absl::InvalidArgumentError(absl::StrCat(path, ": a bucket, not an object"));
  }

  static absl::Status CheckSize(const std::string& path, int64_t bytes) {
    if (bytes <= kMostObjectBytes) return absl::OkStatus();
    return absl::InvalidArgumentError(absl::StrCat(path, ": ", bytes, " bytes, but an object has at most 5 TiB"));
  }

  S3Requests requests_;
  LocalCopies copies_;
  const int64_t part_bytes_;
};

// Sets `bytes` to what the variable `name` says, if it is set.
absl::Status ReadMegabytes(const char* name, int64_t least, int64_t most, int64_t& bytes) {
  const std::string given = ValueOf(std::getenv, name);
  if (given.empty()) return absl::OkStatus();
  int64_t megabytes = 0;
  if (!absl::SimpleAtoi(given, &megabytes) || megabytes < least || megabytes > most) {
    return absl::InvalidArgumentError(
        absl::StrCat(name, " '", given, "': expected a number of MB from ", least, " to ", most));
  }
  bytes = megabytes << 20;
  return absl::OkStatus();
}

}  // namespace

std::unique_ptr<ObjectStore> NewS3Store(const Environment& environment, S3Limits limits, S3Patience patience) {
  return std::make_unique<S3Store>(environment, limits, patience);
}

absl::Status UseS3() {
  S3Limits limits;
  TILEMEND_RETURN_IF_ERROR(ReadMegabytes("TILEMEND_S3_CACHE_MB", 0, int64_t{1} << 40, limits.most_copied));
  TILEMEND_RETURN_IF_ERROR(
      ReadMegabytes("TILEMEND_S3_PART_MB", kLeastPartMegabytes, kMostPartMegabytes, limits.part_bytes));
  UseObjects(NewS3Store(std::getenv, limits));
  return absl::OkStatus();
}

}  // namespace tilemend
