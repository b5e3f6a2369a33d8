/* One pendulum in three formats: the torque is 0.8 qdd + 9.81 sin q. */
#include <math.h>
#include <mjcf_swing/mjcf_swing.h>
#include <osim_swing/osim_swing.h>
#include <sdf_swing/sdf_swing.h>
#include <stdio.h>

int main(void) {
  const double q[1] = {0.7}, qd[1] = {-1.3}, qdd[1] = {2.1}, expected = 0.8 * qdd[0] + 9.81 * sin(q[0]);
  double tau[3];
  if (mjcf_swing_inverse_dynamics(q, qd, qdd, 0.0, NULL, NULL, &tau[mjcf_swing_speed_swing]) != 0) return 1;
  if (sdf_swing_inverse_dynamics(q, qd, qdd, 0.0, NULL, NULL, &tau[1 + sdf_swing_speed_swing]) != 0) return 1;
  if (osim_swing_inverse_dynamics(q, qd, qdd, 0.0, NULL, NULL, &tau[2 + osim_swing_speed_swing]) != 0) return 1;
  for (int k = 0; k < 3; ++k) {
    if (!(fabs(tau[k] - expected) < 1e-12)) {
      printf("format %d: torque %.17g, expected %.17g\n", k, tau[k], expected);
      return 1;
    }
  }
  return 0;
}
