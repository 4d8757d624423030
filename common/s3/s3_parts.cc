#include "common/s3/s3_parts.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "common/s3/md5.h"
#include "common/s3/s3_answers.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

constexpr int64_t kMostParts = 10000;
constexpr const char* kOfUpload[] = {"InitiateMultipartUploadResult"};
constexpr const char* kOfCopy[] = {"CopyPartResult"};

// One part of an upload: the request for it, but for its query.
using PartRequest = std::function<S3Request(int64_t first, int64_t bytes)>;

// One upload, from its beginning to the finished object.
class Upload {
 public:
  Upload(S3Requests& requests, const S3Path& object, const std::string& name)
      : requests_(requests), object_(object), name_(name) {}

  absl::Status Begin() {
    TILEMEND_ASSIGN_OR_RETURN(const S3Answer answer,
                              requests_.Send({.method = "POST", .path = object_, .query = {{"uploads", ""}}}, name_));
    id_ = TextInAnswer(answer.body, kOfUpload, "UploadId");
    return id_.empty() ? absl::DataLossError(absl::StrCat(name_, ": the store does not name the upload"))
                       : absl::OkStatus();
  }

  absl::Status SendParts(int64_t bytes, int64_t part_bytes, const PartRequest& part) {
    for (int64_t first = 0; first < bytes; first += part_bytes) {
      S3Request request = part(first, std::min(part_bytes, bytes - first));
      request.query = {{"partNumber", absl::StrCat(etags_.size() + 1)}, {"uploadId", id_}};
      TILEMEND_ASSIGN_OR_RETURN(const S3Answer answer, requests_.Send(request, name_));
      etags_.push_back(request.body.empty() ? ETagIn(answer.body) : answer.etag);
      if (etags_.back().empty()) return absl::DataLossError(absl::StrCat(name_, ": the store names no ETag of a part"));
    }
    return absl::OkStatus();
  }

  // `whole` tells the ETag of the whole content, where that is one.
  absl::Status Finish(const std::function<std::string()>& whole) {
    std::string body = "<CompleteMultipartUpload>";
    for (size_t i = 0; i < etags_.size(); ++i) {
      absl::StrAppend(&body, "<Part><PartNumber>", i + 1, "</PartNumber><ETag>\"", etags_[i], "\"</ETag></Part>");
    }
    absl::StrAppend(&body, "</CompleteMultipartUpload>");
    S3Request request{.method = "POST", .path = object_, .query = {{"uploadId", id_}}};
    request.body = body;
    absl::Status status = requests_.Send(request, name_).status();
    if (status.ok()) return status;
    // Where only the answer was lost, another try finds no upload.
    const auto look = requests_.Send({"HEAD", object_}, name_);
    const bool is_there = look.ok() && (look->etag == ETagOfParts() || look->etag == whole());
    return is_there ? absl::OkStatus() : status;
  }

  void GiveUp() { requests_.Send({"DELETE", object_, {{"uploadId", id_}}}, name_).IgnoreError(); }

 private:
  static std::string ETagIn(const std::string& body) { return UnquotedETag(TextInAnswer(body, kOfCopy, "ETag")); }

  std::string ETagOfParts() const {
    Md5 md5;
    for (const std::string& etag : etags_) md5.Update(absl::HexStringToBytes(etag));
    return absl::StrCat(md5.FinishHex(), "-", etags_.size());
  }

  S3Requests& requests_;
  const S3Path object_;
  const std::string name_;
  std::string id_;
  std::vector<std::string> etags_;
};

absl::Status SendInParts(Upload upload, int64_t bytes, int64_t part_bytes, const PartRequest& part,
                         const std::function<std::string()>& whole) {
  TILEMEND_RETURN_IF_ERROR(upload.Begin());
  absl::Status status = upload.SendParts(bytes, part_bytes, part);
  if (status.ok()) status = upload.Finish(whole);
  if (!status.ok()) upload.GiveUp();
  return status;
}

}  // namespace

int64_t PartBytes(int64_t object_bytes, int64_t wanted) {
  return std::max(wanted, (object_bytes + kMostParts - 1) / kMostParts);
}

absl::Status PutInParts(S3Requests& requests, const S3Path& object, const std::string& name, std::string_view bytes,
                        int64_t part_bytes) {
  const auto part = [&](int64_t first, int64_t count) {
    S3Request request{.method = "PUT", .path = object};
    request.body = bytes.substr(static_cast<size_t>(first), static_cast<size_t>(count));
    return request;
  };
  const auto whole = [&] {
    Md5 md5;
    md5.Update(bytes);
    return md5.FinishHex();
  };
  return SendInParts(Upload(requests, object, name), static_cast<int64_t>(bytes.size()), part_bytes, part, whole);
}

absl::Status CopyInParts(S3Requests& requests, const S3Path& from, const ObjectLook& look, const S3Path& to,
                         const std::string& name, int64_t part_bytes) {
  const auto part = [&](int64_t first, int64_t count) {
    S3Request request{.method = "PUT", .path = to};
    request.headers = {CopySource(from), absl::StrCat("x-amz-copy-source-range: bytes=", first, "-", first + count - 1),
                       absl::StrCat("x-amz-copy-source-if-match: ", look.etag)};
    return request;
  };
  return SendInParts(Upload(requests, to, name), look.size, part_bytes, part, [&] { return look.etag; });
}

}  // namespace tilemend
