// Who the program is to an S3 store.
#ifndef TILEMEND_COMMON_S3_S3_CREDENTIALS_H_
#define TILEMEND_COMMON_S3_S3_CREDENTIALS_H_

#include <mutex>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "common/s3/s3_address.h"
#include "common/s3/s3_roles.h"

namespace tilemend {

// Those of `profile` in a file as ~/.aws/credentials; nullopt if it has none.
std::optional<S3Credentials> CredentialsInFile(const std::string& text, const std::string& profile);

// Gives the first that there is of:
//  1. AWS_ACCESS_KEY_ID, AWS_SECRET_ACCESS_KEY, AWS_SESSION_TOKEN;
//  2. the profile AWS_PROFILE (default) of AWS_SHARED_CREDENTIALS_FILE (~/.aws/credentials), read again each minute;
//  3. a role (s3_roles.h): of the web identity or the container that the environment names, else of the machine.
// If the role of 3 fails, no other is taken: it may have other rights. Credentials of roles are asked for again five
// minutes before they expire. Until then the old ones are used if that fails.
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

  const Environment environment_;
  std::mutex mutex_;
  std::optional<RoleCredentials> found_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_S3_S3_CREDENTIALS_H_
