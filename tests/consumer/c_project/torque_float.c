/* The same torque in float. */
#include <arm/arm.h>
#include <stdio.h>

int main(void) {
  const float q[arm_nq] = {0.3f, -0.7f}, qd[arm_nv] = {0.5f, 0.2f}, qdd[arm_nv] = {1.0f, -2.0f};
  float tau[arm_nv];
  if (arm_inverse_dynamics(q, qd, qdd, 0.0f, NULL, NULL, tau) != 0) return 1;
  printf("torque %.4f %.4f\n", (double)tau[0], (double)tau[1]);
  return 0;
}
