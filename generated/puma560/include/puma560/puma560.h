/*
puma560: equations of motion as straight-line code.
Written by alembert 0.1.0 from the description of the mechanism "puma560". Do not edit: change the description.
Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.

The interface for C and for whatever can call C. Every function is re-entrant, takes no memory from the heap, and
returns 0, or 1 if an array that it needs is NULL, having written nothing then.

Arguments; arrays must not overlap:

  q           [6] coordinates: q1, q2, q3, q4, q5, q6
  qd          [6] speeds: d(q1), d(q2), d(q3), d(q4), d(q5), d(q6)
  qdd         [6] rates of the speeds
  tau         [6] generalized forces: N m for a speed in rad/s, N for one in m/s
  t           time, s
  parameters  NULL: there are no runtime parameters
  wrenches    NULL: no body takes an external wrench

Angles are in rad and lengths in m.
*/
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
  puma560_nq = 6,
  puma560_nv = 6,
  puma560_body_count = 6,
  puma560_frame_count = 1,
  puma560_output_count = 0,
  puma560_force_count = 0,
  puma560_parameter_count = 0,
  puma560_input_count = 0,
  puma560_state_count = 0,
  puma560_wrench_count = 0,
  puma560_nc = 0
};

/* Names, each list ended by NULL. */
extern const char* const puma560_coordinate_names[6 + 1];
extern const char* const puma560_speed_names[6 + 1];
extern const char* const puma560_body_names[6 + 1];
extern const char* const puma560_frame_names[1 + 1];
extern const char* const puma560_output_names[0 + 1];
extern const char* const puma560_force_names[0 + 1];
extern const char* const puma560_parameter_names[0 + 1];
extern const char* const puma560_wrench_body_names[0 + 1];
extern const char* const puma560_constraint_names[0 + 1];

/* Names for indices: q[puma560_coordinate_NAME], qd[puma560_speed_NAME]. */
enum {
    puma560_coordinate_q1 = 0, puma560_coordinate_q2 = 1, puma560_coordinate_q3 = 2,
    puma560_coordinate_q4 = 3, puma560_coordinate_q5 = 4, puma560_coordinate_q6 = 5
};
enum {
    puma560_speed_q1 = 0, puma560_speed_q2 = 1, puma560_speed_q3 = 2, puma560_speed_q4 = 3,
    puma560_speed_q5 = 4, puma560_speed_q6 = 5
};
enum {
    puma560_body_link1 = 0, puma560_body_link2 = 1, puma560_body_link3 = 2, puma560_body_link4 = 3,
    puma560_body_link5 = 4, puma560_body_link6 = 5
};
enum { puma560_frame_flange = 0 };

/* 1 for each row of the constraints that is the rate of an equation in the coordinates alone, and a 0 after the last. */
extern const int puma560_holonomic[0 + 1];

/* The initial state of the description: coordinates and speeds. */
extern const double puma560_initial_coordinates[6];
extern const double puma560_initial_speeds[6];
/* Values of the runtime parameters in the description, and a 0 after the last. */
extern const double puma560_default_parameters[0 + 1];

/* Inverse dynamics: the generalized forces that give the speeds the rates qdd.
     tau = M(q) qdd + c(q, qd)
   tau [6]: generalized forces, N m for a speed in rad/s, N for one in m/s.
   Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
   Operations: 184 multiplications, 148 additions, 10 sin/cos/tan (reduced formulation; relative error 3.5e-16 where it was measured).
 */
int puma560_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t, const double* parameters,
                             const double* wrenches, double* tau);

/* Mass matrix (joint-space inertia matrix), symmetric and in full.
     kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
   M [6 x 6], row by row: in units of tau / qdd.
   Operations: 91 multiplications, 76 additions, 8 sin/cos/tan (reduced formulation; relative error 1.9e-16 where it was measured).
 */
int puma560_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M);

/* Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
     tau = M(q) qdd + c(q, qd)
   c [6]: bias forces, in units of tau.
   Operations: 165 multiplications, 118 additions, 10 sin/cos/tan (reduced formulation; relative error 6.9e-16 where it was measured).
 */
