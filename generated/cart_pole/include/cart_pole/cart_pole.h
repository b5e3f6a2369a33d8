/*
cart_pole: equations of motion as straight-line code.
Written by alembert 0.1.0 from the description of the mechanism "cart_pole". Do not edit: change the description.
Generated output belongs to its user, who may use it, change it and pass it on without restriction. No warranty.

The interface for C and for whatever can call C. Every function is re-entrant, takes no memory from the heap, and
returns 0, or 1 if an array that it needs is NULL, having written nothing then.

Arguments; arrays must not overlap:

  q           [2] coordinates: x, q
  qd          [2] speeds: d(x), d(q)
  qdd         [2] rates of the speeds
  tau         [2] generalized forces: N m for a speed in rad/s, N for one in m/s
  t           time, s
  parameters  NULL: there are no runtime parameters
  wrenches    [1 x 6] per body of cart_pole_wrench_body_names the force x y z at its centre of mass, N, and the torque
              x y z, N m, both in world axes; NULL for none

Angles are in rad and lengths in m.
*/
#pragma once

#ifdef __cplusplus
extern "C" {
#endif

enum {
  cart_pole_nq = 2,
  cart_pole_nv = 2,
  cart_pole_body_count = 2,
  cart_pole_frame_count = 0,
  cart_pole_output_count = 0,
  cart_pole_force_count = 0,
  cart_pole_parameter_count = 0,
  cart_pole_input_count = 0,
  cart_pole_state_count = 0,
  cart_pole_wrench_count = 1,
  cart_pole_nc = 0
};

/* Names, each list ended by NULL. */
extern const char* const cart_pole_coordinate_names[2 + 1];
extern const char* const cart_pole_speed_names[2 + 1];
extern const char* const cart_pole_body_names[2 + 1];
extern const char* const cart_pole_frame_names[0 + 1];
extern const char* const cart_pole_output_names[0 + 1];
extern const char* const cart_pole_force_names[0 + 1];
extern const char* const cart_pole_parameter_names[0 + 1];
extern const char* const cart_pole_wrench_body_names[1 + 1];
extern const char* const cart_pole_constraint_names[0 + 1];

/* Names for indices: q[cart_pole_coordinate_NAME], qd[cart_pole_speed_NAME]. Wrenches begin at 6 *
   cart_pole_wrench_NAME. */
enum { cart_pole_coordinate_x = 0, cart_pole_coordinate_q = 1 };
enum { cart_pole_speed_x = 0, cart_pole_speed_q = 1 };
enum { cart_pole_body_cart = 0, cart_pole_body_pole = 1 };
enum { cart_pole_wrench_cart = 0 };

/* 1 for each row of the constraints that is the rate of an equation in the coordinates alone, and a 0 after the last. */
extern const int cart_pole_holonomic[0 + 1];

/* The initial state of the description: coordinates and speeds. */
extern const double cart_pole_initial_coordinates[2];
extern const double cart_pole_initial_speeds[2];
/* Values of the runtime parameters in the description, and a 0 after the last. */
extern const double cart_pole_default_parameters[0 + 1];

/* Inverse dynamics: the generalized forces that give the speeds the rates qdd.
     tau = M(q) qdd + c(q, qd)
   tau [2]: generalized forces, N m for a speed in rad/s, N for one in m/s.
   Source: Guenter and Lee, Symbolic Lagrangian Multibody Dynamics, eq. 13.
   Operations: 9 multiplications, 5 additions, 2 sin/cos/tan (reduced formulation; relative error 2e-16 where it was measured).
 */
int cart_pole_inverse_dynamics(const double* q, const double* qd, const double* qdd, double t,
                               const double* parameters, const double* wrenches, double* tau);

/* Mass matrix (joint-space inertia matrix), symmetric and in full.
     kinetic energy = 1/2 qd^T M(q) qd, where no motion is prescribed in time
   M [2 x 2], row by row: in units of tau / qdd.
   Operations: 1 multiplication, 0 additions, 1 sin/cos/tan (reduced formulation; relative error 9e-17 where it was measured).
 */
int cart_pole_mass_matrix(const double* q, double t, const double* parameters, const double* wrenches, double* M);

/* Bias forces: Coriolis, centrifugal and gravity terms, less external wrenches and other forces.
     tau = M(q) qdd + c(q, qd)
   c [2]: bias forces, in units of tau.
   Operations: 4 multiplications, 1 addition, 1 sin/cos/tan (reduced formulation; relative error 9.9e-17 where it was measured).
 */
int cart_pole_bias(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                   double* c);

/* Mass matrix and bias forces at once: shorter than one after the other.
     tau = M(q) qdd + c(q, qd)
   M [2 x 2], row by row: mass matrix, symmetric and in full, in units of tau / qdd.
   c [2]: bias forces, in units of tau.
   Operations: 5 multiplications, 1 addition, 2 sin/cos/tan (reduced formulation; relative error 9.9e-17 where it was measured).
 */
int cart_pole_mass_matrix_and_bias(const double* q, const double* qd, double t, const double* parameters,
                                   const double* wrenches, double* M, double* c);

/* Rates of the coordinates: the speeds, but for a quaternion p half of p (w, 0), with w in the axes of its body.
     dq/dt = N(q) qd
   qdot [2]: per second.
   Operations: 0 multiplications, 0 additions (reduced formulation; relative error 0 where it was measured).
 */
int cart_pole_coordinate_rates(const double* q, const double* qd, double* qdot);

/* Kinetic and potential energy.
     e[0] = 1/2 sum (m |v|^2 + w^T J w), e[1] = -sum m g^T r, zero at the world's origin
   e [2]: kinetic and potential energy, J.
   Operations: 7 multiplications, 2 additions, 1 sin/cos/tan (reduced formulation; relative error 2.3e-16 where it was measured).
 */
int cart_pole_energy(const double* q, const double* qd, double t, const double* parameters, const double* wrenches,
                     double* e);

/* Poses of the bodies in the world.
   W [2 x 3 x 4], row by row: for each body of cart_pole_body_names the matrix [R p]: the columns of R are the
     body's axes, p is its origin, m.
   Operations: 0 multiplications, 0 additions, 2 sin/cos/tan (reduced formulation; relative error 5e-17 where it was measured).
 */
int cart_pole_body_poses(const double* q, double t, const double* parameters, const double* wrenches, double* W);

#ifdef __cplusplus
}
#endif
