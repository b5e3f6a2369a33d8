// A generated mechanism with constraints, integrated from a state made consistent. In: speeds to begin with,
// a step. Out: the state over time, and by how much constraints and energy have been off.
#pragma once

#include <alembert/integrate.hpp>
#include <algorithm>
#include <cmath>

namespace alembert::test {

template <class M>
struct Simulation {
  typename M::CoordinateVector q = M::initial_coordinates();
  typename M::SpeedVector u = M::SpeedVector::Zero();
  typename M::Inputs in;
  ConstraintReport<M::kNc> report;

  /// Closes loops and removes slip, by the least changes.
  [[nodiscard]] Status make_consistent() { return consistent_state<M>(q, u, in, report); }

  /// Unforced steps of the classical Runge-Kutta method, calling `observe` before the first and after each.
  template <class Observe>
  [[nodiscard]] Status run(double duration, double h, Observe&& observe) {
    const auto no_force = [](double, const auto&, const auto&) ->
        typename M::SpeedVector { return M::SpeedVector::Zero(); };
    const double start = in.t;
    const int steps = static_cast<int>(std::lround(duration / h));
    observe();
    for (int i = 1; i <= steps; ++i) {
      const Status status = rk4_step<M>(q, u, in, h, no_force, {}, &report);
      if (status != Status::ok) return status;
      in.t = start + i * h;  // not summed, so that it does not drift
      observe();
    }
    return Status::ok;
  }

  double kinetic_energy() const { return M::energy(q, u, in)[0]; }
  double energy() const { return M::energy(q, u, in).sum(); }
};

/// The largest violations and change of energy of a run.
template <class M>
struct Drift {
  double slip = 0, gap = 0, energy = 0, kinetic = 0;

  explicit Drift(const Simulation<M>& of) : simulation_(of), start_(of.energy()) {}
  void observe() {
    typename M::ConstraintMatrix P;
    typename M::ConstraintVector gamma, velocity, position;
    M::constraints(simulation_.q, simulation_.u, simulation_.in, P, gamma, velocity, position);
    slip = std::max(slip, velocity.cwiseAbs().maxCoeff());
    gap = std::max(gap, position.cwiseAbs().maxCoeff());
    energy = std::max(energy, std::abs(simulation_.energy() - start_));
    kinetic = std::max(kinetic, simulation_.kinetic_energy());
  }
  /// Of the largest kinetic energy.
  double relative_energy() const { return energy / kinetic; }

 private:
  const Simulation<M>& simulation_;
  double start_;
};

}  // namespace alembert::test
