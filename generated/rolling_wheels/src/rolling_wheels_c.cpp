// rolling_wheels: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "rolling_wheels". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// The C interface on top of the functions for double.
#include <rolling_wheels/rolling_wheels.h>
#include <rolling_wheels/rolling_wheels_raw.hpp>

namespace {

using Inputs = ::alembert::mechanisms::rolling_wheels::Inputs<double>;

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

const char* const rolling_wheels_coordinate_names[2 + 1] = {"q1", "q2", nullptr};
const char* const rolling_wheels_speed_names[2 + 1] = {"d(q1)", "d(q2)", nullptr};
const char* const rolling_wheels_body_names[2 + 1] = {"wheel", "small_wheel", nullptr};
const char* const rolling_wheels_frame_names[0 + 1] = {nullptr};
const char* const rolling_wheels_output_names[0 + 1] = {nullptr};
const char* const rolling_wheels_force_names[0 + 1] = {nullptr};
const char* const rolling_wheels_parameter_names[0 + 1] = {nullptr};
const char* const rolling_wheels_wrench_body_names[1 + 1] = {"wheel", nullptr};
const char* const rolling_wheels_constraint_names[0 + 1] = {nullptr};
const int rolling_wheels_holonomic[0 + 1] = {0};
const double rolling_wheels_initial_coordinates[2] = {1.2, 0.4};
const double rolling_wheels_initial_speeds[2] = {0.0, 0.0};
const double rolling_wheels_default_parameters[0 + 1] = {0.0};

int rolling_wheels_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                    const double* parameters, const double* wrenches, double* tau) {
  if (q == nullptr || qd == nullptr || qdd == nullptr || tau == nullptr) return 1;
  ::alembert::mechanisms::rolling_wheels::inverse_dynamics<double>(q, qd, qdd, make_inputs(t, parameters, wrenches), tau);
  return 0;
}

int rolling_wheels_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M) {
  if (q == nullptr || M == nullptr) return 1;
  ::alembert::mechanisms::rolling_wheels::mass_matrix<double>(q, make_inputs(t, parameters, wrenches), M);
  return 0;
}

int rolling_wheels_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                        double* c) {
  if (q == nullptr || qd == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::rolling_wheels::bias<double>(q, qd, make_inputs(t, parameters, wrenches), c);
  return 0;
}

int rolling_wheels_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                        const double* wrenches, double* M, double* c) {
  if (q == nullptr || qd == nullptr || M == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::rolling_wheels::mass_matrix_and_bias<double>(q, qd, make_inputs(t, parameters, wrenches), M, c);
  return 0;
}

int rolling_wheels_coordinate_rates(const double* q, const double* qd, double* qdot) {
  if (q == nullptr || qd == nullptr || qdot == nullptr) return 1;
  ::alembert::mechanisms::rolling_wheels::coordinate_rates<double>(q, qd, qdot);
  return 0;
}

int rolling_wheels_energy(const double* q, const double* qd, double t, const double* parameters,
                          const double* wrenches, double* e) {
  if (q == nullptr || qd == nullptr || e == nullptr) return 1;
  ::alembert::mechanisms::rolling_wheels::energy<double>(q, qd, make_inputs(t, parameters, wrenches), e);
  return 0;
}

int rolling_wheels_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W) {
  if (q == nullptr || W == nullptr) return 1;
  ::alembert::mechanisms::rolling_wheels::body_poses<double>(q, make_inputs(t, parameters, wrenches), W);
  return 0;
}

}  // extern "C"
