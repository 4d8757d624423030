// The tilemend command.
#include <string>
#include <vector>

#include "client/commands.h"
#include "client/job_flags.h"
#include "common/rpc/endpoint.h"
#include "common/s3/s3_store.h"
#include "common/util/signals.h"

int main(int argc, char** argv) {
  tilemend::ExitOnSignal();
  tilemend::PrepareProcess();
  if (const absl::Status store = tilemend::UseS3(); !store.ok()) return tilemend::PrintUsageError(store);
  return tilemend::Dispatch(tilemend::ServiceCommands(), std::vector<std::string>(argv + 1, argv + argc));
}
