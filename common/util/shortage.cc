#include "common/util/shortage.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

#include "common/util/exit_codes.h"

namespace tilemend {
namespace {

// What a thread takes for its stack where nothing else is said, and somewhat more.
constexpr size_t kProbedBytes = size_t{10} << 20;

constexpr size_t kMostPath = 4096;
std::array<char, kMostPath> folder_to_remove = {};

// Of the calls below all may be made in a handler of a signal, and take no memory but of the stack.

void RemoveIn(int folder, int depth);

// What `name` stands for in an open folder. What is too deep stays.
void Remove(int folder, const char* name, int depth) {
  if (unlinkat(folder, name, 0) == 0 || depth == 0) return;
  const int inner = openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (inner < 0) return;
  // Other threads may still write there.
  for (int tries = 0; tries < 3 && unlinkat(folder, name, AT_REMOVEDIR) != 0; ++tries) RemoveIn(inner, depth - 1);
  unlinkat(folder, name, AT_REMOVEDIR);
  close(inner);
}

void RemoveIn(int folder, int depth) {
  alignas(dirent64) std::array<char, 2048> entries;
  long bytes = 0;
  lseek(folder, 0, SEEK_SET);
  while ((bytes = syscall(SYS_getdents64, folder, entries.data(), entries.size())) > 0) {
    for (long at = 0; at < bytes;) {
      auto* const entry = reinterpret_cast<dirent64*>(entries.data() + at);
      at += entry->d_reclen;
      if (std::strcmp(entry->d_name, ".") != 0 && std::strcmp(entry->d_name, "..") != 0)
        Remove(folder, entry->d_name, depth);
    }
  }
}

[[noreturn]] void End(const char* what) {
  std::array<iovec, 4> line{};  // written at once: another thread may be at work on its progress
  const std::array<const char*, 4> texts = {program_invocation_short_name, ": cannot go on: ", what,
                                            "; memory or threads are short here (see `ulimit -a`): give it more, or "
                                            "fewer --workers or --threads, and try again\n"};
  for (size_t k = 0; k < texts.size(); ++k) line[k] = {const_cast<char*>(texts[k]), std::strlen(texts[k])};
  [[maybe_unused]] const ssize_t written = writev(STDERR_FILENO, line.data(), static_cast<int>(line.size()));
  constexpr int kDeepest = 8;
  if (folder_to_remove[0] != '\0') Remove(AT_FDCWD, folder_to_remove.data(), kDeepest);
  _exit(kExitRetryable);
}

[[noreturn]] void EndOfException() {
  try {
    if (const std::exception_ptr thrown = std::current_exception(); thrown != nullptr) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    End("out of memory");
  } catch (const std::system_error& error) {
    End(error.what());
  } catch (...) {
    __gnu_cxx::__verbose_terminate_handler();
  }
  std::abort();
}

bool MemoryIsShort() {
  void* const probe = mmap(nullptr, kProbedBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (probe == MAP_FAILED) return true;
  munmap(probe, kProbedBytes);
  return false;
}

// A process counts like a thread.
bool ThreadsAreShort() {
  const pid_t child = _Fork();
  if (child == 0) _exit(0);
  if (child > 0) waitpid(child, nullptr, 0);
  return child < 0;
}

// Libraries abort without a word, or with one of their own.
void EndOfAbort(int) {
  if (MemoryIsShort()) End("out of memory");
  if (ThreadsAreShort()) End("no thread can be made");
  // After its return as without a handler: the signal may come from without, as that of a watchdog.
  std::raise(SIGABRT);
}

}  // namespace

void EndOnShortage() {
  std::set_terminate(EndOfException);
  struct sigaction action = {};
  action.sa_handler = EndOfAbort;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGABRT, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

void RemoveOnShortage(const std::string& folder) {
  folder_to_remove.front() = '\0';
  if (folder.size() < kMostPath) std::memcpy(folder_to_remove.data(), folder.c_str(), folder.size() + 1);
}

}  // namespace tilemend
