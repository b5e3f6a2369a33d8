// Rollouts (rollout.hpp) in packs: the accelerations of a block of motions come from a generated function over many
// states. In: as for rollout.hpp, and forward_dynamics_batch of the mechanism (`BATCH forward_dynamics`). Out: likewise.
//
// A block is up to 64 motions, one in each lane of its arrays, so that its numbers stay in the nearest caches; lanes
// without a motion do the last one again. A motion that has ended keeps its lane until all of the block have.
//
// What packs find no accelerations of ordinary size for is asked of alembert::forward_dynamics<M>, one state at a time,
// which has them or says why not. With runtime parameters M may become indefinite without any number that is not finite:
// then generate M without the function forward_dynamics, and packs factor M and see it. Implicit steppers take one state
// at a time. Double only, without constraints.
#pragma once

#include <cmath>
#include <cstring>

#include "alembert/rollout.hpp"

namespace alembert {

/// Functions of NAME_batch.hpp. `In` is the BatchInputs of the mechanism.
template <class In>
struct PackedDynamics {
  using Forward = std::size_t (*)(std::size_t, std::size_t, const double*, const double*, const double*,
                                  const In&, double*, const BatchOptions&);
  using Rates = std::size_t (*)(std::size_t, std::size_t, const double*, const double*, const In&, double*,
                                const BatchOptions&);
  /// \param forward  NAME::forward_dynamics_batch
  /// \param rates    NAME::state_rates_batch, if there are states; else they are taken one state at a time
  explicit PackedDynamics(Forward forward, Rates rates = nullptr)
      : forward_dynamics(forward), state_rates(rates) {}
  Forward forward_dynamics;
  Rates state_rates;
};

namespace detail {

inline constexpr std::size_t kMostLanes = 64, kLaneChunk = 8;

/// Rows of lanes: entry i of lane l at [i * lanes + l].
class LaneArray {
 public:
  LaneArray(std::size_t rows, std::size_t lanes) : lanes_(lanes), values_(rows * lanes, 0.0) {}
  double* operator[](std::size_t row) { return values_.data() + row * lanes_; }
  const double* operator[](std::size_t row) const { return values_.data() + row * lanes_; }
  double* data() { return values_.data(); }
  const double* data() const { return values_.data(); }
  std::size_t rows() const { return values_.size() / lanes_; }

 private:
  std::size_t lanes_;
  std::vector<double> values_;
};

/// A block of motions.
template <class M, class In>
class PackedBlock {
 public:
  using All = RolloutState<M>;
  static constexpr std::size_t kNq = All::kNq, kNv = All::kNv, kNs = All::kNs, kNp = All::kNp, kNw = All::kNw;

  PackedBlock(All& all, const PackedDynamics<In>& packed, std::size_t begin, std::size_t end,
              std::size_t lanes)
      : all_(all),
        packed_(packed),
        begin_(begin),
        count_(end - begin),
        lanes_(lanes),
        q_(kNq, lanes),
        u_(kNv, lanes),
        s_(kNs, lanes),
        parameters_(kNp, lanes),
        wrenches_(kNw, lanes),
        tau_(kNv, lanes),
        rate_(kNv, lanes),
        state_rate_(kNs, lanes),
        unit_(kNq, lanes),
        q_rate_(kNq, lanes),
        next_q_(kNq, lanes),
        next_u_(kNv, lanes),
        next_s_(kNs, lanes),
        stage_q_(kNq, lanes),
        stage_u_(kNv, lanes),
        stage_s_(kNs, lanes) {
    options_.instructions = all.way.instructions;
    gather(q_, all.q);
    gather(u_, all.u);
    gather(s_, all.states);
    const typename M::Inputs usual{};
    for (std::size_t l = 0; l < lanes_; ++l) {
      const std::size_t s = motion(l);
      live_[l] = l < count_ && !all.ended[s];
      for (std::size_t i = 0; i < kNp; ++i) parameters_[i][l] = all.parameters(s, usual)[i];
      if constexpr (kNw > 0)
        if (all.way.wrenches != nullptr)
          for (std::size_t i = 0; i < kNw; ++i)
            wrenches_[i][l] = all.way.wrenches[s * all.way.wrenches_step + i];
    }
    put_states(s_);
    if (kNp > 0) in_.parameters = parameters_.data();
    if (kNw > 0 && all.way.wrenches != nullptr) in_.wrenches = wrenches_.data();
  }

