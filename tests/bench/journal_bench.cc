// Times the coordinator's journal on the disk that holds FOLDER.
//
//   journal_bench FOLDER [RESULTS]
//
// Prints how many results a second are durable when 1, 8 and 64 threads each wait for theirs, and, after RESULTS
// results of one job (default 3,000,000: a million cells of three tasks), how long a coordinator that starts again
// takes to open the journal and to look all of them up.
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "absl/strings/str_cat.h"
#include "common/store/digest.h"
#include "coordinator/journal/sqlite_journal.h"

namespace tilemend {
namespace {

constexpr int kEach = 400;  // results of a thread

double Seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::unique_ptr<Journal> Open(const std::string& path) {
  auto journal = OpenSqliteJournal(path);
  if (journal.ok()) return *std::move(journal);
  std::fprintf(stderr, "%s\n", std::string(journal.status().message()).c_str());
  std::exit(1);
}

TaskName Task(int64_t number) {
  return {{static_cast<int32_t>(number / 3 % 1000), static_cast<int32_t>(number / 3000)},
          kAllStages[static_cast<size_t>(number % 3)],
          Sha256Hex(absl::StrCat(number))};
}

ResultRecord Result(int64_t number) {
  const std::string content = absl::StrCat("the output of a task without work, number ", number);
  return {.state = TaskState::kCommitted, .output = Sha256Hex(content), .content = content};
}

double DurablePerSecond(Journal& journal, int threads, int64_t first) {
  const double seconds = Seconds([&] {
    std::vector<std::thread> all;
    for (int t = 0; t < threads; ++t) {
      all.emplace_back([&journal, start = first + t * kEach] {
        for (int i = 0; i < kEach; ++i) {
          journal.PutResult(1, Task(start + i), Result(start + i));
          journal.Await();
        }
      });
    }
    for (std::thread& thread : all) thread.join();
  });
  return threads * kEach / seconds;
}

void Fill(Journal& journal, int64_t results) {
  for (int64_t i = 0; i < results; ++i) {
    journal.PutResult(1, Task(i), Result(i));
    if (i % 10'000 == 0) journal.Await();
  }
  journal.Await();
}

int Main(const std::string& folder, int64_t results) {
  const std::string path = folder + "/journal_bench.sqlite";
  for (const char* suffix : {"", "-wal"}) std::filesystem::remove(path + suffix);
  auto journal = Open(path);
  journal->PutJob({.number = 1, .body = "a job"});
  for (const int threads : {1, 8, 64})
    std::printf("%2d threads: %.0f durable results/s\n", threads, DurablePerSecond(*journal, threads, 1'000'000'000));
  const double fill = Seconds([&] { Fill(*journal, results); });
  journal.reset();
  std::printf("%lld results put in %.1f s, %.0f MB\n", static_cast<long long>(results), fill,
              static_cast<double>(std::filesystem::file_size(path)) / 1e6);
  std::printf("opened in %.2f s\n", Seconds([&] { journal = Open(path); }));
  int64_t found = 0;
  const double find = Seconds([&] {
    for (int64_t i = 0; i < results; ++i) found += journal->Find(1, Task(i)).value().has_value() ? 1 : 0;
  });
  std::printf("%lld found in %.2f s\n", static_cast<long long>(found), find);
  journal.reset();
  std::filesystem::remove(path);
  return found == results ? 0 : 1;
}

}  // namespace
}  // namespace tilemend

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: journal_bench FOLDER [RESULTS]\n");
    return 2;
  }
  return tilemend::Main(argv[1], argc > 2 ? std::atoll(argv[2]) : 3'000'000);
}
