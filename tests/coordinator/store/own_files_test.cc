#include "coordinator/store/own_files.h"

#include <gtest/gtest.h>

#include "tests/coordinator/store/notes_in_memory.h"

namespace tilemend {
namespace {

TEST(OwnFilesTest, AreKnownToLaterProcessesWithTheSameNotes) {
  const auto notes = std::make_shared<NotesInMemory>();
  OwnFiles first(notes), of_another_job(std::make_shared<NotesInMemory>());
  EXPECT_FALSE(first.Has("tiles/a.ply"));
  first.Add({"tiles/a.ply"});
  EXPECT_TRUE(first.Has("tiles/a.ply"));
  EXPECT_FALSE(first.Has("tiles/b.ply"));
  EXPECT_TRUE(OwnFiles(notes).Has("tiles/a.ply"));
  EXPECT_FALSE(of_another_job.Has("tiles/a.ply"));
}

TEST(OwnFilesTest, AreKnownToThisProcessWithoutNotes) {
  OwnFiles files(std::make_shared<JobNotes>());
  files.Add({"tiles/a.ply"});
  EXPECT_TRUE(files.Has("tiles/a.ply"));
}

TEST(OwnFilesTest, AreDurableBeforeTheyAreThere) {
  class Waited : public NotesInMemory {
   public:
    void Await() override { ++times; }
    int times = 0;
  };
  const auto notes = std::make_shared<Waited>();
  OwnFiles files(notes);
  files.Add({"tiles/a.ply", "tiles/b.ply"});
  EXPECT_EQ(notes->times, 1);
  files.Add({});
  EXPECT_EQ(notes->times, 1);
}

}  // namespace
}  // namespace tilemend
