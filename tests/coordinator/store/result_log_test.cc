#include "coordinator/store/result_log.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "common/store/digest.h"
#include "tests/support/temporary_folder.h"

namespace tilemend {
namespace {

class ResultLogTest : public ::testing::Test {
 protected:
  using Opening = ResultLog::Opening;
  ResultLog Open(Opening how = Opening::kNewJob) { return ResultLog::Open(path_, how).value(); }
  int64_t Bytes() const { return static_cast<int64_t>(std::filesystem::file_size(path_)); }

  const std::string a_ = Sha256Hex("a"), b_ = Sha256Hex("b"), c_ = Sha256Hex("c");
  const TemporaryFolder folder_;
  const std::string path_ = folder_ / "log";
};

TEST_F(ResultLogTest, TheNextJobFindsWhatThisOnePut) {
  {
    ResultLog log = Open();
    EXPECT_FALSE(std::filesystem::exists(path_)) << "there is nothing to keep";
    ASSERT_TRUE(log.Put(a_, "one").ok());
    ASSERT_TRUE(log.Put(b_, "").ok());
    ASSERT_TRUE(log.Put(a_, "newer").ok());
    EXPECT_EQ(log.Find(a_), std::nullopt) << "its own";
  }
  ResultLog log = Open();
  EXPECT_EQ(log.Find(a_), "newer");
  EXPECT_EQ(log.Find(b_), "");
  EXPECT_EQ(log.Find(c_), std::nullopt);
}

TEST_F(ResultLogTest, AJobThatGoesOnFindsWhatItFoundBefore) {
  ASSERT_TRUE(Open().Put(a_, "earlier").ok());
  ASSERT_TRUE(Open().Put(b_, "own").ok());
  for (int i = 0; i < 2; ++i) {
    ResultLog log = Open(Opening::kSameJob);
    EXPECT_EQ(log.Find(a_), "earlier");
    EXPECT_EQ(log.Find(b_), std::nullopt);
    const int64_t before = Bytes();
    ASSERT_TRUE(log.Put(b_, "own").ok());
    EXPECT_EQ(Bytes(), before) << "it is there";
  }
}

TEST_F(ResultLogTest, AJobThatHasPutNothingYetGoesOnAsWell) {
  ASSERT_TRUE(Open().Put(a_, "earlier").ok());
  Open();
  EXPECT_EQ(Open(Opening::kSameJob).Find(a_), "earlier");
}

TEST_F(ResultLogTest, AJobThatBeginsAnewForgetsWhatItHasPutAndNothingElse) {
  ASSERT_TRUE(Open().Put(a_, "earlier").ok());
  ASSERT_TRUE(Open().Put(b_, "false").ok());
  for (int i = 0; i < 2; ++i) {
    ResultLog log = Open(Opening::kSameJobAnew);
    EXPECT_EQ(log.Find(a_), "earlier");
    ASSERT_TRUE(log.Put(c_, "true").ok());
  }
  ResultLog log = Open();
  EXPECT_EQ(log.Find(a_), "earlier");
  EXPECT_EQ(log.Find(b_), std::nullopt);
  EXPECT_EQ(log.Find(c_), "true");
}

TEST_F(ResultLogTest, TheFirstJobMayBeginAnewAsWell) {
  { ResultLog nothing = Open(Opening::kSameJobAnew); }
  ASSERT_TRUE(Open().Put(a_, "false").ok());
  { ResultLog log = Open(Opening::kSameJobAnew); }
  EXPECT_EQ(Open().Find(a_), std::nullopt);
}

TEST_F(ResultLogTest, KeepsOnlyWhatTheJobHadUseFor) {
  {
    ResultLog log = Open();
    ASSERT_TRUE(log.Put(a_, std::string(100'000, 'a')).ok());
    ASSERT_TRUE(log.Put(b_, "used").ok());
  }
  {
    ResultLog log = Open();
    EXPECT_EQ(log.Find(b_), "used");
    ASSERT_TRUE(log.Put(c_, "new").ok());
    ASSERT_TRUE(log.KeepUsed().ok());
    EXPECT_LT(Bytes(), 1000);
  }
  ResultLog log = Open();
  EXPECT_EQ(log.Find(a_), std::nullopt);
  EXPECT_EQ(log.Find(b_), "used");
  EXPECT_EQ(log.Find(c_), "new");
}

// Wherever it was cut off, all before is there, and it goes on from there.
TEST_F(ResultLogTest, ATornEndIsAsGoodAsNone) {
  const std::string end = Sha256Hex("end");
  {
    ResultLog log = Open();
    ASSERT_TRUE(log.Put(a_, "whole").ok());
  }
  const int64_t whole = Bytes();
  {
    ResultLog log = Open(Opening::kSameJob);
    ASSERT_TRUE(log.Put(b_, "torn").ok());
  }
  const std::string bytes = ReadFile(path_).value();
  for (int64_t size = whole; size < std::ssize(bytes); ++size) {
    folder_.Write("log", bytes.substr(0, static_cast<size_t>(size)));
    {
      ResultLog log = Open();
      EXPECT_EQ(log.Find(a_), "whole");
      EXPECT_EQ(log.Find(b_), std::nullopt);
      ASSERT_TRUE(log.Put(end, "more").ok());
    }
    ResultLog log = Open();
    EXPECT_EQ(log.Find(a_), "whole");
    EXPECT_EQ(log.Find(end), "more");
  }
}

TEST_F(ResultLogTest, AByteThatChangedMakesNoOtherResult) {
  {
    ResultLog log = Open();
    ASSERT_TRUE(log.Put(a_, "first").ok());
    ASSERT_TRUE(log.Put(b_, "second").ok());
  }
  const std::string bytes = ReadFile(path_).value();
  for (size_t i = 0; i < bytes.size(); ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    folder_.Write("log", changed);
    ResultLog log = Open();
    EXPECT_EQ(log.Find(a_).value_or("first"), "first") << i;
    EXPECT_EQ(log.Find(b_).value_or("second"), "second") << i;
  }
}

TEST_F(ResultLogTest, AFileOfAnotherReleaseIsReplaced) {
  folder_.Write("log", "tilemend-results-9\nwhatever comes here");
  {
    ResultLog log = Open();
    EXPECT_EQ(log.Find(a_), std::nullopt);
    ASSERT_TRUE(log.Put(a_, "one").ok());
  }
  EXPECT_EQ(Open().Find(a_), "one");
}

TEST_F(ResultLogTest, FollowsNoLink) {
  const std::string other = folder_.Write("other", "mine");
  std::filesystem::create_symlink(other, path_);
  EXPECT_FALSE(ResultLog::Open(path_, Opening::kNewJob).ok());
  EXPECT_EQ(ReadFile(other).value(), "mine");
}

}  // namespace
}  // namespace tilemend
