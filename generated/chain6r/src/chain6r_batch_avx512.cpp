// chain6r: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "chain6r". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// Functions over many states, compiled for the instructions avx512; without them, a null pointer.
#include <alembert/batch.hpp>
#include <cstddef>

#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512VL__) && defined(__FMA__)

#define ALEMBERT_PACK_NAMESPACE batch_avx512
#include <alembert/pack_window.hpp>
#include <chain6r/chain6r_batch_impl.hpp>

namespace alembert::mechanisms::chain6r {
namespace {

namespace pack = ::alembert::batch_avx512;
using ::alembert::BatchCall;
using pack::Pack;

/// Time, parameters and wrenches of all states in all lanes.
[[maybe_unused]] void take_common(const BatchCall& call, Inputs<Pack>& in) {
  in.t = Pack(call.t);
}

/// Those that differ from state to state.
[[maybe_unused]] void take_own(const BatchCall& call, const pack::Window& window, Inputs<Pack>* in) {
  Pack row[pack::kMostPacks];
  if (call.t_of_state != nullptr) {
    window.load(call.t_of_state, row, 1);
    for (int k = 0; k < window.packs; ++k) in[k].t = row[k];
  }
}

::std::size_t inverse_dynamics_lanes(const BatchCall& call, ::std::size_t first, ::std::size_t last) {
  constexpr int kPacks = pack::packs_together(24);
  Pack q[kPacks * 6];
  Pack qd[kPacks * 6];
  Pack qdd[kPacks * 6];
  Pack tau[kPacks * 6];
  Inputs<Pack> inputs[kPacks];
  for (Inputs<Pack>& in : inputs) take_common(call, in);
  Pack kept[47];
  const double* const streamed = pack::is_streamed(last - first, 6) ? call.results[0] : nullptr;
  return pack::for_each_window<kPacks>(first, last, streamed, [&](const pack::Window& window) {
    window.load(6, call.arguments[0], call.stride, q);
    window.load(6, call.arguments[1], call.stride, qd);
    window.load(6, call.arguments[2], call.stride, qdd);
    take_own(call, window, inputs);
    detail::inverse_dynamics_packs<Pack>(window.packs, q, qd, qdd, tau, kept, inputs);
    window.store(6, pack::SameRows(), 6, tau, call.results[0], call.stride);
    Pack sum(0.0);
    for (int k = 0; k < window.packs; ++k) sum = sum + (pack::zero_if_finite(6, tau + 6 * k));
    if (pack::is_zero(sum)) return ::std::size_t{0};
    ::std::size_t failed = 0;
    for (int k = 0; k < window.packs; ++k) failed += window.count_not_finite(pack::zero_if_finite(6, tau + 6 * k));
    return failed;
  });
}

::std::size_t mass_matrix_and_bias_lanes(const BatchCall& call, ::std::size_t first, ::std::size_t last) {
  constexpr int kPacks = pack::packs_together(39);
  Pack q[kPacks * 6];
  Pack qd[kPacks * 6];
  Pack M[kPacks * 21];
  Pack c[kPacks * 6];
  Inputs<Pack> inputs[kPacks];
  for (Inputs<Pack>& in : inputs) take_common(call, in);
  Pack kept[75];
  const double* const streamed = pack::is_streamed(last - first, 42) ? call.results[0] : nullptr;
  return pack::for_each_window<kPacks>(first, last, streamed, [&](const pack::Window& window) {
    window.load(6, call.arguments[0], call.stride, q);
    window.load(6, call.arguments[1], call.stride, qd);
    take_own(call, window, inputs);
    detail::mass_matrix_and_bias_packs<Pack>(window.packs, q, qd, M, c, kept, inputs);
    window.store(36, detail::mass_matrix_and_bias_M_rows, 21, M, call.results[0], call.stride);
    window.store(6, pack::SameRows(), 6, c, call.results[1], call.stride);
    Pack sum(0.0);
    for (int k = 0; k < window.packs; ++k) sum = sum + (pack::zero_if_finite(21, M + 21 * k) + pack::zero_if_finite(6, c + 6 * k));
    if (pack::is_zero(sum)) return ::std::size_t{0};
    ::std::size_t failed = 0;
    for (int k = 0; k < window.packs; ++k) failed += window.count_not_finite(pack::zero_if_finite(21, M + 21 * k) + pack::zero_if_finite(6, c + 6 * k));
    return failed;
  });
}

::std::size_t forward_dynamics_lanes(const BatchCall& call, ::std::size_t first, ::std::size_t last) {
  constexpr int kPacks = pack::packs_together(51);
  Pack q[kPacks * 6];
  Pack qd[kPacks * 6];
  Pack tau[kPacks * 6];
  Pack qdd[kPacks * 6];
  Pack M[kPacks * 21];
  Pack c[kPacks * 6];
  Inputs<Pack> inputs[kPacks];
  for (Inputs<Pack>& in : inputs) take_common(call, in);
  Pack kept[75];
  Pack square[36];
  const double* const streamed = pack::is_streamed(last - first, 6) ? call.results[0] : nullptr;
  return pack::for_each_window<kPacks>(first, last, streamed, [&](const pack::Window& window) {
    window.load(6, call.arguments[0], call.stride, q);
    window.load(6, call.arguments[1], call.stride, qd);
    window.load(6, call.arguments[2], call.stride, tau);
    take_own(call, window, inputs);
    detail::mass_matrix_and_bias_packs<Pack>(window.packs, q, qd, M, c, kept, inputs);
    for (int k = 0; k < window.packs; ++k) {
      for (int i = 0; i < 36; ++i) square[i] = M[21 * k + detail::mass_matrix_and_bias_M_rows[i]];
      for (int i = 0; i < 6; ++i) qdd[6 * k + i] = tau[6 * k + i] - c[6 * k + pack::SameRows()[i]];
      pack::solve_positive_definite<6>(square, qdd + 6 * k);
    }
    window.store(6, pack::SameRows(), 6, qdd, call.results[0], call.stride);
    Pack sum(0.0);
    for (int k = 0; k < window.packs; ++k) sum = sum + (pack::zero_if_finite(6, qdd + 6 * k));
    if (pack::is_zero(sum)) return ::std::size_t{0};
    ::std::size_t failed = 0;
    for (int k = 0; k < window.packs; ++k) failed += window.count_not_finite(pack::zero_if_finite(6, qdd + 6 * k));
    return failed;
  });
}

constexpr ::alembert::BatchFunction kFunctions[] = {inverse_dynamics_lanes, mass_matrix_and_bias_lanes,
    forward_dynamics_lanes};

}  // namespace

namespace detail {
const ::alembert::BatchFunction* batch_avx512();
const ::alembert::BatchFunction* batch_avx512() { return kFunctions; }
}  // namespace detail

}  // namespace alembert::mechanisms::chain6r

#else

namespace alembert::mechanisms::chain6r::detail {
const ::alembert::BatchFunction* batch_avx512();
const ::alembert::BatchFunction* batch_avx512() { return nullptr; }
}  // namespace alembert::mechanisms::chain6r::detail

#endif
