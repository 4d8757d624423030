// Who may do what. Every RPC is in one table with the role that it needs. A caller has a name and roles by a token or
// by its certificate.
#ifndef TILEMEND_COORDINATOR_API_ACCESS_H_
#define TILEMEND_COORDINATOR_API_ACCESS_H_

#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "common/util/log.h"

namespace tilemend {

// kWatch may do what kScale may, kSubmit what kWatch may, kAdmin what kSubmit may; kWorker is apart. kAnybody needs no
// name.
enum class Role { kAnybody, kScale, kWatch, kSubmit, kAdmin, kWorker };

// "scale", "watch", "submit", "admin", "worker".
std::string_view RoleName(Role role);

struct RpcNeed {
  std::string_view rpc;  // "package.Service/Method"
  Role role;
};
// All RPCs that a coordinator answers.
const std::vector<RpcNeed>& RpcNeeds();
// kAdmin for one that is not in the table.
Role NeedOf(std::string_view rpc);

// Who calls, once that is known.
struct Caller {
  std::string name;
  std::set<Role> roles;
  // Whether it has this role or a greater one.
  bool May(Role role) const;
};

// What a call shows: see PeerClaims (common/rpc/credentials.h).
struct Claims {
  std::string certificate_name;
  std::vector<std::string> uris;  // alternative names of the certificate
  std::string token;
};

// A token as the coordinator knows it, by its SHA-256: whoever reads the file cannot call with it.
struct KnownToken {
  std::string name;
  std::set<Role> roles;
  absl::Time expires = absl::InfiniteFuture();
};

// Lines "NAME ROLE[,ROLE...] SHA256 [EXPIRES]"; EXPIRES as 2026-12-31T00:00:00Z; # begins a comment. By digest.
// kInvalidArgument names the line, and nothing of what stands in it.
absl::StatusOr<std::map<std::string, KnownToken>> ParseTokens(const std::string& text, const std::string& path);

// Thread-safe.
class Access {
 public:
  // Everybody may do everything: for a coordinator that listens on this machine, or in process, alone.
  static Access Open() { return Access(); }
  // A caller needs a certificate or a token of the file, if there is one ("" if not). By a certificate, its name is the
  // common name, and its roles are URIs tilemend:role:ROLE among the alternative names. A call with a token has the
  // token's name and roles alone. Returns kNotFound or kInvalidArgument for the file. The file is read again when it
  // changes. If it is no such file then, or cannot be read, nothing changes. The `log`, which outlives this, is told of
  // both.
  static absl::StatusOr<Access> Closed(const std::string& token_file, Log& log);

  // Returns kUnauthenticated (UNAUTHENTICATED) for a caller without a name, or with a token that is unknown or has
  // expired. Returns kPermissionDenied (ROLE_NEEDED) for one whose roles do not do.
  absl::StatusOr<Caller> Admit(std::string_view rpc, const Claims& claims, absl::Time now);

  Access(Access&& other) noexcept
      : closed_(other.closed_),
        token_file_(std::move(other.token_file_)),
        text_(std::move(other.text_)),
        log_(other.log_),
        tokens_(std::move(other.tokens_)) {}

 private:
  Access() = default;
  absl::StatusOr<Caller> Identify(const Claims& claims, absl::Time now);
  void Reload(absl::Time now);
  absl::Status ReadAgain();

  bool closed_ = false;
  std::string token_file_;
  std::string text_;   // that the tokens were read from
  std::string fault_;  // that was told last
  Log* log_ = Log::Null();
  std::mutex mutex_;
  absl::Time read_ = absl::InfinitePast();
  std::map<std::string, KnownToken> tokens_;  // by digest
};

}  // namespace tilemend

#endif  // TILEMEND_COORDINATOR_API_ACCESS_H_
