/* A robot whose root moves freely: potential energy grows with its height by its weight. */
#include <arm/arm.h>
#include <stdio.h>

int main(void) {
  double q[arm_nq] = {0}, low[2], high[2];
  const double qd[arm_nv] = {0};
  q[6] = 1.0;
  if (arm_energy(q, qd, 0.0, NULL, NULL, low) != 0) return 1;
  q[2] = 1.0;
  if (arm_energy(q, qd, 0.0, NULL, NULL, high) != 0) return 1;
  printf("weight %.3f\n", high[1] - low[1]);
  return 0;
}
