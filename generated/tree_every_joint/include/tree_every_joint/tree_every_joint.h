/*
tree_every_joint: equations of motion as straight-line code.
Written by alembert 0.1.0 from the description of the mechanism "tree_every_joint". Do not edit: change the description.
Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.

The interface for C and for whatever can call C. Every function is re-entrant, takes no memory from the heap, and
returns 0, or 1 if an array that it needs is NULL, having written nothing then.

Arguments; arrays must not overlap:

  q           [22] coordinates: x, y, z, attitude.x, attitude.y, attitude.z, attitude.w, shoulder, slide, screw, twist, reach and 10 more
  qd          [20] speeds: d(x), d(y), d(z), d(attitude).x, d(attitude).y, d(attitude).z, d(shoulder), d(slide), d(screw), d(twist), d(reach), d(pitch) and 8 more
  qdd         [20] rates of the speeds
  tau         [20] generalized forces: N m for a speed in rad/s, N for one in m/s
  t           time, s
  parameters  NULL: there are no runtime parameters
  wrenches    [2 x 6] per body of tree_every_joint_wrench_body_names the force x y z at its centre of mass, N, and the torque
              x y z, N m, both in world axes; NULL for none

Angles are in rad and lengths in m.
*/
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

enum {
  tree_every_joint_nq = 22,
  tree_every_joint_nv = 20,
  tree_every_joint_body_count = 10,
  tree_every_joint_frame_count = 1,
  tree_every_joint_output_count = 0,
  tree_every_joint_force_count = 0,
  tree_every_joint_parameter_count = 0,
  tree_every_joint_input_count = 0,
  tree_every_joint_state_count = 0,
  tree_every_joint_wrench_count = 2,
  tree_every_joint_nc = 0
};

/* Names, each list ended by NULL. */
extern const char* const tree_every_joint_coordinate_names[22 + 1];
extern const char* const tree_every_joint_speed_names[20 + 1];
extern const char* const tree_every_joint_body_names[10 + 1];
extern const char* const tree_every_joint_frame_names[1 + 1];
extern const char* const tree_every_joint_output_names[0 + 1];
extern const char* const tree_every_joint_force_names[0 + 1];
extern const char* const tree_every_joint_parameter_names[0 + 1];
extern const char* const tree_every_joint_wrench_body_names[2 + 1];
extern const char* const tree_every_joint_constraint_names[0 + 1];

/* Names for indices: q[tree_every_joint_coordinate_NAME], qd[tree_every_joint_speed_NAME]. Of a quaternion
   that of its first entry. Wrenches begin at 6 * tree_every_joint_wrench_NAME. */
enum {
    tree_every_joint_coordinate_x = 0, tree_every_joint_coordinate_y = 1, tree_every_joint_coordinate_z = 2,
    tree_every_joint_coordinate_attitude = 3, tree_every_joint_coordinate_shoulder = 7,
    tree_every_joint_coordinate_slide = 8, tree_every_joint_coordinate_screw = 9,
    tree_every_joint_coordinate_twist = 10, tree_every_joint_coordinate_reach = 11,
    tree_every_joint_coordinate_pitch = 12, tree_every_joint_coordinate_roll = 13,
    tree_every_joint_coordinate_px = 14, tree_every_joint_coordinate_py = 15,
    tree_every_joint_coordinate_pa = 16, tree_every_joint_coordinate_ball = 17,
    tree_every_joint_coordinate_bend = 21
};
enum {
    tree_every_joint_speed_x = 0, tree_every_joint_speed_y = 1, tree_every_joint_speed_z = 2,
    tree_every_joint_speed_attitude = 3, tree_every_joint_speed_shoulder = 6,
    tree_every_joint_speed_slide = 7, tree_every_joint_speed_screw = 8, tree_every_joint_speed_twist = 9,
    tree_every_joint_speed_reach = 10, tree_every_joint_speed_pitch = 11, tree_every_joint_speed_roll = 12,
    tree_every_joint_speed_px = 13, tree_every_joint_speed_py = 14, tree_every_joint_speed_pa = 15,
    tree_every_joint_speed_ball = 16, tree_every_joint_speed_bend = 19
};
enum {
    tree_every_joint_body_trunk = 0, tree_every_joint_body_arm = 1, tree_every_joint_body_piston = 2,
    tree_every_joint_body_drill = 3, tree_every_joint_body_tube = 4, tree_every_joint_body_gimbal = 5,
    tree_every_joint_body_slab = 6, tree_every_joint_body_hand = 7, tree_every_joint_body_finger = 8,
    tree_every_joint_body_thumb = 9
};
enum { tree_every_joint_frame_drill_tip = 0 };
enum {
    tree_every_joint_wrench_trunk = 0, tree_every_joint_wrench_drill = 1
};

