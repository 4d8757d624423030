#include "common/rpc/credentials.h"

#include <arpa/inet.h>
#include <grpc/grpc_security_constants.h>
#include <grpcpp/security/auth_context.h>
#include <grpcpp/security/tls_certificate_provider.h>
#include <grpcpp/security/tls_credentials_options.h>
#include <grpcpp/server_context.h>
#include <openssl/err.h>
#include <openssl/ssl.h>

#include <algorithm>
#include <string_view>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "common/util/files.h"
#include "common/util/status_macros.h"

namespace tilemend {
namespace {

namespace tls = grpc::experimental;

constexpr unsigned kReloadSeconds = 2;

FlagSpec InsecureFlag() { return {"insecure", "", "plain text beyond this machine, too", ""}; }

std::vector<FlagSpec> TlsFlags(const std::string& ca_help) {
  return {{"tls-cert", "FILE", "certificate of this program (PEM), read again when it changes", ""},
          {"tls-key", "FILE", "key of the certificate (PEM)", ""},
          {"tls-ca", "FILE", ca_help, ""}};
}

// What OpenSSL says last, and nothing of the file's content.
absl::Status TlsError(const std::string& path, const std::string& what) {
  const char* const reason = ERR_reason_error_string(ERR_peek_last_error());
  ERR_clear_error();
  return absl::InvalidArgumentError(
      absl::StrCat(path, ": ", what, reason == nullptr ? "" : ": ", reason == nullptr ? "" : reason));
}

// Nobody is asked for the key of a key: the program may have no terminal.
int NoPassword(char*, int, int, void*) { return 0; }

// `fault`: what is wrong if there is no TLS, and the flags for it.
absl::Status CheckPlaintext(const Security& security, const std::string& address, const char* fault) {
  if (!security.tls.empty() || security.plaintext || IsLoopback(address)) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(address, ": ", fault, ", or --insecure if the network is private"));
}

std::shared_ptr<tls::CertificateProviderInterface> Watch(const TlsFiles& files) {
  return std::make_shared<tls::FileWatcherCertificateProvider>(files.key, files.certificate, files.authority,
                                                               kReloadSeconds);
}

}  // namespace

absl::Status CheckTlsFiles(const TlsFiles& files, const TlsFiles& names) {
  for (const std::string& path : {files.certificate, files.key, files.authority}) {
    if (!path.empty()) TILEMEND_RETURN_IF_ERROR(ReadOwnFile(path).status());
  }
  const std::unique_ptr<SSL_CTX, void (*)(SSL_CTX*)> context(SSL_CTX_new(TLS_method()), SSL_CTX_free);
  SSL_CTX_set_default_passwd_cb(context.get(), NoPassword);
  if (!files.authority.empty() && SSL_CTX_load_verify_locations(context.get(), files.authority.c_str(), nullptr) != 1) {
    return TlsError(names.authority, "--tls-ca: no certificates of an authority");
  }
  if (files.certificate.empty() != files.key.empty()) {
    return absl::InvalidArgumentError("--tls-cert and --tls-key go together");
  }
  if (files.certificate.empty()) return absl::OkStatus();
  if (SSL_CTX_use_certificate_chain_file(context.get(), files.certificate.c_str()) != 1) {
    return TlsError(names.certificate, "--tls-cert: no certificate");
  }
  if (SSL_CTX_use_PrivateKey_file(context.get(), files.key.c_str(), SSL_FILETYPE_PEM) != 1 ||
      SSL_CTX_check_private_key(context.get()) != 1) {
    return TlsError(names.key, "--tls-key: not the key of the certificate");
  }
  return absl::OkStatus();
}

bool IsLoopback(const std::string& address) {
  const std::string host = address.substr(0, address.rfind(':'));
  in_addr number{};  // a name may begin with 127., too
  return host == "localhost" || host == "[::1]" ||
         (absl::StartsWith(host, "127.") && inet_pton(AF_INET, host.c_str(), &number) == 1);
}

std::vector<FlagSpec> ServerSecurityFlags() {
  std::vector<FlagSpec> flags = TlsFlags("authority whose certificates callers need (PEM)");
  flags.push_back(InsecureFlag());
  return flags;
}

