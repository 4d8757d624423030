// Digests: SHA-256, the name of a content; XXH3, by which a file is known again.
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

// The digest of a file of a scene or an output: the 128-bit XXH3 of its bytes as 32 lowercase hexadecimal digits. It
// tells a file that was lost, cut off, changed or mixed up. It does not tell one that was made on purpose to have the
// digest of another, as SHA-256 does; that takes ten times as long.
//
// Source: XXH3 as of xxHash 0.8, whose results are fixed for good.
std::string FileDigest(std::string_view bytes);

// Whether `text` has the form of a digest of a file: that of FileDigest, or of SHA-256, which was taken before.
bool IsFileDigest(std::string_view text);

// Whether the file with these bytes has `digest`, of either form. False for other texts.
bool HasFileDigest(std::string_view bytes, std::string_view digest);

// FileDigest of bytes that come in pieces. Not thread-safe.
class FileHash {
 public:
  FileHash();
  ~FileHash();
  FileHash(const FileHash&) = delete;
  FileHash& operator=(const FileHash&) = delete;

  void Update(std::string_view bytes);
  // The digest of all bytes given to Update.
  std::string FinishHex() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_STORE_DIGEST_H_
