// free_body: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "free_body". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// The C interface on top of the functions for double.
#include <free_body/free_body.h>
#include <free_body/free_body_raw.hpp>

namespace {

using Inputs = ::alembert::mechanisms::free_body::Inputs<double>;

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

const char* const free_body_coordinate_names[7 + 1] = {
    "x", "y", "z", "turn.x", "turn.y", "turn.z", "turn.w", nullptr};
const char* const free_body_speed_names[6 + 1] = {
    "d(x)", "d(y)", "d(z)", "d(turn).x", "d(turn).y", "d(turn).z", nullptr};
const char* const free_body_body_names[1 + 1] = {"body", nullptr};
const char* const free_body_frame_names[1 + 1] = {"nose", nullptr};
const char* const free_body_output_names[0 + 1] = {nullptr};
const char* const free_body_force_names[0 + 1] = {nullptr};
const char* const free_body_parameter_names[0 + 1] = {nullptr};
const char* const free_body_wrench_body_names[1 + 1] = {"body", nullptr};
const char* const free_body_constraint_names[0 + 1] = {nullptr};
const int free_body_holonomic[0 + 1] = {0};
const double free_body_initial_coordinates[7] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0};
const double free_body_initial_speeds[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
const double free_body_default_parameters[0 + 1] = {0.0};

int free_body_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                               const double* parameters, const double* wrenches, double* tau) {
  if (q == nullptr || qd == nullptr || qdd == nullptr || tau == nullptr) return 1;
  ::alembert::mechanisms::free_body::inverse_dynamics<double>(q, qd, qdd, make_inputs(t, parameters, wrenches), tau);
  return 0;
}

int free_body_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M) {
  if (q == nullptr || M == nullptr) return 1;
  ::alembert::mechanisms::free_body::mass_matrix<double>(q, make_inputs(t, parameters, wrenches), M);
  return 0;
}

int free_body_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                   double* c) {
  if (q == nullptr || qd == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::free_body::bias<double>(q, qd, make_inputs(t, parameters, wrenches), c);
  return 0;
}

int free_body_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                   const double* wrenches, double* M, double* c) {
  if (q == nullptr || qd == nullptr || M == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::free_body::mass_matrix_and_bias<double>(q, qd, make_inputs(t, parameters, wrenches), M, c);
  return 0;
}

int free_body_coordinate_rates(const double* q, const double* qd, double* qdot) {
  if (q == nullptr || qd == nullptr || qdot == nullptr) return 1;
  ::alembert::mechanisms::free_body::coordinate_rates<double>(q, qd, qdot);
  return 0;
}

int free_body_energy(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                     double* e) {
  if (q == nullptr || qd == nullptr || e == nullptr) return 1;
  ::alembert::mechanisms::free_body::energy<double>(q, qd, make_inputs(t, parameters, wrenches), e);
  return 0;
}

int free_body_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W) {
  if (q == nullptr || W == nullptr) return 1;
  ::alembert::mechanisms::free_body::body_poses<double>(q, make_inputs(t, parameters, wrenches), W);
  return 0;
}

int free_body_frame_poses(const double* q, double t, const double* parameters, const double* wrenches, double* F) {
  if (q == nullptr || F == nullptr) return 1;
  ::alembert::mechanisms::free_body::frame_poses<double>(q, make_inputs(t, parameters, wrenches), F);
  return 0;
}

int free_body_frame_jacobians(const double* q, double t, const double* parameters, const double* wrenches, double* J) {
  if (q == nullptr || J == nullptr) return 1;
  ::alembert::mechanisms::free_body::frame_jacobians<double>(q, make_inputs(t, parameters, wrenches), J);
  return 0;
}

}  // extern "C"
