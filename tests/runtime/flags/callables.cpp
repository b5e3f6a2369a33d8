// Forces as callables of the functions that integrate. Those that return a vector, or refer to one that
// stays, compile; an expression of Eigen, whose operands are gone when it is evaluated, must not: each
// ALEMBERT_CASE is such a one.
#include <cmath>

#include "alembert/implicit_step.hpp"
#include "alembert/integrate.hpp"
#include "runtime/models.hpp"

int main() {
  using M = models::SpinningBody<>;
  M::Quaternion q(0, 0, 0, 1);
  M::Vector w(1, 2, 3), stays(0.5, 0, 0);
  M::Inputs in;
#if ALEMBERT_CASE == 1
  const auto force = [](double, const M::Quaternion&, const M::Vector& u) { return -0.5 * u; };
  return alembert::rk4_step<M>(q, w, in, 0.1, force) == alembert::Status::ok ? 0 : 1;
#elif ALEMBERT_CASE == 2
  const auto force = [](double, const M::Quaternion&, const M::Vector& u) { return -0.5 * u; };
  return alembert::semi_implicit_euler_step<M>(q, w, in, 0.1, force) == alembert::Status::ok ? 0 : 1;
#elif ALEMBERT_CASE == 3
  const auto force = [](double, const M::Quaternion& p, const M::Vector&) { return p.head<3>(); };
  return alembert::rk4_step<M>(q, w, in, 0.1, force) == alembert::Status::ok ? 0 : 1;
#elif ALEMBERT_CASE == 4
  const auto force = [](double, const M::Quaternion&, M::Vector u) -> M::Vector&& { return std::move(u); };
  return alembert::rk4_step<M>(q, w, in, 0.1, force) == alembert::Status::ok ? 0 : 1;
#elif ALEMBERT_CASE == 5
  const auto force = [](double, const M::Quaternion&, const M::Vector& u) { return -0.5 * u; };
  return alembert::linearly_implicit_euler_step<M>(q, w, in, 0.1, force) == alembert::Status::ok ? 0 : 1;
#elif ALEMBERT_CASE == 6
  const auto force = [](double, const M::Quaternion&, const M::Vector& u) { return -0.5 * u; };
  return alembert::implicit_euler_step<M>(q, w, in, 0.1, force) == alembert::Status::ok ? 0 : 1;
#else
  const auto by_value = [](double, const M::Quaternion&, const M::Vector& u) -> M::Vector {
    return -0.5 * u;
  };
  const auto in_place = [&](double, const M::Quaternion&, const M::Vector&) -> const M::Vector& {
    return stays;
  };
  bool ok = alembert::rk4_step<M>(q, w, in, 0.1, by_value) == alembert::Status::ok;
  ok = ok && alembert::rk4_step<M>(q, w, in, 0.1, in_place) == alembert::Status::ok;
  ok = ok && alembert::rk4_step<M>(q, w, in, 0.1, models::no_force<M>) == alembert::Status::ok;
  ok = ok && alembert::semi_implicit_euler_step<M>(q, w, in, 0.1, by_value) == alembert::Status::ok;
  ok = ok && alembert::linearly_implicit_euler_step<M>(q, w, in, 0.1, by_value) == alembert::Status::ok;
  ok = ok && alembert::implicit_euler_step<M>(q, w, in, 0.1, by_value) == alembert::Status::ok;
  return ok && std::isfinite(w.norm()) ? 0 : 1;
#endif
}
