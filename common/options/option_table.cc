// The one table of options. Each field of v1::JobSpec but `scene` stands here.
#include "absl/strings/str_cat.h"
#include "common/options/option.h"
#include "common/records/filler.h"
#include "common/records/surface.h"

namespace tilemend {
namespace {

using enum OptionType;
using enum FlagGroup;
using enum OptionNeeds;

constexpr unsigned kBoth = kOfJobs | kOfFill, kAll = kBoth | kOfInspect;

std::vector<std::string> NamesOfFillers() {
  std::vector<std::string> names;
  for (const Filler filler : kFillers) names.emplace_back(FillerName(filler));
  return names;
}

// Rows as in a table.
// clang-format off

// What is read and written.
std::vector<Option> FileOptions() {
  return {
      {.field = "out", .type = kPath, .value_name = "DIR", .help = "folder to write to", .group = kEveryday,
       .in_report = false},
      {.field = "out", .type = kPath, .value_name = "FILE", .help = "file to write, in the format of MESH",
       .group = kEveryday, .commands = kOfFill, .in_report = false},
      {.field = "overwrite", .help = "write to DIR even if it is not empty; files of other names stay",
       .group = kEveryday, .in_report = false},
      {.field = "overwrite", .help = "replace FILE if it exists", .group = kEveryday, .commands = kOfFill,
       .in_report = false},
      {.field = "dry_run", .help = "find and count the holes, write nothing", .group = kEveryday,
       .in_report = false},
      {.field = "output_format", .type = kWord, .words = {"same", "osgb", "3dtiles", "obj", "ply"},
       .default_value = "same",
       .help = "format of the tiles; 3dtiles and osgb have all levels of detail, obj and ply the finest"},
      {.field = "link", .help = "tiles without a patch as hard links of the originals, where they can be",
       .in_report = false},
  };
}

// The surface of patches.
std::vector<Option> SurfaceOptions() {
  return {
      {.field = "surface", .type = kWord, .words = {"thin-plate", "wang"},
       .default_value = SurfaceName(kDefaultSurface), .help = "wang is for comparison", .group = kPapers,
       .commands = kBoth, .to_workers = true},
      {.field = "filler", .type = kWord, .words = NamesOfFillers(), .default_value = FillerName(Filler::kAuto),
       .help = "of closed holes", .group = kPapers, .commands = kBoth, .to_workers = true},
      {.field = "tension", .type = kNumber, .words = {"auto"}, .value_name = "X", .max = 1000,
       .default_value = "auto", .unit = "per m^2", .help = "how taut the surface is; auto: from the rim",
       .needs = kThinPlate, .commands = kBoth, .to_workers = true},
      {.field = "uniform", .help = "keep the boundary's triangle size inside, no growth", .commands = kBoth,
       .to_workers = true},
      {.field = "gradation", .type = kNumber, .value_name = "X", .min = 1, .max = 10, .default_value = "1.3",
       .help = "growth of triangles from edge to edge inward", .needs = kGrowth, .commands = kBoth,
       .to_workers = true},
      {.field = "size_limit", .type = kNumber, .value_name = "X", .min = 1, .max = 1e6, .default_value = "16",
       .help = "longest edge as a multiple of the rim's mean edge", .needs = kGrowth, .commands = kBoth,
       .to_workers = true},
  };
}

// What is filled, and with what look.
std::vector<Option> ContentOptions() {
  return {
      {.field = "water", .type = kPath, .words = {"auto", "off"}, .value_name = "FILE", .default_value = "auto",
       .help = "fill level water flat; FILE: polygons with and without water, as a GIS writes them",
       .group = kEveryday, .commands = kAll},
      {.field = "water_profile", .type = kWord, .words = {"city", "usgs"}, .default_value = "city",
       .help = "what auto finds: lakes from 1000 m2, rivers from 6 m, or 8000 m2, 30 m", .needs = kWater,
       .commands = kAll},
      {.field = "water_colour", .type = kColour, .value_name = "R,G,B|#rrggbb",
       .help = "colour of filled water; without it, as its shore has it", .needs = kWater, .commands = kBoth},
      {.field = "textures", .type = kWord, .words = {"copy", "link", "off"}, .default_value = "copy",
       .help = "material files and images of OBJ tiles; link: images as hard links"},
      {.field = "texture", .type = kWord, .words = {"synthesize", "flat", "none"}, .default_value = "synthesize",
       .help = "filled faces of tiles with images: made from what lies around, one colour, or neither"},
      {.field = "clear", .type = kPath, .value_name = "FILE",
       .help = "polygons whose surface is taken out and filled anew, a file of a GIS", .group = kEveryday,
       .commands = kAll},
      {.field = "decisions", .type = kPath, .value_name = "FILE",
       .help = "a reviewer's decisions on holes, as report.html writes them; of a finished output only these are redone",
       .commands = kOfJobs | kOfInspect},
      {.field = "area", .type = kPath, .value_name = "FILE",
       .help = "polygon of what is to be covered, as a GIS writes it; without it, the scene's cells",
       .group = kEveryday, .commands = kOfJobs | kOfInspect},
      {.field = "cells", .type = kCells, .value_name = "CELLS",
       .help = "fill and write these alone: \"3,4 0,0-5,9\", column,row; without it, all", .group = kEveryday},
  };
}

// Of one mesh without a grid.
std::vector<Option> MeshOptions() {
  return {
      {.field = "allow_creases", .help = "fill holes also where the surface has to fold back", .commands = kOfFill},
      {.field = "weld", .type = kNumber, .words = {"off"}, .value_name = "TOLERANCE", .min = 1e-12, .max = 1e9,
       .default_value = "off", .unit = "of the mesh's units",
       .help = "merge boundary vertices that are no further apart before filling; the report lists each",
       .group = kEveryday, .commands = kOfFill},
      {.field = "dislocation_width", .type = kNumber, .words = {"auto"}, .value_name = "LENGTH", .min = 1e-12,
       .max = 1e9, .default_value = "auto", .unit = "of the mesh's units",
       .help = "how wide dislocations are at most; auto: a fifth of their edges", .commands = kOfFill},
      {.field = "fill_outlines", .help = "fill the outlines of sheets as well, not only holes", .group = kEveryday,
       .commands = kOfFill},
      {.field = "largest_hole", .type = kWholeNumber, .words = {"any"}, .value_name = "EDGES", .min = 3,
       .max = 1e9, .default_value = "any", .help = "leave holes with a longer boundary open", .group = kEveryday,
       .commands = kOfFill},
  };
}

// What Wang 2021 leaves open.
std::vector<Option> WangTable() {
  const WangOptions d;
  return {
      {.field = "longest_loop", .type = kWholeNumber, .value_name = "N", .min = kShortestLongestLoop,
       .max = kLongestLongestLoop, .default_value = absl::StrCat(d.longest_loop), .unit = "boundary vertices",
       .help = "of wang: longer boundaries are cut; of minimum-area: left open", .group = kPapers,
       .needs = kWangOrMinimumArea, .commands = kBoth, .to_workers = true},
      {.field = "fairing_steps", .type = kWholeNumber, .value_name = "N", .max = kMostFairingSteps,
       .default_value = absl::StrCat(d.fairing_steps), .help = "of wang and minimum-area: steps of fairing (eq. 4)",
       .group = kPapers, .needs = kWangOrMinimumArea, .commands = kBoth, .to_workers = true},
      {.field = "seam_smoothing", .type = kNumber, .value_name = "X", .max = 1,
       .default_value = absl::StrCat(d.seam_smoothing),
       .help = "of wang: how much seams are smoothed (gamma of eq. 5)", .group = kPapers, .needs = kWang},
      {.field = "seam_buffer", .type = kNumber, .value_name = "EDGES", .min = 1, .max = 100,
       .default_value = absl::StrCat(d.seam_buffer), .unit = "edges",
       .help = "of wang: how far around seams it smooths", .group = kPapers, .needs = kWang},
      {.field = "seam_points", .type = kWord, .words = {"projected", "spaced"},
       .default_value = SeamPointsName(d.seam_points), .help = "of wang: where points lie on grid lines",
       .group = kPapers, .needs = kWang},
      {.field = "closure", .type = kWord, .words = {"buffers", "line"}, .default_value = ClosureName(d.closure),
       .help = "of wang: how holes are closed along grid lines", .group = kPapers, .needs = kWang,
       .to_workers = true},
  };
}

// What the papers of advancing fronts leave open.
std::vector<Option> FrontTable() {
  const FillerOptions d;
  return {
      {.field = "front_steps", .type = kWord, .words = {"steady", "printed"},
       .default_value = FrontStepsName(d.steps),
       .help = "of fronts: printed: new vertices on the plane of their two edges, as in the papers",
       .group = kPapers, .needs = kFront, .commands = kBoth, .to_workers = true},
      {.field = "front_merge", .type = kNumber, .value_name = "X", .max = 1,
       .default_value = absl::StrCat(d.merge), .unit = "edges",
       .help = "of fronts: new vertices nearer to the front join it", .group = kPapers, .needs = kFront,
       .commands = kOfFill, .to_workers = true},
      {.field = "longest_rim", .type = kWholeNumber, .value_name = "N", .min = 3, .max = 100000,
       .default_value = absl::StrCat(d.longest_rim), .unit = "edges",
       .help = "of fronts: longer boundaries stay open", .group = kPapers, .needs = kFront, .commands = kOfFill,
       .to_workers = true},
      {.field = "filler_work", .type = kWholeNumber, .value_name = "N", .min = 1, .max = 1e6,
       .default_value = absl::StrCat(d.most_work), .unit = "million edges",
       .help = "of fronts: edges to look at for one hole, else it stays open", .group = kPapers, .needs = kFront,
       .commands = kOfFill, .to_workers = true},
      {.field = "front_bend", .type = kNumber, .words = {"auto"}, .value_name = "X", .max = 1e4,
       .default_value = "auto", .unit = "m", .help = "of advancing-front-normal: eta; auto: half the new edge",
       .group = kPapers, .needs = kFrontNormal, .commands = kOfFill, .to_workers = true},
      {.field = "halvings", .type = kWholeNumber, .value_name = "N", .max = 10,
       .default_value = absl::StrCat(d.halvings),
       .help = "of advancing-front-curvature: how often edges are halved", .group = kPapers,
       .needs = kFrontCurvature, .commands = kOfFill, .to_workers = true},
      {.field = "centroid_steps", .type = kWholeNumber, .value_name = "N", .max = 1000,
       .default_value = absl::StrCat(d.centroid_steps),
       .help = "of advancing-front-curvature: moves to the centroid", .group = kPapers, .needs = kFrontCurvature,
       .commands = kOfFill, .to_workers = true},
  };
}

// What Xu 2014 leaves open.
std::vector<Option> SvmTable() {
  const FillerOptions d;
  return {
      {.field = "long_edge", .type = kNumber, .value_name = "X", .min = 1, .max = 100,
       .default_value = absl::StrCat(d.long_edge), .unit = "mean edges",
       .help = "of svm-laplacian: longer edges are split", .group = kPapers, .needs = kSvm, .commands = kOfFill,
       .to_workers = true},
      {.field = "svm_laplacian", .type = kWord, .words = {"area", "mean"},
       .default_value = LaplacianScaleName(d.scale),
       .help = "of svm-laplacian: Laplacians over areas (eq. 4) or over weights (eq. 2)", .group = kPapers,
       .needs = kSvm, .commands = kOfFill, .to_workers = true},
      {.field = "svm_rings", .type = kWholeNumber, .value_name = "N", .min = 1, .max = 20,
       .default_value = absl::StrCat(d.rings), .help = "of svm-laplacian: rings that are learnt from",
       .group = kPapers, .needs = kSvm, .commands = kOfFill, .to_workers = true},
      {.field = "svm_gamma", .type = kNumber, .value_name = "X", .min = 1e-3, .max = 1e6,
       .default_value = absl::StrCat(d.gamma), .help = "of svm-laplacian: weight of errors (eq. 11)",
       .group = kPapers, .needs = kSvm, .commands = kOfFill, .to_workers = true},
      {.field = "svm_width", .type = kNumber, .value_name = "X", .min = 0.5, .max = 1000,
       .default_value = absl::StrCat(d.kernel_width), .unit = "mean edges",
       .help = "of svm-laplacian: width of the kernel", .group = kPapers, .needs = kSvm, .commands = kOfFill,
       .to_workers = true},
  };
}

// clang-format on

}  // namespace

const std::vector<Option>& AllOptions() {
  static const auto* const options = [] {
    auto* all = new std::vector<Option>;
    for (auto table :
         {FileOptions(), SurfaceOptions(), ContentOptions(), MeshOptions(), WangTable(), FrontTable(), SvmTable()}) {
      all->insert(all->end(), table.begin(), table.end());
    }
    return all;
  }();
  return *options;
}

}  // namespace tilemend
