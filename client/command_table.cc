#include <algorithm>
#include <map>

#include "absl/strings/str_cat.h"
#include "client/commands.h"
#include "client/mesh/mesh_options.h"
#include "common/options/option.h"
#include "common/rpc/credentials.h"
#include "common/util/settings.h"

namespace tilemend {
namespace {

std::vector<FlagSpec> Join(std::vector<FlagSpec> first, const std::vector<FlagSpec>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::vector<FlagSpec> Advanced(std::vector<FlagSpec> flags) {
  for (FlagSpec& flag : flags) flag.group = FlagGroup::kAdvanced;
  return flags;
}

// How to reach a cluster.
std::vector<FlagSpec> CoordinatorFlags() {
  return AllAsSettings(Join({{"coordinator", "HOST:PORT", "address of the coordinator", "127.0.0.1:7070"}},
                            Advanced(ChannelSecurityFlags())));
}

// Of commands that start a job on a cluster.
std::vector<FlagSpec> StartFlags() {
  return Join(Join(CoordinatorFlags(), {{"wait", "", "wait for the end of the job; the exit code is the job's", ""}}),
              Advanced({{"request-id", "ID", "a second call with the same ID gives the same job", ""}}));
}

FlagSpec VerboseFlag() { return {"verbose", "", "show the job, its phases and its tasks as well", "", 'v'}; }

std::vector<FlagSpec> LocalFlags() {
  return Join(
      {{"check", "", "compare the output with the scene, as `tilemend check` does; 100 if it is not accepted", ""},
       VerboseFlag()},
      Advanced({{"workers", "N", "tasks at once, 1 to 1024 (default: the number of cores)", ""},
                {"task-memory", "MB", "memory that tasks take at once, 64 to 1e6; one alone may take more", "384"},
                {"work", "DIR", "folder for intermediate files (default: the system's temporary folder)", ""}}));
}

// With another default of --water than jobs have; "": the command chooses by what it is given.
std::vector<FlagSpec> WithWater(std::vector<FlagSpec> flags, const std::string& default_value) {
  FlagSpec& water = *std::ranges::find(flags, "water", &FlagSpec::name);
  water.default_value = default_value;
  if (default_value.empty()) water.help += " (default: auto, for single meshes off)";
  return flags;
}

std::vector<FlagSpec> AggregateFlags() {
  return {{"out", "FILE", "PLY file to write", ""},
          {"overwrite", "", "replace FILE if it exists", ""},
          {"memory", "MB", "address space that may be taken, 64 to 1e9 (default: any)", ""},
          {"longest-loop", "N", "longer boundaries stay open, 3 to 20000: n^3 steps", "2000"}};
}

std::vector<FlagSpec> InspectFlags() {
  return Join(WithWater(OptionFlags(kOfInspect), ""),
              {{"propose-area", "FILE", "write the outline of the surface as GeoJSON", ""},
               {"propose-water", "FILE", "write what may be water as polygons for --water: .gpkg or .geojson", ""},
               {"holes", "FILE", "write the holes as polygons for a GIS, with what would become of them: GeoJSON", ""},
               {"overwrite", "", "replace the FILE of --propose-area, --propose-water and --holes if it exists", ""}});
}

std::vector<FlagSpec> CheckFlags() {
  return {{"crease-angle", "DEGREES", "a sharper turn of the surface at an edge is a fault", "120"},
          {"spike-angle", "DEGREES", "a vertex with less about it, on long edges, is a spike", "90"},
          {"small-component", "EDGES", "no wider pieces are small, in mean edges of the mesh", "5"},
          {"small-hole", "EDGES", "holes with no more boundary edges are small", "12"},
          {"csv", "FILE", "with OUT: write the places that were found as CSV", ""},
          {"page", "", "with OUT: show the verdict in its report.html; it is kept as acceptance.json", ""}};
}

std::vector<FlagSpec> ReportFlags() {
  return {{"html", "", "write report.html and holes.csv beside report.json, in place of the text", ""}};
}

// What follows "tilemend ".
std::vector<std::string> ExamplesOf(const std::string& command) {
  static const std::map<std::string, std::vector<std::string>> examples = {
      {"inspect", {"inspect scene", "inspect scene --propose-water water.gpkg"}},
      {"check", {"check scene out", "check mesh.ply --crease-angle 150"}},
      {"demo", {"demo", "demo /tmp/first-try"}},
      {"run", {"run scene --out out", "run scene --out out --water lakes.gpkg --area boundary.geojson"}},
      {"fill", {"fill mesh.ply --out filled.ply", "fill mesh.obj --out filled.obj --weld 0.001 --largest-hole 500"}},
      {"aggregate", {"aggregate scene --out joined.ply", "aggregate scene --out joined.ply --memory 8000"}},
      {"report", {"report out", "report out -o json"}},
      {"submit", {"submit /data/scene --out /data/out --wait", "submit /data/scene --out /data/out --priority 10"}},
      {"get", {"get jobs/ID", "get ID -o json"}},
      {"list", {"list --coordinator host:7070", "list --state running"}},
      {"workers", {"workers --coordinator host:7070", "workers -o json"}},
      {"watch", {"watch jobs/ID", "watch ID -o json"}},
      {"cancel", {"cancel jobs/ID", "cancel ID -o json"}},
      {"pause", {"pause jobs/ID", "pause ID -o json"}},
      {"resume", {"resume jobs/ID", "resume ID -o json"}},
      {"prioritize", {"prioritize jobs/ID 10", "prioritize ID -10"}},
      {"retry", {"retry jobs/ID --wait", "retry jobs/ID --overwrite"}}};
  const auto found = examples.find(command);
  return found == examples.end() ? std::vector<std::string>() : found->second;
}

std::vector<Command> WithExamples(std::vector<Command> commands) {
  for (Command& command : commands) command.examples = ExamplesOf(command.name);
  return commands;
}

}  // namespace

std::vector<Command> ServiceCommands() {
  const std::vector<FlagSpec> output = {OutputFlag()}, cluster = Join(CoordinatorFlags(), output),
                              demo = {VerboseFlag()};
  const std::vector<FlagSpec> list =
      Join({{"state", "STATE[,STATE]", "only jobs in these states: running, done, ...", ""}}, cluster);
  const std::vector<FlagSpec> inspect = Join(InspectFlags(), output), aggregate = Join(AggregateFlags(), output);
  const std::vector<FlagSpec> run = Join(Join(OptionFlags(kOfJobs), LocalFlags()), output);
  const std::vector<FlagSpec> fill = Join(WithWater(OptionFlags(kOfFill), kMeshWater), output);
  const std::vector<FlagSpec> retry = Join(
      {{"overwrite", "", "replace the files of the job's output, if it is complete", ""}}, Join(StartFlags(), output));
  const std::vector<FlagSpec> priority =
      Advanced({{"priority", "P", "-100 to 100: tasks of jobs with a lower one wait", "0"}});
  const std::vector<FlagSpec> submit = Join(Join(Join(OptionFlags(kOfJobs), StartFlags()), priority), output);
  return WithExamples({
      {"inspect", "SCENE|MESH", "show tiles, borders and holes; write nothing", 1, {}, inspect, InspectCommand},
      {"check",
       "MESH|SCENE|DIR [OUT]",
       "show what is wrong with a mesh, a scene or an output; with OUT, compare an output with its scene",
       1,
       {},
       Join(CheckFlags(), output),
       CheckCommand,
       1},
      {"demo", "[DIR]", "make a small scene, fill it, and name the page to look at", 0, {}, demo, DemoCommand, 1},
      {"run", "SCENE --out DIR", "fill a scene on this machine", 1, {}, run, RunCommand},
      {"fill", "MESH --out FILE", "fill one mesh, without a grid", 1, {"out"}, fill, FillCommand},
      {"aggregate", "SCENE --out FILE", "join all cells and fill that", 1, {"out"}, aggregate, AggregateCommand},
      {"report", "DIR", "show the report of an output", 1, {}, Join(ReportFlags(), output), ReportCommand},
      {"submit", "SCENE --out DIR", "fill a scene on a cluster", 1, {}, submit, SubmitCommand},
      {"get", "JOB", "show a job", 1, {}, cluster, GetCommand},
      {"list", "", "show all jobs, newest first", 0, {}, list, ListCommand},
      {"workers", "", "show the workers of a cluster", 0, {}, cluster, WorkersCommand},
      {"watch", "JOB", "follow a job to its end", 1, {}, cluster, WatchCommand},
      {"cancel", "JOB", "cancel a job", 1, {}, cluster, CancelCommand},
      {"pause", "JOB", "give out no more tasks of a job", 1, {}, cluster, PauseCommand},
      {"resume", "JOB", "go on with a job that is paused", 1, {}, cluster, ResumeCommand},
      {"prioritize", "JOB PRIORITY", "give a job another priority, -100 to 100", 2, {}, cluster, PrioritizeCommand},
      {"retry", "JOB", "start a finished job again", 1, {}, retry, RetryCommand},
  });
}

}  // namespace tilemend
