// Authorities and certificates for tests, made without a program.
#ifndef TILEMEND_TESTS_SUPPORT_CERTIFICATES_H_
#define TILEMEND_TESTS_SUPPORT_CERTIFICATES_H_

#include <openssl/evp.h>
#include <openssl/x509.h>

#include <memory>
#include <string>
#include <vector>

#include "common/rpc/credentials.h"

namespace tilemend {

class TestAuthority {
 public:
  // `folder` gets NAME.pem.
  TestAuthority(std::string folder, const std::string& name);

  const std::string& path() const { return path_; }

  struct Wanted {
    std::string name;
    std::vector<std::string> roles = {};  // tilemend:role:ROLE
    long from_s = -3600, until_s = 3600;  // from now
    std::vector<std::string> names = {};  // further alternative names: "DNS:example.org"
  };
  // Writes FILE.pem and FILE.key (over old ones) for localhost and 127.0.0.1, and gives them with this authority.
  TlsFiles Issue(const std::string& file, const Wanted& wanted) const;

 private:
  std::string folder_, path_;
  std::shared_ptr<EVP_PKEY> key_;
  std::shared_ptr<X509> certificate_;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_CERTIFICATES_H_
