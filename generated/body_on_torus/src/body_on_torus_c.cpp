// body_on_torus: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "body_on_torus". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// The C interface on top of the functions for double.
#include <body_on_torus/body_on_torus.h>
#include <body_on_torus/body_on_torus_raw.hpp>

namespace {

using Inputs = ::alembert::mechanisms::body_on_torus::Inputs<double>;

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

const char* const body_on_torus_coordinate_names[3 + 1] = {"u", "v", "spin", nullptr};
const char* const body_on_torus_speed_names[3 + 1] = {"d(u)", "d(v)", "d(spin)", nullptr};
const char* const body_on_torus_body_names[1 + 1] = {"slider", nullptr};
const char* const body_on_torus_frame_names[0 + 1] = {nullptr};
const char* const body_on_torus_output_names[0 + 1] = {nullptr};
const char* const body_on_torus_force_names[0 + 1] = {nullptr};
const char* const body_on_torus_parameter_names[0 + 1] = {nullptr};
const char* const body_on_torus_wrench_body_names[0 + 1] = {nullptr};
const char* const body_on_torus_constraint_names[0 + 1] = {nullptr};
const int body_on_torus_holonomic[0 + 1] = {0};
const double body_on_torus_initial_coordinates[3] = {0.0, 0.0, 0.0};
const double body_on_torus_initial_speeds[3] = {0.0, 0.0, 0.0};
const double body_on_torus_default_parameters[0 + 1] = {0.0};

int body_on_torus_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                   const double* parameters, const double* wrenches, double* tau) {
  if (q == nullptr || qd == nullptr || qdd == nullptr || tau == nullptr) return 1;
  ::alembert::mechanisms::body_on_torus::inverse_dynamics<double>(q, qd, qdd, make_inputs(t, parameters, wrenches), tau);
  return 0;
}

int body_on_torus_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M) {
  if (q == nullptr || M == nullptr) return 1;
  ::alembert::mechanisms::body_on_torus::mass_matrix<double>(q, make_inputs(t, parameters, wrenches), M);
  return 0;
}

int body_on_torus_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                       double* c) {
  if (q == nullptr || qd == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::body_on_torus::bias<double>(q, qd, make_inputs(t, parameters, wrenches), c);
  return 0;
}

int body_on_torus_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                       const double* wrenches, double* M, double* c) {
  if (q == nullptr || qd == nullptr || M == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::body_on_torus::mass_matrix_and_bias<double>(q, qd, make_inputs(t, parameters, wrenches), M, c);
  return 0;
}

int body_on_torus_coordinate_rates(const double* q, const double* qd, double* qdot) {
  if (q == nullptr || qd == nullptr || qdot == nullptr) return 1;
  ::alembert::mechanisms::body_on_torus::coordinate_rates<double>(q, qd, qdot);
  return 0;
}

int body_on_torus_energy(const double* q, const double* qd, double t, const double* parameters,
                         const double* wrenches, double* e) {
  if (q == nullptr || qd == nullptr || e == nullptr) return 1;
  ::alembert::mechanisms::body_on_torus::energy<double>(q, qd, make_inputs(t, parameters, wrenches), e);
  return 0;
}

int body_on_torus_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W) {
  if (q == nullptr || W == nullptr) return 1;
  ::alembert::mechanisms::body_on_torus::body_poses<double>(q, make_inputs(t, parameters, wrenches), W);
  return 0;
}

}  // extern "C"
