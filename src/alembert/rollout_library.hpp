// Rollouts of one mechanism behind a function of C, for other languages. In: a RolloutCall, numbers and pointers only.
// Out: its arrays filled. alembert.rollout of Python compiles it for a mechanism.
#pragma once

#include <functional>

#include "alembert/rollout_packs.hpp"

namespace alembert {

/// Rollout and RolloutResults (rollout.hpp) in numbers of fixed size; pointers may be null as there.
struct RolloutCall {
  std::int64_t count, steps, every, hold;
  std::int64_t parameters_step, wrenches_step, controls_step, controls_next;
  std::int32_t stepper, kind, threads, instructions;
  double h, t;
  const double *q, *qd, *parameters, *wrenches, *controls;
  /// Least and largest q, then least and largest qd: a motion that leaves them is stopped. Null: none are.
  const double* bounds;
  double *out_q, *out_qd, *out_states;
  std::int64_t* out_steps;
  std::int32_t* out_status;
  bool* out_stopped;
  /// RolloutMoment's members; null: no policy.
  void (*policy)(double t, std::int64_t step, std::int64_t count, const double* q, const double* qd,
                 const double* states, double* controls, bool* ended);
};

namespace detail {

/// roll(way, out, policy, stop) with what is given.
template <class M, class Roll>
std::size_t roll_by_call(const RolloutCall& call, const Roll& roll) {
  static_assert(sizeof(Status) == sizeof(std::int32_t), "a status is returned in 32 bits");
  Rollout<double> way;
  way.count = static_cast<std::size_t>(call.count);
  way.steps = call.steps;
  way.h = call.h;
  way.t = call.t;
  way.stepper = static_cast<Stepper>(call.stepper);
  way.q = call.q;
  way.qd = call.qd;
  way.parameters = call.parameters;
  way.parameters_step = static_cast<std::size_t>(call.parameters_step);
  way.wrenches = call.wrenches;
  way.wrenches_step = static_cast<std::size_t>(call.wrenches_step);
  way.kind = static_cast<Controls>(call.kind);
  way.controls = call.controls;
  way.controls_step = static_cast<std::size_t>(call.controls_step);
  way.controls_next = static_cast<std::size_t>(call.controls_next);
  way.hold = call.hold;
  way.every = call.every;
  way.threads = call.threads;
  way.instructions = static_cast<Instructions>(call.instructions);
  std::vector<Status> status(way.count);
  RolloutResults<double> out;
  out.q = call.out_q;
  out.qd = call.out_qd;
  out.states = call.out_states;
  out.steps = call.out_steps;
  out.status = status.data();
  out.stopped = call.out_stopped;
  // Once for all that is given or not: it is compiled for each mechanism.
  std::function<void(const RolloutMoment<double>&)> policy;
  if (call.policy != nullptr)
    policy = [&](const RolloutMoment<double>& at) {
      call.policy(at.t, at.step, static_cast<std::int64_t>(at.count), at.q, at.qd, at.states, at.controls,
                  at.ended);
    };
  std::function<bool(std::size_t, double, const double*, const double*)> leaves;
  if (call.bounds != nullptr)
    leaves = [&](std::size_t, double, const double* q, const double* qd) {
      const double* bound = call.bounds;
      for (int i = 0; i < M::kNq; ++i)
        if (!(q[i] >= bound[i]) || !(q[i] <= bound[M::kNq + i])) return true;
      bound += 2 * M::kNq;
      for (int i = 0; i < M::kNv; ++i)
        if (!(qd[i] >= bound[i]) || !(qd[i] <= bound[M::kNv + i])) return true;
      return false;
    };
  const std::size_t failed = roll(way, out, policy, leaves);
  for (std::size_t s = 0; call.out_status != nullptr && s < way.count; ++s)
    call.out_status[s] = static_cast<std::int32_t>(status[s]);
  return failed;
}

}  // namespace detail

/// \return how many motions ended with a status that is not ok
template <class M>
std::size_t rollout_by_call(const RolloutCall& call) {
  return detail::roll_by_call<M>(call, [](const auto& way, const auto& out, const auto& policy,
                                          const auto& stop) { return rollout<M>(way, out, policy, stop); });
}
template <class M, class In>
std::size_t rollout_by_call(const RolloutCall& call, const PackedDynamics<In>& packed) {
  return detail::roll_by_call<M>(call,
                                 [&](const auto& way, const auto& out, const auto& policy, const auto& stop) {
                                   return rollout_in_packs<M>(way, out, packed, policy, stop);
                                 });
}

}  // namespace alembert
