// Runs a fuzz target without libFuzzer: every seed and file as it is, then deterministic mutations of them.
//
//   x_fuzz [--runs=N] [--first=K] [--memory-mb=M] [--dump=FILE] [--write-seeds=FOLDER] [FILE or FOLDER ...]
//
// Run k depends on k alone, so a failure that reports "run 123" is repeated with --first=123 --runs=1; --dump writes
// the inputs to FILE, one over the other, before they are run. Fails if an
// input takes longer than kMostSeconds. --memory-mb limits the address space (ignored under sanitizers, which reserve
// terabytes).
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/fuzz_target.h"

namespace tilemend {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif
constexpr double kMostSeconds = kSanitized ? 20 : 2;
constexpr size_t kMostBytes = 1 << 16;  // of a mutated input

volatile std::sig_atomic_t current_run = -1;

// Tells which run died, with calls that are allowed in a signal handler.
void ReportRun(int signal) {
  char text[] = "fuzz driver: died in run           \n";
  size_t digit = sizeof(text) - 3;
  for (int run = current_run; run > 0 && text[digit] == ' '; run /= 10)
    text[digit--] = static_cast<char>('0' + run % 10);
  if (::write(STDERR_FILENO, text, sizeof(text) - 1) < 0) ::_exit(3);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

class Mutator {
 public:
  Mutator(const std::vector<std::string>& corpus, uint64_t run) : corpus_(corpus), random_(run) {}

  std::string Next() {
    std::string input = corpus_[Below(corpus_.size())];
    const size_t steps = 1 + Below(6);
    for (size_t i = 0; i < steps; ++i) Step(input);
    if (input.size() > kMostBytes) input.resize(kMostBytes);
    return input;
  }

 private:
  size_t Below(size_t n) { return n == 0 ? 0 : static_cast<size_t>(random_() % n); }

  void Step(std::string& s) {
    if (s.empty()) s.push_back('0');
    const size_t at = Below(s.size());
    const size_t length = 1 + Below(std::min<size_t>(s.size() - at, Below(8) == 0 ? 4096 : 16));
    switch (Below(9)) {
      case 0:
        s[at] = static_cast<char>(s[at] ^ (1 << Below(8)));
        break;
      case 1:
        s[at] = static_cast<char>(random_());
        break;
      case 2:
        s.erase(at, length);
        break;
      case 3:
        s.insert(Below(s.size() + 1), s.substr(at, length));
        break;
      case 4:
        s.resize(at);
        break;
      case 5:
        s.replace(at, length, Word());
        break;
      case 6:
        ReplaceNumber(s, at);
        break;
      case 7:
        Splice(s, at);
        break;
      default:
        PutInteger(s, at);
    }
  }

  std::string Word() {
    static constexpr const char* kWords[] = {"0",
                                             "-1",
                                             "3",
                                             "255",
                                             "65536",
                                             "2147483647",
                                             "4294967295",
                                             "1e9",
                                             "1e39",
                                             "1e-320",
                                             "nan",
                                             "inf",
                                             "-0",
                                             "99999999999999999999",
                                             "\n",
                                             "\r\n",
                                             "\r",
                                             "\\\n",
                                             "#",
                                             "/",
                                             "//",
                                             "\t \v",
                                             " ",
                                             "1000000",
                                             "f ",
                                             "v ",
                                             "list",
                                             "property",
                                             "OFF",
                                             "uchar",
                                             "element face 3\n",
                                             ".",
                                             "+",
                                             "\xef\xbb\xbf",
                                             "0x1"};
    return kWords[Below(std::size(kWords))];
  }

  // Puts another number where one stands in text.
  void ReplaceNumber(std::string& s, size_t from) {
    const size_t begin = s.find_first_of("0123456789", from);
    if (begin == std::string::npos) return;
    const size_t end = std::min(s.find_first_not_of("0123456789.", begin), s.size());
    s.replace(begin, end - begin, Below(2) == 0 ? Word() : std::to_string(Below(12)));
  }

  void Splice(std::string& s, size_t at) {
    const std::string& other = corpus_[Below(corpus_.size())];
    s = s.substr(0, at) + other.substr(Below(other.size() + 1));
  }

  void PutInteger(std::string& s, size_t at) {
    static constexpr uint32_t kValues[] = {0,          1,          0x7f,       0x80,       0xff,      0xffff,
                                           0x7fffffff, 0x80000000, 0xffffffff, 0x7fc00000, 0x7f800000};
    const uint32_t value = kValues[Below(std::size(kValues))];
    const size_t bytes = std::min(s.size() - at, size_t{1} << Below(3));
    std::memcpy(s.data() + at, &value, bytes);
  }

  const std::vector<std::string>& corpus_;
  std::mt19937_64 random_;
};

void AddFiles(const std::filesystem::path& path, std::vector<std::string>& corpus) {
  if (std::filesystem::is_directory(path)) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
      if (entry.is_regular_file() && entry.file_size() <= kMostBytes) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());  // the order of a folder is no order
    for (const auto& file : files) AddFiles(file, corpus);
    return;
  }
  std::ifstream file(path, std::ios::binary);
  corpus.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

// For libFuzzer, which has none.
void WriteSeeds(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const std::string& seed : FuzzSeeds()) {
    std::ofstream(folder / ("seed" + std::to_string(number++)), std::ios::binary) << seed;
  }
}

// Returns whether the target was quick enough.
bool RunOne(const std::string& input) {
  const auto begin = std::chrono::steady_clock::now();
  // An exact copy on the heap, so that a sanitizer sees a read beyond the end.
  const std::vector<uint8_t> bytes(input.begin(), input.end());
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  if (seconds.count() <= kMostSeconds) return true;
  std::fprintf(stderr, "fuzz driver: run %d took %.1f s\n", static_cast<int>(current_run), seconds.count());
  return false;
}

int Main(int argc, char** argv) {
  int runs = 20000;
  int first = 0;
  rlim_t memory_mb = 0;
  std::string dump;
  std::vector<std::string> corpus = FuzzSeeds();
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument.substr(0, 7) == "--runs=") {
      runs = std::atoi(argv[i] + 7);
    } else if (argument.substr(0, 8) == "--first=") {
      first = std::atoi(argv[i] + 8);
    } else if (argument.substr(0, 12) == "--memory-mb=") {
      memory_mb = static_cast<rlim_t>(std::atoi(argv[i] + 12));
    } else if (argument.substr(0, 7) == "--dump=") {
      dump = argument.substr(7);
    } else if (argument.substr(0, 14) == "--write-seeds=") {
      WriteSeeds(argv[i] + 14);
    } else {
      AddFiles(std::string(argument), corpus);
    }
  }
  if (memory_mb > 0 && !kSanitized) {
    const rlimit limit{memory_mb << 20, memory_mb << 20};
    if (::setrlimit(RLIMIT_AS, &limit) != 0) return 2;
  }
  for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS}) std::signal(signal, ReportRun);
  for (const std::string& seed : corpus) {
    if (!RunOne(seed)) return 1;
  }
  for (int k = first; k < first + runs; ++k) {
    current_run = k;
    const std::string input = Mutator(corpus, static_cast<uint64_t>(k)).Next();
    if (!dump.empty()) std::ofstream(dump, std::ios::binary) << input;
    if (!RunOne(input)) return 1;
  }
  std::printf("%zu seeds and %d mutations passed\n", corpus.size(), runs);
  return 0;
}

}  // namespace
}  // namespace tilemend

int main(int argc, char** argv) { return tilemend::Main(argc, argv); }
