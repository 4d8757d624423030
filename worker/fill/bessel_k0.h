// The modified Bessel function of the second kind, of order zero.
#ifndef TILEMEND_WORKER_FILL_BESSEL_K0_H_
#define TILEMEND_WORKER_FILL_BESSEL_K0_H_

namespace tilemend {

// K0(x), to some 15 digits. Precondition: x > 0. Eigen's works out the series of both ranges and takes one, at four
// times the cost. Coefficients: Cephes, k0.c (Moshier 1989).
double BesselK0(double x);

}  // namespace tilemend

#endif  // TILEMEND_WORKER_FILL_BESSEL_K0_H_
