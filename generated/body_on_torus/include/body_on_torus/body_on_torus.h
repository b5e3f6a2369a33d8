/*
body_on_torus: equations of motion as straight-line code.
Written by alembert 0.1.0 from the description of the mechanism "body_on_torus". Do not edit: change the description.
Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.

The interface for C and for whatever can call C. Every function is re-entrant, takes no memory from the heap, and
returns 0, or 1 if an array that it needs is NULL, having written nothing then.

Arguments; arrays must not overlap:

  q           [3] coordinates: u, v, spin
  qd          [3] speeds: d(u), d(v), d(spin)
  qdd         [3] rates of the speeds
  tau         [3] generalized forces: N m for a speed in rad/s, N for one in m/s
  t           time, s
  parameters  NULL: there are no runtime parameters
  wrenches    NULL: no body takes an external wrench

Angles are in rad and lengths in m.
*/
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

enum {
  body_on_torus_nq = 3,
  body_on_torus_nv = 3,
  body_on_torus_body_count = 1,
  body_on_torus_frame_count = 0,
  body_on_torus_output_count = 0,
  body_on_torus_force_count = 0,
  body_on_torus_parameter_count = 0,
  body_on_torus_input_count = 0,
  body_on_torus_state_count = 0,
  body_on_torus_wrench_count = 0,
  body_on_torus_nc = 0
};

/* Names, each list ended by NULL. */
extern const char* const body_on_torus_coordinate_names[3 + 1];
extern const char* const body_on_torus_speed_names[3 + 1];
extern const char* const body_on_torus_body_names[1 + 1];
extern const char* const body_on_torus_frame_names[0 + 1];
extern const char* const body_on_torus_output_names[0 + 1];
extern const char* const body_on_torus_force_names[0 + 1];
extern const char* const body_on_torus_parameter_names[0 + 1];
extern const char* const body_on_torus_wrench_body_names[0 + 1];
extern const char* const body_on_torus_constraint_names[0 + 1];

/* Names for indices: q[body_on_torus_coordinate_NAME], qd[body_on_torus_speed_NAME]. */
enum {
    body_on_torus_coordinate_u = 0, body_on_torus_coordinate_v = 1, body_on_torus_coordinate_spin = 2
};
enum {
    body_on_torus_speed_u = 0, body_on_torus_speed_v = 1, body_on_torus_speed_spin = 2
};
enum { body_on_torus_body_slider = 0 };

/* 1 for each row of the constraints that is the rate of an equation in the coordinates alone, and a 0 after the last. */
extern const int body_on_torus_holonomic[0 + 1];

/* The initial state of the description: coordinates and speeds. */
extern const double body_on_torus_initial_coordinates[3];
extern const double body_on_torus_initial_speeds[3];
/* Values of the runtime parameters in the description, and a 0 after the last. */
extern const double body_on_torus_default_parameters[0 + 1];

/* Inverse dynamics: the generalized forces that give the speeds the rates qdd.
     tau = M(q) qdd + c(q, qd)
   tau [3]: generalized forces, N m for a speed in rad/s, N for one in m/s.
   Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
   Operations: 63 multiplications, 48 additions, 4 sin/cos/tan (reduced formulation; relative error 2e-16 where it was measured).
 */
int body_on_torus_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                   const double* parameters, const double* wrenches, double* tau);

/* Mass matrix (joint-space inertia matrix), symmetric and in full.
     kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
   M [3 x 3], row by row: in units of tau / qdd.
   Operations: 20 multiplications, 14 additions, 4 sin/cos/tan (reduced formulation; relative error 5.4e-16 where it was measured).
 */
int body_on_torus_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M);

/* Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
     tau = M(q) qdd + c(q, qd)
   c [3]: bias forces, in units of tau.
   Operations: 55 multiplications, 38 additions, 4 sin/cos/tan (reduced formulation; relative error 1.9e-16 where it was measured).
 */
int body_on_torus_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                       double* c);

/* Mass matrix and bias forces at once: shorter than one after the other.
     tau = M(q) qdd + c(q, qd)
   M [3 x 3], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
   c [3]: bias forces, in units of tau.
   Operations: 75 multiplications, 52 additions, 4 sin/cos/tan (reduced formulation; relative error 5.4e-16 where it was measured).
 */
int body_on_torus_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                       const double* wrenches, double* M, double* c);

/* Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
     dq/dt = N(q) qd
   qdot [3]: per second.
   Operations: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
 */
int body_on_torus_coordinate_rates(const double* q, const double* qd, double* qdot);

/* Kinetic and potential energy.
     e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
   e [2]: kinetic and potential energy, J.
   Operations: 36 multiplications, 22 additions, 4 sin/cos/tan (reduced formulation; relative error 6e-15 where it was measured).
 */
int body_on_torus_energy(const double* q, const double* qd, double t, const double* parameters,
                         const double* wrenches, double* e);

/* Poses of the bodies in the world.
   W [1 x 3 x 4], row by row: for each body of body_on_torus_body_names the matrix [R p]: the columns of R are the
     body's axes, p is its origin, m.
   Operations: 19 multiplications, 6 additions, 6 sin/cos/tan (reduced formulation; relative error 1.8e-16 where it was measured).
 */
int body_on_torus_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W);

#ifdef __cplusplus
}
#endif
