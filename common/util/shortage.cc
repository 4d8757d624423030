#include "common/util/shortage.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <new>
#include <system_error>

#include "common/util/exit_codes.h"

namespace tilemend {
namespace {

// What a thread takes for its stack where nothing else is said, and somewhat more.
constexpr size_t kProbedBytes = size_t{10} << 20;

// Only what may be called in a handler of a signal, and takes no memory.
[[noreturn]] void End(const char* what) {
  const char* const program = program_invocation_short_name;
  for (const char* text : {program, ": cannot go on: ", what,
                           "; memory or threads are short here (see `ulimit -a`): give it more, or fewer --workers "
                           "or --threads, and try again\n"}) {
    if (write(STDERR_FILENO, text, std::strlen(text)) < 0) break;
  }
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
}

}  // namespace tilemend
