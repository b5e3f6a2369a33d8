// Model predictive control of a pole on a cart. Each 20 ms the controller predicts one second, linearizes the
// dynamics along the prediction, solves for the best correction (a Riccati recursion) and applies the first
// force.
#include <alembert/integrate.hpp>
#include <alembert/linearize.hpp>
#include <array>
#include <cart_pole/cart_pole.hpp>
#include <cmath>
#include <cstdio>

using CartPole = alembert::mechanisms::cart_pole::Mechanism<>;
using State = Eigen::Vector4d;  // x, angle, and their rates
constexpr int kHorizon = 50;
constexpr double kStep = 0.02;         // s
const State kWeights(10, 100, 1, 1);   // of the state
constexpr double kForceWeight = 0.01;  // of the force on the cart
std::array<double, kHorizon> plan{};   // forces, N

/// The state one step on, and if asked for its derivatives by the state (A) and the force (B).
bool step(const State& s, double force, State& next, Eigen::Matrix4d* A = nullptr, State* B = nullptr) {
  const CartPole::SpeedVector tau(force, 0);
  alembert::Linearization<CartPole> line;
  if (alembert::linearize<CartPole>(s.head<2>(), s.tail<2>(), tau, {}, line) != alembert::Status::ok)
    return false;
  next.tail<2>() = s.tail<2>() + kStep * line.qdd;
  next.head<2>() = s.head<2>() + kStep * next.tail<2>();
  if (A != nullptr) {
    A->setIdentity();
    A->bottomLeftCorner<2, 2>() = kStep * line.qdd_q;
    A->bottomRightCorner<2, 2>() += kStep * line.qdd_qd;
    A->topRows<2>() += kStep * A->bottomRows<2>();
    B->tail<2>() = kStep * line.qdd_tau.col(0);
    B->head<2>() = kStep * B->tail<2>();
  }
  return true;
}

/// Improves the plan from state s on by one Gauss-Newton step; returns the first force.
double improve(const State& s, bool& ok) {
  std::array<State, kHorizon + 1> path{s};
  std::array<Eigen::Matrix4d, kHorizon> A;
  std::array<State, kHorizon> B, gain;
  std::array<double, kHorizon> change{};
  for (int k = 0; k < kHorizon; ++k) ok = ok && step(path[k], plan[k], path[k + 1], &A[k], &B[k]);
  Eigen::Matrix4d V = 10 * Eigen::Matrix4d(kWeights.asDiagonal());
  State v = V * path[kHorizon];
  for (int k = kHorizon - 1; k >= 0; --k) {
    const double curvature = kForceWeight + B[k].dot(V * B[k]);
    gain[k] = A[k].transpose() * (V * B[k]) / curvature;
    change[k] = (kForceWeight * plan[k] + B[k].dot(v)) / curvature;
    const Eigen::Matrix4d closed = A[k] - B[k] * gain[k].transpose();
    v = kWeights.cwiseProduct(path[k]) + A[k].transpose() * v - gain[k] * curvature * change[k];
    V = Eigen::Matrix4d(kWeights.asDiagonal()) + A[k].transpose() * V * closed;
  }
  State now = s, next;
  for (int k = 0; k < kHorizon; ++k, now = next) {
    plan[k] -= change[k] + gain[k].dot(now - path[k]);
    ok = ok && step(now, plan[k], next);
  }
  return plan[0];
}

int main() {
  State s(0, 0.9, 0, 0);  // the pole leans by 0.9 rad
  bool ok = true;
  std::printf("time   cart    pole   force\n");
  for (int k = 0; k <= 300 && ok; ++k) {
    const double force = improve(s, ok);
    if (k % 50 == 0) std::printf("%4.2f %6.3f %7.4f %7.2f\n", k * kStep, s(0), s(1), force);
    State next;
    ok = ok && step(s, force, next);
    s = next;
  }
  return ok && s.norm() < 0.05 ? 0 : 1;
}
