// Flags of a program that shows its metrics.
#ifndef TILEMEND_COMMON_RPC_STATUS_FLAGS_H_
#define TILEMEND_COMMON_RPC_STATUS_FLAGS_H_

#include <vector>

#include "absl/status/status.h"
#include "common/metrics/status_server.h"
#include "common/rpc/credential_keeper.h"
#include "common/util/flags.h"

namespace tilemend {

// --metrics, --metrics-tls and --metrics-token, beside those of credentials.h.
std::vector<FlagSpec> StatusFlags();

// What is served how, with files of `files`.
StatusSecurity StatusSecurityFromFlags(const Flags& flags, const CredentialFiles& files);

// kInvalidArgument if the address is malformed, the certificate or the token is missing, or the token would be shown in
// plain text beyond this machine.
absl::Status CheckStatusFlags(const Flags& flags);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_STATUS_FLAGS_H_
