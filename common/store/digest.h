// SHA-256, the name of a content.
#ifndef TILEMEND_COMMON_STORE_DIGEST_H_
#define TILEMEND_COMMON_STORE_DIGEST_H_

#include <array>
#include <memory>
#include <string>
#include <string_view>

namespace tilemend {

// The SHA-256 of `bytes`. Thread-safe, here and below.
std::array<char, 32> Sha256Of(std::string_view bytes);

// The SHA-256 of `bytes` as 64 lowercase hexadecimal digits.
std::string Sha256Hex(std::string_view bytes);

// Whether `text` has the form that Sha256Hex returns: anything else must not become a file name.
bool IsDigest(std::string_view text);

// SHA-256 of bytes that come in pieces. Not thread-safe.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;

  void Update(std::string_view bytes);
  // The digest of all bytes given to Update. Call once, last.
  std::string FinishHex();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_STORE_DIGEST_H_
