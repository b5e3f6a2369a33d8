// Forces as callables of the functions that integrate. Those that return a vector, or refer to one that
// stays, compile; an expression of Eigen, whose operands are gone when it is evaluated, must not: with
// ALEMBERT_EXPRESSIONS there are six.
#include <cmath>

#include "alembert/implicit_step.hpp"
#include "alembert/integrate.hpp"
#include "runtime/models.hpp"

using M = models::SpinningBody<>;

#ifdef ALEMBERT_EXPRESSIONS
/// Each of a type of its own: what one type is refused for is said once.
template <int>
auto scaled() {
  return [](double, const M::Quaternion&, const M::Vector& u) { return -0.5 * u; };
}
#endif

int main() {
  M::Quaternion q(0, 0, 0, 1);
  M::Vector w(1, 2, 3), stays(0.5, 0, 0);
  M::Inputs in;
#ifdef ALEMBERT_EXPRESSIONS
  const auto part = [](double, const M::Quaternion& p, const M::Vector&) { return p.head<3>(); };
  const auto moved = [](double, const M::Quaternion&, M::Vector u) -> M::Vector&& { return std::move(u); };
  alembert::rk4_step<M>(q, w, in, 0.1, scaled<0>());
  alembert::rk4_step<M>(q, w, in, 0.1, part);
  alembert::rk4_step<M>(q, w, in, 0.1, moved);
  alembert::semi_implicit_euler_step<M>(q, w, in, 0.1, scaled<1>());
  alembert::linearly_implicit_euler_step<M>(q, w, in, 0.1, scaled<2>());
  alembert::implicit_euler_step<M>(q, w, in, 0.1, scaled<3>());
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
