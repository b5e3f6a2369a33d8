// Derivatives along the speeds (see the header).
#include "dynamics/tree/speed_derivatives.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "differentiation/jacobian.hpp"
#include "symbolic/postorder.hpp"
#include "symbolic/simplify.hpp"

namespace alembert {

std::array<Expr, 4> quaternion_rate_column(std::span<const Expr> q, int speed) {
  const Expr x = q[0], y = q[1], z = q[2], w = q[3];
  const Expr half = x.graph().rational(Rational(1, 2));
  switch (speed) {
    case 0:
      return {half * w, half * z, -(half * y), -(half * x)};
    case 1:
      return {-(half * z), half * w, half * x, -(half * y)};
    default:
      return {half * y, -(half * x), half * w, -(half * z)};
  }
}

SpeedDerivatives::SpeedDerivatives(const Mechanism& mechanism, ExprGraph& graph)
    : mechanism_(mechanism), graph_(graph), time_index_(mechanism.nv) {
  for (std::size_t i = 0; i < mechanism.coordinates.size(); ++i) {
    const Coordinate& coordinate = mechanism.coordinates[i];
    for (int a = 0; a < coordinate.nq(); ++a) {
      variables_.push_back({coordinate.symbols[static_cast<std::size_t>(a)], static_cast<int>(i), a});
    }
    speeds_.insert(speeds_.end(), coordinate.speed_symbols.begin(), coordinate.speed_symbols.end());
    rates_.insert(rates_.end(), coordinate.rate_symbols.begin(), coordinate.rate_symbols.end());
  }
  variables_.push_back({mechanism.time, -1, 0});
  speeds_.push_back(graph.one());
  rates_.push_back(graph.zero());
  for (std::size_t v = 0; v < variables_.size(); ++v) {
    const std::uint32_t index = graph.symbol_index(variables_[v].symbol.ref().node());
    if (variable_of_symbol_.size() <= index) variable_of_symbol_.resize(index + 1, -1);
    variable_of_symbol_[index] = static_cast<int>(v);
  }
}

Expr SpeedDerivatives::speed(int index) const {
  return speeds_[static_cast<std::size_t>(index)];
}
Expr SpeedDerivatives::rate(int index) const {
  return rates_[static_cast<std::size_t>(index)];
}

bool SpeedDerivatives::moves(std::span<const Expr> functions) const {
  return !variables_in(functions).empty();
}

std::vector<int> SpeedDerivatives::variables_in(std::span<const Expr> functions) const {
  std::vector<int> present;
  for (const std::uint32_t id : postorder(functions)) {
    if (graph_.node(id).op != Operation::symbol) continue;
    const std::uint32_t index = graph_.symbol_index(id);
    if (index < variable_of_symbol_.size() && variable_of_symbol_[index] >= 0) {
      present.push_back(variable_of_symbol_[index]);
    }
  }
  std::sort(present.begin(), present.end());
  return present;
}

std::vector<SpeedPartial> SpeedDerivatives::partials(std::span<const Expr> functions) const {
  std::vector<std::uint32_t> key;
  for (const Expr function : functions) key.push_back(function.ref().bits);
  const auto at = known_.find(key);
  if (at != known_.end()) return at->second;
  return known_.emplace(std::move(key), derived(functions)).first->second;
}

std::vector<SpeedPartial> SpeedDerivatives::derived(std::span<const Expr> functions) const {
  const std::vector<int> present = variables_in(functions);
  if (present.empty()) return {};

  std::vector<Expr> symbols;
  for (const int v : present) symbols.push_back(variables_[static_cast<std::size_t>(v)].symbol);
  const Jacobian jacobian = alembert::jacobian(functions, symbols);

  if (jacobian.d_star_gave_up) ++d_star_gave_up_;

  const std::size_t count = functions.size();
  std::map<int, std::vector<Expr>> by_speed;
  for (std::size_t j = 0; j < present.size(); ++j) {
    const Variable& variable = variables_[static_cast<std::size_t>(present[j])];
    const auto accumulate = [&](int speed, Expr weight) {
      std::vector<Expr>& sums = by_speed.try_emplace(speed, count, graph_.zero()).first->second;
      for (std::size_t i = 0; i < count; ++i) sums[i] += weight * jacobian(i, j);
    };
    if (variable.coordinate < 0) {
      accumulate(time_index_, graph_.one());
      continue;
    }
    const Coordinate& coordinate = mechanism_.coordinates[static_cast<std::size_t>(variable.coordinate)];
    if (coordinate.type == CoordinateType::real) {
      accumulate(coordinate.first_speed, graph_.one());
    } else {
      for (int k = 0; k < 3; ++k) {
        const std::array<Expr, 4> column = quaternion_rate_column(coordinate.symbols, k);
        accumulate(coordinate.first_speed + k, column[static_cast<std::size_t>(variable.component)]);
      }
    }
  }

  std::vector<Expr> flat;
  for (const auto& [speed, values] : by_speed) flat.insert(flat.end(), values.begin(), values.end());
  flat = simplify(flat);
  std::vector<SpeedPartial> result;
  std::size_t offset = 0;
  for (const auto& [speed, values] : by_speed) {
    SpeedPartial partial{speed,
                         {flat.begin() + static_cast<std::ptrdiff_t>(offset),
                          flat.begin() + static_cast<std::ptrdiff_t>(offset + count)}};
    offset += count;
    const bool any =
        std::any_of(partial.values.begin(), partial.values.end(), [](Expr e) { return !e.is_zero(); });
    if (any) result.push_back(std::move(partial));
  }
  return result;
}

std::vector<Expr> SpeedDerivatives::first_rate(std::span<const SpeedPartial> partials,
                                               std::size_t count) const {
  std::vector<Expr> sums(count, graph_.zero());
  for (const SpeedPartial& partial : partials) {
    for (std::size_t i = 0; i < count; ++i) sums[i] += partial.values[i] * speed(partial.speed);
  }
  return sums;
}

std::vector<Expr> SpeedDerivatives::second_rate(std::span<const SpeedPartial> partials,
                                                std::size_t count) const {
  std::vector<Expr> result(count, graph_.zero());
  for (const SpeedPartial& partial : partials) {
    for (std::size_t i = 0; i < count; ++i) result[i] += partial.values[i] * rate(partial.speed);
  }
  add_quadratic_rate(partials, result);
  return result;
}

std::vector<Expr> SpeedDerivatives::quadratic_rate(std::span<const SpeedPartial> partials,
                                                   std::size_t count) const {
  std::vector<Expr> result(count, graph_.zero());
  add_quadratic_rate(partials, result);
  return result;
}

void SpeedDerivatives::add_quadratic_rate(std::span<const SpeedPartial> partials,
                                          std::vector<Expr>& result) const {
  const std::size_t count = result.size();
  std::vector<Expr> flat;
  for (const SpeedPartial& partial : partials)
    flat.insert(flat.end(), partial.values.begin(), partial.values.end());
  const std::vector<SpeedPartial> second = this->partials(flat);

  // The products u_k u_l are symmetric though D_l D_k need not be: one coefficient for each unordered pair.
  std::map<std::pair<int, int>, std::vector<Expr>> pairs;
  for (const SpeedPartial& inner : second) {
    for (std::size_t k = 0; k < partials.size(); ++k) {
      const auto key = std::minmax(inner.speed, partials[k].speed);
      std::vector<Expr>& sums = pairs.try_emplace(key, count, graph_.zero()).first->second;
      for (std::size_t i = 0; i < count; ++i) sums[i] += inner.values[k * count + i];
    }
  }
  std::vector<Expr> coefficients;
  for (const auto& [key, sums] : pairs) coefficients.insert(coefficients.end(), sums.begin(), sums.end());
  coefficients = simplify(coefficients);

  std::size_t offset = 0;
  for (const auto& [key, sums] : pairs) {
    const Expr product = speed(key.first) * speed(key.second);
    for (std::size_t i = 0; i < count; ++i) result[i] += coefficients[offset + i] * product;
    offset += count;
  }
}

std::vector<Expr> SpeedDerivatives::along_speeds(std::span<const Expr> by_coordinates) const {
  const std::size_t nq = static_cast<std::size_t>(mechanism_.nq),
                    nv = static_cast<std::size_t>(mechanism_.nv);
  const std::vector<Expr> N = coordinate_rate_matrix();
  std::vector<Expr> out(by_coordinates.size() / nq * nv, graph_.zero());
  for (std::size_t entry = 0; entry < by_coordinates.size(); ++entry)
    for (std::size_t k = 0; k < nv; ++k)
      if (const Expr rate = N[entry % nq * nv + k]; !rate.is_zero())
        out[entry / nq * nv + k] += by_coordinates[entry] * rate;
  return out;
}

std::vector<Expr> SpeedDerivatives::coordinate_rate_matrix() const {
  const std::size_t nv = static_cast<std::size_t>(mechanism_.nv);
  std::vector<Expr> matrix(static_cast<std::size_t>(mechanism_.nq) * nv, graph_.zero());
  for (const Coordinate& coordinate : mechanism_.coordinates) {
    const std::size_t row = static_cast<std::size_t>(coordinate.first_q);
    const std::size_t column = static_cast<std::size_t>(coordinate.first_speed);
    if (coordinate.type == CoordinateType::real) {
      matrix[row * nv + column] = graph_.one();
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<Expr, 4> entries = quaternion_rate_column(coordinate.symbols, static_cast<int>(k));
      for (std::size_t a = 0; a < 4; ++a) matrix[(row + a) * nv + column + k] = entries[a];
    }
  }
  return matrix;
}

}  // namespace alembert
