// MD5, which S3 stores name contents with.
#ifndef TILEMEND_COMMON_S3_MD5_H_
#define TILEMEND_COMMON_S3_MD5_H_

#include <string>
#include <string_view>

struct evp_md_ctx_st;  // of OpenSSL

namespace tilemend {

// The MD5 of bytes that come in pieces. It tells damage, not malice. Not thread-safe.
class Md5 {
 public:
  Md5();
  ~Md5();
  Md5(const Md5&) = delete;
  Md5& operator=(const Md5&) = delete;

  void Update(std::string_view bytes);
  // The MD5 of all bytes given to Update, as 32 lowercase hexadecimal digits. Call once, last.
  std::string FinishHex();

 private:
  evp_md_ctx_st* context_;
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_S3_MD5_H_
