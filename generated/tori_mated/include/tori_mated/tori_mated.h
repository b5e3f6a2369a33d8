/*
tori_mated: equations of motion as straight-line code.
Written by alembert 0.1.0 from the description of the mechanism "tori_mated". Do not edit: change the description.
Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.

The interface for C and for whatever can call C. Every function is re-entrant, takes no memory from the heap, and
returns 0, or 1 if an array that it needs is NULL, having written nothing then.

Arguments; arrays must not overlap:

  q           [5] coordinates: u1, v1, u2, v2, turn
  qd          [5] speeds: d(u1), d(v1), d(u2), d(v2), d(turn)
  qdd         [5] rates of the speeds
  tau         [5] generalized forces: N m for a speed in rad/s, N for one in m/s
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
  tori_mated_nq = 5,
  tori_mated_nv = 5,
  tori_mated_body_count = 1,
  tori_mated_frame_count = 0,
  tori_mated_output_count = 0,
  tori_mated_force_count = 0,
  tori_mated_parameter_count = 0,
  tori_mated_input_count = 0,
  tori_mated_state_count = 0,
  tori_mated_wrench_count = 0,
  tori_mated_nc = 0
};

/* Names, each list ended by NULL. */
extern const char* const tori_mated_coordinate_names[5 + 1];
extern const char* const tori_mated_speed_names[5 + 1];
extern const char* const tori_mated_body_names[1 + 1];
extern const char* const tori_mated_frame_names[0 + 1];
extern const char* const tori_mated_output_names[0 + 1];
extern const char* const tori_mated_force_names[0 + 1];
extern const char* const tori_mated_parameter_names[0 + 1];
extern const char* const tori_mated_wrench_body_names[0 + 1];
extern const char* const tori_mated_constraint_names[0 + 1];

/* Names for indices: q[tori_mated_coordinate_NAME], qd[tori_mated_speed_NAME]. */
enum {
    tori_mated_coordinate_u1 = 0, tori_mated_coordinate_v1 = 1, tori_mated_coordinate_u2 = 2,
    tori_mated_coordinate_v2 = 3, tori_mated_coordinate_turn = 4
};
enum {
    tori_mated_speed_u1 = 0, tori_mated_speed_v1 = 1, tori_mated_speed_u2 = 2, tori_mated_speed_v2 = 3,
    tori_mated_speed_turn = 4
};
enum { tori_mated_body_ring = 0 };

/* 1 for each row of the constraints that is the rate of an equation in the coordinates alone, and a 0 after the last. */
extern const int tori_mated_holonomic[0 + 1];

/* The initial state of the description: coordinates and speeds. */
extern const double tori_mated_initial_coordinates[5];
extern const double tori_mated_initial_speeds[5];
/* Values of the runtime parameters in the description, and a 0 after the last. */
extern const double tori_mated_default_parameters[0 + 1];

/* Inverse dynamics: the generalized forces that give the speeds the rates qdd.
     tau = M(q) qdd + c(q, qd)
   tau [5]: generalized forces, N m for a speed in rad/s, N for one in m/s.
   Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
   Operations: 128 multiplications, 96 additions, 8 sin/cos/tan (reduced formulation; relative error 4.5e-16 where it was measured).
 */
int tori_mated_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                const double* parameters, const double* wrenches, double* tau);

/* Mass matrix (joint-space inertia matrix), symmetric and in full.
     kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
   M [5 x 5], row by row: in units of tau / qdd.
   Operations: 74 multiplications, 67 additions, 8 sin/cos/tan (reduced formulation; relative error 1.1e-15 where it was measured).
 */
int tori_mated_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M);

/* Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
     tau = M(q) qdd + c(q, qd)
   c [5]: bias forces, in units of tau.
   Operations: 123 multiplications, 86 additions, 8 sin/cos/tan (reduced formulation; relative error 3.8e-16 where it was measured).
 */
int tori_mated_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                    double* c);

/* Mass matrix and bias forces at once: shorter than one after the other.
     tau = M(q) qdd + c(q, qd)
   M [5 x 5], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
   c [5]: bias forces, in units of tau.
   Operations: 197 multiplications, 153 additions, 8 sin/cos/tan (reduced formulation; relative error 1.1e-15 where it was measured).
 */
int tori_mated_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                    const double* wrenches, double* M, double* c);

/* Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
     dq/dt = N(q) qd
   qdot [5]: per second.
   Operations: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
 */
int tori_mated_coordinate_rates(const double* q, const double* qd, double* qdot);

/* Kinetic and potential energy.
     e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
   e [2]: kinetic and potential energy, J.
   Operations: 68 multiplications, 43 additions, 8 sin/cos/tan (reduced formulation; relative error 2.4e-15 where it was measured).
 */
int tori_mated_energy(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                      double* e);

/* Poses of the bodies in the world.
   W [1 x 3 x 4], row by row: for each body of tori_mated_body_names the matrix [R p]: the columns of R are the
     body's axes, p is its origin, m.
   Operations: 44 multiplications, 21 additions, 10 sin/cos/tan (reduced formulation; relative error 1.4e-16 where it was measured).
 */
int tori_mated_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W);

#ifdef __cplusplus
}
#endif
