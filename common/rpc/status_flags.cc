#include "common/rpc/status_flags.h"

#include <string>

#include "absl/strings/str_cat.h"
#include "common/rpc/credentials.h"
#include "common/rpc/endpoint.h"
#include "common/util/status_macros.h"

namespace tilemend {

std::vector<FlagSpec> StatusFlags() {
  return {{"metrics", "HOST:PORT", "serve /metrics, /healthz and /readyz on http://HOST:PORT", ""},
          {"metrics-tls", "", "on https://HOST:PORT, with --tls-cert and --tls-key", ""},
          {"metrics-token", "FILE", "file with the token that readers of /metrics show (Bearer)", ""}};
}

StatusSecurity StatusSecurityFromFlags(const Flags& flags, const CredentialFiles& files) {
  if (!flags.Switch("metrics-tls")) return {"", "", files.metrics_token};
  return {files.tls.certificate, files.tls.key, files.metrics_token};
}

absl::Status CheckStatusFlags(const Flags& flags) {
  if (!flags.IsGiven("metrics")) return absl::OkStatus();
  const std::string address = flags.Text("metrics");
  TILEMEND_RETURN_IF_ERROR(CheckAddress(address));
  const bool tls = flags.Switch("metrics-tls");
  if (tls && (flags.Text("tls-cert").empty() || flags.Text("tls-key").empty())) {
    return absl::InvalidArgumentError("--metrics-tls needs --tls-cert and --tls-key");
  }
  const std::string token = flags.Text("metrics-token");
  if (token.empty()) return absl::OkStatus();
  if (!tls && !flags.Switch("insecure") && !IsLoopback(address)) {
    return absl::InvalidArgumentError(
        absl::StrCat(address, ": the token would leave this machine in plain text; give --metrics-tls, or --insecure"));
  }
  return ReadToken(token).status();
}

}  // namespace tilemend
