// States at which oracles are asked, and what they answer.
#pragma once

#include <Eigen/Core>
#include <map>
#include <random>
#include <string>

#include "oracles/description/description.hpp"

namespace alembert::oracles {

using Wrench = std::array<double, 6>;  ///< world force at the centre of mass, world torque

struct State {
  std::vector<double> q;              ///< nq; quaternions in the order x y z w, of length 1
  std::vector<double> speeds, rates;  ///< nv
  double time = 0;
  std::map<std::string, double> parameters = {};           ///< runtime parameters
  std::map<std::string, Wrench> wrenches = {};             ///< by body, of those with external_wrench
  std::map<std::string, double> inputs = {}, states = {};  ///< others have their initial values
};

template <class R>
using VectorOf = Eigen::Matrix<R, Eigen::Dynamic, 1>;
template <class R>
using MatrixOf = Eigen::Matrix<R, Eigen::Dynamic, Eigen::Dynamic>;

/// M(q) rates + c(q, speeds, t) = tau.
template <class R>
struct DynamicsOf {
  VectorOf<R> tau;
  MatrixOf<R> mass_matrix;
  VectorOf<R> bias;
};
using Dynamics = DynamicsOf<double>;

/// A random state: coordinates within their limits (or 1.5 about their initial value), speeds and rates
/// within 2, time within 2 s, wrenches within 5 N and 5 N m, inputs and states within their limits (or 1 about their
/// initial value).
State random_state(const Description& description, std::mt19937_64& random);

/// For each runtime parameter a value up to a tenth off its default.
std::map<std::string, double> random_parameters(const Description& description, std::uint64_t seed);

/// The rate of q: N(q) u for real coordinates and quaternions.
template <class R>
std::vector<R> coordinate_rates(const Description& description, const std::vector<R>& q,
                                const std::vector<R>& speeds);

/// max |a - b| / max(1, max |b|); infinite if a shape differs or an entry is no number.
double relative_error(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace alembert::oracles
