// tori_mated: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "tori_mated". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// The C interface on top of the functions for double.
#include <tori_mated/tori_mated.h>
#include <tori_mated/tori_mated_raw.hpp>

namespace {

using Inputs = ::alembert::mechanisms::tori_mated::Inputs<double>;

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

const char* const tori_mated_coordinate_names[5 + 1] = {"u1", "v1", "u2", "v2", "turn", nullptr};
const char* const tori_mated_speed_names[5 + 1] = {"d(u1)", "d(v1)", "d(u2)", "d(v2)", "d(turn)", nullptr};
const char* const tori_mated_body_names[1 + 1] = {"ring", nullptr};
const char* const tori_mated_frame_names[0 + 1] = {nullptr};
const char* const tori_mated_output_names[0 + 1] = {nullptr};
const char* const tori_mated_force_names[0 + 1] = {nullptr};
const char* const tori_mated_parameter_names[0 + 1] = {nullptr};
const char* const tori_mated_wrench_body_names[0 + 1] = {nullptr};
const char* const tori_mated_constraint_names[0 + 1] = {nullptr};
const int tori_mated_holonomic[0 + 1] = {0};
const double tori_mated_initial_coordinates[5] = {0.0, 0.0, 0.0, 0.0, 0.0};
const double tori_mated_initial_speeds[5] = {0.0, 0.0, 0.0, 0.0, 0.0};
const double tori_mated_default_parameters[0 + 1] = {0.0};

int tori_mated_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                const double* parameters, const double* wrenches, double* tau) {
  if (q == nullptr || qd == nullptr || qdd == nullptr || tau == nullptr) return 1;
  ::alembert::mechanisms::tori_mated::inverse_dynamics<double>(q, qd, qdd, make_inputs(t, parameters, wrenches), tau);
  return 0;
}

int tori_mated_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M) {
  if (q == nullptr || M == nullptr) return 1;
  ::alembert::mechanisms::tori_mated::mass_matrix<double>(q, make_inputs(t, parameters, wrenches), M);
  return 0;
}

int tori_mated_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                    double* c) {
  if (q == nullptr || qd == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::tori_mated::bias<double>(q, qd, make_inputs(t, parameters, wrenches), c);
  return 0;
}

int tori_mated_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                    const double* wrenches, double* M, double* c) {
  if (q == nullptr || qd == nullptr || M == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::tori_mated::mass_matrix_and_bias<double>(q, qd, make_inputs(t, parameters, wrenches), M, c);
  return 0;
}

int tori_mated_coordinate_rates(const double* q, const double* qd, double* qdot) {
  if (q == nullptr || qd == nullptr || qdot == nullptr) return 1;
  ::alembert::mechanisms::tori_mated::coordinate_rates<double>(q, qd, qdot);
  return 0;
}

int tori_mated_energy(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                      double* e) {
  if (q == nullptr || qd == nullptr || e == nullptr) return 1;
  ::alembert::mechanisms::tori_mated::energy<double>(q, qd, make_inputs(t, parameters, wrenches), e);
  return 0;
}

int tori_mated_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W) {
  if (q == nullptr || W == nullptr) return 1;
  ::alembert::mechanisms::tori_mated::body_poses<double>(q, make_inputs(t, parameters, wrenches), W);
  return 0;
}

}  // extern "C"
