// Many motions of a mechanism at once. In: N starts, controls as arrays, held, or by a policy over the whole batch, a
// step. Out: the states every few steps, and for each motion how far it came and why it ended there.
//
// A motion depends on its own start, parameters and controls alone: not on the others, their number, its place among
// them or the number of threads, to the last bit. Threads take blocks of motions. rollout(way, out, ...) steps one state
// at a time with the methods of integrate.hpp and implicit_step.hpp, constraints kept; rollout_in_packs(way, out, packed, ...) of
// rollout_packs.hpp takes the accelerations of a block from a function over many states, in packs.
//
// Arrays hold one motion after the other: entry i of motion s of q stands at q[s * n_q + i]. A motion that has ended,
// because it was stopped or because a step failed, stays where it was: later rows repeat its last state, and
// `steps` says how many steps it made. A start that is not finite makes none; all else in the results is finite.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "alembert/batch.hpp"
#include "alembert/implicit_step.hpp"
#include "alembert/integrate.hpp"

namespace alembert {

enum class Stepper { semi_implicit_euler = 0, rk4 = 1, linearly_implicit_euler = 2, implicit_euler = 3 };

/// What controls are: generalized forces, n_v of them, or the inputs of the description, n_i.
enum class Controls { forces = 0, inputs = 1 };

/// What is asked for. Arrays that are not given are those of the description, controls zero or the description's.
template <class S = double>
struct Rollout {
  std::size_t count = 0;   ///< motions
  std::int64_t steps = 0;  ///< of each
  S h = S(0);              ///< step, s
  S t = S(0);              ///< time of the start, s; after k steps it is t + k h to the last digit
  Stepper stepper = Stepper::semi_implicit_euler;
  /// Starts, which are moved to the nearest states that keep unit quaternions and constraints.
  const S* q = nullptr;             ///< count x n_q
  const S* qd = nullptr;            ///< count x n_v
  const S* parameters = nullptr;    ///< as Inputs::parameters: runtime parameters, inputs, states
  std::size_t parameters_step = 0;  ///< numbers from one motion's to the next; 0: all share them
  const S* wrenches = nullptr;      ///< as Inputs::wrenches
  std::size_t wrenches_step = 0;
  Controls kind = Controls::forces;
  const S* controls = nullptr;    ///< held over each step, in all stages of a method
  std::size_t controls_step = 0;  ///< numbers from one motion's to the next
  std::size_t controls_next = 0;  ///< numbers from one moment's to the next; 0: held throughout
  std::int64_t hold = 1;   ///< steps from one moment of the controls, and call of the policy, to the next
  std::int64_t every = 0;  ///< steps from one row of results to the next; 0: the end alone
  int threads = 1;         ///< 0: one a core
  Instructions instructions = Instructions::best;  ///< of packs; between sets results differ by rounding
};

/// Rows of results: the start, every `every` steps, and the end.
template <class S>
std::size_t rollout_rows(const Rollout<S>& way) {
  if (way.every <= 0) return 1;
  return static_cast<std::size_t>(way.steps / way.every + 1 + (way.steps % way.every != 0 ? 1 : 0));
}

/// Where results go. Only what is given is written.
template <class S = double>
struct RolloutResults {
  S* q = nullptr;                 ///< count x rows x n_q
  S* qd = nullptr;                ///< count x rows x n_v
  S* states = nullptr;            ///< count x rows x n_s
  std::int64_t* steps = nullptr;  ///< [count] steps made
  Status* status = nullptr;       ///< [count] ok, or why there was no further step
  bool* stopped = nullptr;        ///< [count] whether the policy or the predicate ended it
};

/// What a policy sees, and what it fills, every `hold` steps.
template <class S>
struct RolloutMoment {
  S t;                ///< s
  std::int64_t step;  ///< steps made
  std::size_t count;
  const S* q;       ///< count x n_q, of ended motions where they ended
  const S* qd;      ///< count x n_v
  const S* states;  ///< count x n_s
  S* controls;      ///< count x n_v or n_i, to be filled; what it was at the last call, zero at first
  bool* ended;      ///< [count]; set, it stops a motion
};

/// No policy, and no predicate.
struct NoPolicy {};
struct NeverStop {};

namespace detail {

/// Whether there is something to call: std::function and pointers to functions may be empty.
template <class F>
bool is_given([[maybe_unused]] const F& f) {
  if constexpr (std::is_same_v<F, NoPolicy> || std::is_same_v<F, NeverStop>)
    return false;
  else if constexpr (std::is_constructible_v<bool, const F&>)
    return static_cast<bool>(f);
  else
    return true;
}

/// work(block) for all blocks, by whichever thread is free.
template <class Work>
void share_blocks(std::size_t blocks, int threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto take = [&] {
    for (std::size_t block; (block = next.fetch_add(1)) < blocks;) work(block);
  };
#ifdef ALEMBERT_BATCH_THREADS
  std::size_t count = threads > 0 ? static_cast<std::size_t>(threads) : std::thread::hardware_concurrency();
  if (count > blocks) count = blocks;
  std::vector<std::thread> started;
#if defined(__cpp_exceptions)
  try {
    for (std::size_t k = 1; k < count; ++k) started.emplace_back(take);
  } catch (...) {  // fewer do as well
  }
#else
  for (std::size_t k = 1; k < count; ++k) started.emplace_back(take);
#endif
  take();
  for (std::thread& thread : started) thread.join();
#else
  static_cast<void>(threads);
  take();
#endif
}

template <class M, class = void>
struct InputCount : std::integral_constant<std::size_t, 0> {};
template <class M>
struct InputCount<M, std::void_t<decltype(M::kNinputs)>>
    : std::integral_constant<std::size_t, static_cast<std::size_t>(M::kNinputs)> {};

template <class Inputs, class = void>
struct WrenchNumbers : std::integral_constant<std::size_t, 0> {};
template <class Inputs>
struct WrenchNumbers<Inputs, std::void_t<decltype(std::declval<Inputs&>().wrenches)>>
    : std::tuple_size<decltype(Inputs::wrenches)> {};

/// The motions of a rollout between two calls of the policy, and what they share.
template <class M>
class RolloutState {
 public:
  using S = typename M::Scalar;
  using Inputs = typename M::Inputs;
  static constexpr std::size_t kNq = static_cast<std::size_t>(M::kNq), kNv = static_cast<std::size_t>(M::kNv),
                               kNs = static_cast<std::size_t>(StateCount<M>::value);
  static constexpr std::size_t kNi = InputCount<M>::value, kNp = ParameterCount<Inputs>::value,
                               kNw = WrenchNumbers<Inputs>::value;
  static constexpr std::size_t kFirstInput = kNp - kNi - kNs, kFirstState = kNp - kNs;

