#include "worker/service/folder_looks.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

v1::SyncResponse AskFor(const std::string& job) {
  v1::SyncResponse response;
  response.add_look()->set_job(job);
  return response;
}

v1::SyncRequest Told(const FolderLooks& looks) {
  v1::SyncRequest request;
  looks.AddTo(request);
  return request;
}

TEST(FolderLooksTest, TellsThatItLooksUntilItHasSeen) {
  FolderLooks looks;
  looks.Take({}, AskFor("a"));
  EXPECT_EQ(looks.TakeNext()->job(), "a");
  EXPECT_FALSE(looks.TakeNext());
  ASSERT_EQ(Told(looks).seen_size(), 1);
  EXPECT_TRUE(Told(looks).seen(0).looking());
  EXPECT_FALSE(looks.has_seen());
  v1::FoldersSeen seen;
  seen.set_job("a");
  looks.Add("a", seen);
  EXPECT_TRUE(looks.has_seen());
  EXPECT_FALSE(Told(looks).seen(0).looking());
}

TEST(FolderLooksTest, LooksOnceAtWhatIsAskedForTwice) {
  FolderLooks looks;
  looks.Take({}, AskFor("a"));
  looks.Take(Told(looks), AskFor("a"));
  EXPECT_TRUE(looks.TakeNext());
  EXPECT_FALSE(looks.has_next());
}

TEST(FolderLooksTest, ForgetsWhatItHasTold) {
  FolderLooks looks;
  looks.Take({}, AskFor("a"));
  looks.TakeNext();
  const v1::SyncRequest before = Told(looks);
  v1::FoldersSeen seen;
  seen.set_job("a");
  looks.Add("a", seen);
  looks.Take(before, {});
  EXPECT_TRUE(looks.has_seen()) << "only that it looks was told";
  looks.Take(Told(looks), {});
  EXPECT_EQ(Told(looks).seen_size(), 0);
}

}  // namespace
}  // namespace tilemend
