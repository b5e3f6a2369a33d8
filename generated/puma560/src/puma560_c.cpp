// puma560: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "puma560". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// The C interface on top of the functions for double.
#include <puma560/puma560.h>
#include <puma560/puma560_raw.hpp>

namespace {

using Inputs = ::alembert::mechanisms::puma560::Inputs<double>;

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

const char* const puma560_coordinate_names[6 + 1] = {"q1", "q2", "q3", "q4", "q5", "q6", nullptr};
const char* const puma560_speed_names[6 + 1] = {
    "d(q1)", "d(q2)", "d(q3)", "d(q4)", "d(q5)", "d(q6)", nullptr};
const char* const puma560_body_names[6 + 1] = {
    "link1", "link2", "link3", "link4", "link5", "link6", nullptr};
const char* const puma560_frame_names[1 + 1] = {"flange", nullptr};
const char* const puma560_output_names[0 + 1] = {nullptr};
const char* const puma560_force_names[0 + 1] = {nullptr};
const char* const puma560_parameter_names[0 + 1] = {nullptr};
const char* const puma560_wrench_body_names[0 + 1] = {nullptr};
const char* const puma560_constraint_names[0 + 1] = {nullptr};
const int puma560_holonomic[0 + 1] = {0};
const double puma560_initial_coordinates[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
const double puma560_initial_speeds[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
const double puma560_default_parameters[0 + 1] = {0.0};

int puma560_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t, const double* parameters,
                             const double* wrenches, double* tau) {
  if (q == nullptr || qd == nullptr || qdd == nullptr || tau == nullptr) return 1;
  ::alembert::mechanisms::puma560::inverse_dynamics<double>(q, qd, qdd, make_inputs(t, parameters, wrenches), tau);
  return 0;
}

int puma560_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M) {
  if (q == nullptr || M == nullptr) return 1;
  ::alembert::mechanisms::puma560::mass_matrix<double>(q, make_inputs(t, parameters, wrenches), M);
  return 0;
}

int puma560_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                 double* c) {
  if (q == nullptr || qd == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::puma560::bias<double>(q, qd, make_inputs(t, parameters, wrenches), c);
  return 0;
}

int puma560_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                 const double* wrenches, double* M, double* c) {
  if (q == nullptr || qd == nullptr || M == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::puma560::mass_matrix_and_bias<double>(q, qd, make_inputs(t, parameters, wrenches), M, c);
  return 0;
}

int puma560_coordinate_rates(const double* q, const double* qd, double* qdot) {
  if (q == nullptr || qd == nullptr || qdot == nullptr) return 1;
  ::alembert::mechanisms::puma560::coordinate_rates<double>(q, qd, qdot);
  return 0;
}

int puma560_energy(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                   double* e) {
  if (q == nullptr || qd == nullptr || e == nullptr) return 1;
  ::alembert::mechanisms::puma560::energy<double>(q, qd, make_inputs(t, parameters, wrenches), e);
  return 0;
}

int puma560_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W) {
  if (q == nullptr || W == nullptr) return 1;
  ::alembert::mechanisms::puma560::body_poses<double>(q, make_inputs(t, parameters, wrenches), W);
  return 0;
}

int puma560_frame_poses(const double* q, double t, const double* parameters, const double* wrenches, double* F) {
  if (q == nullptr || F == nullptr) return 1;
  ::alembert::mechanisms::puma560::frame_poses<double>(q, make_inputs(t, parameters, wrenches), F);
  return 0;
}

int puma560_frame_jacobians(const double* q, double t, const double* parameters, const double* wrenches, double* J) {
  if (q == nullptr || J == nullptr) return 1;
  ::alembert::mechanisms::puma560::frame_jacobians<double>(q, make_inputs(t, parameters, wrenches), J);
  return 0;
}

}  // extern "C"
