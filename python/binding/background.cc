#include "python/binding/background.h"

#include <cxxabi.h>
#include <pybind11/pybind11.h>
#include <unistd.h>

#include <chrono>
#include <exception>
#include <future>

#include "python/binding/interpreter_exit.h"

namespace tilemend {
namespace {

namespace py = pybind11;

constexpr auto kBetweenLooks = std::chrono::milliseconds(50);  // a person who presses Ctrl-C does not notice it

void CallHandlers(const SharedStep& step, SharedStep::Step& shown,
                  const std::function<void(const SharedStep::Step&)>& show) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  SharedStep::Step now = step.Get();
  if (!show || now.name.empty() || now == shown) return;
  shown = now;
  show(now);
}

// In a thread that Python ends by unwinding its stack, without the GIL: nothing of Python may be released so.
[[noreturn]] void SleepUntilProcessEnds() {
  while (true) ::pause();
}

}  // namespace

void SharedStep::Set(std::string_view name, size_t done, size_t all) {
  const std::lock_guard lock(mutex_);
  step_ = {std::string(name), done, all};
}

SharedStep::Step SharedStep::Get() const {
  const std::lock_guard lock(mutex_);
  return step_;
}

void RunInBackground(const std::function<void()>& work, CancelToken& cancel, const SharedStep& step,
                     const std::function<void(const SharedStep::Step&)>& show) {
  ThrowIfInterpreterEnds();
  std::future<void> done = std::async(std::launch::async, [&work] {
    const HoldsExit holds_exit;
    work();
  });
  std::exception_ptr thrown;
  SharedStep::Step shown;
  for (bool is_over = false; !is_over && !thrown;) {
    {
      const WithoutGil without_gil;
      is_over = done.wait_for(kBetweenLooks) == std::future_status::ready;
    }
    try {
      CallHandlers(step, shown, show);
    } catch (const abi::__forced_unwind&) {
      cancel.Cancel();
      done.wait();
      SleepUntilProcessEnds();
    } catch (...) {
      thrown = std::current_exception();
      cancel.Cancel();
    }
  }
  {
    const WithoutGil without_gil;
    done.wait();
  }
  if (thrown) std::rethrow_exception(thrown);
  ThrowIfInterpreterEnds();
  done.get();
}

}  // namespace tilemend
