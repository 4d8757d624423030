#include "common/util/log.h"

#include <unistd.h>

#include <cmath>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/util/text.h"

namespace tilemend {
namespace {

class NullLog : public Log {
  void Write(LogLevel, std::string_view, const LogFields&) override {}
};

std::string_view LevelName(LogLevel level) {
  switch (level) {
    case LogLevel::kWarning:
      return "warning";
    case LogLevel::kError:
      return "error";
    default:
      return "info";
  }
}

// A value from elsewhere may be megabytes long.
constexpr size_t kMostOfValue = 4000;

// Within double quotes; of what is printable, only these two need it.
std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : Printable(text)) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

bool IsPlain(const std::string& text) {
  return text.find_first_of(" \"=\\") == std::string::npos && Printable(text) == text;
}

std::string TimeText(absl::Time time) { return absl::FormatTime("%Y-%m-%d%ET%H:%M:%E3SZ", time, absl::UTCTimeZone()); }

std::string TextLine(absl::Time time, LogLevel level, std::string_view event, const LogFields& fields) {
  std::string line = absl::StrCat(TimeText(time), " ", std::string(LevelName(level)), " ", Printable(event));
  for (const LogField& field : fields) {
    if (field.text.empty()) continue;
    const std::string text = Shortened(field.text, kMostOfValue);
    absl::StrAppend(&line, " ", field.key, "=", IsPlain(text) ? text : Quoted(text));
  }
  return line + "\n";
}

std::string JsonLine(absl::Time time, LogLevel level, std::string_view event, const LogFields& fields) {
  std::string line = absl::StrCat("{\"time\":\"", TimeText(time), "\",\"level\":\"", std::string(LevelName(level)),
                                  "\",\"event\":", Quoted(event));
  for (const LogField& field : fields) {
    if (field.text.empty()) continue;
    absl::StrAppend(&line, ",", Quoted(field.key), ":",
                    field.is_number ? field.text : Quoted(Shortened(field.text, kMostOfValue)));
  }
  return line + "}\n";
}

}  // namespace

LogField::LogField(std::string_view k, int64_t value) : key(k), text(absl::StrCat(value)), is_number(true) {}

LogField::LogField(std::string_view k, double value)
    : key(k), text(std::isfinite(value) ? absl::StrCat(value) : ""), is_number(true) {}

Log* Log::Null() {
  static NullLog log;
  return &log;
}

std::string LogLine(LogFormat format, absl::Time time, LogLevel level, std::string_view event,
                    const LogFields& fields) {
  return format == LogFormat::kText ? TextLine(time, level, event, fields) : JsonLine(time, level, event, fields);
}

StreamLog::StreamLog(std::FILE* stream, LogFormat format, LogFields always, std::function<absl::Time()> clock)
    : stream_(stream), format_(format), always_(std::move(always)), clock_(std::move(clock)) {}

void StreamLog::Write(LogLevel level, std::string_view event, const LogFields& fields) {
  LogFields all = fields;
  if (format_ == LogFormat::kJson) all.insert(all.begin(), always_.begin(), always_.end());
  const std::string line = LogLine(format_, clock_(), level, event, all);
  std::lock_guard<std::mutex> lock(mutex_);
  if (lost_ > 0) {
    LogFields lost = format_ == LogFormat::kJson ? always_ : LogFields();
    lost.emplace_back("lines", lost_);
    if (Put(LogLine(format_, clock_(), LogLevel::kError, "lines lost", lost))) lost_ = 0;
  }
  if (lost_ == 0 && Put(line)) return;
  if (++lost_ == 1) on_loss_();
}

bool StreamLog::Put(const std::string& line) {
  const std::string whole = is_torn_ ? "\n" + line : line;
  const size_t written = std::fwrite(whole.data(), 1, whole.size(), stream_);
  if (written == whole.size() && std::fflush(stream_) == 0) {
    is_torn_ = false;
    return true;
  }
  std::clearerr(stream_);
  is_torn_ = is_torn_ || written > 0;
  return false;
}

absl::StatusOr<LogFormat> LogFormatNamed(const std::string& name, std::FILE* stream) {
  if (name == "text") return LogFormat::kText;
  if (name == "json") return LogFormat::kJson;
  if (name == "auto") return isatty(fileno(stream)) == 1 ? LogFormat::kText : LogFormat::kJson;
  return absl::InvalidArgumentError(absl::StrCat("--log '", name, "': expected text, json or auto"));
}

}  // namespace tilemend
