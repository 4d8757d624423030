#include "common/store/digest.h"

#include <openssl/evp.h>

// Its functions as part of this file: nothing to load, and better code.
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <cstdlib>

#include "absl/strings/escaping.h"
#include "absl/strings/string_view.h"

namespace tilemend {
namespace {

// The library fails only for want of memory or of the algorithm itself; a wrong digest would be worse than an end.
void Require(bool success) {
  if (!success) std::abort();
}

bool IsHex(std::string_view text, size_t digits) {
  const auto is_hex = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  return text.size() == digits && std::all_of(text.begin(), text.end(), is_hex);
}

std::string Hex(const XXH128_hash_t& hash) {
  XXH128_canonical_t bytes;
  XXH128_canonicalFromHash(&bytes, hash);
  return absl::BytesToHexString(absl::string_view(reinterpret_cast<const char*>(bytes.digest), sizeof bytes.digest));
}

}  // namespace

struct Sha256::Context {
  Context() : md(EVP_MD_CTX_new()) {}
  ~Context() { EVP_MD_CTX_free(md); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  EVP_MD_CTX* md;
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {
  Require(context_->md != nullptr && EVP_DigestInit_ex(context_->md, EVP_sha256(), nullptr) == 1);
}

Sha256::~Sha256() = default;

void Sha256::Update(std::string_view bytes) {
  Require(EVP_DigestUpdate(context_->md, bytes.data(), bytes.size()) == 1);
}

std::string Sha256::FinishHex() {
  std::array<unsigned char, 32> digest{};
  Require(EVP_DigestFinal_ex(context_->md, digest.data(), nullptr) == 1);
  return absl::BytesToHexString(absl::string_view(reinterpret_cast<const char*>(digest.data()), digest.size()));
}

std::array<char, 32> Sha256Of(std::string_view bytes) {
  // Made once: to look an algorithm up and make room for it takes longer than to use it on a few bytes.
  static const EVP_MD* const algorithm = EVP_MD_fetch(nullptr, "SHA256", nullptr);
  thread_local const std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  std::array<char, 32> digest{};
  Require(algorithm != nullptr && context != nullptr && EVP_DigestInit_ex(context.get(), algorithm, nullptr) == 1 &&
          EVP_DigestUpdate(context.get(), bytes.data(), bytes.size()) == 1 &&
          EVP_DigestFinal_ex(context.get(), reinterpret_cast<unsigned char*>(digest.data()), nullptr) == 1);
  return digest;
}

std::string Sha256Hex(std::string_view bytes) {
  const std::array<char, 32> digest = Sha256Of(bytes);
  return absl::BytesToHexString(absl::string_view(digest.data(), digest.size()));
}

bool IsDigest(std::string_view text) { return IsHex(text, 64); }

std::string FileDigest(std::string_view bytes) { return Hex(XXH3_128bits(bytes.data(), bytes.size())); }

bool IsFileDigest(std::string_view text) { return IsHex(text, 32) || IsDigest(text); }

bool HasFileDigest(std::string_view bytes, std::string_view digest) {
  return digest == (IsDigest(digest) ? Sha256Hex(bytes) : FileDigest(bytes));
}

struct FileHash::State {
  XXH3_state_t state;
};

FileHash::FileHash() : state_(std::make_unique<State>()) { XXH3_128bits_reset(&state_->state); }

FileHash::~FileHash() = default;

void FileHash::Update(std::string_view bytes) { XXH3_128bits_update(&state_->state, bytes.data(), bytes.size()); }

std::string FileHash::FinishHex() const { return Hex(XXH3_128bits_digest(&state_->state)); }

}  // namespace tilemend
