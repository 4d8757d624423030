// Values on a coarse lattice of squares, spread from where they are known to where they are not.
#ifndef TILEMEND_WORKER_TEXTURE_SQUARE_LATTICE_H_
#define TILEMEND_WORKER_TEXTURE_SQUARE_LATTICE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "worker/texture/ortho_raster.h"

namespace tilemend {

using Channels = std::array<float, 3>;

// Squares of 2^k pixels of a raster's lattice. The first square begins at a multiple of its side from the lattice's
// origin, so the squares of all rasters with that texel coincide.
struct SquareLattice {
  int32_t pixels = 1;  // along a side
  int64_t column = 0;  // of the first square
  int64_t row = 0;
  int32_t width = 0;
  int32_t height = 0;
  std::vector<Channels> values;
  std::vector<float> weights;  // 0: not known

  size_t At(int32_t x, int32_t y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  }
};

// A lattice of zeros over the frame, with squares of `side` metres rounded to a power of two of pixels.
SquareLattice LatticeOver(const RasterFrame& frame, double side);

// The square that holds a pixel of the frame.
size_t SquareOf(const SquareLattice& lattice, const RasterFrame& frame, int32_t x, int32_t y);

// Bilinear between the centres of squares, at the centre of a pixel. Reads values, not weights.
Channels ValueAt(const SquareLattice& lattice, const RasterFrame& frame, int32_t x, int32_t y);

// Smooths by a Gaussian of `sigma` squares, normalised by the weights; squares within 3 sigma of a known one become
// known. Cost: O(squares * sigma).
void SmoothSquares(double sigma, SquareLattice& lattice);

// Gives every square a value. Known ones keep theirs. The rest gets means of ever larger squares, interpolated
// (push-pull; Gortler, Grzeszczuk, Szeliski and Cohen 1996). All values are 0 if none is known. Cost: O(squares).
void FillSquares(SquareLattice& lattice);

// Gives every square a value. Known ones keep theirs; from them values fall to 0 over some `reach` squares. They solve
// v = reach^2 * laplacian of v (the screened Poisson equation of Bhat, Curless, Cohen and Zitnick 2008), by `sweeps` of
// successive over-relaxation. Cost: O(squares * sweeps).
void FadeSquares(double reach, int sweeps, SquareLattice& lattice);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_TEXTURE_SQUARE_LATTICE_H_
