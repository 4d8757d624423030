// A PostgreSQL server for one test, on a socket in a folder of its own.
#ifndef TILEMEND_TESTS_SUPPORT_POSTGRES_SERVER_H_
#define TILEMEND_TESTS_SUPPORT_POSTGRES_SERVER_H_

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/support/temporary_folder.h"

namespace tilemend {

class PostgresServer {
 public:
  // The folder of its programs, "" if it is not installed.
  static std::string Programs() {
    std::error_code error;
    for (const auto& version : std::filesystem::directory_iterator("/usr/lib/postgresql", error)) {
      if (std::filesystem::exists(version.path() / "bin" / "initdb")) return (version.path() / "bin").string();
    }
    return "";
  }

  // Precondition: installed.
  PostgresServer() {
    if (getuid() == 0) Run("chown postgres " + folder_.path() + " && chmod 755 " + folder_.path());
    RunAs("initdb -D " + folder_.path() + "/data -A trust -U tilemend --no-sync");
    RunAs("pg_ctl -D " + folder_.path() + "/data -w -l " + folder_.path() + "/log -o \"-k " + folder_.path() +
          " -c listen_addresses=''\" start");
  }
  ~PostgresServer() { RunAs("pg_ctl -D " + folder_.path() + "/data -m immediate stop"); }
  PostgresServer(const PostgresServer&) = delete;
  PostgresServer& operator=(const PostgresServer&) = delete;

  std::string where() const { return "host=" + folder_.path() + " user=tilemend dbname=postgres"; }

 private:
  static void Run(const std::string& command) {
    if (std::system(("(" + command + ") >/dev/null 2>&1").c_str()) != 0) ADD_FAILURE() << command;
  }
  // The server does not run as root.
  static void RunAs(const std::string& command) {
    const std::string user = getuid() == 0 ? "runuser -u postgres -- " : "";
    Run("cd / && " + user + Programs() + "/" + command);
  }

  const TemporaryFolder folder_;
};

}  // namespace tilemend

#endif  // TILEMEND_TESTS_SUPPORT_POSTGRES_SERVER_H_
