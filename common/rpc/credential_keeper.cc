#include "common/rpc/credential_keeper.h"

#include <fcntl.h>
#include <openssl/pem.h>
#include <openssl/x509.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "common/util/files.h"
#include "common/util/place.h"
#include "common/util/status_macros.h"
#include "common/util/utc.h"

namespace tilemend {
namespace {

constexpr std::chrono::seconds kInterval(1);

std::string PathOf(int fd) { return absl::StrCat("/proc/self/fd/", fd); }

absl::Status NotKept() {
  return absl::UnavailableError(absl::StrCat("cannot keep certificates in memory: ", std::strerror(errno)));
}

// Of the first certificate of a PEM text; the distant past if there is none.
absl::Time EndOf(const std::string& pem) {
  const std::unique_ptr<BIO, decltype(&BIO_free)> bio(BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())),
                                                      BIO_free);
  const std::unique_ptr<X509, decltype(&X509_free)> certificate(PEM_read_bio_X509(bio.get(), nullptr, nullptr, nullptr),
                                                                X509_free);
  std::tm end{};
  if (certificate == nullptr || ASN1_TIME_to_tm(X509_get0_notAfter(certificate.get()), &end) != 1) {
    return absl::InfinitePast();
  }
  return absl::FromTM(end, absl::UTCTimeZone());
}

absl::StatusOr<std::string> ReadIfNamed(const std::string& path) {
  return path.empty() ? absl::StatusOr<std::string>(std::string()) : ReadOwnFile(path);
}

}  // namespace

KeptText::~KeptText() {
  if (fd_ >= 0) close(fd_);
}

std::string KeptText::path() const { return fd_ < 0 ? "" : PathOf(fd_); }

absl::Status KeptText::Put(std::string_view text) {
  const Descriptor fresh(memfd_create("tilemend", MFD_CLOEXEC));
  const timespec times[2] = {{++changes_, 0}, {changes_, 0}};  // gRPC takes the same time for the same text
  if (fresh.get() < 0 || write(fresh.get(), text.data(), text.size()) != static_cast<ssize_t>(text.size()) ||
      futimens(fresh.get(), times) != 0) {
    return NotKept();
  }
  if (fd_ >= 0) return dup3(fresh.get(), fd_, O_CLOEXEC) < 0 ? NotKept() : absl::OkStatus();
  fd_ = fcntl(fresh.get(), F_DUPFD_CLOEXEC, 0);
  return fd_ < 0 || access(path().c_str(), R_OK) != 0 ? NotKept() : absl::OkStatus();
}

CredentialFiles CredentialFilesFromFlags(const Flags& flags) {
  const Security security = SecurityFromFlags(flags);
  return {security.tls, security.token_file, flags.IsGiven("metrics") ? flags.Text("metrics-token") : ""};
}

absl::StatusOr<std::unique_ptr<CredentialKeeper>> CredentialKeeper::Start(const CredentialFiles& files, Log& log,
                                                                          MetricsRegistry& metrics) {
  std::unique_ptr<CredentialKeeper> keeper(new CredentialKeeper(files, log, metrics));
  for (const Part& part : keeper->parts_) TILEMEND_RETURN_IF_ERROR(part.read());
  keeper->kept_ = {keeper->PathsOf(keeper->identity_, keeper->authority_), keeper->token_.file.path(),
                   keeper->metrics_token_.file.path()};
  if (!keeper->parts_.empty()) keeper->thread_ = std::thread([raw = keeper.get()] { raw->Run(); });
  return keeper;
}

CredentialKeeper::CredentialKeeper(const CredentialFiles& files, Log& log, MetricsRegistry& metrics)
    : files_(files), log_(log), metrics_(metrics) {
  if (!files.tls.empty()) parts_.push_back({"certificates", [this] { return ReadTls(); }});
  if (!files.token.empty()) {
    parts_.push_back({"token", [this] { return ReadWord(files_.token, token_); }});
  }
  if (!files.metrics_token.empty()) {
    parts_.push_back({"token of the metrics", [this] { return ReadWord(files_.metrics_token, metrics_token_); }});
  }
}

CredentialKeeper::~CredentialKeeper() { StopLooking(); }

void CredentialKeeper::StopLooking() {
  if (!thread_.joinable()) return;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    end_ = true;
  }
  ended_.notify_all();
  thread_.join();
}

void CredentialKeeper::Run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ended_.wait_for(lock, kInterval, [this] { return end_; })) {
    lock.unlock();
    Look();
    lock.lock();
  }
}

void CredentialKeeper::Look() {
  for (Part& part : parts_) {
    const std::string error(part.read().message());
    if (!error.empty() && error != part.told) {
      log_.Warn(part.name + " not read", {{"error", error}, {"in_use", "what was read before"}});
    }
    part.told = error;
  }
}

TlsFiles CredentialKeeper::PathsOf(const KeptText& identity, const KeptText& authority) const {
  return {files_.tls.certificate.empty() ? "" : identity.path(), files_.tls.key.empty() ? "" : identity.path(),
          files_.tls.authority.empty() ? "" : authority.path()};
}

absl::Status CredentialKeeper::ReadTls() {
  TILEMEND_ASSIGN_OR_RETURN(const std::string certificate, ReadIfNamed(files_.tls.certificate));
  TILEMEND_ASSIGN_OR_RETURN(const std::string key, ReadIfNamed(files_.tls.key));
  TILEMEND_ASSIGN_OR_RETURN(const std::string authority, ReadIfNamed(files_.tls.authority));
  const std::string identity = certificate == key ? certificate : absl::StrCat(certificate, "\n", key);
  if (identity == identity_text_ && authority == authority_text_) return absl::OkStatus();
  KeptText new_identity, new_authority;
  TILEMEND_RETURN_IF_ERROR(new_identity.Put(identity));
  TILEMEND_RETURN_IF_ERROR(new_authority.Put(authority));
  TILEMEND_RETURN_IF_ERROR(CheckTlsFiles(PathsOf(new_identity, new_authority), files_.tls));
  TILEMEND_RETURN_IF_ERROR(identity_.Put(identity));
  TILEMEND_RETURN_IF_ERROR(authority_.Put(authority));
  identity_text_ = identity;
  authority_text_ = authority;
  if (!certificate.empty()) TellOf(certificate);
  return absl::OkStatus();
}

void CredentialKeeper::TellOfReaders(const std::string& file) {
  struct stat info {};
  if (stat(file.c_str(), &info) == 0 && (info.st_mode & S_IROTH) != 0) log_.Warn("all may read", {{"file", file}});
}

void CredentialKeeper::TellOf(const std::string& certificate) {
  const absl::Time end = EndOf(certificate);
  metrics_.AddGauge("tilemend_certificate_expiry_timestamp_seconds", "When the program's certificate ends.", {})
      ->Set(absl::ToDoubleSeconds(end - absl::UnixEpoch()));
  log_.Write(end < absl::Now() ? LogLevel::kWarning : LogLevel::kInfo, "certificates read",
             {{"certificate", files_.tls.certificate}, {"expires", UtcText(end)}});
  TellOfReaders(files_.tls.key);
}

absl::Status CredentialKeeper::ReadWord(const std::string& file, KeptWord& kept) {
  TILEMEND_ASSIGN_OR_RETURN(const std::string word, ReadToken(file));
  if (word == kept.word) return absl::OkStatus();
  TILEMEND_RETURN_IF_ERROR(kept.file.Put(word));
  if (!kept.word.empty()) log_.Info("token read", {{"file", file}});
  kept.word = word;
  TellOfReaders(file);
  return absl::OkStatus();
}

}  // namespace tilemend