  RolloutState(const Rollout<S>& asked, const RolloutResults<S>& results)
      : way(asked),
        out(results),
        rows(rollout_rows(asked)),
        q(asked.q, asked.q + asked.count * kNq),
        u(asked.qd, asked.qd + asked.count * kNv),
        states(asked.count * kNs),
        steps(asked.count, 0),
        status(asked.count, Status::ok),
        ended(new bool[asked.count]()),
        stopped(asked.count, 0) {
    if constexpr (kNs > 0) {
      const Inputs usual{};
      for (std::size_t s = 0; s < way.count; ++s)
        std::copy_n(parameters(s, usual) + kFirstState, kNs,
                    states.begin() + static_cast<std::ptrdiff_t>(s * kNs));
    }
  }
  /// The start of a motion: quaternions of unit length, on the constraints.
  void begin(std::size_t s) {
    CoordinateVector<M> start = coordinates(s);
    SpeedVector<M> speed = speeds(s);
    status[s] = Status::not_finite;
    if (is_finite(way.h) && is_finite(way.t) && all_finite(start) && all_finite(speed)) {
      Inputs in = inputs(s, 0);
      const BoundMechanism<M> system(in);
      ConstraintReport<BoundMechanism<M>::kNc> report;
      status[s] = settle(system, start, speed, StepOptions<S>(), report);
    }
    if (status[s] == Status::ok) {
      std::copy_n(start.data(), kNq, q.begin() + static_cast<std::ptrdiff_t>(s * kNq));
      std::copy_n(speed.data(), kNv, u.begin() + static_cast<std::ptrdiff_t>(s * kNv));
    }
    ended[s] = status[s] != Status::ok;
    if (way.every > 0 || way.steps == 0) record(s, 0);
  }
  ~RolloutState() { delete[] ended; }
  RolloutState(const RolloutState&) = delete;
  RolloutState& operator=(const RolloutState&) = delete;

  CoordinateVector<M> coordinates(std::size_t s) const {
    return Eigen::Map<const CoordinateVector<M>>(q.data() + s * kNq);
  }
  SpeedVector<M> speeds(std::size_t s) const { return Eigen::Map<const SpeedVector<M>>(u.data() + s * kNv); }
  S time(std::int64_t step) const { return way.t + static_cast<S>(step) * way.h; }

  const S* parameters(std::size_t s, [[maybe_unused]] const Inputs& usual) const {
    if (way.parameters != nullptr) return way.parameters + s * way.parameters_step;
    if constexpr (kNp > 0)
      return usual.parameters.data();
    else
      return nullptr;
  }

