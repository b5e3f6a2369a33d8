/*
four_bar_knee: equations of motion as straight-line code.
Written by alembert 0.1.0 from the description of the mechanism "four_bar_knee". Do not edit: change the description.
Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.

The interface for C and for whatever can call C. Every function is re-entrant, takes no memory from the heap, and
returns 0, or 1 if an array that it needs is NULL, having written nothing then.

Arguments; arrays must not overlap:

  q           [2] coordinates: hip, q
  qd          [2] speeds: d(hip), d(q)
  qdd         [2] rates of the speeds
  tau         [2] generalized forces: N m for a speed in rad/s, N for one in m/s
  t           time, s
  parameters  NULL: there are no runtime parameters
  wrenches    [1 x 6] per body of four_bar_knee_wrench_body_names the force x y z at its centre of mass, N, and the torque
              x y z, N m, both in world axes; NULL for none

Angles are in rad and lengths in m.
*/
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

enum {
  four_bar_knee_nq = 2,
  four_bar_knee_nv = 2,
  four_bar_knee_body_count = 2,
  four_bar_knee_frame_count = 1,
  four_bar_knee_output_count = 0,
  four_bar_knee_force_count = 0,
  four_bar_knee_parameter_count = 0,
  four_bar_knee_input_count = 0,
  four_bar_knee_state_count = 0,
  four_bar_knee_wrench_count = 1,
  four_bar_knee_nc = 0
};

/* Names, each list ended by NULL. */
extern const char* const four_bar_knee_coordinate_names[2 + 1];
extern const char* const four_bar_knee_speed_names[2 + 1];
extern const char* const four_bar_knee_body_names[2 + 1];
extern const char* const four_bar_knee_frame_names[1 + 1];
extern const char* const four_bar_knee_output_names[0 + 1];
extern const char* const four_bar_knee_force_names[0 + 1];
extern const char* const four_bar_knee_parameter_names[0 + 1];
extern const char* const four_bar_knee_wrench_body_names[1 + 1];
extern const char* const four_bar_knee_constraint_names[0 + 1];

/* Names for indices: q[four_bar_knee_coordinate_NAME], qd[four_bar_knee_speed_NAME]. Wrenches begin at 6 *
   four_bar_knee_wrench_NAME. */
enum {
    four_bar_knee_coordinate_hip = 0, four_bar_knee_coordinate_q = 1
};
enum { four_bar_knee_speed_hip = 0, four_bar_knee_speed_q = 1 };
enum { four_bar_knee_body_thigh = 0, four_bar_knee_body_shank = 1 };
enum { four_bar_knee_frame_ankle = 0 };
enum { four_bar_knee_wrench_shank = 0 };

/* 1 for each row of the constraints that is the rate of an equation in the coordinates alone, and a 0 after the last. */
extern const int four_bar_knee_holonomic[0 + 1];

/* The initial state of the description: coordinates and speeds. */
extern const double four_bar_knee_initial_coordinates[2];
extern const double four_bar_knee_initial_speeds[2];
/* Values of the runtime parameters in the description, and a 0 after the last. */
extern const double four_bar_knee_default_parameters[0 + 1];

/* Inverse dynamics: the generalized forces that give the speeds the rates qdd.
     tau = M(q) qdd + c(q, qd)
   tau [2]: generalized forces, N m for a speed in rad/s, N for one in m/s.
   Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
   Operations: 116 multiplications, 75 additions, 5 divisions, 8 sin/cos/tan, 5 other functions (reduced formulation; relative error 5e-16 where it was measured).
 */
int four_bar_knee_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                   const double* parameters, const double* wrenches, double* tau);

/* Mass matrix (joint-space inertia matrix), symmetric and in full.
     kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
   M [2 x 2], row by row: in units of tau / qdd.
   Operations: 46 multiplications, 33 additions, 4 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation; relative error 2.9e-15 where it was measured).
 */
int four_bar_knee_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M);

/* Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
     tau = M(q) qdd + c(q, qd)
   c [2]: bias forces, in units of tau.
   Operations: 107 multiplications, 66 additions, 5 divisions, 8 sin/cos/tan, 5 other functions (reduced formulation; relative error 7.1e-16 where it was measured).
 */
int four_bar_knee_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                       double* c);

/* Mass matrix and bias forces at once: shorter than one after the other.
     tau = M(q) qdd + c(q, qd)
   M [2 x 2], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
   c [2]: bias forces, in units of tau.
   Operations: 131 multiplications, 84 additions, 5 divisions, 8 sin/cos/tan, 5 other functions (reduced formulation; relative error 2.9e-15 where it was measured).
 */
int four_bar_knee_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                       const double* wrenches, double* M, double* c);

/* Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
     dq/dt = N(q) qd
   qdot [2]: per second.
   Operations: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
 */
int four_bar_knee_coordinate_rates(const double* q, const double* qd, double* qdot);

/* Kinetic and potential energy.
     e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
   e [2]: kinetic and potential energy, J.
   Operations: 55 multiplications, 34 additions, 5 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation; relative error 4.3e-15 where it was measured).
 */
int four_bar_knee_energy(const double* q, const double* qd, double t, const double* parameters,
                         const double* wrenches, double* e);

/* Poses of the bodies in the world.
   W [2 x 3 x 4], row by row: for each body of four_bar_knee_body_names the matrix [R p]: the columns of R are the
     body's axes, p is its origin, m.
   Operations: 18 multiplications, 14 additions, 2 divisions, 6 sin/cos/tan, 4 other functions (reduced formulation; relative error 3.3e-16 where it was measured).
 */
int four_bar_knee_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W);

/* Poses of the named frames in the world.
   F [1 x 3 x 4], row by row: for each frame of four_bar_knee_frame_names the matrix [R p]: the columns of R are
     the frame's axes, p is its origin, m.
   Operations: 20 multiplications, 16 additions, 2 divisions, 6 sin/cos/tan, 4 other functions (reduced formulation; relative error 3.3e-16 where it was measured).
 */
int four_bar_knee_frame_poses(const double* q, double t, const double* parameters, const double* wrenches, double* F);

/* Geometric Jacobians of the named frames' origins: angular rows first, in world axes.
     J(q) qd = (angular velocity x y z, velocity of the frame's origin x y z), less what motion prescribed in time adds
   J [1 x 6 x 2], row by row: for each frame of four_bar_knee_frame_names 6 rows: 3 angular, then 3 linear.
   Operations: 54 multiplications, 32 additions, 4 divisions, 6 sin/cos/tan, 5 other functions (reduced formulation; relative error 9.5e-16 where it was measured).
 */
int four_bar_knee_frame_jacobians(const double* q, double t, const double* parameters, const double* wrenches,
                                  double* J);

#ifdef __cplusplus
}
#endif
