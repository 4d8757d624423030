#include "tests/support/certificates.h"

#include <gtest/gtest.h>
#include <openssl/pem.h>
#include <openssl/rand.h>
#include <openssl/x509v3.h>

#include <cstdio>
#include <utility>

#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

std::shared_ptr<EVP_PKEY> NewKey() { return {EVP_EC_gen("P-256"), EVP_PKEY_free}; }

std::shared_ptr<X509> NewCertificate(const std::string& name, EVP_PKEY* key, long from_s, long until_s) {
  std::shared_ptr<X509> certificate(X509_new(), X509_free);
  X509_set_version(certificate.get(), 2);
  long serial = 0;
  EXPECT_EQ(RAND_bytes(reinterpret_cast<unsigned char*>(&serial), 4), 1);
  ASN1_INTEGER_set(X509_get_serialNumber(certificate.get()), serial);
  X509_gmtime_adj(X509_getm_notBefore(certificate.get()), from_s);
  X509_gmtime_adj(X509_getm_notAfter(certificate.get()), until_s);
  X509_NAME_add_entry_by_txt(X509_get_subject_name(certificate.get()), "CN", MBSTRING_UTF8,
                             reinterpret_cast<const unsigned char*>(name.c_str()), -1, -1, 0);
  X509_set_pubkey(certificate.get(), key);
  return certificate;
}

void AddExtension(X509* certificate, int kind, const std::string& text) {
  const std::unique_ptr<X509_EXTENSION, void (*)(X509_EXTENSION*)> extension(
      X509V3_EXT_conf_nid(nullptr, nullptr, kind, text.c_str()), X509_EXTENSION_free);
  EXPECT_NE(extension, nullptr) << text;
  X509_add_ext(certificate, extension.get(), -1);
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

}  // namespace

TestAuthority::TestAuthority(std::string folder, const std::string& name)
    : folder_(std::move(folder)), path_(absl::StrCat(folder_, "/", name, ".pem")), key_(NewKey()) {
  certificate_ = NewCertificate(name, key_.get(), -3600, 7200);
  X509_set_issuer_name(certificate_.get(), X509_get_subject_name(certificate_.get()));
  AddExtension(certificate_.get(), NID_basic_constraints, "critical,CA:TRUE");
  X509_sign(certificate_.get(), key_.get(), EVP_sha256());
  const File file(std::fopen(path_.c_str(), "w"), std::fclose);
  PEM_write_X509(file.get(), certificate_.get());
}

TlsFiles TestAuthority::Issue(const std::string& file, const Wanted& wanted) const {
  const auto key = NewKey();
  const auto certificate = NewCertificate(wanted.name, key.get(), wanted.from_s, wanted.until_s);
  X509_set_issuer_name(certificate.get(), X509_get_subject_name(certificate_.get()));
  std::string names = "DNS:localhost,IP:127.0.0.1";
  for (const std::string& role : wanted.roles) absl::StrAppend(&names, ",URI:tilemend:role:", role);
  for (const std::string& more : wanted.names) absl::StrAppend(&names, ",", more);
  AddExtension(certificate.get(), NID_subject_alt_name, names);
  X509_sign(certificate.get(), key_.get(), EVP_sha256());
  const TlsFiles files = {absl::StrCat(folder_, "/", file, ".pem"), absl::StrCat(folder_, "/", file, ".key"), path_};
  const File certificate_file(std::fopen(files.certificate.c_str(), "w"), std::fclose);
  PEM_write_X509(certificate_file.get(), certificate.get());
  const File key_file(std::fopen(files.key.c_str(), "w"), std::fclose);
  PEM_write_PrivateKey(key_file.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr);
  return files;
}

}  // namespace tilemend
