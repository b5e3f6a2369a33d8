// cart_pole: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "cart_pole". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// The C interface on top of the functions for double.
#include <cart_pole/cart_pole.h>
#include <cart_pole/cart_pole_raw.hpp>

namespace {

using Inputs = ::alembert::mechanisms::cart_pole::Inputs<double>;

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

const char* const cart_pole_coordinate_names[2 + 1] = {"x", "q", nullptr};
const char* const cart_pole_speed_names[2 + 1] = {"d(x)", "d(q)", nullptr};
const char* const cart_pole_body_names[2 + 1] = {"cart", "pole", nullptr};
const char* const cart_pole_frame_names[0 + 1] = {nullptr};
const char* const cart_pole_output_names[0 + 1] = {nullptr};
const char* const cart_pole_force_names[0 + 1] = {nullptr};
const char* const cart_pole_parameter_names[0 + 1] = {nullptr};
const char* const cart_pole_wrench_body_names[1 + 1] = {"cart", nullptr};
const char* const cart_pole_constraint_names[0 + 1] = {nullptr};
const int cart_pole_holonomic[0 + 1] = {0};
const double cart_pole_initial_coordinates[2] = {0.0, 0.1};
const double cart_pole_initial_speeds[2] = {0.0, 0.0};
const double cart_pole_default_parameters[0 + 1] = {0.0};

int cart_pole_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                               const double* parameters, const double* wrenches, double* tau) {
  if (q == nullptr || qd == nullptr || qdd == nullptr || tau == nullptr) return 1;
  ::alembert::mechanisms::cart_pole::inverse_dynamics<double>(q, qd, qdd, make_inputs(t, parameters, wrenches), tau);
  return 0;
}

int cart_pole_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M) {
  if (q == nullptr || M == nullptr) return 1;
  ::alembert::mechanisms::cart_pole::mass_matrix<double>(q, make_inputs(t, parameters, wrenches), M);
  return 0;
}

int cart_pole_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                   double* c) {
  if (q == nullptr || qd == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::cart_pole::bias<double>(q, qd, make_inputs(t, parameters, wrenches), c);
  return 0;
}

int cart_pole_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                   const double* wrenches, double* M, double* c) {
  if (q == nullptr || qd == nullptr || M == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::cart_pole::mass_matrix_and_bias<double>(q, qd, make_inputs(t, parameters, wrenches), M, c);
  return 0;
}

int cart_pole_coordinate_rates(const double* q, const double* qd, double* qdot) {
  if (q == nullptr || qd == nullptr || qdot == nullptr) return 1;
  ::alembert::mechanisms::cart_pole::coordinate_rates<double>(q, qd, qdot);
  return 0;
}

int cart_pole_energy(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                     double* e) {
  if (q == nullptr || qd == nullptr || e == nullptr) return 1;
  ::alembert::mechanisms::cart_pole::energy<double>(q, qd, make_inputs(t, parameters, wrenches), e);
  return 0;
}

int cart_pole_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W) {
  if (q == nullptr || W == nullptr) return 1;
  ::alembert::mechanisms::cart_pole::body_poses<double>(q, make_inputs(t, parameters, wrenches), W);
  return 0;
}

}  // extern "C"
