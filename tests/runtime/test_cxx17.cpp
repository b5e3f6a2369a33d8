// Instantiates the runtime library as C++17 without exceptions and RTTI: it only has to compile.
#include "alembert/consistent_state.hpp"
#include "alembert/energy.hpp"
#include "alembert/forward_dynamics.hpp"
#include "alembert/implicit_step.hpp"
#include "alembert/integrate.hpp"
#include "alembert/linearize.hpp"
#include "alembert/rollout_library.hpp"
#include "alembert/topology.hpp"
#include "runtime/constrained_models.hpp"
#include "runtime/models.hpp"
#include "runtime/plane_models.hpp"

static_assert(__cplusplus < 202002L, "this file is for C++17");
using Model = models::SpinningBody<float>;

alembert::Status step_in_cxx17(Eigen::Vector4f& q, Eigen::Vector3f& w, Model::Inputs& in) {
  const auto force = [](float, const Eigen::Vector4f&, const Eigen::Vector3f&) {
    return Eigen::Vector3f(Eigen::Vector3f::Zero());
  };
  if (const auto status = alembert::rk4_step<Model>(q, w, in, 0.1f, force); status != alembert::Status::ok)
    return status;
  return alembert::semi_implicit_euler_step<Model>(q, w, in, alembert::energy<Model>(q, w, in).total(),
                                                   force);
}

std::size_t roll_out_in_cxx17(const alembert::RolloutCall& call) {
  return alembert::rollout_by_call<models::SpinningBody<>>(call);
}

alembert::Status linearize_in_cxx17(const Eigen::Vector4f& q, const Eigen::Vector3f& w,
                                    alembert::Linearization<Model>& out) {
  return alembert::linearize<Model>(q, w, w, {}, out);
}

using Top = models::HeldTop<float>;

alembert::Status constrained_step_in_cxx17(Top::CoordinateVector& q, Top::SpeedVector& u, Top::Inputs& in) {
  const auto force = [](float, const Top::CoordinateVector&, const Top::SpeedVector&) {
    return Top::SpeedVector(Top::SpeedVector::Zero());
  };
  alembert::ConstraintReport<3> report;
  if (const auto status = alembert::consistent_state<Top>(q, u, in, report); status != alembert::Status::ok)
    return status;
  if (const auto status = alembert::linearly_implicit_euler_step<Top>(q, u, in, 0.1f, force, {}, &report);
      status != alembert::Status::ok)
    return status;
  if (const auto status = alembert::implicit_euler_step<Top>(q, u, in, 0.1f, force);
      status != alembert::Status::ok)
    return status;
  return alembert::rk4_step<Top>(q, u, in, 0.1f, force);
}

using Rods = models::HingedByRows;

alembert::Status change_in_cxx17(const std::array<alembert::BodyMotion<double>, 2>& bodies, Rods::Vector& q,
                                 Rods::Vector& u) {
  return alembert::change_topology<Rods>(bodies, {}, q, u);
}
