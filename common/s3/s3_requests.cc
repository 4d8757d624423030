#include "common/s3/s3_requests.h"

#include <curl/curl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <random>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "common/s3/md5.h"
#include "common/s3/s3_answers.h"
#include "common/store/digest.h"
#include "common/util/error_info.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

constexpr size_t kMostAnswerBytes = size_t{16} << 20;  // a page of 1,000 keys of 1,024 bytes has less
constexpr absl::Duration kMostDelay = absl::Seconds(20);
constexpr long kSilentSeconds = 30;  // NOLINT(google-runtime-int): libcurl's type

// What curl's callbacks fill and read.
struct Exchange {
  std::string_view to_send;
  size_t sent = 0;
  int to_file = -1;
  bool file_failed = false;
  bool is_success = false;  // 2xx: the body is the object, else an error's text
  bool has_md5 = true;      // the ETag is the MD5 of the content: not with keys of Amazon's KMS or the caller's
  Md5 md5;
  S3Answer answer;
};

size_t TakeBody(char* bytes, size_t, size_t count, void* user) {
  Exchange& exchange = *static_cast<Exchange*>(user);
  if (exchange.to_file < 0 || !exchange.is_success) {
    if (exchange.answer.body.size() + count > kMostAnswerBytes) return 0;
    exchange.answer.body.append(bytes, count);
    return count;
  }
  exchange.md5.Update({bytes, count});
  size_t done = 0;
  while (done < count) {
    const ssize_t n = ::write(exchange.to_file, bytes + done, count - done);
    if (n < 0 && errno == EINTR) continue;
    exchange.file_failed = n <= 0;
    if (n <= 0) return 0;
    done += static_cast<size_t>(n);
  }
  return count;
}

size_t GiveBody(char* room, size_t, size_t count, void* user) {
  Exchange& exchange = *static_cast<Exchange*>(user);
  const size_t n = std::min(count, exchange.to_send.size() - exchange.sent);
  std::memcpy(room, exchange.to_send.data() + exchange.sent, n);
  exchange.sent += n;
  return n;
}

int SeekBody(void* user, curl_off_t offset, int origin) {
  if (origin != SEEK_SET) return CURL_SEEKFUNC_CANTSEEK;
  static_cast<Exchange*>(user)->sent = static_cast<size_t>(offset);
  return CURL_SEEKFUNC_OK;
}

size_t TakeHeader(char* bytes, size_t, size_t count, void* user) {
  Exchange& exchange = *static_cast<Exchange*>(user);
  const absl::string_view line = absl::StripAsciiWhitespace(absl::string_view(bytes, count));
  if (absl::StartsWith(line, "HTTP/")) exchange.is_success = line.find(" 2") != absl::string_view::npos;
  const size_t colon = line.find(':');
  if (colon == absl::string_view::npos) return count;
  const std::string name = absl::AsciiStrToLower(line.substr(0, colon));
  const std::string value(absl::StripAsciiWhitespace(line.substr(colon + 1)));
  if (name == "etag") exchange.answer.etag = UnquotedETag(value);
  if (name == "content-length" && !absl::SimpleAtoi(value, &exchange.answer.size)) exchange.answer.size = -1;
  if (name == "x-amz-server-side-encryption-customer-algorithm") exchange.has_md5 = false;
  if (name == "x-amz-server-side-encryption" && value != "AES256") exchange.has_md5 = false;
  return count;
}

// One for each thread: it keeps its connection from request to request.
CURL* HandleOfThread() {
  static const CURLcode ready = curl_global_init(CURL_GLOBAL_DEFAULT);
  thread_local const std::unique_ptr<CURL, decltype(&curl_easy_cleanup)> handle(
      ready == CURLE_OK ? curl_easy_init() : nullptr, &curl_easy_cleanup);
  if (handle) curl_easy_reset(handle.get());
  return handle.get();
}

class HeaderList {
 public:
  ~HeaderList() { curl_slist_free_all(list_); }
  void Add(const std::string& line) { list_ = curl_slist_append(list_, line.c_str()); }
  curl_slist* get() const { return list_; }

 private:
  curl_slist* list_ = nullptr;
};

