// Functions of the catalogue in long double, compiled without the flags under test.
#include <free_body/free_body_impl.hpp>
#include <puma560/puma560_impl.hpp>
#include <runtime_parameters/runtime_parameters_impl.hpp>
#include <tree_every_joint/tree_every_joint_impl.hpp>

#include "mechanisms.hpp"

#define ALEMBERT_DEFINE(name)                                                                               \
  void name##_start(double* q) {                                                                            \
    for (const double x : alembert::mechanisms::name::kInitialCoordinates) *q++ = x;                        \
  }                                                                                                         \
  void name##_exact(const double* q, const double* qd, const double* qdd, long double* tau, long double* M, \
                    long double* c, long double* e) {                                                       \
    namespace m = alembert::mechanisms::name;                                                               \
    long double x[m::kNq], u[m::kNv], a[m::kNv];                                                            \
    for (int i = 0; i < m::kNq; ++i) x[i] = q[i];                                                           \
    for (int i = 0; i < m::kNv; ++i) {                                                                      \
      u[i] = qd[i];                                                                                         \
      a[i] = qdd[i];                                                                                        \
    }                                                                                                       \
    const m::Inputs<long double> in;                                                                        \
    m::inverse_dynamics(x, u, a, in, tau);                                                                  \
    m::mass_matrix_and_bias(x, u, in, M, c);                                                                \
    m::energy(x, u, in, e);                                                                                 \
  }
ALEMBERT_MECHANISMS(ALEMBERT_DEFINE)
