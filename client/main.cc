// The tilemend command.
#include <string>
#include <vector>

#include "client/commands.h"
#include "common/rpc/endpoint.h"

int main(int argc, char** argv) {
  tilemend::PrepareProcess();
  return tilemend::Dispatch(tilemend::ServiceCommands(), std::vector<std::string>(argv + 1, argv + argc));
}
