// four_bar_knee: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "four_bar_knee". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// The C interface on top of the functions for double.
#include <four_bar_knee/four_bar_knee.h>
#include <four_bar_knee/four_bar_knee_raw.hpp>

namespace {

using Inputs = ::alembert::mechanisms::four_bar_knee::Inputs<double>;

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

const char* const four_bar_knee_coordinate_names[2 + 1] = {"hip", "q", nullptr};
const char* const four_bar_knee_speed_names[2 + 1] = {"d(hip)", "d(q)", nullptr};
const char* const four_bar_knee_body_names[2 + 1] = {"thigh", "shank", nullptr};
const char* const four_bar_knee_frame_names[1 + 1] = {"ankle", nullptr};
const char* const four_bar_knee_output_names[0 + 1] = {nullptr};
const char* const four_bar_knee_force_names[0 + 1] = {nullptr};
const char* const four_bar_knee_parameter_names[0 + 1] = {nullptr};
const char* const four_bar_knee_wrench_body_names[1 + 1] = {"shank", nullptr};
const char* const four_bar_knee_constraint_names[0 + 1] = {nullptr};
const int four_bar_knee_holonomic[0 + 1] = {0};
const double four_bar_knee_initial_coordinates[2] = {0.0, 1.3};
const double four_bar_knee_initial_speeds[2] = {0.0, 0.0};
const double four_bar_knee_default_parameters[0 + 1] = {0.0};

int four_bar_knee_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                   const double* parameters, const double* wrenches, double* tau) {
  if (q == nullptr || qd == nullptr || qdd == nullptr || tau == nullptr) return 1;
  ::alembert::mechanisms::four_bar_knee::inverse_dynamics<double>(q, qd, qdd, make_inputs(t, parameters, wrenches), tau);
  return 0;
}

int four_bar_knee_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M) {
  if (q == nullptr || M == nullptr) return 1;
  ::alembert::mechanisms::four_bar_knee::mass_matrix<double>(q, make_inputs(t, parameters, wrenches), M);
  return 0;
}

int four_bar_knee_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                       double* c) {
  if (q == nullptr || qd == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::four_bar_knee::bias<double>(q, qd, make_inputs(t, parameters, wrenches), c);
  return 0;
}

int four_bar_knee_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                       const double* wrenches, double* M, double* c) {
  if (q == nullptr || qd == nullptr || M == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::four_bar_knee::mass_matrix_and_bias<double>(q, qd, make_inputs(t, parameters, wrenches), M, c);
  return 0;
}

int four_bar_knee_coordinate_rates(const double* q, const double* qd, double* qdot) {
  if (q == nullptr || qd == nullptr || qdot == nullptr) return 1;
  ::alembert::mechanisms::four_bar_knee::coordinate_rates<double>(q, qd, qdot);
  return 0;
}

int four_bar_knee_energy(const double* q, const double* qd, double t, const double* parameters,
                         const double* wrenches, double* e) {
  if (q == nullptr || qd == nullptr || e == nullptr) return 1;
  ::alembert::mechanisms::four_bar_knee::energy<double>(q, qd, make_inputs(t, parameters, wrenches), e);
  return 0;
}

int four_bar_knee_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W) {
  if (q == nullptr || W == nullptr) return 1;
  ::alembert::mechanisms::four_bar_knee::body_poses<double>(q, make_inputs(t, parameters, wrenches), W);
  return 0;
}

int four_bar_knee_frame_poses(const double* q, double t, const double* parameters, const double* wrenches, double* F) {
  if (q == nullptr || F == nullptr) return 1;
  ::alembert::mechanisms::four_bar_knee::frame_poses<double>(q, make_inputs(t, parameters, wrenches), F);
  return 0;
}

int four_bar_knee_frame_jacobians(const double* q, double t, const double* parameters, const double* wrenches,
                                  double* J) {
  if (q == nullptr || J == nullptr) return 1;
  ::alembert::mechanisms::four_bar_knee::frame_jacobians<double>(q, make_inputs(t, parameters, wrenches), J);
  return 0;
}

}  // extern "C"
