// spherical_pendulum: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "spherical_pendulum". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// The C interface on top of the functions for double.
#include <spherical_pendulum/spherical_pendulum.h>
#include <spherical_pendulum/spherical_pendulum_raw.hpp>

namespace {

using Inputs = ::alembert::mechanisms::spherical_pendulum::Inputs<double>;

[[maybe_unused]] Inputs make_inputs(double t, const double* parameters, const double* wrenches) {
  Inputs in;
  in.t = t;
  if (parameters != nullptr)
    for (double& x : in.parameters) x = *parameters++;
  if (wrenches != nullptr)
    for (double& x : in.wrenches) x = *wrenches++;
  return in;
}

}  // namespace

extern "C" {

const char* const spherical_pendulum_coordinate_names[4 + 1] = {"turn.x", "turn.y", "turn.z", "turn.w", nullptr};
const char* const spherical_pendulum_speed_names[3 + 1] = {"d(turn).x", "d(turn).y", "d(turn).z", nullptr};
const char* const spherical_pendulum_body_names[1 + 1] = {"bob", nullptr};
const char* const spherical_pendulum_frame_names[0 + 1] = {nullptr};
const char* const spherical_pendulum_output_names[0 + 1] = {nullptr};
const char* const spherical_pendulum_force_names[0 + 1] = {nullptr};
const char* const spherical_pendulum_parameter_names[0 + 1] = {nullptr};
const char* const spherical_pendulum_wrench_body_names[1 + 1] = {"bob", nullptr};
const char* const spherical_pendulum_constraint_names[0 + 1] = {nullptr};
const int spherical_pendulum_holonomic[0 + 1] = {0};
const double spherical_pendulum_initial_coordinates[4] = {0.0, 0.0, 0.0, 1.0};
const double spherical_pendulum_initial_speeds[3] = {0.0, 0.0, 0.0};
const double spherical_pendulum_default_parameters[0 + 1] = {0.0};

int spherical_pendulum_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                        const double* parameters, const double* wrenches, double* tau) {
  if (q == nullptr || qd == nullptr || qdd == nullptr || tau == nullptr) return 1;
  ::alembert::mechanisms::spherical_pendulum::inverse_dynamics<double>(q, qd, qdd, make_inputs(t, parameters, wrenches), tau);
  return 0;
}

int spherical_pendulum_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches,
                                   double* M) {
  if (q == nullptr || M == nullptr) return 1;
  ::alembert::mechanisms::spherical_pendulum::mass_matrix<double>(q, make_inputs(t, parameters, wrenches), M);
  return 0;
}

int spherical_pendulum_bias(const double* q, const double* qd, double t, const double* parameters,
                            const double* wrenches, double* c) {
  if (q == nullptr || qd == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::spherical_pendulum::bias<double>(q, qd, make_inputs(t, parameters, wrenches), c);
  return 0;
}

int spherical_pendulum_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                        const double* wrenches, double* M, double* c) {
  if (q == nullptr || qd == nullptr || M == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::spherical_pendulum::mass_matrix_and_bias<double>(q, qd, make_inputs(t, parameters, wrenches), M, c);
  return 0;
}

int spherical_pendulum_coordinate_rates(const double* q, const double* qd, double* qdot) {
  if (q == nullptr || qd == nullptr || qdot == nullptr) return 1;
  ::alembert::mechanisms::spherical_pendulum::coordinate_rates<double>(q, qd, qdot);
  return 0;
}

int spherical_pendulum_energy(const double* q, const double* qd, double t, const double* parameters,
                              const double* wrenches, double* e) {
  if (q == nullptr || qd == nullptr || e == nullptr) return 1;
  ::alembert::mechanisms::spherical_pendulum::energy<double>(q, qd, make_inputs(t, parameters, wrenches), e);
  return 0;
}

int spherical_pendulum_body_poses(const double* q, double t, const double* parameters, const double* wrenches,
                                  double* W) {
  if (q == nullptr || W == nullptr) return 1;
  ::alembert::mechanisms::spherical_pendulum::body_poses<double>(q, make_inputs(t, parameters, wrenches), W);
  return 0;
}

}  // extern "C"
