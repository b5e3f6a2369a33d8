// Times of the torus chains for the report: M and c, and the Cholesky solve. In: nothing. Out: JSON, for each
// chain the median nanoseconds of both at random states.
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <chrono>
#include <random>
#include <string>
#include <vector>

#include "alembert/forward_dynamics.hpp"
#include "chains.hpp"

namespace {

constexpr int kStates = 16;
constexpr int kRounds = 201;

template <class Work>
double median_nanoseconds(int repeat, Work&& work) {
  std::vector<double> times;
  for (int round = 0; round < kRounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < repeat; ++i) work(i % kStates);
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
    times.push_back(spent.count() / repeat);
  }
  std::nth_element(times.begin(), times.begin() + kRounds / 2, times.end());
  return times[kRounds / 2];
}

template <class M>
std::string measured() {
  using alembert::CoordinateVector, alembert::SpeedMatrix, alembert::SpeedVector;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<CoordinateVector<M>> q(kStates);
  std::vector<SpeedVector<M>> qd(kStates);
  for (auto& x : q) x = x.unaryExpr([&](double) { return uniform(random); });
  for (auto& x : qd) x = x.unaryExpr([&](double) { return uniform(random); });
  const typename M::Inputs in;
  std::vector<SpeedMatrix<M>> mass(kStates);
  std::vector<SpeedVector<M>> bias(kStates);
  const auto evaluate = [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    M::mass_matrix_and_bias(q[k], qd[k], in, mass[k], bias[k]);
  };
  for (int i = 0; i < kStates; ++i) evaluate(i);
  double sink = 0;
  const auto solve = [&](int i) {
    const auto k = static_cast<std::size_t>(i);
    SpeedMatrix<M> factor = mass[k];
    SpeedVector<M> x = -bias[k];
    if (alembert::factor_ldlt(factor) == alembert::Status::ok) alembert::solve_ldlt(factor, x);
    sink += x(0);
  };
  const double equations = median_nanoseconds(kStates, evaluate);
  const double cholesky = median_nanoseconds(kStates, solve);
  return fmt::format(R"({{"coordinates": {}, "equations": {:.1f}, "solve": {:.1f}, "checksum": {:.17g}}})",
                     M::kNq, equations, cholesky, sink);
}

template <class... M>
void print_all() {
  std::string text;
  const auto one = [&](const std::string& line) { text += (text.empty() ? "" : ",\n ") + line; };
  (one(measured<M>()), ...);
  fmt::print("[{}]\n", text);
}

}  // namespace

int main() {
  print_all<ALEMBERT_CHAINS>();
  return 0;
}