  template <class Stop>
  void go(std::int64_t first, std::int64_t last, const Stop& stop) {
    std::int64_t step = first;
    for (; step < last && std::any_of(live_, live_ + count_, [](bool lives) { return lives; }); ++step) {
      take_controls(step);
      std::fill(failed_, failed_ + kMostLanes, Status::ok);
      if (all_.way.stepper == Stepper::rk4)
        rk4(all_.time(step));
      else
        semi_implicit_euler(all_.time(step));
      settle(all_.time(step) + all_.way.h);
      pass_on(step + 1, last, stop);
    }
  }

 private:
  std::size_t motion(std::size_t lane) const { return begin_ + std::min(lane, count_ - 1); }

  /// f(lane) for all lanes. Chunks have one length, so that all lanes are compiled alike.
  template <class F>
  void each(const F& f) const {
    for (std::size_t chunk = 0; chunk < lanes_; chunk += kLaneChunk)
      for (std::size_t l = chunk; l < chunk + kLaneChunk; ++l) f(l);
  }
  void gather(LaneArray& to, const std::vector<double>& from) const {
    const std::size_t n = to.rows();
    for (std::size_t l = 0; l < lanes_; ++l)
      for (std::size_t i = 0; i < n; ++i) to[i][l] = from[motion(l) * n + i];
  }
  void put_states(const LaneArray& s) {
    for (std::size_t i = 0; i < kNs; ++i) std::copy_n(s[i], lanes_, parameters_[All::kFirstState + i]);
  }

  void take_controls(std::int64_t step) {
    if (all_.way.controls == nullptr && all_.chosen.empty()) return;
    LaneArray& to = all_.way.kind == Controls::forces ? tau_ : parameters_;
    const std::size_t first = all_.way.kind == Controls::forces ? 0 : All::kFirstInput, n = all_.width();
    for (std::size_t l = 0; l < lanes_; ++l) {
      const double* given = all_.controls(motion(l), step);
      for (std::size_t i = 0; i < n; ++i) to[first + i][l] = given[i];
    }
  }

  void fail(std::size_t lane, Status status) {
    if (failed_[lane] == Status::ok) failed_[lane] = status;
  }

  /// Quaternions of length one.
  void normalize_lanes(LaneArray& q) {
    for (const int offset : M::kQuaternionOffsets) {
      const std::size_t first = static_cast<std::size_t>(offset);
      double *x = q[first], *y = q[first + 1], *z = q[first + 2], *w = q[first + 3];
      double norm[kMostLanes];
      each(
          [&](std::size_t l) { norm[l] = std::sqrt(x[l] * x[l] + y[l] * y[l] + z[l] * z[l] + w[l] * w[l]); });
      for (std::size_t l = 0; l < count_; ++l)
        if (!is_finite(norm[l]) || !(norm[l] > 0)) fail(l, Status::not_finite);
      each([&](std::size_t l) {
        x[l] /= norm[l];
        y[l] /= norm[l];
        z[l] /= norm[l];
        w[l] /= norm[l];
      });
    }
  }

  /// N(q) u: speeds, but for a quaternion p half of p (w, 0).
  void find_coordinate_rates(const LaneArray& q, const LaneArray& u, LaneArray& rate) const {
    std::size_t i = 0, k = 0;
    const auto copy_until = [&](std::size_t end) {
      for (; i < end; ++i, ++k) std::copy_n(u[k], lanes_, rate[i]);
    };
    for (const int offset : M::kQuaternionOffsets) {
      copy_until(static_cast<std::size_t>(offset));
      const double *x = q[i], *y = q[i + 1], *z = q[i + 2], *w = q[i + 3], *a = u[k], *b = u[k + 1],
                   *c = u[k + 2];
      double *dx = rate[i], *dy = rate[i + 1], *dz = rate[i + 2], *dw = rate[i + 3];
      each([&](std::size_t l) {
        dx[l] = 0.5 * (w[l] * a[l] + y[l] * c[l] - z[l] * b[l]);
        dy[l] = 0.5 * (w[l] * b[l] + z[l] * a[l] - x[l] * c[l]);
        dz[l] = 0.5 * (w[l] * c[l] + x[l] * b[l] - y[l] * a[l]);
        dw[l] = 0.5 * (-x[l] * a[l] - y[l] * b[l] - z[l] * c[l]);
      });
      i += 4;
      k += 3;
    }
    copy_until(kNq);
  }

  /// A lane's state and inputs, for functions over one state.
  void take_lane(std::size_t lane, const LaneArray& q, const LaneArray& u, double t,
                 CoordinateVector<M>& position, SpeedVector<M>& speed, typename M::Inputs& in) const {
    for (std::size_t i = 0; i < kNq; ++i) position(static_cast<Eigen::Index>(i)) = q[i][lane];
    for (std::size_t i = 0; i < kNv; ++i) speed(static_cast<Eigen::Index>(i)) = u[i][lane];
    in = all_.inputs(motion(lane), 0);
    if constexpr (kNp > 0)
      for (std::size_t i = 0; i < kNp; ++i) in.parameters[i] = parameters_[i][lane];
    in.t = t;
  }

