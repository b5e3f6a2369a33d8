// chain6r: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "chain6r". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Functions over many states: the choice of instructions at run time, and the C interface.
#include <chain6r/chain6r.h>
#include <chain6r/chain6r_batch.hpp>

namespace alembert::mechanisms::chain6r {

namespace detail {

// Null if not compiled for these instructions.
const ::alembert::BatchFunction* batch_avx512();
const ::alembert::BatchFunction* batch_avx2();
const ::alembert::BatchFunction* batch_baseline();

}  // namespace detail

namespace {

/// The functions in their order in the table, for the widest instructions up to those wanted.
::alembert::BatchFunction choose(::alembert::Instructions wanted, int function) {
  if ((wanted == ::alembert::Instructions::best || wanted >= ::alembert::Instructions::avx512) &&
      ::alembert::has_instructions(::alembert::Instructions::avx512) && detail::batch_avx512() != nullptr)
    return detail::batch_avx512()[function];
  if ((wanted == ::alembert::Instructions::best || wanted >= ::alembert::Instructions::avx2) &&
      ::alembert::has_instructions(::alembert::Instructions::avx2) && detail::batch_avx2() != nullptr)
    return detail::batch_avx2()[function];
  return detail::batch_baseline()[function];
}

::alembert::BatchCall make_call(const BatchInputs& in, ::std::size_t stride) {
  ::alembert::BatchCall call = {};
  call.stride = stride;
  call.t = in.common.t;
  call.parameters = in.common.parameters.data();
  call.wrenches = in.common.wrenches.data();
  call.t_of_state = in.t;
  call.parameters_of_state = in.parameters;
  call.wrenches_of_state = in.wrenches;
  return call;
}

}  // namespace

::std::size_t inverse_dynamics_batch(::std::size_t n, ::std::size_t stride, const double* q, const double* qd,
                                     const double* qdd, const BatchInputs& in, double* tau,
                                     const ::alembert::BatchOptions& options) {
  ::alembert::BatchCall call = make_call(in, stride);
  call.arguments[0] = q;
  call.arguments[1] = qd;
  call.arguments[2] = qdd;
  call.results[0] = tau;
  return ::alembert::run_batch(choose(options.instructions, 0), call, n, options.threads);
}

::std::size_t mass_matrix_and_bias_batch(::std::size_t n, ::std::size_t stride, const double* q, const double* qd,
                                        const BatchInputs& in, double* M, double* c,
                                        const ::alembert::BatchOptions& options) {
  ::alembert::BatchCall call = make_call(in, stride);
  call.arguments[0] = q;
  call.arguments[1] = qd;
  call.results[0] = M;
  call.results[1] = c;
  return ::alembert::run_batch(choose(options.instructions, 1), call, n, options.threads);
}

::std::size_t forward_dynamics_batch(::std::size_t n, ::std::size_t stride, const double* q, const double* qd,
                                     const double* tau, const BatchInputs& in, double* qdd,
                                     const ::alembert::BatchOptions& options) {
  ::alembert::BatchCall call = make_call(in, stride);
  call.arguments[0] = q;
  call.arguments[1] = qd;
  call.arguments[2] = tau;
  call.results[0] = qdd;
  return ::alembert::run_batch(choose(options.instructions, 2), call, n, options.threads);
}

}  // namespace alembert::mechanisms::chain6r

extern "C" {

int chain6r_inverse_dynamics_batch(size_t n, size_t stride, const double* q, const double* qd, const double* qdd,
                                   double t, const double* parameters, const double* wrenches, double* tau,
                                   int threads) {
  if (stride < n || q == nullptr || qd == nullptr || qdd == nullptr || tau == nullptr) return 1;
  ::alembert::mechanisms::chain6r::BatchInputs in;
  in.common.t = t;
  if (parameters != nullptr)
    for (double& x : in.common.parameters) x = *parameters++;
  in.wrenches = wrenches;
  ::alembert::BatchOptions options;
  options.threads = threads;
  return ::alembert::mechanisms::chain6r::inverse_dynamics_batch(n, stride, q, qd, qdd, in, tau, options) == 0 ? 0 : 2;
}

int chain6r_mass_matrix_and_bias_batch(size_t n, size_t stride, const double* q, const double* qd, double t,
                                       const double* parameters, const double* wrenches, double* M, double* c,
                                       int threads) {
  if (stride < n || q == nullptr || qd == nullptr || M == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::chain6r::BatchInputs in;
  in.common.t = t;
  if (parameters != nullptr)
    for (double& x : in.common.parameters) x = *parameters++;
  in.wrenches = wrenches;
  ::alembert::BatchOptions options;
  options.threads = threads;
  return ::alembert::mechanisms::chain6r::mass_matrix_and_bias_batch(n, stride, q, qd, in, M, c, options) == 0 ? 0 : 2;
}

int chain6r_forward_dynamics_batch(size_t n, size_t stride, const double* q, const double* qd, const double* tau,
                                   double t, const double* parameters, const double* wrenches, double* qdd,
                                   int threads) {
  if (stride < n || q == nullptr || qd == nullptr || tau == nullptr || qdd == nullptr) return 1;
  ::alembert::mechanisms::chain6r::BatchInputs in;
  in.common.t = t;
  if (parameters != nullptr)
    for (double& x : in.common.parameters) x = *parameters++;
  in.wrenches = wrenches;
  ::alembert::BatchOptions options;
  options.threads = threads;
  return ::alembert::mechanisms::chain6r::forward_dynamics_batch(n, stride, q, qd, tau, in, qdd, options) == 0 ? 0 : 2;
}

}  // extern "C"
