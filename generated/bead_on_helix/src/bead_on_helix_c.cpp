// bead_on_helix: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "bead_on_helix". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// The C interface on top of the functions for double.
#include <bead_on_helix/bead_on_helix.h>
#include <bead_on_helix/bead_on_helix_raw.hpp>

namespace {

using Inputs = ::alembert::mechanisms::bead_on_helix::Inputs<double>;

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

const char* const bead_on_helix_coordinate_names[2 + 1] = {"s", "spin", nullptr};
const char* const bead_on_helix_speed_names[2 + 1] = {"d(s)", "d(spin)", nullptr};
const char* const bead_on_helix_body_names[1 + 1] = {"bead", nullptr};
const char* const bead_on_helix_frame_names[0 + 1] = {nullptr};
const char* const bead_on_helix_output_names[0 + 1] = {nullptr};
const char* const bead_on_helix_force_names[0 + 1] = {nullptr};
const char* const bead_on_helix_parameter_names[0 + 1] = {nullptr};
const char* const bead_on_helix_wrench_body_names[1 + 1] = {"bead", nullptr};
const char* const bead_on_helix_constraint_names[0 + 1] = {nullptr};
const int bead_on_helix_holonomic[0 + 1] = {0};
const double bead_on_helix_initial_coordinates[2] = {0.0, 0.0};
const double bead_on_helix_initial_speeds[2] = {0.0, 0.0};
const double bead_on_helix_default_parameters[0 + 1] = {0.0};

int bead_on_helix_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                   const double* parameters, const double* wrenches, double* tau) {
  if (q == nullptr || qd == nullptr || qdd == nullptr || tau == nullptr) return 1;
  ::alembert::mechanisms::bead_on_helix::inverse_dynamics<double>(q, qd, qdd, make_inputs(t, parameters, wrenches), tau);
  return 0;
}

int bead_on_helix_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M) {
  if (q == nullptr || M == nullptr) return 1;
  ::alembert::mechanisms::bead_on_helix::mass_matrix<double>(q, make_inputs(t, parameters, wrenches), M);
  return 0;
}

int bead_on_helix_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                       double* c) {
  if (q == nullptr || qd == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::bead_on_helix::bias<double>(q, qd, make_inputs(t, parameters, wrenches), c);
  return 0;
}

int bead_on_helix_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                       const double* wrenches, double* M, double* c) {
  if (q == nullptr || qd == nullptr || M == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::bead_on_helix::mass_matrix_and_bias<double>(q, qd, make_inputs(t, parameters, wrenches), M, c);
  return 0;
}

int bead_on_helix_coordinate_rates(const double* q, const double* qd, double* qdot) {
  if (q == nullptr || qd == nullptr || qdot == nullptr) return 1;
  ::alembert::mechanisms::bead_on_helix::coordinate_rates<double>(q, qd, qdot);
  return 0;
}

int bead_on_helix_energy(const double* q, const double* qd, double t, const double* parameters,
                         const double* wrenches, double* e) {
  if (q == nullptr || qd == nullptr || e == nullptr) return 1;
  ::alembert::mechanisms::bead_on_helix::energy<double>(q, qd, make_inputs(t, parameters, wrenches), e);
  return 0;
}

int bead_on_helix_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W) {
  if (q == nullptr || W == nullptr) return 1;
  ::alembert::mechanisms::bead_on_helix::body_poses<double>(q, make_inputs(t, parameters, wrenches), W);
  return 0;
}

}  // extern "C"
