// Generated code for one state and for many, compiled with the flags under test: sums in another order and
// fused products change last digits, and that is all they may change. Out: nothing and 0, or what is wrong
// and 1.
#include <cmath>
#include <cstdio>
#include <free_body/free_body_raw.hpp>
#include <puma560/puma560_batch.hpp>
#include <puma560/puma560_raw.hpp>
#include <random>
#include <runtime_parameters/runtime_parameters_raw.hpp>
#include <tree_every_joint/tree_every_joint_raw.hpp>
#include <vector>

#include "../../runtime/flags/reference.hpp"
#include "mechanisms.hpp"

namespace {

int failures = 0;
constexpr double kBound = 1e-12;  // of the largest entry

void compare(const char* what, int n, const double* found, const long double* exact) {
  long double largest = 0, worst = 0;
  for (int i = 0; i < n; ++i) {
    largest = std::fabs(exact[i]) > largest ? std::fabs(exact[i]) : largest;
    const long double error = std::fabs(static_cast<long double>(found[i]) - exact[i]);
    worst = error > worst ? error : worst;
  }
  bool finite = true;
  for (int i = 0; i < n; ++i) finite = finite && !is_a_nan(found[i]);
  if (finite && worst <= kBound * largest) return;
  std::printf("wrong: %s by %Lg of %Lg\n", what, worst, largest);
  ++failures;
}

std::mt19937_64 engine(7);
double uniform(double width) {
  return std::uniform_real_distribution<double>(-width, width)(engine);
}

#define ALEMBERT_CHECK(name)                                                                    \
  void check_##name() {                                                                         \
    namespace m = alembert::mechanisms::name;                                                   \
    for (int k = 0; k < 50; ++k) {                                                              \
      double q[m::kNq], u[m::kNv], a[m::kNv], tau[m::kNv], M[m::kNv * m::kNv], c[m::kNv], e[2]; \
      long double tau_x[m::kNv], M_x[m::kNv * m::kNv], c_x[m::kNv], e_x[2];                     \
      name##_start(q);                                                                          \
      for (double& x : q) x += uniform(k < 10 ? 0.1 : 1.5);                                     \
      for (double& x : u) x = uniform(3);                                                       \
      for (double& x : a) x = uniform(10);                                                      \
      const m::Inputs<double> in;                                                               \
      m::inverse_dynamics(q, u, a, in, tau);                                                    \
      m::mass_matrix_and_bias(q, u, in, M, c);                                                  \
      m::energy(q, u, in, e);                                                                   \
      name##_exact(q, u, a, tau_x, M_x, c_x, e_x);                                              \
      compare(#name " inverse_dynamics", m::kNv, tau, tau_x);                                   \
      compare(#name " mass_matrix", m::kNv* m::kNv, M, M_x);                                    \
      compare(#name " bias", m::kNv, c, c_x);                                                   \
      compare(#name " energy", 2, e, e_x);                                                      \
    }                                                                                           \
  }
ALEMBERT_MECHANISMS(ALEMBERT_CHECK)

/// A batch with one state spoilt: the others are right and one is counted.
void check_batch() {
  namespace m = alembert::mechanisms::puma560;
  constexpr std::size_t n = 37;
  const double values[] = {0.5, not_a_number(), infinity()};
  for (int which = 0; which < 3; ++which) {
    const double bad = values[which];
    const std::size_t expected = which == 0 ? 0 : 1;
    for (std::size_t spoilt = 0; spoilt < n; spoilt += 4) {
      std::vector<double> q(6 * n), u(6 * n), a(6 * n), tau(6 * n), qdd(6 * n);
      for (std::vector<double>* x : {&q, &u, &a})
        for (double& y : *x) y = uniform(2);
      q[3 * n + spoilt] = bad;
      const std::size_t failed =
          m::inverse_dynamics_batch(n, n, q.data(), u.data(), a.data(), {}, tau.data());
      const std::size_t unsolved =
          m::forward_dynamics_batch(n, n, q.data(), u.data(), tau.data(), {}, qdd.data());
      if (failed != expected || unsolved != expected) {
        std::printf("wrong: %zu and %zu states failed, expected %zu\n", failed, unsolved, expected);
        ++failures;
      }
      for (std::size_t s = 0; s < n; ++s) {
        if (s == spoilt && expected == 1) continue;
        double one[3][6], found[6];
        for (std::size_t i = 0; i < 6; ++i) {
          one[0][i] = q[i * n + s];
          one[1][i] = u[i * n + s];
          one[2][i] = a[i * n + s];
          found[i] = tau[i * n + s];
        }
        long double exact[6], M[36], c[6], e[2];
        puma560_exact(one[0], one[1], one[2], exact, M, c, e);
        compare("batch of inverse_dynamics", 6, found, exact);
        for (std::size_t i = 0; i < 6; ++i) {
          if (std::fabs(qdd[i * n + s] - one[2][i]) > 1e-9) {
            std::printf("wrong: batch of forward_dynamics gives %g for %g\n", qdd[i * n + s], one[2][i]);
            ++failures;
          }
        }
      }
    }
  }
}

}  // namespace

int main() {
#define ALEMBERT_CALL(name) check_##name();
  ALEMBERT_MECHANISMS(ALEMBERT_CALL)
  check_batch();
  return failures == 0 ? 0 : 1;
}
