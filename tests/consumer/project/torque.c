/* The same torque in C. */
#include <arm/arm.h>
#include <stdio.h>

int main(void) {
  const double q[arm_nq] = {0.3, -0.7}, qd[arm_nv] = {0.5, 0.2}, qdd[arm_nv] = {1.0, -2.0};
  double tau[arm_nv];
  if (arm_inverse_dynamics(q, qd, qdd, 0.0, NULL, NULL, tau) != 0) return 1;
  if (arm_inverse_dynamics(q, qd, NULL, 0.0, NULL, NULL, tau) == 0) return 1;
  printf("torque %.6f %.6f\n", tau[arm_speed_shoulder], tau[arm_speed_elbow]);
  return 0;
}