  /// Accelerations into rate_.
  void accelerate(const LaneArray& q, const LaneArray& u, double t) {
    in_.common.t = t;
    static_cast<void>(packed_.forward_dynamics(lanes_, lanes_, q.data(), u.data(), tau_.data(), in_,
                                               rate_.data(), options_));
    double largest[kMostLanes] = {};
    bool finite[kMostLanes];
    std::fill(finite, finite + lanes_, true);
    for (std::size_t i = 0; i < kNv; ++i)
      for (std::size_t l = 0; l < lanes_; ++l) {
        finite[l] &= is_finite(rate_[i][l]);
        largest[l] = std::max(largest[l], std::abs(rate_[i][l]));
      }
    for (std::size_t l = 0; l < count_; ++l) {
      if (!live_[l] || failed_[l] != Status::ok || (finite[l] && is_ordinary_rate(largest[l]))) continue;
      CoordinateVector<M> position;
      SpeedVector<M> speed, force, qdd;
      typename M::Inputs in{};
      take_lane(l, q, u, t, position, speed, in);
      for (std::size_t i = 0; i < kNv; ++i) force(static_cast<Eigen::Index>(i)) = tau_[i][l];
      fail(l, forward_dynamics<M>(position, speed, force, in, qdd));
      for (std::size_t i = 0; failed_[l] == Status::ok && i < kNv; ++i)
        rate_[i][l] = qdd(static_cast<Eigen::Index>(i));
    }
  }

  /// Rates of the states into state_rate_.
  void find_state_rates([[maybe_unused]] const LaneArray& q, [[maybe_unused]] const LaneArray& u,
                        [[maybe_unused]] double t) {
    if constexpr (kNs > 0) {
      in_.common.t = t;
      if (packed_.state_rates != nullptr) {
        static_cast<void>(
            packed_.state_rates(lanes_, lanes_, q.data(), u.data(), in_, state_rate_.data(), options_));
        return;
      }
      for (std::size_t l = 0; l < lanes_; ++l) {
        CoordinateVector<M> position;
        SpeedVector<M> speed;
        typename M::Inputs in{};
        take_lane(l, q, u, t, position, speed, in);
        const Eigen::Matrix<double, M::kNstates, 1> rate = M::state_rates(position, speed, in);
        for (std::size_t i = 0; i < kNs; ++i) state_rate_[i][l] = rate(static_cast<Eigen::Index>(i));
      }
    }
  }

  /// to = from + a x
  void add(LaneArray& to, const LaneArray& from, double a, const LaneArray& x) const {
    for (std::size_t i = 0; i < to.rows(); ++i) {
      double* const sum = to[i];
      const double *b = from[i], *c = x[i];
      each([&](std::size_t l) { sum[l] = b[l] + a * c[l]; });
    }
  }

  void semi_implicit_euler(double t) {
    const double h = all_.way.h;
    accelerate(q_, u_, t);
    add(next_u_, u_, h, rate_);
    find_coordinate_rates(q_, next_u_, q_rate_);
    add(next_q_, q_, h, q_rate_);
    find_state_rates(q_, next_u_, t);
    add(next_s_, s_, h, state_rate_);
  }

  void rk4(double t) {
    const double h = all_.way.h, half = h * 0.5;
    const double offsets[4] = {0, half, half, h}, weights[4] = {h / 6, h / 3, h / 3, h / 6};
    next_q_ = q_;
    next_u_ = u_;
    next_s_ = s_;
    stage_q_ = q_;
    stage_u_ = u_;
    for (int stage = 0; stage < 4; ++stage) {
      const double now = t + offsets[stage];
      if (stage > 0) {
        add(stage_q_, q_, offsets[stage], q_rate_);
        add(stage_u_, u_, offsets[stage], rate_);
        add(stage_s_, s_, offsets[stage], state_rate_);
        put_states(stage_s_);
      }
      unit_ = stage_q_;
      normalize_lanes(unit_);
      accelerate(unit_, stage_u_, now);
      find_coordinate_rates(stage_q_, stage_u_, q_rate_);
      find_state_rates(unit_, stage_u_, now);
      add(next_q_, next_q_, weights[stage], q_rate_);
      add(next_u_, next_u_, weights[stage], rate_);
      add(next_s_, next_s_, weights[stage], state_rate_);
    }
  }