void SetCommon(CURL* curl, const std::string& method, const std::string& url, Exchange& exchange) {
  curl_easy_setopt(curl, CURLOPT_URL, url.c_str());
  curl_easy_setopt(curl, CURLOPT_PATH_AS_IS, 1L);
  curl_easy_setopt(curl, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(curl, CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(curl, CURLOPT_WRITEFUNCTION, &TakeBody);
  curl_easy_setopt(curl, CURLOPT_WRITEDATA, &exchange);
  curl_easy_setopt(curl, CURLOPT_HEADERFUNCTION, &TakeHeader);
  curl_easy_setopt(curl, CURLOPT_HEADERDATA, &exchange);
  if (method == "HEAD") curl_easy_setopt(curl, CURLOPT_NOBODY, 1L);
  if (method != "HEAD" && method != "GET") curl_easy_setopt(curl, CURLOPT_CUSTOMREQUEST, method.c_str());
}

void SetBody(CURL* curl, Exchange& exchange) {
  curl_easy_setopt(curl, CURLOPT_UPLOAD, 1L);
  curl_easy_setopt(curl, CURLOPT_READFUNCTION, &GiveBody);
  curl_easy_setopt(curl, CURLOPT_READDATA, &exchange);
  curl_easy_setopt(curl, CURLOPT_SEEKFUNCTION, &SeekBody);
  curl_easy_setopt(curl, CURLOPT_SEEKDATA, &exchange);
  curl_easy_setopt(curl, CURLOPT_INFILESIZE_LARGE, static_cast<curl_off_t>(exchange.to_send.size()));
}

// To be called last: the headers are signed, too.
void Sign(CURL* curl, const S3Credentials& credentials, const std::string& region, HeaderList& headers) {
  // Seconds without a byte, not of the whole: large tiles over slow lines take their time.
  curl_easy_setopt(curl, CURLOPT_CONNECTTIMEOUT, 10L);
  curl_easy_setopt(curl, CURLOPT_LOW_SPEED_LIMIT, 1L);
  curl_easy_setopt(curl, CURLOPT_LOW_SPEED_TIME, kSilentSeconds);
  const std::string signing = absl::StrCat("aws:amz:", region, ":s3");
  curl_easy_setopt(curl, CURLOPT_AWS_SIGV4, signing.c_str());
  curl_easy_setopt(curl, CURLOPT_USERNAME, credentials.key_id.c_str());
  curl_easy_setopt(curl, CURLOPT_PASSWORD, credentials.secret.c_str());
  if (!credentials.session_token.empty()) {
    headers.Add(absl::StrCat("x-amz-security-token: ", credentials.session_token));
  }
  curl_easy_setopt(curl, CURLOPT_HTTPHEADER, headers.get());
}

// Whether an ETag is the MD5 of a content, which one of an object in parts is not.
bool IsMd5(const std::string& etag) {
  return etag.size() == 32 &&
         std::all_of(etag.begin(), etag.end(), [](unsigned char c) { return absl::ascii_isxdigit(c); });
}

absl::Status Unreachable(const std::string& path, const std::string& why) {
  return WithErrorInfo(absl::UnavailableError(absl::StrCat(Printable(path), ": ", why)),
                       {"OBJECT_STORE_UNREACHABLE", {}});
}

absl::Status Refused(const std::string& path, const std::string& why) {
  return WithErrorInfo(
      absl::PermissionDeniedError(absl::StrCat(Printable(path), ": the object store refuses it: ", why)),
      {"OBJECT_STORE_REFUSED", {}});
}

// Texts of a store: what it echoes of a request, as a key's id, is in the message alone, which is left out for 403.
absl::Status StatusOfAnswer(const std::string& path, long code, const S3Error& error) {  // NOLINT(google-runtime-int)
  const std::string what = absl::StrCat("HTTP ", code, error.code.empty() ? "" : " ", Printable(error.code));
  if (error.code == "NoSuchBucket") return absl::NotFoundError(absl::StrCat(Printable(path), ": no such bucket"));
  if (code == 404) return absl::NotFoundError(absl::StrCat(Printable(path), ": no such object"));
  if (code >= 500 || code == 429 || code == 408 || error.code == "RequestTimeout") {
    return Unreachable(path, absl::StrCat("the object store answers ", what));
  }
  if (error.code == "ExpiredToken") return Refused(path, what + "; the session token is over: renew the credentials");
  if (error.code == "RequestTimeTooSkewed") return Refused(path, what + "; set the clock of this machine");
  if (code == 301 || code == 307 || code == 400) {
    return Refused(path, absl::StrCat(what, "; is AWS_REGION the bucket's, and AWS_ENDPOINT_URL the store's?"));
  }
  return Refused(path, absl::StrCat(what, "; check the credentials, and their rights to this bucket"));
}

bool IsWorthAnotherTry(const absl::Status& status) { return absl::IsUnavailable(status); }

absl::Duration DelayBefore(int tried, absl::Duration unit) {
  thread_local std::minstd_rand random{std::random_device()()};
  const absl::Duration most = std::min(unit * (1 << std::min(tried, 10)), kMostDelay);
  return most * std::uniform_real_distribution<>(0, 1)(random);
}

// What is wrong with the content that came or went, judged by its MD5.
absl::Status CheckContent(const S3Request& request, const std::string& path, Exchange& exchange) {
  const bool sends_object = request.method == "PUT" && !request.body.empty();
  if (sends_object) exchange.md5.Update(request.body);
  if ((request.to_file < 0 && !sends_object) || !exchange.has_md5 || !IsMd5(exchange.answer.etag))
    return absl::OkStatus();
  if (absl::AsciiStrToLower(exchange.answer.etag) == exchange.md5.FinishHex()) return absl::OkStatus();
  return Unreachable(path, sends_object ? "the object store has other bytes than were sent"
                                        : "other bytes came than the object's checksum (ETag) says");
}

}  // namespace

struct S3Requests::Outcome {
  absl::Status status;
  S3Answer answer;
  bool is_expired = false;  // the credentials
};

S3Requests::Outcome S3Requests::Try(const S3Request& request, const std::string& path, const std::string& digest) {
  const auto credentials = credentials_.Get(absl::Now());
  if (!credentials.ok()) {
    const std::string text = absl::StrCat(Printable(path), ": ", std::string(credentials.status().message()));
    return {WithErrorInfo(absl::PermissionDeniedError(text), {"OBJECT_STORE_REFUSED", {}}), {}};
  }
  CURL* const curl = HandleOfThread();
  if (curl == nullptr) return {absl::ResourceExhaustedError("libcurl cannot start"), {}};
  if (request.to_file >= 0 && (::ftruncate(request.to_file, 0) != 0 || ::lseek(request.to_file, 0, SEEK_SET) != 0)) {
    return {absl::InternalError(absl::StrCat(path, ": cannot begin its local copy anew")), {}};
  }
  Exchange exchange;
  exchange.to_send = request.body;
  exchange.to_file = request.to_file;
  SetCommon(curl, request.method, UrlOf(address_, request.path, request.query), exchange);
  if (request.method == "PUT" || request.method == "POST") SetBody(curl, exchange);
  HeaderList headers;
  headers.Add(absl::StrCat("x-amz-content-sha256: ", digest));
  for (const std::string& header : request.headers) headers.Add(header);
  Sign(curl, *credentials, address_.region, headers);
  const CURLcode result = curl_easy_perform(curl);
  if (exchange.file_failed) {
    return {
        absl::ResourceExhaustedError(absl::StrCat(path, ": no room for its local copy; set TMPDIR to a larger disk")),
        {}};
  }
  if (result != CURLE_OK) return {Unreachable(path, curl_easy_strerror(result)), {}};
  long code = 0;  // NOLINT(google-runtime-int): libcurl's type
  curl_easy_getinfo(curl, CURLINFO_RESPONSE_CODE, &code);
  // A copy may fail after its 200 has been sent.
  const S3Error error = request.to_file >= 0 && exchange.is_success ? S3Error{} : ErrorInAnswer(exchange.answer.body);
  if (error.code == "ExpiredToken") credentials_.Forget();
  if (code / 100 == 2 && !error.code.empty()) code = 500;
  if (code / 100 != 2) return {StatusOfAnswer(path, code, error), {}, error.code == "ExpiredToken"};
  absl::Status checked = CheckContent(request, path, exchange);
  return {std::move(checked), std::move(exchange.answer)};
}

absl::StatusOr<S3Answer> S3Requests::Send(const S3Request& request, const std::string& path) {
  const std::string digest = Sha256Hex(request.body);
  bool is_renewed = false;
  for (int tried = 1;; ++tried) {
    Outcome outcome = Try(request, path, digest);
    if (outcome.status.ok()) return std::move(outcome.answer);
    if (outcome.is_expired && !std::exchange(is_renewed, true)) continue;  // there may be new ones
    if (!IsWorthAnotherTry(outcome.status)) return outcome.status;
    if (tried >= patience_.tries) {
      return Unreachable(path, absl::StrCat(std::string(outcome.status.message()).substr(Printable(path).size() + 2),
                                            " (", tried, " tries)"));
    }
    absl::SleepFor(DelayBefore(tried, patience_.unit));
  }
}

std::optional<std::string> AskService(const ServiceRequest& request) {
  CURL* const curl = HandleOfThread();
  if (curl == nullptr) return std::nullopt;
  Exchange exchange;
  exchange.to_send = request.body;
  SetCommon(curl, request.method, request.url, exchange);
  if (request.method != "GET") SetBody(curl, exchange);
  HeaderList headers;
  if (!request.header.empty()) headers.Add(request.header);
  curl_easy_setopt(curl, CURLOPT_HTTPHEADER, headers.get());
  curl_easy_setopt(curl, CURLOPT_CONNECTTIMEOUT, request.is_near ? 1L : 10L);
  curl_easy_setopt(curl, CURLOPT_TIMEOUT, request.is_near ? 5L : kSilentSeconds);
  if (request.is_near) curl_easy_setopt(curl, CURLOPT_PROXY, "");
  long code = 0;  // NOLINT(google-runtime-int): libcurl's type
  if (curl_easy_perform(curl) != CURLE_OK) return std::nullopt;
  curl_easy_getinfo(curl, CURLINFO_RESPONSE_CODE, &code);
  if (code != 200) return std::nullopt;
  return std::move(exchange.answer.body);
}

}  // namespace tilemend