int puma560_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                 double* c);

/* Mass matrix and bias forces at once: shorter than one after the other.
     tau = M(q) qdd + c(q, qd)
   M [6 x 6], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
   c [6]: bias forces, in units of tau.
   Operations: 256 multiplications, 194 additions, 10 sin/cos/tan (reduced formulation; relative error 6.9e-16 where it was measured).
 */
int puma560_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                 const double* wrenches, double* M, double* c);

/* Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
     dq/dt = N(q) qd
   qdot [6]: per second.
   Operations: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
 */
int puma560_coordinate_rates(const double* q, const double* qd, double* qdot);

/* Kinetic and potential energy.
     e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
   e [2]: kinetic and potential energy, J.
   Operations: 126 multiplications, 80 additions, 10 sin/cos/tan (reduced formulation; relative error 9.7e-16 where it was measured).
 */
int puma560_energy(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                   double* e);

/* Poses of the bodies in the world.
   W [6 x 3 x 4], row by row: for each body of puma560_body_names the matrix [R p]: the columns of R are the body's
     axes, p is its origin, m.
   Operations: 63 multiplications, 30 additions, 12 sin/cos/tan (reduced formulation; relative error 2.3e-16 where it was measured).
 */
int puma560_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W);

/* Poses of the named frames in the world.
   F [1 x 3 x 4], row by row: for each frame of puma560_frame_names the matrix [R p]: the columns of R are the
     frame's axes, p is its origin, m.
   Operations: 64 multiplications, 33 additions, 12 sin/cos/tan (reduced formulation; relative error 2.5e-16 where it was measured).
 */
int puma560_frame_poses(const double* q, double t, const double* parameters, const double* wrenches, double* F);

/* Geometric Jacobians of the named frames' origins: angular rows first, in world axes.
     J(q) qd = (angular velocity x y z, velocity of the frame's origin x y z), less what motion prescribed in time adds
   J [1 x 6 x 6], row by row: for each frame of puma560_frame_names 6 rows: 3 angular, then 3 linear.
   Operations: 59 multiplications, 24 additions, 10 sin/cos/tan (reduced formulation; relative error 1.8e-16 where it was measured).
 */
int puma560_frame_jacobians(const double* q, double t, const double* parameters, const double* wrenches, double* J);

/* inverse_dynamics for n states: entry i of state s stands at x[i * stride + s], stride >= n, matrices and poses row by row. t and
   parameters (may be NULL) are those of all states; wrenches [0 x 6 x stride] are of each, or NULL for none. The states
   are spread over threads (0: one a core), which changes no result. Returns 0; 1 if an array is NULL or the stride too
   small; 2 if a result is not finite. */
int puma560_inverse_dynamics_batch(size_t n, size_t stride, const double* q, const double* qd, const double* qdd,
                                   double t, const double* parameters, const double* wrenches, double* tau,
                                   int threads);

/* mass_matrix_and_bias for n states: entry i of state s stands at x[i * stride + s], stride >= n, matrices and poses row by row. t and
   parameters (may be NULL) are those of all states; wrenches [0 x 6 x stride] are of each, or NULL for none. The states
   are spread over threads (0: one a core), which changes no result. Returns 0; 1 if an array is NULL or the stride too
   small; 2 if a result is not finite. */
int puma560_mass_matrix_and_bias_batch(size_t n, size_t stride, const double* q, const double* qd, double t,
                                       const double* parameters, const double* wrenches, double* M, double* c,
                                       int threads);

/* forward_dynamics for n states: entry i of state s stands at x[i * stride + s], stride >= n, matrices and poses row by row. t and
   parameters (may be NULL) are those of all states; wrenches [0 x 6 x stride] are of each, or NULL for none. The states
   are spread over threads (0: one a core), which changes no result. Returns 0; 1 if an array is NULL or the stride too
   small; 2 if a result is not finite. */
int puma560_forward_dynamics_batch(size_t n, size_t stride, const double* q, const double* qd, const double* tau,
                                   double t, const double* parameters, const double* wrenches, double* qdd,
                                   int threads);

#ifdef __cplusplus
}
#endif
