// Simulated histories of a cluster, many of them: whatever happens to workers, to the coordinator, to its journal and
// to what they tell each other, no task is lost, none is committed twice, no stale result is taken, and every job ends
// with the outcome of an undisturbed one or says that something is missing.
//
//     state_simulation_test --gtest_filter=*ManyHistories* [with TILEMEND_SEEDS=N, TILEMEND_FIRST_SEED=N]
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string>

#include "absl/strings/numbers.h"
#include "absl/strings/str_join.h"
#include "tests/coordinator/state/simulation/history.h"

namespace tilemend::simulation {
namespace {

int64_t NumberFrom(const char* variable, int64_t otherwise) {
  const char* text = std::getenv(variable);
  int64_t number = 0;
  return text != nullptr && absl::SimpleAtoi(text, &number) ? number : otherwise;
}

void ExpectSound(const HistoryResult& result) {
  EXPECT_TRUE(result.broken.empty()) << absl::StrJoin(result.broken, "; ");
}

TEST(StateSimulationTest, NothingIsLostOrDoneTwiceInManyHistories) {
  const int64_t seeds = NumberFrom("TILEMEND_SEEDS", 2000), first = NumberFrom("TILEMEND_FIRST_SEED", 0);
  const auto start = std::chrono::steady_clock::now();
  Tally sum;
  int64_t jobs = 0, done = 0, partial = 0, cancelled = 0, failed = 0, set_aside = 0;
  for (int64_t seed = first; seed < first + seeds; ++seed) {
    const auto number = static_cast<uint64_t>(seed);
    const HistoryResult result = RunHistory(number, FaultsOf(number));
    EXPECT_TRUE(result.broken.empty()) << "seed " << seed << ": " << absl::StrJoin(result.broken, "; ");
    if (HasFailure()) return;
    jobs += result.jobs, done += result.done, partial += result.partial, cancelled += result.cancelled;
    failed += result.failed, sum.revoked += result.tally.revoked;
    const Tally& t = result.tally;
    sum.events += t.events, sum.crashes += t.crashes, sum.refused_late += t.refused_late, sum.struck += t.struck;
    sum.quarantined += t.quarantined, sum.failed += t.failed, sum.doubled += t.doubled, sum.committed += t.committed;
    sum.suspected += t.suspected, sum.cleared += t.cleared, set_aside += std::ssize(result.set_aside);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf(
      "%ld histories, %ld events, %.1f s; %ld jobs: %ld done, %ld partial, %ld cancelled, %ld failed; %ld tasks "
      "committed, "
      "%ld failed, %ld quarantined, %ld late results refused, %ld strikes, %ld second attempts, %ld workers suspected, "
      "%ld cleared, %ld set aside, %ld times revoked, %ld coordinators ended: 0 invariants broken\n",
      seeds, sum.events, seconds, jobs, done, partial, cancelled, failed, sum.committed, sum.failed, sum.quarantined,
      sum.refused_late, sum.struck, sum.doubled, sum.suspected, sum.cleared, set_aside, sum.revoked, sum.crashes);
  if (seeds < 1000) return;
  for (const int64_t seen : {done, partial, cancelled, sum.refused_late, sum.struck, sum.quarantined, sum.doubled,
                             sum.suspected, sum.cleared, sum.revoked, failed, set_aside}) {
    EXPECT_GT(seen, 0) << "the histories are too calm";
  }
}

TEST(StateSimulationTest, TheSameSeedGivesTheSameHistory) {
  for (uint64_t seed = 0; seed < 100; ++seed) {
    EXPECT_EQ(RunHistory(seed, FaultsOf(seed)).tally.trace, RunHistory(seed, FaultsOf(seed)).tally.trace) << seed;
  }
}

TEST(StateSimulationTest, ACalmDayHasNoStrikesAndNoSecondAttempts) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    const HistoryResult result = RunHistory(seed, {});
    ExpectSound(result);
    EXPECT_EQ(result.done, result.jobs) << seed;
    EXPECT_EQ(result.tally.struck + result.tally.doubled, 0) << seed;
  }
}

TEST(StateSimulationTest, APauseOfTheCoordinatorIsHeldAgainstNobody) {
  for (uint64_t seed = 0; seed < 500; ++seed) {
    Faults faults;
    faults.pause = 30;
    const HistoryResult result = RunHistory(seed, faults);
    ExpectSound(result);
    EXPECT_EQ(result.tally.struck, 0) << seed;
    EXPECT_EQ(result.done, result.jobs) << seed;
  }
}

TEST(StateSimulationTest, OneBadMachineFailsNoJobThatGoodOnesFinish) {
  for (uint64_t seed = 0; seed < 500; ++seed) {
    Faults faults;
    faults.full_disk = seed % 2 == 0;
    faults.liar = seed % 3 == 0;
    faults.slow = seed % 5 == 0;
    faults.loss = faults.doubling = faults.delay = 5;
    const HistoryResult result = RunHistory(seed, faults);
    ExpectSound(result);
    EXPECT_EQ(result.done, result.jobs) << seed;
  }
}

TEST(StateSimulationTest, ATaskThatKillsWorkersTakesNoOtherWithIt) {
  for (uint64_t seed = 0; seed < 500; ++seed) {
    Faults faults;
    faults.killer = true;
    faults.crash = seed % 2 == 0 ? 5 : 0;
    const HistoryResult result = RunHistory(seed, faults);
    ExpectSound(result);
    EXPECT_EQ(result.tally.quarantined, result.partial) << seed;
    EXPECT_EQ(result.tally.failed, 0) << seed;
  }
}

TEST(StateSimulationTest, ALiarIsSetAsideAndNobodyElseIs) {
  int set_aside = 0;
  for (uint64_t seed = 0; seed < 500; ++seed) {
    Faults faults;
    faults.liar = true;
    const HistoryResult result = RunHistory(seed, faults);
    ExpectSound(result);
    set_aside += result.set_aside.empty() ? 0 : 1;
  }
  EXPECT_GT(set_aside, 400);  // in some it comes too late for a task
}

// A job fails only if one swindler after the other comes, or there is nobody else.
TEST(StateSimulationTest, WhatASwindlerGaveIsDoneAgainByOthers) {
  int set_aside = 0, jobs = 0, failed = 0;
  int64_t revoked = 0;
  for (uint64_t seed = 0; seed < 500; ++seed) {
    Faults faults;
    faults.swindler = true;
    faults.crash = seed % 2 == 0 ? 5 : 0;
    faults.death = seed % 3 == 0 ? 5 : 0;
    const HistoryResult result = RunHistory(seed, faults);
    ExpectSound(result);
    EXPECT_EQ(result.done + result.failed, result.jobs) << seed;
    jobs += result.jobs, failed += result.failed;
    set_aside += result.set_aside.empty() ? 0 : 1;
    revoked += result.tally.revoked;
  }
  EXPECT_GT(revoked, 200);
  EXPECT_GT(set_aside, 100);
  EXPECT_LT(failed, jobs / 10);
}

TEST(StateSimulationTest, AJobWhoseResultsAreAllWrongIsPartialAndCostsNoOtherAWorker) {
  for (uint64_t seed = 0; seed < 500; ++seed) {
    Faults faults;
    faults.poison = true;
    faults.crash = seed % 2 == 0 ? 5 : 0;
    const HistoryResult result = RunHistory(seed, faults);
    ExpectSound(result);
    EXPECT_EQ(result.partial, 1) << seed;
    EXPECT_EQ(result.done, result.jobs - 1) << seed;
    EXPECT_TRUE(result.set_aside.empty()) << seed;
  }
}

}  // namespace
}  // namespace tilemend::simulation
