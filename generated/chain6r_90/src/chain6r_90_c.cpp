// chain6r_90: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "chain6r_90". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// The C interface on top of the functions for double.
#include <chain6r_90/chain6r_90.h>
#include <chain6r_90/chain6r_90_raw.hpp>

namespace {

using Inputs = ::alembert::mechanisms::chain6r_90::Inputs<double>;

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

const char* const chain6r_90_coordinate_names[6 + 1] = {"q1", "q2", "q3", "q4", "q5", "q6", nullptr};
const char* const chain6r_90_speed_names[6 + 1] = {
    "d(q1)", "d(q2)", "d(q3)", "d(q4)", "d(q5)", "d(q6)", nullptr};
const char* const chain6r_90_body_names[6 + 1] = {
    "link1", "link2", "link3", "link4", "link5", "link6", nullptr};
const char* const chain6r_90_frame_names[0 + 1] = {nullptr};
const char* const chain6r_90_output_names[0 + 1] = {nullptr};
const char* const chain6r_90_force_names[0 + 1] = {nullptr};
const char* const chain6r_90_parameter_names[0 + 1] = {nullptr};
const char* const chain6r_90_wrench_body_names[0 + 1] = {nullptr};
const char* const chain6r_90_constraint_names[0 + 1] = {nullptr};
const int chain6r_90_holonomic[0 + 1] = {0};
const double chain6r_90_initial_coordinates[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
const double chain6r_90_initial_speeds[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
const double chain6r_90_default_parameters[0 + 1] = {0.0};

int chain6r_90_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                const double* parameters, const double* wrenches, double* tau) {
  if (q == nullptr || qd == nullptr || qdd == nullptr || tau == nullptr) return 1;
  ::alembert::mechanisms::chain6r_90::inverse_dynamics<double>(q, qd, qdd, make_inputs(t, parameters, wrenches), tau);
  return 0;
}

int chain6r_90_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M) {
  if (q == nullptr || M == nullptr) return 1;
  ::alembert::mechanisms::chain6r_90::mass_matrix<double>(q, make_inputs(t, parameters, wrenches), M);
  return 0;
}

int chain6r_90_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                    double* c) {
  if (q == nullptr || qd == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::chain6r_90::bias<double>(q, qd, make_inputs(t, parameters, wrenches), c);
  return 0;
}

int chain6r_90_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                    const double* wrenches, double* M, double* c) {
  if (q == nullptr || qd == nullptr || M == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::chain6r_90::mass_matrix_and_bias<double>(q, qd, make_inputs(t, parameters, wrenches), M, c);
  return 0;
}

int chain6r_90_coordinate_rates(const double* q, const double* qd, double* qdot) {
  if (q == nullptr || qd == nullptr || qdot == nullptr) return 1;
  ::alembert::mechanisms::chain6r_90::coordinate_rates<double>(q, qd, qdot);
  return 0;
}

int chain6r_90_energy(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                      double* e) {
  if (q == nullptr || qd == nullptr || e == nullptr) return 1;
  ::alembert::mechanisms::chain6r_90::energy<double>(q, qd, make_inputs(t, parameters, wrenches), e);
  return 0;
}

int chain6r_90_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W) {
  if (q == nullptr || W == nullptr) return 1;
  ::alembert::mechanisms::chain6r_90::body_poses<double>(q, make_inputs(t, parameters, wrenches), W);
  return 0;
}

}  // extern "C"