  /// The step's end: finite, with unit quaternions; and then the state.
  void settle(double t) {
    bool finite[kMostLanes];
    std::fill(finite, finite + lanes_, is_finite(t));
    for (const LaneArray* array : {&next_q_, &next_u_, &next_s_})
      for (std::size_t i = 0; i < array->rows(); ++i)
        for (std::size_t l = 0; l < lanes_; ++l) finite[l] &= is_finite((*array)[i][l]);
    for (std::size_t l = 0; l < count_; ++l)
      if (!finite[l]) fail(l, Status::not_finite);
    normalize_lanes(next_q_);
    const auto take = [&](LaneArray& to, const LaneArray& from) {
      for (std::size_t i = 0; i < to.rows(); ++i)
        for (std::size_t l = 0; l < lanes_; ++l)
          if (live_[std::min(l, count_ - 1)] && failed_[std::min(l, count_ - 1)] == Status::ok)
            to[i][l] = from[i][l];
    };
    take(q_, next_q_);
    take(u_, next_u_);
    take(s_, next_s_);
    put_states(s_);
  }

  /// What came of the step, to all that is known of the motions.
  template <class Stop>
  void pass_on(std::int64_t step, std::int64_t last, [[maybe_unused]] const Stop& stop) {
    const bool may_stop = is_given(stop);
    const bool seen = may_stop || step == last || (all_.way.every > 0 && step % all_.way.every == 0);
    for (std::size_t l = 0; l < count_; ++l) {
      if (!live_[l]) continue;
      const std::size_t s = begin_ + l;
      all_.status[s] = failed_[l];
      const bool failed = failed_[l] != Status::ok;
      if (seen || failed) {
        for (std::size_t i = 0; i < kNq; ++i) all_.q[s * kNq + i] = q_[i][l];
        for (std::size_t i = 0; i < kNv; ++i) all_.u[s * kNv + i] = u_[i][l];
        for (std::size_t i = 0; i < kNs; ++i) all_.states[s * kNs + i] = s_[i][l];
      }
      if (failed) {
        live_[l] = false;
        all_.ended[s] = true;
        continue;
      }
      all_.steps[s] = step;
      all_.record_after(s, step);
      if constexpr (!std::is_same_v<Stop, NeverStop>) {
        if (may_stop && stop(s, all_.time(step), all_.q.data() + s * kNq, all_.u.data() + s * kNv)) {
          live_[l] = false;
          all_.ended[s] = true;
          all_.stopped[s] = 1;
        }
      }
    }
  }

  All& all_;
  const PackedDynamics<In>& packed_;
  std::size_t begin_, count_, lanes_;
  LaneArray q_, u_, s_, parameters_, wrenches_, tau_, rate_, state_rate_;
  LaneArray unit_, q_rate_, next_q_, next_u_, next_s_, stage_q_, stage_u_, stage_s_;
  bool live_[kMostLanes] = {};
  Status failed_[kMostLanes] = {};
  In in_;
  BatchOptions options_;
};

}  // namespace detail

/// rollout of rollout.hpp in packs: arguments and result are the same, rounding is not. `stop` is called after each
/// step likewise.
///
///   rollout_in_packs<Arm>(way, out, PackedDynamics(arm::forward_dynamics_batch));
template <class M, class In, class Policy = NoPolicy, class Stop = NeverStop>
std::size_t rollout_in_packs(const Rollout<double>& way, const RolloutResults<double>& out,
                             const PackedDynamics<In>& packed, Policy&& policy = {}, const Stop& stop = {}) {
  static_assert(std::is_same_v<typename M::Scalar, double>, "packs are of double");
  static_assert(!has_constraints_v<M>, "packs keep no constraints: take rollout");
  if (way.stepper != Stepper::rk4 && way.stepper != Stepper::semi_implicit_euler)
    return rollout<M>(way, out, policy, stop);
  // Smaller blocks where there are too few motions for all threads; no result depends on it.
  std::size_t threads = way.threads > 0 ? static_cast<std::size_t>(way.threads) : 1;
#ifdef ALEMBERT_BATCH_THREADS
  if (way.threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
#endif
  const std::size_t share = (way.count + threads - 1) / threads;
  const std::size_t lanes =
      std::min(detail::kMostLanes, std::max<std::size_t>(1, (share + 7) / 8) * detail::kLaneChunk);
  return detail::roll_out<M>(
      way, out, policy, lanes,
      [&](detail::RolloutState<M>& all, std::size_t begin, std::size_t end, std::int64_t first,
          std::int64_t last) {
        detail::PackedBlock<M, In>(all, packed, begin, end, lanes).go(first, last, stop);
      });
}

}  // namespace alembert
