#include "coordinator/journal/postgres_connection.h"

#include <libpq-fe.h>

#include <array>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"

namespace tilemend {
namespace {

constexpr int kBinary = 1;

// As the server sends and takes a BIGINT.
std::array<char, 8> BigEndian(int64_t value) {
  std::array<char, 8> bytes{};
  for (size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(static_cast<uint64_t>(value) >> (56 - 8 * i));
  return bytes;
}

}  // namespace

void PostgresRows::Clearer::operator()(pg_result* result) const { PQclear(result); }

int PostgresRows::size() const { return PQntuples(result_.get()); }

int64_t PostgresRows::changed() const { return std::atoll(PQcmdTuples(result_.get())); }

int64_t PostgresRows::Int(int row, int column) const {
  uint64_t value = 0;
  for (const char byte : Bytes(row, column)) value = value << 8 | static_cast<unsigned char>(byte);
  return static_cast<int64_t>(value);
}

std::string_view PostgresRows::Bytes(int row, int column) const {
  return {PQgetvalue(result_.get(), row, column), static_cast<size_t>(PQgetlength(result_.get(), row, column))};
}

void PostgresConnection::Closer::operator()(pg_conn* connection) const { PQfinish(connection); }

absl::StatusOr<PostgresConnection> PostgresConnection::Open(const std::string& where) {
  // Those of `where`, which come last, count.
  const char* const keywords[] = {"application_name",    "connect_timeout",  "tcp_user_timeout", "keepalives_idle",
                                  "keepalives_interval", "keepalives_count", "dbname",           nullptr};
  const char* const values[] = {"tilemend-coordinator", "10", "10000", "5", "2", "3", where.c_str(), nullptr};
  PostgresConnection opened(PQconnectdbParams(keywords, values, 1));
  if (opened.connection_ == nullptr) return absl::ResourceExhaustedError("no memory to connect to PostgreSQL");
  if (PQstatus(opened.connection_.get()) != CONNECTION_OK) return opened.Error();
  PQsetNoticeProcessor(
      opened.connection_.get(), [](void*, const char*) {}, nullptr);
  return opened;
}

absl::Status PostgresConnection::Error() const {
  const bool is_gone = PQstatus(connection_.get()) != CONNECTION_OK;
  const std::string text =
      absl::StrCat("PostgreSQL: ", absl::StripAsciiWhitespace(absl::string_view(PQerrorMessage(connection_.get()))));
  return is_gone ? absl::UnavailableError(text) : absl::InternalError(text);
}

absl::Status PostgresConnection::Run(const std::string& sql) {
  const PostgresRows rows(PQexec(connection_.get(), sql.c_str()));
  const ExecStatusType status = PQresultStatus(rows.result_.get());
  return status == PGRES_COMMAND_OK || status == PGRES_TUPLES_OK ? absl::OkStatus() : Error();
}

absl::StatusOr<PostgresRows> PostgresConnection::Query(const std::string& sql,
                                                       const std::vector<PostgresValue>& values) {
  auto name = prepared_.find(sql);
  if (name == prepared_.end()) {
    const std::string fresh = absl::StrCat("s", prepared_.size());
    const PostgresRows made(PQprepare(connection_.get(), fresh.c_str(), sql.c_str(), 0, nullptr));
    if (PQresultStatus(made.result_.get()) != PGRES_COMMAND_OK) return Error();
    name = prepared_.emplace(sql, fresh).first;
  }
  std::vector<std::array<char, 8>> integers(values.size());
  std::vector<const char*> bytes;
  std::vector<int> lengths;
  for (size_t i = 0; i < values.size(); ++i) {
    std::string_view value;
    if (const auto* integer = std::get_if<int64_t>(&values[i])) {
      integers[i] = BigEndian(*integer);
      value = {integers[i].data(), integers[i].size()};
    } else {
      value = std::get<std::string_view>(values[i]);
    }
    bytes.push_back(value.data() == nullptr ? "" : value.data());  // null would be NULL
    lengths.push_back(static_cast<int>(value.size()));
  }
  const std::vector<int> formats(values.size(), kBinary);
  PostgresRows rows(PQexecPrepared(connection_.get(), name->second.c_str(), static_cast<int>(values.size()),
                                   bytes.data(), lengths.data(), formats.data(), kBinary));
  const ExecStatusType status = PQresultStatus(rows.result_.get());
  if (status != PGRES_COMMAND_OK && status != PGRES_TUPLES_OK) return Error();
  return rows;
}

}  // namespace tilemend
