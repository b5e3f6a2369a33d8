/*
stanford: equations of motion as straight-line code.
Written by alembert 0.1.0 from the description of the mechanism "stanford". Do not edit: change the description.
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
  stanford_nq = 6,
  stanford_nv = 6,
  stanford_body_count = 6,
  stanford_frame_count = 0,
  stanford_output_count = 0,
  stanford_force_count = 0,
  stanford_parameter_count = 0,
  stanford_input_count = 0,
  stanford_state_count = 0,
  stanford_wrench_count = 0,
  stanford_nc = 0
};

/* Names, each list ended by NULL. */
extern const char* const stanford_coordinate_names[6 + 1];
extern const char* const stanford_speed_names[6 + 1];
extern const char* const stanford_body_names[6 + 1];
extern const char* const stanford_frame_names[0 + 1];
extern const char* const stanford_output_names[0 + 1];
extern const char* const stanford_force_names[0 + 1];
extern const char* const stanford_parameter_names[0 + 1];
extern const char* const stanford_wrench_body_names[0 + 1];
extern const char* const stanford_constraint_names[0 + 1];

/* Names for indices: q[stanford_coordinate_NAME], qd[stanford_speed_NAME]. */
enum {
    stanford_coordinate_q1 = 0, stanford_coordinate_q2 = 1, stanford_coordinate_q3 = 2,
    stanford_coordinate_q4 = 3, stanford_coordinate_q5 = 4, stanford_coordinate_q6 = 5
};
enum {
    stanford_speed_q1 = 0, stanford_speed_q2 = 1, stanford_speed_q3 = 2, stanford_speed_q4 = 3,
    stanford_speed_q5 = 4, stanford_speed_q6 = 5
};
enum {
    stanford_body_link1 = 0, stanford_body_link2 = 1, stanford_body_link3 = 2, stanford_body_link4 = 3,
    stanford_body_link5 = 4, stanford_body_link6 = 5
};

/* 1 for each row of the constraints that is the rate of an equation in the coordinates alone, and a 0 after the last. */
extern const int stanford_holonomic[0 + 1];

/* The initial state of the description: coordinates and speeds. */
extern const double stanford_initial_coordinates[6];
extern const double stanford_initial_speeds[6];
/* Values of the runtime parameters in the description, and a 0 after the last. */
extern const double stanford_default_parameters[0 + 1];

/* Inverse dynamics: the generalized forces that give the speeds the rates qdd.
     tau = M(q) qdd + c(q, qd)
   tau [6]: generalized forces, N m for a speed in rad/s, N for one in m/s.
   Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
   Operations: 135 multiplications, 104 additions, 8 sin/cos/tan (reduced formulation; relative error 2.3e-16 where it was measured).
 */
int stanford_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                              const double* parameters, const double* wrenches, double* tau);

/* Mass matrix (joint-space inertia matrix), symmetric and in full.
     kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
   M [6 x 6], row by row: in units of tau / qdd.
   Operations: 50 multiplications, 37 additions, 6 sin/cos/tan (reduced formulation; relative error 2.7e-16 where it was measured).
 */
int stanford_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M);

/* Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
     tau = M(q) qdd + c(q, qd)
   c [6]: bias forces, in units of tau.
   Operations: 126 multiplications, 89 additions, 8 sin/cos/tan (reduced formulation; relative error 2.2e-16 where it was measured).
 */
int stanford_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                  double* c);

/* Mass matrix and bias forces at once: shorter than one after the other.
     tau = M(q) qdd + c(q, qd)
   M [6 x 6], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
   c [6]: bias forces, in units of tau.
   Operations: 176 multiplications, 125 additions, 8 sin/cos/tan (reduced formulation; relative error 2.7e-16 where it was measured).
 */
int stanford_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                  const double* wrenches, double* M, double* c);

/* Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
     dq/dt = N(q) qd
   qdot [6]: per second.
   Operations: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
 */
int stanford_coordinate_rates(const double* q, const double* qd, double* qdot);

/* Kinetic and potential energy.
     e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
   e [2]: kinetic and potential energy, J.
   Operations: 88 multiplications, 56 additions, 8 sin/cos/tan (reduced formulation; relative error 2.6e-16 where it was measured).
 */
int stanford_energy(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                    double* e);

/* Poses of the bodies in the world.
   W [6 x 3 x 4], row by row: for each body of stanford_body_names the matrix [R p]: the columns of R are the
     body's axes, p is its origin, m.
   Operations: 43 multiplications, 19 additions, 10 sin/cos/tan (reduced formulation; relative error 2e-16 where it was measured).
 */
int stanford_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W);

#ifdef __cplusplus
}
#endif
