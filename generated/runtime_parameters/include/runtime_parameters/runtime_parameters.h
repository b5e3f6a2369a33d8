/*
runtime_parameters: equations of motion as straight-line code.
Written by alembert 0.1.0 from the description of the mechanism "runtime_parameters". Do not edit: change the description.
Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.

The interface for C and for whatever can call C. Every function is re-entrant, takes no memory from the heap, and
returns 0, or 1 if an array that it needs is NULL, having written nothing then.

Arguments; arrays must not overlap:

  q           [2] coordinates: q1, q2
  qd          [2] speeds: d(q1), d(q2)
  qdd         [2] rates of the speeds
  tau         [2] generalized forces: N m for a speed in rad/s, N for one in m/s
  t           time, s
  parameters  [4] runtime parameters in SI units; NULL for the values of the description
  wrenches    NULL: no body takes an external wrench

Angles are in rad and lengths in m.
*/
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

enum {
  runtime_parameters_nq = 2,
  runtime_parameters_nv = 2,
  runtime_parameters_body_count = 2,
  runtime_parameters_frame_count = 0,
  runtime_parameters_output_count = 0,
  runtime_parameters_force_count = 0,
  runtime_parameters_parameter_count = 4,
  runtime_parameters_input_count = 0,
  runtime_parameters_state_count = 0,
  runtime_parameters_wrench_count = 0,
  runtime_parameters_nc = 0
};

/* Names, each list ended by NULL. */
extern const char* const runtime_parameters_coordinate_names[2 + 1];
extern const char* const runtime_parameters_speed_names[2 + 1];
extern const char* const runtime_parameters_body_names[2 + 1];
extern const char* const runtime_parameters_frame_names[0 + 1];
extern const char* const runtime_parameters_output_names[0 + 1];
extern const char* const runtime_parameters_force_names[0 + 1];
extern const char* const runtime_parameters_parameter_names[4 + 1];
extern const char* const runtime_parameters_wrench_body_names[0 + 1];
extern const char* const runtime_parameters_constraint_names[0 + 1];

/* Names for indices: q[runtime_parameters_coordinate_NAME], qd[runtime_parameters_speed_NAME],
   parameters[runtime_parameters_parameter_NAME]. */
enum {
    runtime_parameters_coordinate_q1 = 0, runtime_parameters_coordinate_q2 = 1
};
enum {
    runtime_parameters_speed_q1 = 0, runtime_parameters_speed_q2 = 1
};
enum {
    runtime_parameters_body_crank = 0, runtime_parameters_body_rod = 1
};
enum {
    runtime_parameters_parameter_g = 0, runtime_parameters_parameter_m = 1,
    runtime_parameters_parameter_l = 2, runtime_parameters_parameter_I = 3
};

/* 1 for each row of the constraints that is the rate of an equation in the coordinates alone, and a 0 after the last. */
extern const int runtime_parameters_holonomic[0 + 1];

/* The initial state of the description: coordinates and speeds. */
extern const double runtime_parameters_initial_coordinates[2];
extern const double runtime_parameters_initial_speeds[2];
/* Values of the runtime parameters in the description, and a 0 after the last. */
extern const double runtime_parameters_default_parameters[4 + 1];

/* Inverse dynamics: the generalized forces that give the speeds the rates qdd.
     tau = M(q) qdd + c(q, qd)
   tau [2]: generalized forces, N m for a speed in rad/s, N for one in m/s.
   Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
   Operations: 35 multiplications, 18 additions, 2 sin/cos/tan (reduced formulation; relative error 4.9e-16 where it was measured).
 */
int runtime_parameters_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                        const double* parameters, const double* wrenches, double* tau);

/* Mass matrix (joint-space inertia matrix), symmetric and in full.
     kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
   M [2 x 2], row by row: in units of tau / qdd.
   Operations: 10 multiplications, 4 additions, 2 sin/cos/tan (reduced formulation; relative error 2.2e-16 where it was measured).
 */
int runtime_parameters_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches,
                                   double* M);

/* Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
     tau = M(q) qdd + c(q, qd)
   c [2]: bias forces, in units of tau.
   Operations: 28 multiplications, 11 additions, 2 sin/cos/tan (reduced formulation; relative error 2e-16 where it was measured).
 */
int runtime_parameters_bias(const double* q, const double* qd, double t, const double* parameters,
                            const double* wrenches, double* c);

/* Mass matrix and bias forces at once: shorter than one after the other.
     tau = M(q) qdd + c(q, qd)
   M [2 x 2], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
   c [2]: bias forces, in units of tau.
   Operations: 33 multiplications, 14 additions, 2 sin/cos/tan (reduced formulation; relative error 3.4e-16 where it was measured).
 */
int runtime_parameters_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                        const double* wrenches, double* M, double* c);

/* Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
     dq/dt = N(q) qd
   qdot [2]: per second.
   Operations: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
 */
int runtime_parameters_coordinate_rates(const double* q, const double* qd, double* qdot);

/* Kinetic and potential energy.
     e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
   e [2]: kinetic and potential energy, J.
   Operations: 20 multiplications, 6 additions, 2 sin/cos/tan (reduced formulation; relative error 1.5e-15 where it was measured).
 */
int runtime_parameters_energy(const double* q, const double* qd, double t, const double* parameters,
                              const double* wrenches, double* e);

/* Poses of the bodies in the world.
   W [2 x 3 x 4], row by row: for each body of runtime_parameters_body_names the matrix [R p]: the columns of R are
     the body's axes, p is its origin, m.
   Operations: 6 multiplications, 0 additions, 4 sin/cos/tan (reduced formulation; relative error 1e-16 where it was measured).
 */
int runtime_parameters_body_poses(const double* q, double t, const double* parameters, const double* wrenches,
                                  double* W);

#ifdef __cplusplus
}
#endif
