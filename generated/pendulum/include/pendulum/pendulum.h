/*
pendulum: equations of motion as straight-line code.
Written by alembert 0.1.0 from the description of the mechanism "pendulum". Do not edit: change the description.
Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.

The interface for C and for whatever can call C. Every function is re-entrant, takes no memory from the heap, and
returns 0, or 1 if an array that it needs is NULL, having written nothing then.

Arguments; arrays must not overlap:

  q           [1] coordinates: q
  qd          [1] speeds: d(q)
  qdd         [1] rates of the speeds
  tau         [1] generalized forces: N m for a speed in rad/s, N for one in m/s
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
  pendulum_nq = 1,
  pendulum_nv = 1,
  pendulum_body_count = 1,
  pendulum_frame_count = 0,
  pendulum_output_count = 0,
  pendulum_force_count = 0,
  pendulum_parameter_count = 0,
  pendulum_input_count = 0,
  pendulum_state_count = 0,
  pendulum_wrench_count = 0,
  pendulum_nc = 0
};

/* Names, each list ended by NULL. */
extern const char* const pendulum_coordinate_names[1 + 1];
extern const char* const pendulum_speed_names[1 + 1];
extern const char* const pendulum_body_names[1 + 1];
extern const char* const pendulum_frame_names[0 + 1];
extern const char* const pendulum_output_names[0 + 1];
extern const char* const pendulum_force_names[0 + 1];
extern const char* const pendulum_parameter_names[0 + 1];
extern const char* const pendulum_wrench_body_names[0 + 1];
extern const char* const pendulum_constraint_names[0 + 1];

/* Names for indices: q[pendulum_coordinate_NAME], qd[pendulum_speed_NAME]. */
enum { pendulum_coordinate_q = 0 };
enum { pendulum_speed_q = 0 };
enum { pendulum_body_rod = 0 };

/* 1 for each row of the constraints that is the rate of an equation in the coordinates alone, and a 0 after the last. */
extern const int pendulum_holonomic[0 + 1];

/* The initial state of the description: coordinates and speeds. */
extern const double pendulum_initial_coordinates[1];
extern const double pendulum_initial_speeds[1];
/* Values of the runtime parameters in the description, and a 0 after the last. */
extern const double pendulum_default_parameters[0 + 1];

/* Inverse dynamics: the generalized forces that give the speeds the rates qdd.
     tau = M(q) qdd + c(q, qd)
   tau [1]: generalized forces, N m for a speed in rad/s, N for one in m/s.
   Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
   Operations: 2 multiplications, 1 addition, 1 sin/cos/tan (reduced formulation; relative error 2.4e-16 where it was measured).
 */
int pendulum_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                              const double* parameters, const double* wrenches, double* tau);

/* Mass matrix (joint-space inertia matrix), symmetric and in full.
     kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
   M [1 x 1], row by row: in units of tau / qdd.
   Operations: 0 multiplications, 0 additions (reduced formulation; relative error 6.3e-17 where it was measured).
 */
int pendulum_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M);

/* Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
     tau = M(q) qdd + c(q, qd)
   c [1]: bias forces, in units of tau.
   Operations: 1 multiplication, 0 additions, 1 sin/cos/tan (reduced formulation; relative error 1.8e-16 where it was measured).
 */
int pendulum_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                  double* c);

/* Mass matrix and bias forces at once: shorter than one after the other.
     tau = M(q) qdd + c(q, qd)
   M [1 x 1], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
   c [1]: bias forces, in units of tau.
   Operations: 1 multiplication, 0 additions, 1 sin/cos/tan (reduced formulation; relative error 1.8e-16 where it was measured).
 */
int pendulum_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                  const double* wrenches, double* M, double* c);

/* Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
     dq/dt = N(q) qd
   qdot [1]: per second.
   Operations: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
 */
int pendulum_coordinate_rates(const double* q, const double* qd, double* qdot);

/* Kinetic and potential energy.
     e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
   e [2]: kinetic and potential energy, J.
   Operations: 3 multiplications, 0 additions, 1 sin/cos/tan (reduced formulation; relative error 1.7e-16 where it was measured).
 */
int pendulum_energy(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                    double* e);

/* Poses of the bodies in the world.
   W [1 x 3 x 4], row by row: for each body of pendulum_body_names the matrix [R p]: the columns of R are the
     body's axes, p is its origin, m.
   Operations: 0 multiplications, 0 additions, 2 sin/cos/tan (reduced formulation; relative error 5e-17 where it was measured).
 */
int pendulum_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W);

#ifdef __cplusplus
}
#endif
