// A structured log: an event that never changes its name, and what belongs to it as fields.
//
//   log.Info("job finished", {{"job", id}, {"state", "done"}, {"seconds", 12.5}});
//
//   2026-11-22T05:10:00.123Z info job finished job=4f1c state=done seconds=12.5           kText
//   {"time":"2026-11-22T05:10:00.123Z","level":"info","event":"job finished", ...}        kJson
#ifndef TILEMEND_COMMON_UTIL_LOG_H_
#define TILEMEND_COMMON_UTIL_LOG_H_

#include <cstdint>
#include <cstdio>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/clock.h"
#include "absl/time/time.h"

namespace tilemend {

enum class LogLevel { kInfo, kWarning, kError };
enum class LogFormat { kText, kJson };

struct LogField {
  LogField(std::string_view k, std::string_view value) : key(k), text(value) {}
  LogField(std::string_view k, const std::string& value) : key(k), text(value) {}
  LogField(std::string_view k, const char* value) : key(k), text(value) {}
  LogField(std::string_view k, int value) : LogField(k, static_cast<int64_t>(value)) {}
  LogField(std::string_view k, int64_t value);
  LogField(std::string_view k, double value);

  std::string key;  // lower_case
  std::string text;
  bool is_number = false;
};
using LogFields = std::vector<LogField>;

// Behind an interface, with a null object, as metrics are. Thread-safe. No secrets: neither tokens nor keys.
class Log {
 public:
  virtual ~Log() = default;
  virtual void Write(LogLevel level, std::string_view event, const LogFields& fields) = 0;
  void Info(std::string_view event, const LogFields& fields = {}) { Write(LogLevel::kInfo, event, fields); }
  void Warn(std::string_view event, const LogFields& fields = {}) { Write(LogLevel::kWarning, event, fields); }
  void Error(std::string_view event, const LogFields& fields = {}) { Write(LogLevel::kError, event, fields); }
  static Log* Null();
};

// One line of the log, with its end. Values are made printable, whatever bytes they have; of long ones the ends are
// shown. Fields without text are left out.
std::string LogLine(LogFormat format, absl::Time time, LogLevel level, std::string_view event, const LogFields& fields);

// Writes whole lines to a stream that outlives it. `always` goes with every line of JSON: the program and its release.
// Lines that the stream does not take (the disk is full) are counted; the next one that it takes says how many. A
// stream without a buffer (setvbuf) repeats nothing of them.
class StreamLog : public Log {
 public:
  StreamLog(std::FILE* stream, LogFormat format, LogFields always, std::function<absl::Time()> clock = absl::Now);
  void Write(LogLevel level, std::string_view event, const LogFields& fields) override;
  // `tell` is called with the first line of a series that the stream does not take. Before the first Write.
  void OnLoss(std::function<void()> tell) { on_loss_ = std::move(tell); }

 private:
  bool Put(const std::string& line);

  std::FILE* const stream_;
  const LogFormat format_;
  const LogFields always_;
  const std::function<absl::Time()> clock_;
  std::mutex mutex_;
  std::function<void()> on_loss_ = [] {};
  int64_t lost_ = 0;      // lines that the stream did not take, and nobody can read of
  bool is_torn_ = false;  // the last line ends in its middle
};

// "text", "json" or "auto": text on a terminal, else JSON. kInvalidArgument for another word.
absl::StatusOr<LogFormat> LogFormatNamed(const std::string& name, std::FILE* stream);

}  // namespace tilemend

#endif  // TILEMEND_COMMON_UTIL_LOG_H_
