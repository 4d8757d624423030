// What a program tells the service manager that runs it (systemd, Type=notify): that it is ready, what it does, that it
// is alive or ends. Where there is none, nothing happens.
#ifndef TILEMEND_COMMON_SERVICE_SERVICE_NOTIFIER_H_
#define TILEMEND_COMMON_SERVICE_SERVICE_NOTIFIER_H_

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace tilemend {

class ServiceNotifier {
 public:
  // The program is ready. From now on `status` says in one line what it does, again and again on a thread of its own.
  // It should take the locks that the program's work takes: when it does not come back, the manager's watchdog
  // (WatchdogSec) takes the program for dead.
  explicit ServiceNotifier(std::function<std::string()> status);
  // The program ends.
  ~ServiceNotifier();
  ServiceNotifier(const ServiceNotifier&) = delete;
  ServiceNotifier& operator=(const ServiceNotifier&) = delete;

 private:
  void Run(std::chrono::microseconds interval);

  const std::function<std::string()> status_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool end_ = false;
  std::thread thread_;  // none without a manager
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_SERVICE_SERVICE_NOTIFIER_H_
