// Second derivatives of forces by jets, and those by parameters (see the header).
#include "oracles/taylor/force_derivatives.hpp"

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "oracles/taylor/numeric_lagrangian.hpp"

namespace alembert::oracles {

namespace {

/// f as one number of a state moves: its derivatives along the way.
template <class R>
class WeightedForces {
 public:
  using T = Jet<R>;
  WeightedForces(const Description& description, const State& state)
      : description_(description),
        state_(state),
        fixed_(lifted<T>(state)),
        weights_(force_weights(description.nv)) {}

  /// Turned about axes of the bodies for all of s, so that it stays a motion to the second order.
  void move(StateOf<T>& state, const std::vector<R>& along) const {
    const StateOf<R> exact = lifted<R>(state_);
    const std::vector<R> rates = coordinate_rates(description_, exact.q, along);
    for (std::size_t i = 0; i < rates.size(); ++i) state.q[i] = T(exact.q[i], rates[i], R(0.0));
    std::size_t q = 0, speed = 0;
    for (const Coordinate& coordinate : description_.coordinates) {
      const std::size_t size = coordinate.quaternion ? 4 : 1, turns = coordinate.quaternion ? 3 : 1;
      R square(0.0);
      for (std::size_t k = 0; k < turns; ++k) square += along[speed + k] * along[speed + k];
      for (std::size_t i = 0; i < size && coordinate.quaternion; ++i)
        state.q[q + i].second = -square / R(4.0) * exact.q[q + i];
      q += size;
      speed += turns;
    }
  }
  std::vector<R> unit(std::size_t k) const {
    std::vector<R> v(weights_.size(), R(0.0));
    v[k] = R(1.0);
    return v;
  }
  T at(const StateOf<T>& state) const {
    const std::vector<T> forces = numeric_forces(description_, state, state_.wrenches);
    T sum(0.0);
    for (std::size_t k = 0; k < forces.size(); ++k) sum = sum + T(weights_[k]) * forces[k];
    return sum;
  }
  const StateOf<T>& fixed() const { return fixed_; }
  std::size_t size() const { return weights_.size(); }

 private:
  const Description& description_;
  const State& state_;
  StateOf<T> fixed_;
  std::vector<double> weights_;
};

/// A description with one runtime parameter changed. They are kept, since to read one takes longer than its forces do.
class Variants {
 public:
  explicit Variants(const Description& of) : text(of.text), parameters(of.runtime_parameters) {}
  const Description& with(const std::string& name, double value) {
    const auto [found, is_new] = read_.try_emplace({name, value});
    if (is_new) {
      std::map<std::string, double> values = parameters;
      values.at(name) = value;
      found->second = parse_description(text, values);
    }
    return found->second;
  }
  const std::string text;
  const std::map<std::string, double> parameters;