  /// Controls of a motion over the step after `step`; null: none are given.
  const S* controls(std::size_t s, std::int64_t step) const {
    if (!chosen.empty()) return chosen.data() + s * width();
    if (way.controls == nullptr) return nullptr;
    return way.controls + s * way.controls_step +
           static_cast<std::size_t>(step / std::max<std::int64_t>(way.hold, 1)) * way.controls_next;
  }
  std::size_t width() const { return way.kind == Controls::forces ? kNv : kNi; }

  /// The inputs of a motion at its state.
  Inputs inputs(std::size_t s, std::int64_t step) const {
    Inputs in{};
    if constexpr (kNp > 0) {
      if (way.parameters != nullptr) std::copy_n(parameters(s, in), kNp, in.parameters.begin());
      if constexpr (kNs > 0)
        std::copy_n(states.data() + s * kNs, kNs,
                    in.parameters.begin() + static_cast<std::ptrdiff_t>(kFirstState));
    }
    if constexpr (kNw > 0)
      if (way.wrenches != nullptr)
        std::copy_n(way.wrenches + s * way.wrenches_step, kNw, in.wrenches.begin());
    in.t = time(step);
    return in;
  }

  /// Writes the state of a motion as a row of the results.
  void record(std::size_t s, std::size_t row) const {
    const auto write = [&](S* to, const std::vector<S>& from, std::size_t n) {
      if (to != nullptr) std::copy_n(from.data() + s * n, n, to + (s * rows + row) * n);
    };
    write(out.q, q, kNq);
    write(out.qd, u, kNv);
    write(out.states, states, kNs);
  }
  /// The same after `step` steps, if there is a row for them.
  void record_after(std::size_t s, std::int64_t step) const {
    if (step == way.steps)
      record(s, rows - 1);
    else if (way.every > 0 && step % way.every == 0)
      record(s, static_cast<std::size_t>(step / way.every));
  }
  /// The rows that are left of all motions that ended early, and what became of each.
  std::size_t finish() {
    std::size_t failed = 0;
    for (std::size_t s = 0; s < way.count; ++s) {
      if (steps[s] < way.steps) {
        const std::size_t passed = way.every > 0 ? static_cast<std::size_t>(steps[s] / way.every) + 1 : 0;
        for (std::size_t row = passed; row < rows; ++row) record(s, row);
      }
      if (out.steps != nullptr) out.steps[s] = steps[s];
      if (out.status != nullptr) out.status[s] = status[s];
      if (out.stopped != nullptr) out.stopped[s] = stopped[s] != 0;
      failed += status[s] == Status::ok ? 0 : 1;
    }
    return failed;
  }

