// Random states and the measure of agreement (see the header).
#include "oracles/state.hpp"

#include <cmath>
#include <limits>

namespace alembert::oracles {

namespace {

/// Written out, because the standard leaves the algorithm of std::uniform_real_distribution open: a seed
/// means the same states with every compiler.
double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

}  // namespace

State random_state(const Description& description, std::mt19937_64& random) {
  State state;
  for (const Coordinate& c : description.coordinates) {
    if (c.quaternion) {
      std::array<double, 4> x{};
      double square = 0;
      while (square < 0.05 || square > 1) {
        square = 0;
        for (double& entry : x) {
          entry = uniform(random, -1, 1);
          square += entry * entry;
        }
      }
      for (const double entry : x) state.q.push_back(entry / std::sqrt(square));
    } else if (c.limits) {
      state.q.push_back(uniform(random, c.limits->first, c.limits->second));
    } else {
      state.q.push_back(uniform(random, c.initial[0] - 1.5, c.initial[0] + 1.5));
    }
  }
  for (int k = 0; k < description.nv; ++k) {
    state.speeds.push_back(uniform(random, -2, 2));
    state.rates.push_back(uniform(random, -2, 2));
  }
  state.time = uniform(random, 0, 2);
  for (const Body& body : description.bodies) {
    if (!body.external_wrench) continue;
    for (double& entry : state.wrenches[body.name]) entry = uniform(random, -5, 5);
  }
  state.parameters = description.runtime_parameters;
  const auto draw = [&](const auto& given) {
    const auto [low, high] = given.limits.value_or(std::pair(given.initial - 1, given.initial + 1));
    return uniform(random, low, high);
  };
  for (const Input& input : description.inputs) state.inputs[input.name] = draw(input);
  for (const Integrated& integrated : description.states) state.states[integrated.name] = draw(integrated);
  return state;
}

std::map<std::string, double> random_parameters(const Description& description, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::map<std::string, double> values = description.runtime_parameters;
  for (auto& [name, value] : values) value *= uniform(random, 0.9, 1.1);
  return values;
}

template <class R>
std::vector<R> coordinate_rates(const Description& description, const std::vector<R>& q,
                                const std::vector<R>& speeds) {
  std::vector<R> rates;
  for (const Coordinate& c : description.coordinates) {
    const R* u = &speeds[static_cast<std::size_t>(c.first_speed)];
    if (!c.quaternion) {
      rates.push_back(u[0]);
      continue;
    }
    // 1/2 q (u, 0), with q = (v, w) and the angular velocity u in the child's axes.
    const R* v = &q[static_cast<std::size_t>(c.first_q)];
    const R w = v[3], half(0.5);
    rates.push_back(half * (w * u[0] + v[1] * u[2] - v[2] * u[1]));
    rates.push_back(half * (w * u[1] + v[2] * u[0] - v[0] * u[2]));
    rates.push_back(half * (w * u[2] + v[0] * u[1] - v[1] * u[0]));
    rates.push_back(-(half * (v[0] * u[0] + v[1] * u[1] + v[2] * u[2])));
  }
  return rates;
}

#define ALEMBERT_RATES(R) \
  template std::vector<R> coordinate_rates(const Description&, const std::vector<R>&, const std::vector<R>&);
ALEMBERT_RATES(double)
ALEMBERT_RATES(long double)
ALEMBERT_RATES(Jet<double>)
ALEMBERT_RATES(Jet<long double>)
#undef ALEMBERT_RATES

double relative_error(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) return std::numeric_limits<double>::infinity();
  if (!a.allFinite() || !b.allFinite()) return std::numeric_limits<double>::infinity();
  if (a.size() == 0) return 0;
  return (a - b).cwiseAbs().maxCoeff() / std::max(1.0, b.cwiseAbs().maxCoeff());
}

}  // namespace alembert::oracles
