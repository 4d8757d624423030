// Credentials of roles: those that a service gives to a program, because of where it runs.
#ifndef TILEMEND_COMMON_S3_S3_ROLES_H_
#define TILEMEND_COMMON_S3_S3_ROLES_H_

#include <optional>
#include <string>

#include "absl/time/time.h"
#include "common/s3/s3_address.h"

namespace tilemend {

// Secrets: never in a log, an error or a report.
struct S3Credentials {
  std::string key_id, secret;
  std::string session_token;  // "" for keys that last
};

struct RoleCredentials {
  S3Credentials credentials;
  absl::Time expires;
  absl::Time renew;  // from then on new ones are asked for
};

// What the service of a container or a machine answers (JSON); nullopt if it is no such answer.
std::optional<RoleCredentials> CredentialsOfRole(const std::string& json);

// Each is nullopt where the environment names no such service, or where it does not answer as it should.

// Of AWS_ROLE_ARN, by the token in the file AWS_WEB_IDENTITY_TOKEN_FILE: pods of Kubernetes have them. Asks the
// security token service of the region, or AWS_ENDPOINT_URL_STS. Source: AWS STS API reference,
// AssumeRoleWithWebIdentity.
std::optional<RoleCredentials> RoleOfWebIdentity(const Environment& environment);

// By AWS_CONTAINER_CREDENTIALS_RELATIVE_URI, or AWS_CONTAINER_CREDENTIALS_FULL_URI with the token in
// AWS_CONTAINER_AUTHORIZATION_TOKEN_FILE or AWS_CONTAINER_AUTHORIZATION_TOKEN. Without TLS the token goes to this
// machine and to the addresses of ECS and EKS alone. Source: AWS SDKs and tools reference guide, "Container credential
// provider".
std::optional<RoleCredentials> RoleOfContainer(const Environment& environment);

// By IMDSv2 at AWS_EC2_METADATA_SERVICE_ENDPOINT, unless AWS_EC2_METADATA_DISABLED is true.
// Source: Amazon EC2 user guide, "Retrieve security credentials from instance metadata".
std::optional<RoleCredentials> RoleOfMachine(const Environment& environment);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_S3_S3_ROLES_H_
