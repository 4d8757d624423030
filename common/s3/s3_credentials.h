// Who the program is to an S3 store.
#ifndef TILEMEND_COMMON_S3_S3_CREDENTIALS_H_
#define TILEMEND_COMMON_S3_S3_CREDENTIALS_H_

#include <mutex>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "common/s3/s3_address.h"

namespace tilemend {

// Secrets: never in a log, an error or a report.
struct S3Credentials {
  std::string key_id, secret;
  std::string session_token;  // "" for keys that last
};

// Those of `profile` in a file as ~/.aws/credentials; nullopt if it has none.
std::optional<S3Credentials> CredentialsInFile(const std::string& text, const std::string& profile);

// What the service of a machine's role answers, and until when it holds. nullopt if it is no such answer.
struct RoleCredentials {
  S3Credentials credentials;
  absl::Time expires;
  absl::Time renew;  // from then on new ones are asked for
};
std::optional<RoleCredentials> CredentialsOfRole(const std::string& json);

// Gives the first that there is of:
//  1. AWS_ACCESS_KEY_ID, AWS_SECRET_ACCESS_KEY, AWS_SESSION_TOKEN;
//  2. the profile AWS_PROFILE (default) of AWS_SHARED_CREDENTIALS_FILE (~/.aws/credentials), read again each minute;
//  3. the role of the machine by IMDSv2 at AWS_EC2_METADATA_SERVICE_ENDPOINT, unless AWS_EC2_METADATA_DISABLED is true;
//     asked for again five minutes before they expire. Until then the old ones are used if that fails.
// Thread-safe.
class S3CredentialSource {
 public:
  explicit S3CredentialSource(Environment environment) : environment_(std::move(environment)) {}
  // kPermissionDenied (OBJECT_STORE_REFUSED) says where was looked.
  absl::StatusOr<S3Credentials> Get(absl::Time now);
  // The store says that they have expired: the next Get looks again.
  void Forget();

 private:
  absl::StatusOr<RoleCredentials> Find(absl::Time now) const;
  std::optional<RoleCredentials> AskRole() const;

  const Environment environment_;
  std::mutex mutex_;
  std::optional<RoleCredentials> found_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_S3_S3_CREDENTIALS_H_
