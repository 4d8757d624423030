// The ways to fill closed holes that can be asked for by name.
#ifndef TILEMEND_COMMON_RECORDS_FILLER_H_
#define TILEMEND_COMMON_RECORDS_FILLER_H_

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tilemend {

enum class Filler : uint8_t {
  kAuto,                     // by the kind of the hole (worker/fill/fill_holes.h)
  kAdvancingFrontNormal,     // Sun et al. 2012
  kAdvancingFrontCurvature,  // the front refined by Gaussian curvature
  kAdvancingFrontPoisson,    // Zhao et al. 2007
  kSvmLaplacian,             // Xu et al. 2014
  kMinimumArea,              // Liepa 2003, as Wang 2021 takes it
};

inline constexpr std::array kFillers = {Filler::kAuto,
                                        Filler::kAdvancingFrontNormal,
                                        Filler::kAdvancingFrontCurvature,
                                        Filler::kAdvancingFrontPoisson,
                                        Filler::kSvmLaplacian,
                                        Filler::kMinimumArea};

// As flags, jobs and reports say it.
constexpr const char* FillerName(Filler filler) {
  switch (filler) {
    case Filler::kAuto:
      break;
    case Filler::kAdvancingFrontNormal:
      return "advancing-front-normal";
    case Filler::kAdvancingFrontCurvature:
      return "advancing-front-curvature";
    case Filler::kAdvancingFrontPoisson:
      return "advancing-front-poisson";
    case Filler::kSvmLaplacian:
      return "svm-laplacian";
    case Filler::kMinimumArea:
      return "minimum-area";
  }
  return "auto";
}

// The filler of that name; nothing for any other text.
constexpr std::optional<Filler> FillerNamed(std::string_view name) {
  for (const Filler filler : kFillers) {
    if (name == FillerName(filler)) return filler;
  }
  return std::nullopt;
}

// Those that share the advancing front.
inline constexpr std::array kFrontFillers = {Filler::kAdvancingFrontNormal, Filler::kAdvancingFrontCurvature,
                                             Filler::kAdvancingFrontPoisson, Filler::kSvmLaplacian};

constexpr bool HasFront(Filler filler) { return filler != Filler::kAuto && filler != Filler::kMinimumArea; }

// Why an option that these fillers have is refused beside another one.
inline std::string NoSuchOption(Filler filler, std::span<const Filler> fillers) {
  std::string names;
  for (const Filler having : fillers) names += (names.empty() ? "" : ", ") + std::string(FillerName(having));
  return "the filler " + std::string(FillerName(filler)) + " has no such option; leave it out, or choose " + names;
}

// Where a front puts new vertices.
enum class FrontSteps : uint8_t {
  kSteady,   // across normals that the front carries along or fits, and no nearer than the rim's edges are long
  kPrinted,  // as the papers say, on the plane of the two edges: large fronts leave their surface or do not close
};

constexpr const char* FrontStepsName(FrontSteps steps) { return steps == FrontSteps::kPrinted ? "printed" : "steady"; }

// The steps of that name; nothing for any other text.
constexpr std::optional<FrontSteps> FrontStepsNamed(std::string_view name) {
  for (const FrontSteps steps : {FrontSteps::kSteady, FrontSteps::kPrinted}) {
    if (name == FrontStepsName(steps)) return steps;
  }
  return std::nullopt;
}

// What is learnt as the Laplacian of a vertex (Xu 2014).
enum class LaplacianScale : uint8_t {
  kMean,  // eq. 1 to 3: the weighted mean of its neighbours less itself, which grows with the square of the edges
  kArea,  // eq. 4: the same sum over the vertex's Voronoi area, the normal by mean curvature, whatever the triangles
};

constexpr const char* LaplacianScaleName(LaplacianScale scale) {
  return scale == LaplacianScale::kArea ? "area" : "mean";
}

// The scale of that name; nothing for any other text.
constexpr std::optional<LaplacianScale> LaplacianScaleNamed(std::string_view name) {
  for (const LaplacianScale scale : {LaplacianScale::kMean, LaplacianScale::kArea}) {
    if (name == LaplacianScaleName(scale)) return scale;
  }
  return std::nullopt;
}

// What the papers leave open.
struct FillerOptions {
  FrontSteps steps = FrontSteps::kSteady;  // of every front
  // Of every front: a new vertex closer than this to the front, in edges there, becomes a vertex of it (Xu 2014, 3.2).
  double merge = 0.6;  // [0, 1]
  // Likewise: holes of more boundary edges stay open, with that reason.
  int32_t longest_rim = 1000;  // [3, 100000]
  // Likewise: edges of the front that may be looked at for one hole, in millions; beyond, it stays open with that
  // reason. The same on every machine; a million takes about 0.04 s.
  int32_t most_work = 100;  // [1, 1000000]
  // Of Sun 2012, eq. 5: eta, metres. None: half the new edge, with which the new vertex lies on the osculating circle.
  std::optional<double> bend = {};  // [0, 10000]
  // Of Xu 2014. Edges of the rim longer than this many mean ones are split (3.1: k). Next are the rings of the surface
  // that are learnt from (3.3: k) and gamma of eq. 11. Last is the width of the kernel in mean edges of the rim.
  double long_edge = 1.5;  // [1, 100]
  LaplacianScale scale = LaplacianScale::kArea;
  int32_t rings = 3;         // [1, 20]
  double gamma = 10;         // [1e-3, 1e6]
  double kernel_width = 10;  // [0.5, 1000]
  // Of the curvature paper: how often an edge may be halved, and how often vertices go to the centroid.
  int32_t halvings = 2;         // [0, 10]
  int32_t centroid_steps = 10;  // [0, 1000]
};

}  // namespace tilemend

#endif  // TILEMEND_COMMON_RECORDS_FILLER_H_
