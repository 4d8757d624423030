// TLS for servers and channels, from files that may be replaced while the program runs, and what a call says of who
// makes it.
#ifndef TILEMEND_COMMON_RPC_CREDENTIALS_H_
#define TILEMEND_COMMON_RPC_CREDENTIALS_H_

#include <grpcpp/security/credentials.h>
#include <grpcpp/security/server_credentials.h>

#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/util/flags.h"

namespace grpc {
class ServerContextBase;
}

namespace tilemend {

// Paths of PEM files. All empty: no TLS.
struct TlsFiles {
  std::string certificate;  // of this program, followed by those between it and the authority
  std::string key;          // of the certificate
  // Whose certificates are trusted. A server with it refuses whoever has none of that authority; a channel without it
  // trusts the system's authorities.
  std::string authority;
  bool empty() const { return certificate.empty() && key.empty() && authority.empty(); }
};

// What one end of a connection brings along.
struct Security {
  TlsFiles tls;
  std::string token_file = {};  // of a channel: holds the token that goes with each call; "" none
  bool plaintext = false;       // without TLS beyond this machine, too
};

// Whether HOST of "HOST:PORT" is this machine alone.
bool IsLoopback(const std::string& address);

// --tls-cert, --tls-key, --tls-ca and --insecure; for channels --token-file as well.
std::vector<FlagSpec> ServerSecurityFlags();
std::vector<FlagSpec> ChannelSecurityFlags();
Security SecurityFromFlags(const Flags& flags);

// kInvalidArgument if a file of these is not what it should be, or key and certificate do not belong together; errors
// of ReadOwnFile. They speak of the files by the paths of `names`, and of nothing that stands in them.
absl::Status CheckTlsFiles(const TlsFiles& files, const TlsFiles& names);

// Returns kInvalidArgument if a file is missing or is not what it should be, or if key and certificate do not belong
// together. The same if plain text would leave this machine: `address` (HOST:PORT) is no loopback address, and there is
// neither TLS nor --insecure.
absl::Status CheckServerSecurity(const Security& security, const std::string& address);
absl::Status CheckChannelSecurity(const Security& security, const std::string& address);

// The token that a file holds, without the blanks around it. Returns kInvalidArgument unless it is one word of
// printable ASCII of at most 4096 letters: gRPC ends the process for a call with anything else. Errors of ReadOwnFile.
absl::StatusOr<std::string> ReadToken(const std::string& file);

// For files that passed the check. They are looked at again every few seconds: connections that are made later have
// the new certificates, those that are there go on.
std::shared_ptr<grpc::ServerCredentials> MakeServerCredentials(const TlsFiles& files);
std::shared_ptr<grpc::ChannelCredentials> MakeChannelCredentials(const TlsFiles& files);

// What a call shows of its maker. Nothing of it is checked but the certificate.
struct PeerClaims {
  std::string address;
  std::string certificate_name;   // the common name, "" without a certificate
  std::vector<std::string> uris;  // alternative names of the certificate
  std::string token;              // of "authorization: Bearer TOKEN"
};
PeerClaims ClaimsOf(const grpc::ServerContextBase& context);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_CREDENTIALS_H_
