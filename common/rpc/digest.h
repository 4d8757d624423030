// SHA-256 digests, which name blobs.
#ifndef TILEMEND_COMMON_RPC_DIGEST_H_
#define TILEMEND_COMMON_RPC_DIGEST_H_

#include <memory>
#include <string>
#include <string_view>

namespace tilemend {

// 64 lower-case hexadecimal digits.
std::string Sha256Hex(std::string_view bytes);

// True for 64 lower-case hexadecimal digits: anything else must not become a file name.
bool IsDigest(std::string_view text);

// SHA-256 of bytes that come in pieces.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  void Update(std::string_view bytes);
  // Call once, last.
  std::string FinishHex();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RPC_DIGEST_H_
