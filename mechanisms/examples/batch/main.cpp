// The inverse dynamics of a million states of the PUMA 560 in one call: packs of states in the vector
// registers, blocks of packs on all threads. The columns of an Eigen matrix with a row for each state lie as
// the function wants them.
#include <alembert/batch.hpp>
#include <chrono>
#include <cstdio>
#include <puma560/puma560.hpp>
#include <puma560/puma560_batch.hpp>

namespace puma560 = alembert::mechanisms::puma560;
using Puma = puma560::Mechanism<>;
using States = Eigen::Matrix<double, Eigen::Dynamic, Puma::kNv>;  // column-major: a row for each state

int main() {
  const Eigen::Index n = 1000000;
  const States q = States::Random(n, 6), qd = States::Random(n, 6), qdd = States::Random(n, 6);
  States tau(n, 6);
  alembert::BatchOptions options;
  options.threads = 0;  // one a core

  const auto begin = std::chrono::steady_clock::now();
  const std::size_t bad = puma560::inverse_dynamics_batch(n, tau.outerStride(), q.data(), qd.data(),
                                                          qdd.data(), {}, tau.data(), options);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
  if (bad != 0) return 1;

  double error = 0;
  for (Eigen::Index s = 0; s < n; s += 99991) {
    const Puma::SpeedVector one = Puma::inverse_dynamics(q.row(s), qd.row(s), qdd.row(s));
    error = std::max(error, (one - tau.row(s).transpose()).cwiseAbs().maxCoeff());
  }
  std::printf("%.1f million states a second; largest difference from one at a time: %.1e N m\n",
              1e-6 * static_cast<double>(n) / time.count(), error);
  return error < 1e-10 ? 0 : 1;
}
