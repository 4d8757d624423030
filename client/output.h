// What the commands print.
#ifndef TILEMEND_CLIENT_OUTPUT_H_
#define TILEMEND_CLIENT_OUTPUT_H_

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "common/util/exit_codes.h"
#include "tilemend/v1/jobs.pb.h"

namespace tilemend {

enum class OutputFormat { kTable, kJson };

// The most rows of one table on a terminal.
inline constexpr size_t kMostListedRows = 30;

// "and 12 more; WHERE" with a line's end, if a table shows only the first rows of `count`; else "".
std::string MoreText(size_t count, const std::string& where);

// Metres with three decimals: of a number, or "first to last" of two.
std::string LevelText(const nlohmann::ordered_json& level);

// Rows under their headings, columns lined up; columns of numbers alone at their right. Cells need not be printable.
std::string Table(const std::vector<std::string>& headings, const std::vector<std::vector<std::string>>& rows);

// "1 tension", "2 tensions".
std::string Counted(size_t count, const std::string& noun);
// "1 fill of water", "2 fills of water".
std::string Counted(size_t count, const std::string& one, const std::string& many);

// Begins with the name that the job has.
std::string JobText(const v1::Job& job, OutputFormat format);
// Tables keep to `columns`, those of a terminal, if there are any (FittedTable); JSON has all.
std::string JobsText(const std::vector<v1::Job>& jobs, OutputFormat format, size_t columns = 0);
std::string WorkersText(const std::vector<v1::WorkerInfo>& workers, OutputFormat format, size_t columns = 0);

// By the job's end; kExitDone for a job that still runs.
ExitCode ExitCodeOf(const v1::Job& job);

// One line on stderr; gives the exit code.
ExitCode PrintError(const absl::Status& status);

// On stderr, one line each.
void PrintWarnings(const std::vector<std::string>& warnings);

absl::Time TimeOf(const google::protobuf::Timestamp& time);

// "less than 1 s", then to the nearest second "12 s", "2 min 05 s", "1 h 02 min", "3 d 04 h". durationText in
// web/src/jobs.ts writes the same.
std::string DurationText(absl::Duration duration);

// "3/24", or "-" while the whole is not known.
std::string Share(int64_t part, int64_t whole);

}  // namespace tilemend

#endif  // TILEMEND_CLIENT_OUTPUT_H_
