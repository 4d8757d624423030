#include <utility>

#include "client/commands.h"
#include "client/job_flags.h"

namespace tilemend {
namespace {

FlagSpec CoordinatorFlag() { return {"coordinator", "HOST:PORT", "where the coordinator listens", "127.0.0.1:7070"}; }
FlagSpec RequestIdFlag() { return {"request-id", "ID", "makes a repeated submit give the same job", ""}; }
FlagSpec WaitFlag() { return {"wait", "", "wait for the end of the job", ""}; }

std::vector<FlagSpec> Join(std::vector<FlagSpec> first, const std::vector<FlagSpec>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace

std::vector<Command> ServiceCommands() {
  const std::vector<FlagSpec> cluster = {CoordinatorFlag(), OutputFlag()};
  const std::vector<FlagSpec> start = {CoordinatorFlag(), WaitFlag(), RequestIdFlag()};
  const std::vector<FlagSpec> local = {
      {"workers", "N", "tasks at once (default: the machine's cores)", ""},
      {"work", "DIR", "where to put intermediate files (default: the system's temporary folder)", ""}};
  const std::vector<FlagSpec> shape = {{"surface", "NAME", "thin-plate or wang", "thin-plate"},
                                       TensionFlag(),
                                       GradationFlag(),
                                       SizeLimitFlag(),
                                       {"uniform", "", "triangles as large as the rim's throughout", ""},
                                       {"out", "FILE", "where to write the filled mesh", ""},
                                       {"overwrite", "", "replace an existing output", ""},
                                       OutputFlag()};
  // A mesh of its own need not be terrain: a bowl without its bottom is no lake.
  const std::vector<FlagSpec> fill = Join(shape, WaterFlags("off"));
  return {
      {"inspect",
       "SCENE|MESH",
       "show tiles, borders and holes; writes nothing",
       1,
       {},
       Join({OutputFlag()}, WaterFlags("")),
       InspectCommand},
      {"fill", "MESH --out FILE", "fill the holes of one mesh", 1, {"out"}, fill, FillCommand},
      {"run", "SCENE --out DIR", "fill a scene on this machine", 1, {}, Join(JobFlags(), local), RunCommand},
      {"submit", "SCENE --out DIR", "fill a scene on a cluster", 1, {}, Join(JobFlags(), start), SubmitCommand},
      {"get", "JOB", "show a job", 1, {}, cluster, GetCommand},
      {"list", "", "show all jobs, newest first", 0, {}, cluster, ListCommand},
      {"watch", "JOB", "follow a job to its end", 1, {}, cluster, WatchCommand},
      {"cancel", "JOB", "end a job", 1, {}, cluster, CancelCommand},
      {"retry", "JOB", "start a job that is over again", 1, {}, Join(start, {OutputFlag()}), RetryCommand},
      {"report", "OUT", "show the report of an output", 1, {}, {OutputFlag()}, ReportCommand},
  };
}

}  // namespace tilemend
