// Which mechanisms of the catalogue are compiled with flags, and compared with themselves in long double.
#pragma once

#define ALEMBERT_MECHANISMS(X) X(puma560) X(free_body) X(tree_every_joint) X(runtime_parameters)
#define ALEMBERT_DECLARE(name)                                                                              \
                                                                                                            \
  void name##_start(double* q);                                                                             \
  void name##_exact(const double* q, const double* qd, const double* qdd, long double* tau, long double* M, \
                    long double* c, long double* e);
ALEMBERT_MECHANISMS(ALEMBERT_DECLARE)
#undef ALEMBERT_DECLARE