std::vector<FlagSpec> ChannelSecurityFlags() {
  std::vector<FlagSpec> flags = TlsFlags("authority of the coordinator's certificate (PEM)");
  flags.push_back({"token-file", "FILE", "file with the token that says who calls", ""});
  flags.push_back(InsecureFlag());
  return flags;
}

Security SecurityFromFlags(const Flags& flags) {
  return {{flags.Text("tls-cert"), flags.Text("tls-key"), flags.Text("tls-ca")},
          flags.Text("token-file"),
          flags.Switch("insecure")};
}

absl::Status CheckServerSecurity(const Security& security, const std::string& address) {
  TILEMEND_RETURN_IF_ERROR(
      CheckPlaintext(security, address, "plain text would leave this machine; give --tls-cert and --tls-key"));
  if (!security.tls.authority.empty() && security.tls.certificate.empty()) {
    return absl::InvalidArgumentError("--tls-ca needs --tls-cert and --tls-key");
  }
  return CheckTlsFiles(security.tls, security.tls);
}

absl::Status CheckChannelSecurity(const Security& security, const std::string& address) {
  const char* const fault =
      security.token_file.empty()
          ? "plain text would leave this machine; give --tls-ca (and --tls-cert and --tls-key if the coordinator asks "
            "for a certificate)"
          : "--tls-ca is missing: without TLS the token would leave this machine in plain text; give --tls-ca";
  TILEMEND_RETURN_IF_ERROR(CheckPlaintext(security, address, fault));
  if (!security.token_file.empty()) TILEMEND_RETURN_IF_ERROR(ReadToken(security.token_file).status());
  return CheckTlsFiles(security.tls, security.tls);
}

absl::StatusOr<std::string> ReadToken(const std::string& file) {
  constexpr size_t kLongest = 4096;
  TILEMEND_ASSIGN_OR_RETURN(const std::string text, ReadOwnFile(file));
  std::string token(absl::StripAsciiWhitespace(text));
  const bool is_word = std::all_of(token.begin(), token.end(), [](unsigned char c) { return absl::ascii_isgraph(c); });
  if (is_word && !token.empty() && token.size() <= kLongest) return token;
  return absl::InvalidArgumentError(absl::StrCat(file, ": expected a token: one word of printable ASCII"));
}

std::shared_ptr<grpc::ServerCredentials> MakeServerCredentials(const TlsFiles& files) {
  if (files.empty()) return grpc::InsecureServerCredentials();
  tls::TlsServerCredentialsOptions options(Watch(files));
  options.watch_identity_key_cert_pairs();
  if (!files.authority.empty()) {
    options.watch_root_certs();
    options.set_cert_request_type(GRPC_SSL_REQUEST_AND_REQUIRE_CLIENT_CERTIFICATE_AND_VERIFY);
  }
  return tls::TlsServerCredentials(options);
}

std::shared_ptr<grpc::ChannelCredentials> MakeChannelCredentials(const TlsFiles& files) {
  if (files.empty()) return grpc::InsecureChannelCredentials();
  tls::TlsChannelCredentialsOptions options;
  options.set_certificate_provider(Watch(files));
  if (!files.authority.empty()) options.watch_root_certs();
  if (!files.certificate.empty()) options.watch_identity_key_cert_pairs();
  return tls::TlsCredentials(options);
}

PeerClaims ClaimsOf(const grpc::ServerContextBase& context) {
  constexpr absl::string_view kScheme = "Bearer ";
  PeerClaims claims;
  claims.address = context.peer();
  if (const auto auth = context.auth_context(); auth != nullptr && auth->IsPeerAuthenticated()) {
    for (const auto& name : auth->FindPropertyValues(GRPC_X509_CN_PROPERTY_NAME)) {
      claims.certificate_name.assign(name.data(), name.size());
    }
    // Of URIs alone: an authority that checks who owns a DNS name would sign any that looks like a role.
    for (const auto& uri : auth->FindPropertyValues(GRPC_PEER_URI_PROPERTY_NAME)) {
      claims.uris.emplace_back(uri.data(), uri.size());
    }
  }
  const auto& metadata = context.client_metadata();
  if (const auto found = metadata.find("authorization"); found != metadata.end()) {
    absl::string_view value(found->second.data(), found->second.size());
    if (absl::StartsWithIgnoreCase(value, kScheme)) claims.token = std::string(value.substr(kScheme.size()));
  }
  return claims;
}

}  // namespace tilemend
