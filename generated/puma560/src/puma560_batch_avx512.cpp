// puma560: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "puma560". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Functions over many states, compiled for the instructions avx512; without them, a null pointer.
#include <alembert/batch.hpp>
#include <cstddef>

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__) && defined(__FMA__)

#define ALEMBERT_PACK_NAMESPACE batch_avx512
#include <alembert/pack.hpp>
#include <puma560/puma560_impl.hpp>

namespace alembert::mechanisms::puma560 {
namespace {

namespace pack = ::alembert::batch_avx512;
using ::alembert::BatchCall;
using pack::Pack;

/// Time, parameters and wrenches of all states in all lanes.
[[maybe_unused]] void take_common(const BatchCall& call, Inputs<Pack>& in) {
  in.t = Pack(call.t);
}

/// Those that differ from state to state.
[[maybe_unused]] void take_own([[maybe_unused]] const BatchCall& call, [[maybe_unused]] const pack::Window& window,
                               [[maybe_unused]] Inputs<Pack>& in) {
  if (call.t_of_state != nullptr) window.load(1, call.t_of_state, call.stride, &in.t);
}

::std::size_t inverse_dynamics_lanes(const BatchCall& call, ::std::size_t first, ::std::size_t last) {
  Inputs<Pack> in;
  take_common(call, in);
  return pack::for_each_window(first, last, [&](const pack::Window& window, int skip) {
    Pack q[6];
    Pack qd[6];
    Pack qdd[6];
    Pack tau[6];
    window.load(6, call.arguments[0], call.stride, q);
    window.load(6, call.arguments[1], call.stride, qd);
    window.load(6, call.arguments[2], call.stride, qdd);
    take_own(call, window, in);
    inverse_dynamics<Pack>(q, qd, qdd, in, tau);
    window.store(6, tau, call.results[0], call.stride);
    return pack::count_not_finite(window, skip, pack::zero_if_finite(6, tau));
  });
}

::std::size_t mass_matrix_and_bias_lanes(const BatchCall& call, ::std::size_t first, ::std::size_t last) {
  Inputs<Pack> in;
  take_common(call, in);
  return pack::for_each_window(first, last, [&](const pack::Window& window, int skip) {
    Pack q[6];
    Pack qd[6];
    Pack M[36];
    Pack c[6];
    window.load(6, call.arguments[0], call.stride, q);
    window.load(6, call.arguments[1], call.stride, qd);
    take_own(call, window, in);
    mass_matrix_and_bias<Pack>(q, qd, in, M, c);
    window.store(36, M, call.results[0], call.stride);
    window.store(6, c, call.results[1], call.stride);
    return pack::count_not_finite(window, skip, pack::zero_if_finite(36, M) + pack::zero_if_finite(6, c));
  });
}

::std::size_t forward_dynamics_lanes(const BatchCall& call, ::std::size_t first, ::std::size_t last) {
  Inputs<Pack> in;
  take_common(call, in);
  return pack::for_each_window(first, last, [&](const pack::Window& window, int skip) {
    Pack q[6];
    Pack qd[6];
    Pack tau[6];
    Pack qdd[6];
    Pack M[36];
    window.load(6, call.arguments[0], call.stride, q);
    window.load(6, call.arguments[1], call.stride, qd);
    window.load(6, call.arguments[2], call.stride, tau);
    take_own(call, window, in);
    mass_matrix_and_bias<Pack>(q, qd, in, M, qdd);
    for (int i = 0; i < 6; ++i) qdd[i] = tau[i] - qdd[i];
    pack::solve_positive_definite<6>(M, qdd);
    window.store(6, qdd, call.results[0], call.stride);
    return pack::count_not_finite(window, skip, pack::zero_if_finite(6, qdd));
  });
}

constexpr ::alembert::BatchFunction kFunctions[] = {inverse_dynamics_lanes, mass_matrix_and_bias_lanes,
    forward_dynamics_lanes};

}  // namespace

namespace detail {
const ::alembert::BatchFunction* batch_avx512();
const ::alembert::BatchFunction* batch_avx512() { return kFunctions; }
}  // namespace detail

}  // namespace alembert::mechanisms::puma560

#else

namespace alembert::mechanisms::puma560::detail {
const ::alembert::BatchFunction* batch_avx512();
const ::alembert::BatchFunction* batch_avx512() { return nullptr; }
}  // namespace alembert::mechanisms::puma560::detail

#endif
