/*
free_body: equations of motion as straight-line code.
Written by alembert 0.1.0 from the description of the mechanism "free_body". Do not edit: change the description.
Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.

The interface for C and for whatever can call C. Every function is re-entrant, takes no memory from the heap, and
returns 0, or 1 if an array that it needs is NULL, having written nothing then.

Arguments; arrays must not overlap:

  q           [7] coordinates: x, y, z, turn.x, turn.y, turn.z, turn.w
  qd          [6] speeds: d(x), d(y), d(z), d(turn).x, d(turn).y, d(turn).z
  qdd         [6] rates of the speeds
  tau         [6] generalized forces: N m for a speed in rad/s, N for one in m/s
  t           time, s
  parameters  NULL: there are no runtime parameters
  wrenches    [1 x 6] per body of free_body_wrench_body_names the force x y z at its centre of mass, N, and the torque
              x y z, N m, both in world axes; NULL for none

Angles are in rad and lengths in m.
*/
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

enum {
  free_body_nq = 7,
  free_body_nv = 6,
  free_body_body_count = 1,
  free_body_frame_count = 1,
  free_body_output_count = 0,
  free_body_force_count = 0,
  free_body_parameter_count = 0,
  free_body_input_count = 0,
  free_body_state_count = 0,
  free_body_wrench_count = 1,
  free_body_nc = 0
};

/* Names, each list ended by NULL. */
extern const char* const free_body_coordinate_names[7 + 1];
extern const char* const free_body_speed_names[6 + 1];
extern const char* const free_body_body_names[1 + 1];
extern const char* const free_body_frame_names[1 + 1];
extern const char* const free_body_output_names[0 + 1];
extern const char* const free_body_force_names[0 + 1];
extern const char* const free_body_parameter_names[0 + 1];
extern const char* const free_body_wrench_body_names[1 + 1];
extern const char* const free_body_constraint_names[0 + 1];

/* Names for indices: q[free_body_coordinate_NAME], qd[free_body_speed_NAME]. Of a quaternion that of its
   first entry. Wrenches begin at 6 * free_body_wrench_NAME. */
enum {
    free_body_coordinate_x = 0, free_body_coordinate_y = 1, free_body_coordinate_z = 2,
    free_body_coordinate_turn = 3
};
enum {
    free_body_speed_x = 0, free_body_speed_y = 1, free_body_speed_z = 2, free_body_speed_turn = 3
};
enum { free_body_body_body = 0 };
enum { free_body_frame_nose = 0 };
enum { free_body_wrench_body = 0 };

/* 1 for each row of the constraints that is the rate of an equation in the coordinates alone, and a 0 after the last. */
extern const int free_body_holonomic[0 + 1];

/* The initial state of the description: coordinates and speeds. */
extern const double free_body_initial_coordinates[7];
extern const double free_body_initial_speeds[6];
/* Values of the runtime parameters in the description, and a 0 after the last. */
extern const double free_body_default_parameters[0 + 1];

/* Inverse dynamics: the generalized forces that give the speeds the rates qdd.
     tau = M(q) qdd + c(q, qd)
   tau [6]: generalized forces, N m for a speed in rad/s, N for one in m/s.
   Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
   Operations: 90 multiplications, 97 additions (reduced formulation; relative error 3e-16 where it was measured).
 */
int free_body_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                               const double* parameters, const double* wrenches, double* tau);

/* Mass matrix (joint-space inertia matrix), symmetric and in full.
     kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
   M [6 x 6], row by row: in units of tau / qdd.
   Operations: 27 multiplications, 24 additions (reduced formulation; relative error 2e-16 where it was measured).
 */
int free_body_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M);

/* Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
     tau = M(q) qdd + c(q, qd)
   c [6]: bias forces, in units of tau.
   Operations: 75 multiplications, 79 additions (reduced formulation; relative error 1.7e-16 where it was measured).
 */
int free_body_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                   double* c);

/* Mass matrix and bias forces at once: shorter than one after the other.
     tau = M(q) qdd + c(q, qd)
   M [6 x 6], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
   c [6]: bias forces, in units of tau.
   Operations: 93 multiplications, 88 additions (reduced formulation; relative error 2e-16 where it was measured).
 */
int free_body_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                   const double* wrenches, double* M, double* c);

/* Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
     dq/dt = N(q) qd
   qdot [7]: per second.
   Operations: 15 multiplications, 8 additions (reduced formulation; relative error 1e-16 where it was measured).
 */
int free_body_coordinate_rates(const double* q, const double* qd, double* qdot);

/* Kinetic and potential energy.
     e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
   e [2]: kinetic and potential energy, J.
   Operations: 48 multiplications, 44 additions (reduced formulation; relative error 2.8e-16 where it was measured).
 */
int free_body_energy(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                     double* e);

/* Poses of the bodies in the world.
   W [1 x 3 x 4], row by row: for each body of free_body_body_names the matrix [R p]: the columns of R are the
     body's axes, p is its origin, m.
   Operations: 9 multiplications, 21 additions (reduced formulation; relative error 2.9e-16 where it was measured).
 */
int free_body_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W);

/* Poses of the named frames in the world.
   F [1 x 3 x 4], row by row: for each frame of free_body_frame_names the matrix [R p]: the columns of R are the
     frame's axes, p is its origin, m.
   Operations: 15 multiplications, 27 additions (reduced formulation; relative error 2.9e-16 where it was measured).
 */
int free_body_frame_poses(const double* q, double t, const double* parameters, const double* wrenches, double* F);

/* Geometric Jacobians of the named frames' origins: angular rows first, in world axes.
     J(q) qd = (angular velocity x y z, velocity of the frame's origin x y z), less what motion prescribed in time adds
   J [1 x 6 x 6], row by row: for each frame of free_body_frame_names 6 rows: 3 angular, then 3 linear.
   Operations: 48 multiplications, 41 additions (reduced formulation; relative error 4.5e-16 where it was measured).
 */
int free_body_frame_jacobians(const double* q, double t, const double* parameters, const double* wrenches, double* J);

#ifdef __cplusplus
}
#endif
