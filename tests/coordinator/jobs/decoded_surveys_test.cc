#include "coordinator/jobs/decoded_surveys.h"

#include <gtest/gtest.h>

namespace tilemend {
namespace {

SurveyRecord RecordOf(int64_t triangles) {
  SurveyRecord record;
  record.triangle_count = triangles;
  record.band.points.resize(1000);
  return record;
}

constexpr size_t kRoomForTwo = 60'000;  // a record of 1,000 points takes 24,000 bytes and a few hundred

TEST(DecodedSurveysTest, GivesEachRecordOnceForTheBytesItIsOf) {
  DecodedSurveys surveys;
  surveys.Put("a", RecordOf(1));
  surveys.Put("b", RecordOf(2));
  EXPECT_FALSE(surveys.Take("c"));
  EXPECT_EQ(surveys.Take("b")->triangle_count, 2);
  EXPECT_FALSE(surveys.Take("b"));
  EXPECT_EQ(surveys.Take("a")->triangle_count, 1);
}

// A job that lags behind takes the oldest first.
TEST(DecodedSurveysTest, KeepsTheOldestWhereThereIsNoRoomForAll) {
  DecodedSurveys surveys(kRoomForTwo);
  for (const char* output : {"a", "b", "c"}) surveys.Put(output, RecordOf(1));
  EXPECT_TRUE(surveys.Take("a"));
  EXPECT_TRUE(surveys.Take("b"));
  EXPECT_FALSE(surveys.Take("c"));
  // What was taken makes room.
  for (const char* output : {"d", "e"}) surveys.Put(output, RecordOf(1));
  EXPECT_TRUE(surveys.Take("d"));
  EXPECT_TRUE(surveys.Take("e"));
}

TEST(DecodedSurveysTest, DropsRecordsThatNobodyTakes) {
  constexpr int kMaxAge = 3;
  DecodedSurveys surveys(kRoomForTwo, kMaxAge);
  for (const char* output : {"cancelled", "late"}) surveys.Put(output, RecordOf(1));
  for (const char* output : {"a", "b"}) surveys.Put(output, RecordOf(1));
  EXPECT_FALSE(surveys.Take("a"));
  EXPECT_FALSE(surveys.Take("b"));
  for (const char* output : {"c", "d"}) surveys.Put(output, RecordOf(1));
  EXPECT_FALSE(surveys.Take("cancelled"));
  EXPECT_FALSE(surveys.Take("late"));
  EXPECT_TRUE(surveys.Take("c"));
  EXPECT_TRUE(surveys.Take("d"));
}

TEST(DecodedSurveysTest, ARecordThatIsTooLargeIsNotKept) {
  DecodedSurveys surveys(kRoomForTwo / 4);
  surveys.Put("a", RecordOf(1));
  EXPECT_FALSE(surveys.Take("a"));
}

}  // namespace
}  // namespace tilemend
