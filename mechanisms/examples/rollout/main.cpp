// Which controller balances a pole on a cart? Two thousand of them, with gains drawn at random, try it at once for ten
// seconds. A motion is stopped when its pole or its cart goes too far.
#include <alembert/rollout_packs.hpp>
#include <array>
#include <cart_pole/cart_pole.hpp>
#include <cart_pole/cart_pole_batch.hpp>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

namespace cart_pole = alembert::mechanisms::cart_pole;
using Cart = cart_pole::Mechanism<>;
constexpr std::size_t kCount = 2000;

int main() {
  std::mt19937 random(1);
  const auto number = [&](double most) { return most * static_cast<double>(random()) / 4294967296.0; };
  std::vector<std::array<double, 4>> gains(kCount);  // of x, the pole's angle, and their rates
  for (auto& k : gains) k = {number(20), number(200), number(20), number(40)};
  std::vector<double> q(2 * kCount, 0.0), qd(2 * kCount, 0.0), end_q(2 * kCount), end_qd(2 * kCount);
  for (std::size_t s = 0; s < kCount; ++s) q[2 * s + 1] = 0.2;  // rad from upright

  alembert::Rollout<double> way;
  way.count = kCount;
  way.steps = 10000;
  way.h = 1e-3;
  way.hold = 10;  // controllers run at 100 Hz
  way.threads = 0;
  way.q = q.data();
  way.qd = qd.data();
  std::vector<std::int64_t> steps(kCount);
  alembert::RolloutResults<double> out;
  out.q = end_q.data();
  out.qd = end_qd.data();
  out.steps = steps.data();
  const auto control = [&](const alembert::RolloutMoment<double>& at) {
    for (std::size_t s = 0; s < at.count; ++s) {
      const double *x = at.q + 2 * s, *v = at.qd + 2 * s;
      const auto& k = gains[s];
      at.controls[2 * s] = k[0] * x[0] + k[1] * x[1] + k[2] * v[0] + k[3] * v[1];  // N, on the cart
    }
  };
  const auto lost = [](std::size_t, double, const double* x, const double*) {
    return std::abs(x[0]) > 2 || std::abs(x[1]) > 0.8;
  };
  const alembert::PackedDynamics packed(cart_pole::forward_dynamics_batch);
  if (alembert::rollout_in_packs<Cart>(way, out, packed, control, lost) != 0) return 1;

  std::size_t left = 0, best = kCount;
  const auto rest = [&](std::size_t s) {
    return std::hypot(end_q[2 * s], end_q[2 * s + 1]) + std::hypot(end_qd[2 * s], end_qd[2 * s + 1]);
  };
  for (std::size_t s = 0; s < kCount; ++s) {
    if (steps[s] < way.steps) continue;
    ++left;
    if (best == kCount || rest(s) < rest(best)) best = s;
  }
  if (best == kCount) return 1;
  std::printf(
      "%zu of %zu controllers balance; the best, of gains %.1f %.1f %.1f %.1f, comes to rest to %.1e\n", left,
      kCount, gains[best][0], gains[best][1], gains[best][2], gains[best][3], rest(best));
  return left > 20 && left < kCount && rest(best) < 1e-6 ? 0 : 1;
}