  const Rollout<S>& way;
  const RolloutResults<S>& out;
  std::size_t rows;
  std::vector<S> q, u, states, chosen;
  std::vector<std::int64_t> steps;
  std::vector<Status> status;
  bool* ended;
  std::vector<unsigned char> stopped;
};

/// The steps of one motion, one state at a time.
template <class M, class Stop>
void step_motion(RolloutState<M>& all, std::size_t s, std::int64_t first, std::int64_t last,
                 const Stop& stop) {
  using State = RolloutState<M>;
  using S = typename M::Scalar;
  CoordinateVector<M> q = all.coordinates(s);
  SpeedVector<M> u = all.speeds(s), tau = SpeedVector<M>::Zero();
  typename M::Inputs in = all.inputs(s, first);
  BoundMechanism<M> system(in);
  ConstraintReport<BoundMechanism<M>::kNc> report;
  const StepOptions<S> options;
  const auto force = [&](S, const CoordinateVector<M>&, const SpeedVector<M>&) -> SpeedVector<M> {
    return tau;
  };
  const S h = all.way.h;
  for (std::int64_t step = first; step < last; ++step) {
    if (const S* given = all.controls(s, step); given != nullptr) {
      if (all.way.kind == Controls::forces)
        for (std::size_t i = 0; i < State::kNv; ++i) tau(static_cast<Eigen::Index>(i)) = given[i];
      else if constexpr (State::kNi > 0)
        std::copy_n(given, State::kNi,
                    in.parameters.begin() + static_cast<std::ptrdiff_t>(State::kFirstInput));
    }
    in.t = all.time(step);
    Status status = Status::missing_function;
    if (all.way.stepper == Stepper::rk4) {
      status = advance_by_rk4(system, q, u, h, force, options, report);
    } else if (all.way.stepper == Stepper::semi_implicit_euler) {
      status = advance_by_semi_implicit_euler(system, q, u, h, force, options, report);
    } else if constexpr (has_derivatives_v<M> && (State::kNs == 0 || HasStateRatesDerivatives<M>::value)) {
      status = all.way.stepper == Stepper::implicit_euler
                   ? advance_by_implicit_euler(system, q, u, h, force, options, report)
                   : advance_by_linearly_implicit_euler(system, q, u, h, force, options, report);
    }
    all.status[s] = status;
    if (status != Status::ok) {
      all.ended[s] = true;
      return;
    }
    for (std::size_t i = 0; i < State::kNq; ++i) all.q[s * State::kNq + i] = q(static_cast<Eigen::Index>(i));
    for (std::size_t i = 0; i < State::kNv; ++i) all.u[s * State::kNv + i] = u(static_cast<Eigen::Index>(i));
    if constexpr (State::kNs > 0)
      std::copy_n(in.parameters.begin() + static_cast<std::ptrdiff_t>(State::kFirstState), State::kNs,
                  all.states.begin() + static_cast<std::ptrdiff_t>(s * State::kNs));
    all.steps[s] = step + 1;
    all.record_after(s, step + 1);
    if constexpr (!std::is_same_v<Stop, NeverStop>) {
      if (is_given(stop) &&
          stop(s, all.time(step + 1), all.q.data() + s * State::kNq, all.u.data() + s * State::kNv)) {
        all.ended[s] = true;
        all.stopped[s] = 1;
        return;
      }
    }
  }
}

/// All motions, in segments between calls of the policy. run(all, begin, end, first, last): steps first ... last of
/// motions begin ... end - 1, of which some have ended.
template <class M, class Policy, class Run>
std::size_t roll_out(const Rollout<typename M::Scalar>& way, const RolloutResults<typename M::Scalar>& out,
                     Policy& policy, std::size_t block, const Run& run) {
  static_assert(is_mechanism_v<M>,
                "generate M with mass_matrix_and_bias and coordinate_rates (alembert/mechanism.hpp)");
  using S = typename M::Scalar;
  const bool has_policy = is_given<std::decay_t<Policy>>(policy);
  RolloutState<M> all(way, out);
  if (has_policy) all.chosen.assign(way.count * all.width(), S(0));
  const std::size_t blocks = (way.count + block - 1) / block;
  share_blocks(blocks, way.threads, [&](std::size_t b) {
    for (std::size_t s = b * block; s < std::min(way.count, (b + 1) * block); ++s) all.begin(s);
  });
  const std::int64_t length = has_policy ? std::max<std::int64_t>(way.hold, 1) : way.steps;
  for (std::int64_t first = 0; first < way.steps; first += length) {
    const std::int64_t last = std::min(way.steps, first + length);
    if constexpr (!std::is_same_v<std::decay_t<Policy>, NoPolicy>)
      if (has_policy) {
        std::vector<unsigned char> before(all.ended, all.ended + way.count);
        policy(RolloutMoment<S>{all.time(first), first, way.count, all.q.data(), all.u.data(),
                                all.states.data(), all.chosen.data(), all.ended});
        for (std::size_t s = 0; s < way.count; ++s) {
          if (before[s] != 0)
            all.ended[s] = true;
          else if (all.ended[s])
            all.stopped[s] = 1;
        }
      }
    if (std::all_of(all.ended, all.ended + way.count, [](bool e) { return e; })) break;
    share_blocks(blocks, way.threads, [&](std::size_t b) {
      run(all, b * block, std::min(way.count, (b + 1) * block), first, last);
    });
  }
  return all.finish();
}

}  // namespace detail

/// N motions of T steps. See the top of this file.
///
/// \param way     what is asked for; count and steps may be zero
/// \param out     results; their memory is the caller's
/// \param policy  callable (const RolloutMoment<S>&), called every way.hold steps by the caller's thread, for all motions
///                at once; in place of way.controls
/// \param stop    callable (std::size_t motion, S t, const S* q, const S* qd) -> bool, called after each step by any of
///                the threads; true ends the motion
/// \return        how many motions ended with a status that is not ok. not_finite: also of h, t, a start or a
///                control. missing_function: of an implicit stepper, where M lacks inverse_dynamics_derivatives or, with states,
///                state_rates_derivatives
template <class M, class Policy = NoPolicy, class Stop = NeverStop>
std::size_t rollout(const Rollout<typename M::Scalar>& way, const RolloutResults<typename M::Scalar>& out,
                    Policy&& policy = {}, const Stop& stop = {}) {
  return detail::roll_out<M>(way, out, policy, 4,
                             [&](detail::RolloutState<M>& all, std::size_t begin, std::size_t end,
                                 std::int64_t first, std::int64_t last) {
                               for (std::size_t s = begin; s < end; ++s)
                                 if (!all.ended[s]) detail::step_motion(all, s, first, last, stop);
                             });
}

}  // namespace alembert