 private:
  std::map<std::pair<std::string, double>, Description> read_;
};

/// Those of the description that was asked for last: its states come one after another.
Variants& variants_of(const Description& description) {
  thread_local std::optional<Variants> last;
  if (!last || last->text != description.text || last->parameters != description.runtime_parameters)
    last.emplace(description);
  return *last;
}

}  // namespace

std::vector<double> force_weights(int nv) {
  std::vector<double> weights;
  for (int k = 0; k < nv; ++k) weights.push_back(std::cos(1.7 * k + 0.4) + (k % 2 == 0 ? 0.5 : -0.5));
  return weights;
}

template <class R>
std::map<std::string, Eigen::MatrixXd> second_derivatives_of_forces(const Description& description,
                                                                    const State& state) {
  using T = Jet<R>;
  const WeightedForces<R> f(description, state);
  const std::size_t n = f.size();
  const Eigen::Index nv = description.nv;
  MatrixOf<R> q_q(nv, nv), q_u(nv, nv), u_u(nv, nv), q_rates(nv, nv);
  std::vector<T> along, by_speed;
  std::vector<StateOf<T>> moved, faster;
  for (std::size_t k = 0; k < n; ++k) {
    moved.push_back(f.fixed());
    f.move(moved.back(), f.unit(k));
    faster.push_back(f.fixed());
    faster.back().speeds[k].first = R(1.0);
    along.push_back(f.at(moved.back()));
    by_speed.push_back(f.at(faster.back()));
  }
  for (std::size_t j = 0; j < n; ++j) {
    const auto row = static_cast<Eigen::Index>(j);
    for (std::size_t k = 0; k < n; ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      StateOf<T> both = moved[j];
      both.speeds[k].first = R(1.0);
      q_u(row, column) = (f.at(both).second - along[j].second - by_speed[k].second) / R(2.0);
      // Of rates the forces are linear.
      both = moved[j];
      both.rates[k] = both.rates[k] + T(1.0);
      q_rates(row, column) = f.at(both).first - along[j].first;
      if (k > j) continue;
      if (k == j) {
        q_q(row, row) = along[j].second;
        u_u(row, row) = by_speed[j].second;
        continue;
      }
      std::vector<R> two = f.unit(j);
      two[k] = R(1.0);
      both = f.fixed();
      f.move(both, two);
      q_q(row, column) = q_q(column, row) = (f.at(both).second - along[j].second - along[k].second) / R(2.0);
      both = faster[j];
      both.speeds[k].first = R(1.0);
      u_u(row, column) = u_u(column, row) =
          (f.at(both).second - by_speed[j].second - by_speed[k].second) / R(2.0);
    }
  }
  // The mean of both orders so far. Of turns about x and y the two differ by a turn about z, and so on around: entry
  // (j, k) is along k of what is along j.
  Eigen::Index speed = 0;
  for (const Coordinate& coordinate : description.coordinates) {
    for (Eigen::Index a = 0; a < 3 && coordinate.quaternion; ++a) {
      const Eigen::Index b = (a + 1) % 3, c = (a + 2) % 3;
      const R half = along[static_cast<std::size_t>(speed + c)].first / R(2.0);
      q_q(speed + b, speed + a) += half;
      q_q(speed + a, speed + b) -= half;
    }
    speed += coordinate.quaternion ? 3 : 1;
  }
  return {{"tau_qq", q_q.template cast<double>()},
          {"tau_qqd", q_u.template cast<double>()},
          {"tau_qdqd", u_u.template cast<double>()},
          {"tau_qqdd", q_rates.template cast<double>()}};
}

Eigen::MatrixXd parameter_derivatives_of_forces(const Description& description, const State& state) {
  using R = long double;
  Variants& variants = variants_of(description);
  Eigen::MatrixXd result(description.nv, static_cast<Eigen::Index>(description.runtime_parameters.size()));
  Eigen::Index column = 0;
  for (const auto& parameter : description.parameters) {
    const std::string& name = parameter.first;
    if (description.runtime_parameters.count(name) == 0) continue;
    const double value = description.runtime_parameters.at(name);
    const auto difference = [&](double step) -> VectorOf<R> {
      const double there = value + step, back = value - step;
      const VectorOf<R> tau = numeric_lagrangian<R>(variants.with(name, there), state).tau -
                              numeric_lagrangian<R>(variants.with(name, back), state).tau;
      return tau / (R(there) - R(back));
    };
    // Differences of steps h, h/2, h/4, h/8 are right to h^2; each round gains two orders. By how much the last one
    // changes what it began with tells rounding from them.
    const auto extrapolated = [&](double scale) {
      std::array<VectorOf<R>, 4> rows;
      for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i] = difference(std::ldexp(scale, -static_cast<int>(i)));
      VectorOf<R> before;
      for (std::size_t round = 1; round < rows.size(); ++round) {
        before = rows[0];
        for (std::size_t i = 0; i + round < rows.size(); ++i) {
          const R gain = std::pow(R(4.0), static_cast<int>(round));
          rows[i] = (gain * rows[i + 1] - rows[i]) / (gain - R(1.0));
        }
      }
      return std::pair(rows[0], R((rows[0] - before).cwiseAbs().maxCoeff()));
    };
    // A length may be far shorter than those of the mechanism, which have a say in how forces change with it; and a force may
    // jump nearby.
    auto best = extrapolated(value == 0 ? 1e-3 : 1e-2 * std::abs(value));
    for (const double scale : {1e-3, 1e-5, 1e-6}) {
      if (best.second <= R(1e-12) * best.first.cwiseAbs().maxCoeff()) break;
      if (const auto other = extrapolated(scale); other.second < best.second) best = other;
    }
    result.col(column++) = best.first.template cast<double>();
  }
  return result;
}

template std::map<std::string, Eigen::MatrixXd> second_derivatives_of_forces<double>(const Description&,
                                                                                     const State&);
template std::map<std::string, Eigen::MatrixXd> second_derivatives_of_forces<long double>(const Description&,
                                                                                          const State&);

}  // namespace alembert::oracles
