// tree_every_joint: equations of motion as straight-line code.
// Written by alembert 0.1.0 from the description of the mechanism "tree_every_joint". Do not edit: change the description.
// Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.
//
// The C interface on top of the functions for double.
#include <tree_every_joint/tree_every_joint.h>
#include <tree_every_joint/tree_every_joint_raw.hpp>

namespace {

using Inputs = ::alembert::mechanisms::tree_every_joint::Inputs<double>;

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

const char* const tree_every_joint_coordinate_names[22 + 1] = {
    "x", "y", "z", "attitude.x", "attitude.y", "attitude.z", "attitude.w", "shoulder", "slide", "screw",
    "twist", "reach", "pitch", "roll", "px", "py", "pa", "ball.x", "ball.y", "ball.z", "ball.w", "bend",
    nullptr};
const char* const tree_every_joint_speed_names[20 + 1] = {
    "d(x)", "d(y)", "d(z)", "d(attitude).x", "d(attitude).y", "d(attitude).z", "d(shoulder)", "d(slide)",
    "d(screw)", "d(twist)", "d(reach)", "d(pitch)", "d(roll)", "d(px)", "d(py)", "d(pa)", "d(ball).x",
    "d(ball).y", "d(ball).z", "d(bend)", nullptr};
const char* const tree_every_joint_body_names[10 + 1] = {
    "trunk", "arm", "piston", "drill", "tube", "gimbal", "slab", "hand", "finger", "thumb", nullptr};
const char* const tree_every_joint_frame_names[1 + 1] = {"drill_tip", nullptr};
const char* const tree_every_joint_output_names[0 + 1] = {nullptr};
const char* const tree_every_joint_force_names[0 + 1] = {nullptr};
const char* const tree_every_joint_parameter_names[0 + 1] = {nullptr};
const char* const tree_every_joint_wrench_body_names[2 + 1] = {"trunk", "drill", nullptr};
const char* const tree_every_joint_constraint_names[0 + 1] = {nullptr};
const int tree_every_joint_holonomic[0 + 1] = {0};
const double tree_every_joint_initial_coordinates[22] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0,
    0.0};
const double tree_every_joint_initial_speeds[20] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
const double tree_every_joint_default_parameters[0 + 1] = {0.0};

int tree_every_joint_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                      const double* parameters, const double* wrenches, double* tau) {
  if (q == nullptr || qd == nullptr || qdd == nullptr || tau == nullptr) return 1;
  ::alembert::mechanisms::tree_every_joint::inverse_dynamics<double>(q, qd, qdd, make_inputs(t, parameters, wrenches), tau);
  return 0;
}

int tree_every_joint_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches,
                                 double* M) {
  if (q == nullptr || M == nullptr) return 1;
  ::alembert::mechanisms::tree_every_joint::mass_matrix<double>(q, make_inputs(t, parameters, wrenches), M);
  return 0;
}

int tree_every_joint_bias(const double* q, const double* qd, double t, const double* parameters,
                          const double* wrenches, double* c) {
  if (q == nullptr || qd == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::tree_every_joint::bias<double>(q, qd, make_inputs(t, parameters, wrenches), c);
  return 0;
}

int tree_every_joint_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                        const double* wrenches, double* M, double* c) {
  if (q == nullptr || qd == nullptr || M == nullptr || c == nullptr) return 1;
  ::alembert::mechanisms::tree_every_joint::mass_matrix_and_bias<double>(q, qd, make_inputs(t, parameters, wrenches), M, c);
  return 0;
}

int tree_every_joint_coordinate_rates(const double* q, const double* qd, double* qdot) {
  if (q == nullptr || qd == nullptr || qdot == nullptr) return 1;
  ::alembert::mechanisms::tree_every_joint::coordinate_rates<double>(q, qd, qdot);
  return 0;
}

int tree_every_joint_energy(const double* q, const double* qd, double t, const double* parameters,
                            const double* wrenches, double* e) {
  if (q == nullptr || qd == nullptr || e == nullptr) return 1;
  ::alembert::mechanisms::tree_every_joint::energy<double>(q, qd, make_inputs(t, parameters, wrenches), e);
  return 0;
}

int tree_every_joint_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W) {
  if (q == nullptr || W == nullptr) return 1;
  ::alembert::mechanisms::tree_every_joint::body_poses<double>(q, make_inputs(t, parameters, wrenches), W);
  return 0;
}

int tree_every_joint_frame_poses(const double* q, double t, const double* parameters, const double* wrenches,
                                 double* F) {
  if (q == nullptr || F == nullptr) return 1;
  ::alembert::mechanisms::tree_every_joint::frame_poses<double>(q, make_inputs(t, parameters, wrenches), F);
  return 0;
}

int tree_every_joint_frame_jacobians(const double* q, double t, const double* parameters, const double* wrenches,
                                     double* J) {
  if (q == nullptr || J == nullptr) return 1;
  ::alembert::mechanisms::tree_every_joint::frame_jacobians<double>(q, make_inputs(t, parameters, wrenches), J);
  return 0;
}

}  // extern "C"
