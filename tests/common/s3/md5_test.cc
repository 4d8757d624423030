#include "common/s3/md5.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

// RFC 1321, A.5.
TEST(Md5Test, KnowsTheExamplesOfTheStandard) {
  EXPECT_EQ(Md5().FinishHex(), "d41d8cd98f00b204e9800998ecf8427e");
  Md5 md5;
  md5.Update("message ");
  md5.Update("digest");
  EXPECT_EQ(md5.FinishHex(), "f96b697d7cb7938d525a2f31aaf161d0");
}

}  // namespace
}  // namespace tilemend
