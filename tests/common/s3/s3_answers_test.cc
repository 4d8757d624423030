#include "common/s3/s3_answers.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

TEST(S3AnswersTest, ReadsAnError) {
  const S3Error error =
      ErrorInAnswer("<?xml version=\"1.0\"?><Error><Code>NoSuchKey</Code><Message>no</Message></Error>");
  EXPECT_EQ(error.code, "NoSuchKey");
  EXPECT_EQ(error.message, "no");
  EXPECT_EQ(ErrorInAnswer("").code, "");
  EXPECT_EQ(ErrorInAnswer("<CopyObjectResult/>").code, "");
}

TEST(S3AnswersTest, ReadsOnePage) {
  const auto page = ReadListing(
      "<ListBucketResult><IsTruncated>true</IsTruncated><NextContinuationToken>t/+</NextContinuationToken>"
      "<Contents><Key>city/</Key></Contents><Contents><Key>city/a&amp;b.obj</Key></Contents>"
      "<CommonPrefixes><Prefix>city/tiles/</Prefix></CommonPrefixes></ListBucketResult>",
      "city/");
  ASSERT_TRUE(page.ok());
  ASSERT_EQ(page->entries.size(), 2U);
  EXPECT_EQ(page->entries[0].name, "a&b.obj");
  EXPECT_FALSE(page->entries[0].is_folder);
  EXPECT_EQ(page->entries[1].name, "tiles");
  EXPECT_TRUE(page->entries[1].is_folder);
  EXPECT_EQ(page->next, "t/+");
}

TEST(S3AnswersTest, RefusesWhatIsNoListing) {
  EXPECT_FALSE(ReadListing("<html/>", "").ok());
  EXPECT_FALSE(ReadListing("<ListBucketResult><IsTruncated>true</IsTruncated></ListBucketResult>", "").ok());
}

}  // namespace
}  // namespace tilemend
