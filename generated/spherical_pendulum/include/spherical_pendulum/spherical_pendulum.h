/*
spherical_pendulum: equations of motion as straight-line code.
Written by alembert 0.1.0 from the description of the mechanism "spherical_pendulum". Do not edit: change the description.
Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.

The interface for C and for whatever can call C. Every function is re-entrant, takes no memory from the heap, and
returns 0, or 1 if an array that it needs is NULL, having written nothing then.

Arguments; arrays must not overlap:

  q           [4] coordinates: turn.x, turn.y, turn.z, turn.w
  qd          [3] speeds: d(turn).x, d(turn).y, d(turn).z
  qdd         [3] rates of the speeds
  tau         [3] generalized forces: N m for a speed in rad/s, N for one in m/s
  t           time, s
  parameters  NULL: there are no runtime parameters
  wrenches    [1 x 6] per body of spherical_pendulum_wrench_body_names the force x y z at its centre of mass, N, and the torque
              x y z, N m, both in world axes; NULL for none

Angles are in rad and lengths in m.
*/
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

enum {
  spherical_pendulum_nq = 4,
  spherical_pendulum_nv = 3,
  spherical_pendulum_body_count = 1,
  spherical_pendulum_frame_count = 0,
  spherical_pendulum_output_count = 0,
  spherical_pendulum_force_count = 0,
  spherical_pendulum_parameter_count = 0,
  spherical_pendulum_input_count = 0,
  spherical_pendulum_state_count = 0,
  spherical_pendulum_wrench_count = 1,
  spherical_pendulum_nc = 0
};

/* Names, each list ended by NULL. */
extern const char* const spherical_pendulum_coordinate_names[4 + 1];
extern const char* const spherical_pendulum_speed_names[3 + 1];
extern const char* const spherical_pendulum_body_names[1 + 1];
extern const char* const spherical_pendulum_frame_names[0 + 1];
extern const char* const spherical_pendulum_output_names[0 + 1];
extern const char* const spherical_pendulum_force_names[0 + 1];
extern const char* const spherical_pendulum_parameter_names[0 + 1];
extern const char* const spherical_pendulum_wrench_body_names[1 + 1];
extern const char* const spherical_pendulum_constraint_names[0 + 1];

/* Names for indices: q[spherical_pendulum_coordinate_NAME], qd[spherical_pendulum_speed_NAME]. Of a
   quaternion that of its first entry. Wrenches begin at 6 * spherical_pendulum_wrench_NAME. */
enum { spherical_pendulum_coordinate_turn = 0 };
enum { spherical_pendulum_speed_turn = 0 };
enum { spherical_pendulum_body_bob = 0 };
enum { spherical_pendulum_wrench_bob = 0 };

/* 1 for each row of the constraints that is the rate of an equation in the coordinates alone, and a 0 after the last. */
extern const int spherical_pendulum_holonomic[0 + 1];

/* The initial state of the description: coordinates and speeds. */
extern const double spherical_pendulum_initial_coordinates[4];
extern const double spherical_pendulum_initial_speeds[3];
/* Values of the runtime parameters in the description, and a 0 after the last. */
extern const double spherical_pendulum_default_parameters[0 + 1];

/* Inverse dynamics: the generalized forces that give the speeds the rates qdd.
     tau = M(q) qdd + c(q, qd)
   tau [3]: generalized forces, N m for a speed in rad/s, N for one in m/s.
   Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
   Operations: 60 multiplications, 69 additions (reduced formulation; relative error 3.6e-16 where it was measured).
 */
int spherical_pendulum_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                                        const double* parameters, const double* wrenches, double* tau);

/* Mass matrix (joint-space inertia matrix), symmetric and in full.
     kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
   M [3 x 3], row by row: in units of tau / qdd.
   Operations: 0 multiplications, 0 additions (reduced formulation; relative error 7.6e-17 where it was measured).
 */
int spherical_pendulum_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches,
                                   double* M);

/* Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
     tau = M(q) qdd + c(q, qd)
   c [3]: bias forces, in units of tau.
   Operations: 57 multiplications, 60 additions (reduced formulation; relative error 1.5e-15 where it was measured).
 */
int spherical_pendulum_bias(const double* q, const double* qd, double t, const double* parameters,
                            const double* wrenches, double* c);

/* Mass matrix and bias forces at once: shorter than one after the other.
     tau = M(q) qdd + c(q, qd)
   M [3 x 3], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
   c [3]: bias forces, in units of tau.
   Operations: 57 multiplications, 60 additions (reduced formulation; relative error 1.5e-15 where it was measured).
 */
int spherical_pendulum_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                        const double* wrenches, double* M, double* c);

/* Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
     dq/dt = N(q) qd
   qdot [4]: per second.
   Operations: 15 multiplications, 8 additions (reduced formulation; relative error 1.7e-16 where it was measured).
 */
int spherical_pendulum_coordinate_rates(const double* q, const double* qd, double* qdot);

/* Kinetic and potential energy.
     e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
   e [2]: kinetic and potential energy, J.
   Operations: 23 multiplications, 15 additions (reduced formulation; relative error 4.7e-15 where it was measured).
 */
int spherical_pendulum_energy(const double* q, const double* qd, double t, const double* parameters,
                              const double* wrenches, double* e);

/* Poses of the bodies in the world.
   W [1 x 3 x 4], row by row: for each body of spherical_pendulum_body_names the matrix [R p]: the columns of R are
     the body's axes, p is its origin, m.
   Operations: 9 multiplications, 21 additions (reduced formulation; relative error 2e-16 where it was measured).
 */
int spherical_pendulum_body_poses(const double* q, double t, const double* parameters, const double* wrenches,
                                  double* W);

#ifdef __cplusplus
}
#endif
