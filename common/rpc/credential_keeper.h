// Certificates, keys and tokens as they last were in order. Programs that read such files again and again by themselves
// (gRPC, OpenSSL, the sender of tokens) read them here. A file that is replaced by something else, removed, or written
// just now changes nothing; the log says so.
#ifndef TILEMEND_COMMON_RPC_CREDENTIAL_KEEPER_H_
#define TILEMEND_COMMON_RPC_CREDENTIAL_KEEPER_H_

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/metrics/metrics.h"
#include "common/rpc/credentials.h"
#include "common/util/flags.h"
#include "common/util/log.h"

namespace tilemend {

// A text in memory at a path of the process's own, where it always stands whole. A new text takes the place of the old
// one in one step, and its file has another time of change. Not thread-safe but for those who read the file.
class KeptText {
 public:
  KeptText() = default;
  ~KeptText();
  KeptText(const KeptText&) = delete;
  KeptText& operator=(const KeptText&) = delete;
  // kUnavailable if the system gives no file in memory, or does not show it (/proc).
  absl::Status Put(std::string_view text);
  std::string path() const;  // "" before the first text

 private:
  int fd_ = -1;
  time_t changes_ = 0;
};

// Paths; "" where there is none.
struct CredentialFiles {
  TlsFiles tls = {};
  std::string token = {};          // goes with each call
  std::string metrics_token = {};  // that readers of the metrics show
};

// Of --tls-cert, --tls-key, --tls-ca, --token-file and, with --metrics, --metrics-token.
CredentialFiles CredentialFilesFromFlags(const Flags& flags);

// Costs a look at each file a second.
class CredentialKeeper {
 public:
  // Reads the files, and again until it ends. A certificate's end is a metric. `log` and `metrics` outlive it. Errors
  // of CheckTlsFiles and ReadToken.
  static absl::StatusOr<std::unique_ptr<CredentialKeeper>> Start(const CredentialFiles& files, Log& log,
                                                                 MetricsRegistry& metrics);
  ~CredentialKeeper();

  // Where they stand as they last were in order, as long as this lives. Certificate and key are one file.
  const CredentialFiles& kept() const { return kept_; }
  // Looks at the files now. Not beside the keeper's own thread: for tests, which stop it.
  void Look();
  void StopLooking();

 private:
  // One thing that is kept, of one file or several.
  struct Part {
    std::string name;  // for the log
    std::function<absl::Status()> read;
    std::string told = {};  // the last error
  };
  struct KeptWord {
    KeptText file;
    std::string word = {};
  };
  CredentialKeeper(const CredentialFiles& files, Log& log, MetricsRegistry& metrics);
  TlsFiles PathsOf(const KeptText& identity, const KeptText& authority) const;
  absl::Status ReadTls();
  absl::Status ReadWord(const std::string& file, KeptWord& kept);
  void TellOf(const std::string& certificate);
  // In the log, if all users of the machine may read a file that only the program should.
  void TellOfReaders(const std::string& file);
  void Run();

  const CredentialFiles files_;
  Log& log_;
  MetricsRegistry& metrics_;
  CredentialFiles kept_;
  std::vector<Part> parts_;
  KeptText identity_, authority_;
  std::string identity_text_, authority_text_;
  KeptWord token_, metrics_token_;

  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false;
  std::thread thread_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_CREDENTIAL_KEEPER_H_
