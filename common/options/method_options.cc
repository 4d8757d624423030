#include "common/options/method_options.h"

namespace tilemend {

WangOptions WangOptionsOf(const v1::JobSpec& spec) {
  WangOptions options;
  if (spec.has_seam_smoothing()) options.seam_smoothing = spec.seam_smoothing();
  if (spec.has_seam_buffer()) options.seam_buffer = spec.seam_buffer();
  if (spec.has_longest_loop()) options.longest_loop = spec.longest_loop();
  if (spec.has_fairing_steps()) options.fairing_steps = spec.fairing_steps();
  options.seam_points = SeamPointsNamed(spec.seam_points()).value_or(options.seam_points);
  options.closure = ClosureNamed(spec.closure()).value_or(options.closure);
  return options;
}

FillerOptions FillerOptionsOf(const v1::JobSpec& spec) {
  FillerOptions options;
  options.steps = FrontStepsNamed(spec.front_steps()).value_or(options.steps);
  if (spec.has_front_merge()) options.merge = spec.front_merge();
  if (spec.has_longest_rim()) options.longest_rim = spec.longest_rim();
  if (spec.has_filler_work()) options.most_work = spec.filler_work();
  if (spec.has_front_bend()) options.bend = spec.front_bend();
  if (spec.has_long_edge()) options.long_edge = spec.long_edge();
  options.scale = LaplacianScaleNamed(spec.svm_laplacian()).value_or(options.scale);
  if (spec.has_svm_rings()) options.rings = spec.svm_rings();
  if (spec.has_svm_gamma()) options.gamma = spec.svm_gamma();
  if (spec.has_svm_width()) options.kernel_width = spec.svm_width();
  if (spec.has_halvings()) options.halvings = spec.halvings();
  if (spec.has_centroid_steps()) options.centroid_steps = spec.centroid_steps();
  return options;
}

}  // namespace tilemend