/* 1 for each row of the constraints that is the rate of an equation in the coordinates alone, and a 0 after the last. */
extern const int tree_every_joint_holonomic[0 + 1];

/* The initial state of the description: coordinates and speeds. */
extern const double tree_every_joint_initial_coordinates[22];
extern const double tree_every_joint_initial_speeds[20];
/* Values of the runtime parameters in the description, and a 0 after the last. */
extern const double tree_every_joint_default_parameters[0 + 1];

/* Inverse dynamics: the generalized forces that give the speeds the rates qdd.
     tau = M(q) qdd + c(q, qd)
   tau [20]: generalized forces, N m for a speed in rad/s, N for one in m/s.
   Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
   Operations: 919 multiplications, 877 additions, 16 sin/cos/tan (reduced formulation; relative error 4.6e-16 where it was measured).
 */
int tree_every_joint_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                      const double* parameters, const double* wrenches, double* tau);

/* Mass matrix (joint-space inertia matrix), symmetric and in full.
     kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
   M [20 x 20], row by row: in units of tau / qdd.
   Operations: 856 multiplications, 766 additions, 16 sin/cos/tan (reduced formulation; relative error 5.5e-16 where it was measured).
 */
int tree_every_joint_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches,
                                 double* M);

/* Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
     tau = M(q) qdd + c(q, qd)
   c [20]: bias forces, in units of tau.
   Operations: 888 multiplications, 810 additions, 16 sin/cos/tan (reduced formulation; relative error 6.4e-16 where it was measured).
 */
int tree_every_joint_bias(const double* q, const double* qd, double t, const double* parameters,
                          const double* wrenches, double* c);

/* Mass matrix and bias forces at once: shorter than one after the other.
     tau = M(q) qdd + c(q, qd)
   M [20 x 20], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
   c [20]: bias forces, in units of tau.
   Operations: 1710 multiplications, 1524 additions, 16 sin/cos/tan (reduced formulation; relative error 6.4e-16 where it was measured).
 */
int tree_every_joint_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                        const double* wrenches, double* M, double* c);

/* Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
     dq/dt = N(q) qd
   qdot [22]: per second.
   Operations: 30 multiplications, 16 additions (reduced formulation; relative error 9.7e-17 where it was measured).
 */
int tree_every_joint_coordinate_rates(const double* q, const double* qd, double* qdot);

/* Kinetic and potential energy.
     e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
   e [2]: kinetic and potential energy, J.
   Operations: 792 multiplications, 653 additions, 16 sin/cos/tan (reduced formulation; relative error 6.8e-16 where it was measured).
 */
int tree_every_joint_energy(const double* q, const double* qd, double t, const double* parameters,
                            const double* wrenches, double* e);

/* Poses of the bodies in the world.
   W [10 x 3 x 4], row by row: for each body of tree_every_joint_body_names the matrix [R p]: the columns of R are
     the body's axes, p is its origin, m.
   Operations: 274 multiplications, 239 additions, 16 sin/cos/tan (reduced formulation; relative error 3.3e-16 where it was measured).
 */
int tree_every_joint_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W);

/* Poses of the named frames in the world.
   F [1 x 3 x 4], row by row: for each frame of tree_every_joint_frame_names the matrix [R p]: the columns of R are
     the frame's axes, p is its origin, m.
   Operations: 82 multiplications, 76 additions, 4 sin/cos/tan (reduced formulation; relative error 5e-16 where it was measured).
 */
int tree_every_joint_frame_poses(const double* q, double t, const double* parameters, const double* wrenches,
                                 double* F);

/* Geometric Jacobians of the named frames' origins: angular rows first, in world axes.
     J(q) qd = (angular velocity x y z, velocity of the frame's origin x y z), less what motion prescribed in time adds
   J [1 x 6 x 20], row by row: for each frame of tree_every_joint_frame_names 6 rows: 3 angular, then 3 linear.
   Operations: 527 multiplications, 395 additions, 4 sin/cos/tan (reduced formulation; relative error 5.1e-16 where it was measured).
 */
int tree_every_joint_frame_jacobians(const double* q, double t, const double* parameters, const double* wrenches,
                                     double* J);

#ifdef __cplusplus
}
#endif
