#include "common/store/digest.h"

#include <gtest/gtest.h>

#include <string>

namespace tilemend {
namespace {

TEST(DigestTest, IsSha256) {
  EXPECT_EQ(Sha256Hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(Sha256Hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  // FIPS 180-2, appendix B.3.
  EXPECT_EQ(Sha256Hex(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(DigestTest, DoesNotDependOnThePieces) {
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += static_cast<char>(i * 37);
  for (const size_t piece : {size_t{1}, size_t{7}, size_t{64}, size_t{999}}) {
    Sha256 sha;
    sha.Update("");
    for (size_t at = 0; at < bytes.size(); at += piece) sha.Update(bytes.substr(at, piece));
    EXPECT_EQ(sha.FinishHex(), Sha256Hex(bytes)) << piece;
  }
}

TEST(DigestTest, KnowsItsForm) {
  EXPECT_TRUE(IsDigest(Sha256Hex("x")));
  EXPECT_FALSE(IsDigest(""));
  EXPECT_FALSE(IsDigest(std::string(63, 'a')));
  EXPECT_FALSE(IsDigest(std::string(64, 'A')));
  EXPECT_FALSE(IsDigest(std::string(64, '/')));
}

TEST(FileDigestTest, IsXxh3) {
  EXPECT_EQ(FileDigest(""), "99aa06d3014798d86001c324468d497f");
  EXPECT_EQ(FileDigest("abc"), "06b05ab6733a618578af5f94892f3950");
}

TEST(FileDigestTest, DoesNotDependOnThePieces) {
  std::string bytes;
  for (int i = 0; i < 3000; ++i) bytes += static_cast<char>(i * 37);
  for (const size_t piece : {size_t{1}, size_t{7}, size_t{256}, size_t{2999}}) {
    FileHash hash;
    hash.Update("");
    for (size_t at = 0; at < bytes.size(); at += piece) hash.Update(bytes.substr(at, piece));
    EXPECT_EQ(hash.FinishHex(), FileDigest(bytes)) << piece;
  }
}

TEST(FileDigestTest, KnowsItsFormAndTheOneBefore) {
  EXPECT_TRUE(IsFileDigest(FileDigest("x")));
  EXPECT_TRUE(IsFileDigest(Sha256Hex("x")));
  for (const size_t digits : {0, 31, 33, 63, 65}) EXPECT_FALSE(IsFileDigest(std::string(digits, 'a'))) << digits;
  EXPECT_FALSE(IsFileDigest(std::string(32, 'A')));
  EXPECT_TRUE(HasFileDigest("x", FileDigest("x")));
  EXPECT_TRUE(HasFileDigest("x", Sha256Hex("x")));
  EXPECT_FALSE(HasFileDigest("x", FileDigest("y")));
  EXPECT_FALSE(HasFileDigest("x", Sha256Hex("y")));
  EXPECT_FALSE(HasFileDigest("x", ""));
}

}  // namespace
}  // namespace tilemend
