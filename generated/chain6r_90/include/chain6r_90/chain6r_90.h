/*
chain6r_90: equations of motion as straight-line code.
Written by alembert 0.1.0 from the description of the mechanism "chain6r_90". Do not edit: change the description.
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

#ifdef __cplusplus
extern "C" {
#endif

enum {
  chain6r_90_nq = 6,
  chain6r_90_nv = 6,
  chain6r_90_body_count = 6,
  chain6r_90_frame_count = 0,
  chain6r_90_output_count = 0,
  chain6r_90_force_count = 0,
  chain6r_90_parameter_count = 0,
  chain6r_90_input_count = 0,
  chain6r_90_state_count = 0,
  chain6r_90_wrench_count = 0,
  chain6r_90_nc = 0
};

/* Names, each list ended by NULL. */
extern const char* const chain6r_90_coordinate_names[6 + 1];
extern const char* const chain6r_90_speed_names[6 + 1];
extern const char* const chain6r_90_body_names[6 + 1];
extern const char* const chain6r_90_frame_names[0 + 1];
extern const char* const chain6r_90_output_names[0 + 1];
extern const char* const chain6r_90_force_names[0 + 1];
extern const char* const chain6r_90_parameter_names[0 + 1];
extern const char* const chain6r_90_wrench_body_names[0 + 1];
extern const char* const chain6r_90_constraint_names[0 + 1];

/* Names for indices: q[chain6r_90_coordinate_NAME], qd[chain6r_90_speed_NAME]. */
enum {
    chain6r_90_coordinate_q1 = 0, chain6r_90_coordinate_q2 = 1, chain6r_90_coordinate_q3 = 2,
    chain6r_90_coordinate_q4 = 3, chain6r_90_coordinate_q5 = 4, chain6r_90_coordinate_q6 = 5
};
enum {
    chain6r_90_speed_q1 = 0, chain6r_90_speed_q2 = 1, chain6r_90_speed_q3 = 2, chain6r_90_speed_q4 = 3,
    chain6r_90_speed_q5 = 4, chain6r_90_speed_q6 = 5
};
enum {
    chain6r_90_body_link1 = 0, chain6r_90_body_link2 = 1, chain6r_90_body_link3 = 2,
    chain6r_90_body_link4 = 3, chain6r_90_body_link5 = 4, chain6r_90_body_link6 = 5
};

/* 1 for each row of the constraints that is the rate of an equation in the coordinates alone, and a 0 after the last. */
extern const int chain6r_90_holonomic[0 + 1];

/* The initial state of the description: coordinates and speeds. */
extern const double chain6r_90_initial_coordinates[6];
extern const double chain6r_90_initial_speeds[6];
/* Values of the runtime parameters in the description, and a 0 after the last. */
extern const double chain6r_90_default_parameters[0 + 1];

/* Inverse dynamics: the generalized forces that give the speeds the rates qdd.
     tau = M(q) qdd + c(q, qd)
   tau [6]: generalized forces, N m for a speed in rad/s, N for one in m/s.
   Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
   Operations: 229 multiplications, 206 additions, 10 sin/cos/tan (reduced formulation; relative error 2.9e-16 where it was measured).
 */
int chain6r_90_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                const double* parameters, const double* wrenches, double* tau);

/* Mass matrix (joint-space inertia matrix), symmetric and in full.
     kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
   M [6 x 6], row by row: in units of tau / qdd.
   Operations: 110 multiplications, 101 additions, 10 sin/cos/tan (reduced formulation; relative error 2.5e-16 where it was measured).
 */
int chain6r_90_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M);

/* Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
     tau = M(q) qdd + c(q, qd)
   c [6]: bias forces, in units of tau.
   Operations: 212 multiplications, 177 additions, 10 sin/cos/tan (reduced formulation; relative error 3.1e-16 where it was measured).
 */
int chain6r_90_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                    double* c);

/* Mass matrix and bias forces at once: shorter than one after the other.
     tau = M(q) qdd + c(q, qd)
   M [6 x 6], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
   c [6]: bias forces, in units of tau.
   Operations: 322 multiplications, 278 additions, 10 sin/cos/tan (reduced formulation; relative error 3.1e-16 where it was measured).
 */
int chain6r_90_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                    const double* wrenches, double* M, double* c);

/* Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
     dq/dt = N(q) qd
   qdot [6]: per second.
   Operations: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
 */
int chain6r_90_coordinate_rates(const double* q, const double* qd, double* qdot);

/* Kinetic and potential energy.
     e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
   e [2]: kinetic and potential energy, J.
   Operations: 176 multiplications, 118 additions, 10 sin/cos/tan (reduced formulation; relative error 3e-15 where it was measured).
 */
int chain6r_90_energy(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                      double* e);

/* Poses of the bodies in the world.
   W [6 x 3 x 4], row by row: for each body of chain6r_90_body_names the matrix [R p]: the columns of R are the
     body's axes, p is its origin, m.
   Operations: 56 multiplications, 25 additions, 12 sin/cos/tan (reduced formulation; relative error 2.3e-16 where it was measured).
 */
int chain6r_90_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W);

#ifdef __cplusplus
}
#endif
