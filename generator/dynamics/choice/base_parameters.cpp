// Base parameters by the rank of the regressor (see the header). Source: M. Gautier and W. Khalil, Direct calculation of
// minimum set of inertial parameters of serial robots, IEEE Trans. Robotics and Automation 6, 1990; here of any
// mechanism, from the regressor itself.
#include "dynamics/choice/base_parameters.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "dynamics/recursions/regressor.hpp"
#include "dynamics/tree/state_values.hpp"
#include "support/error.hpp"
#include "symbolic/evaluate_modular.hpp"
#include "symbolic/extended.hpp"

namespace alembert {
namespace {

/// Points that must bring nothing new before the rank is believed, and states beyond those that give it, which the
/// coefficients must obey too.
constexpr unsigned kIdlePoints = 3;
/// Relative to a column: less is rounding of the numbers that the description stands for, such as the components
/// of an axis that was made a unit vector. Points modulo a prime take these for independent, and no measurement
/// could tell them.
const Extended kRounding = 64 * std::numeric_limits<double>::epsilon();

/// The regressor's columns that are not zero, as a table of expressions.
struct RegressorColumns {
  std::vector<std::size_t> parameters;
  std::vector<Expr> entries;  ///< row by row
  std::size_t rows;
};

RegressorColumns columns_of(const std::vector<Expr>& Y, std::size_t rows) {
  RegressorColumns out{{}, {}, rows};
  const std::size_t all = Y.size() / std::max<std::size_t>(rows, 1);
  for (std::size_t c = 0; c < all; ++c) {
    bool zero = true;
    for (std::size_t r = 0; r < rows; ++r) zero = zero && Y[r * all + c].is_zero();
    if (!zero) out.parameters.push_back(c);
  }
  for (std::size_t r = 0; r < rows; ++r)
    for (const std::size_t c : out.parameters) out.entries.push_back(Y[r * all + c]);
  return out;
}

std::array<std::uint32_t, 4> indices_of(const Coordinate& quaternion, const ExprGraph& graph) {
  std::array<std::uint32_t, 4> indices{};
  for (std::size_t a = 0; a < 4; ++a) indices[a] = graph.symbol_index(quaternion.symbols[a].ref().node());
  return indices;
}

/// Random, with quaternions p^2/|p|^2, which are of unit length. `runtime`: symbols that are the same for all seeds.
std::vector<Modular> modular_point(const Mechanism& mechanism, const ExprGraph& graph,
                                   const std::vector<Expr>& runtime, std::uint64_t seed) {
  using namespace modular;
  std::vector<Modular> point = random_modular_point(graph.symbol_count(), seed);
  for (const Coordinate& coordinate : mechanism.coordinates) {
    if (coordinate.type != CoordinateType::quaternion) continue;
    const std::array<std::uint32_t, 4> at = indices_of(coordinate, graph);
    const Modular x = point[at[0]], y = point[at[1]], z = point[at[2]], w = point[at[3]];
    const Modular v = add(add(multiply(x, x), multiply(y, y)), multiply(z, z)), ww = multiply(w, w);
    const Modular scale = modular::inverse(add(v, ww)), twice = multiply(add(w, w), scale);
    point[at[0]] = multiply(twice, x);
    point[at[1]] = multiply(twice, y);
    point[at[2]] = multiply(twice, z);
    point[at[3]] = multiply(add(ww, negate(v)), scale);
  }
  const std::vector<Modular> same = random_modular_point(graph.symbol_count(), 1);
  for (const Expr symbol : runtime) {
    const std::uint32_t at = graph.symbol_index(symbol.ref().node());
    point[at] = same[at];
  }
  return point;
}

/// Whether each column is independent of those before it, or zero everywhere, and how many points show that.
struct Independent {
  std::vector<char> columns, zero;
  unsigned points;
};
Independent independent_columns(const Mechanism& mechanism, const RegressorColumns& columns,
                                const ExprGraph& graph, const std::vector<Expr>& runtime) {
  using namespace modular;
  const std::size_t n = columns.parameters.size();
  std::vector<std::vector<Modular>> basis(n);  // by the column of its first entry, which is 1
  std::vector<char> zero(n, 1);
  unsigned idle = 0, points = 0;
  for (; idle < kIdlePoints; ++points) {
    const std::vector<Modular> values =
        evaluate_modular(columns.entries, modular_point(mechanism, graph, runtime, 11 + points));
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!is_zero(values[i])) zero[i % n] = 0;
    bool found = false;
    for (std::size_t r = 0; r < columns.rows; ++r) {
      std::vector<Modular> row(values.begin() + static_cast<std::ptrdiff_t>(r * n),
                               values.begin() + static_cast<std::ptrdiff_t>((r + 1) * n));
      for (std::size_t c = 0; c < n; ++c) {
        if (is_zero(row[c])) continue;
        const bool is_new = basis[c].empty();
        const Modular factor = is_new ? modular::inverse(row[c]) : negate(row[c]);
        if (is_new) {
          for (Modular& entry : row) entry = multiply(factor, entry);
          basis[c] = std::move(row);
          found = true;
          break;
        }
        for (std::size_t k = c; k < n; ++k) row[k] = add(row[k], multiply(factor, basis[c][k]));
      }
    }
    idle = found ? 0 : idle + 1;
  }
  Independent out{std::vector<char>(n), zero, points};
  for (std::size_t c = 0; c < n; ++c) out.columns[c] = !basis[c].empty();
  return out;
}

using Rows = std::vector<std::vector<Extended>>;

/// The columns at so many random states, at other values of `varied` in each.
Rows sampled_rows(const Mechanism& mechanism, const RegressorColumns& columns, ExprGraph& graph,
                  const std::vector<Expr>& varied, unsigned states) {
  const std::size_t n = columns.parameters.size();
  const ExtendedFunction function(columns.entries);
  Rows rows;
  for (unsigned seed = 1, found = 0; found < states; ++seed) {
    if (seed > 10 + 4 * states)
      throw InternalError("base parameters: the regressor has no values at most states");
    const std::vector<double> given = state_values(mechanism, graph, 500 + seed);
    std::vector<Extended> state(given.begin(), given.end());
    state[graph.symbol_index(mechanism.time.ref().node())] = 0.37 * seed;
    for (std::size_t k = 0; k < varied.size(); ++k) {
      Extended& value = state[graph.symbol_index(varied[k].ref().node())];
      value += (1 + abs(value)) * sin(Extended(seed + 3 * k));
    }
    for (const Coordinate& coordinate : mechanism.coordinates) {
      if (coordinate.type != CoordinateType::quaternion) continue;
      Extended square = 0;
      for (const std::uint32_t at : indices_of(coordinate, graph)) square += state[at] * state[at];
      for (const std::uint32_t at : indices_of(coordinate, graph)) state[at] /= sqrt(square);
    }
    const std::vector<Extended> values = function(state);
    const auto finite = [](const Extended& x) { return isfinite(x); };
    if (!std::all_of(values.begin(), values.end(), finite)) continue;
    ++found;
    for (std::size_t r = 0; r < columns.rows; ++r)
      rows.emplace_back(values.begin() + static_cast<std::ptrdiff_t>(r * n),
                        values.begin() + static_cast<std::ptrdiff_t>((r + 1) * n));
  }
  return rows;
}

/// Row reduction: rows whose first entry is 1, in a column where it is the only one. Returns the columns; what is
/// left of all other rows is nothing but rounding, which grows where rows are divided by small entries; or else nothing
/// is returned: more columns are independent.
std::optional<std::vector<std::size_t>> reduce(Rows& rows, const std::vector<char>& may_be_first) {
  std::vector<std::size_t> firsts;
  std::vector<Extended> noise(rows.size(), kRounding);
  for (std::size_t c = 0; c < may_be_first.size(); ++c) {
    const std::size_t k = firsts.size();
    if (k == rows.size()) break;
    if (!may_be_first[c]) continue;
    std::size_t largest = rows.size();
    for (std::size_t r = k; r < rows.size(); ++r)
      if (abs(rows[r][c]) > noise[r] && (largest == rows.size() || abs(rows[r][c]) > abs(rows[largest][c])))
        largest = r;
    if (largest == rows.size()) continue;
    std::swap(rows[k], rows[largest]);
    std::swap(noise[k], noise[largest]);
    const Extended pivot = rows[k][c];
    for (Extended& entry : rows[k]) entry /= pivot;
    noise[k] /= abs(pivot);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r == k || rows[r][c] == 0) continue;
      const Extended factor = rows[r][c];
      for (std::size_t j = 0; j < rows[r].size(); ++j) rows[r][j] -= factor * rows[k][j];
      noise[r] += abs(factor) * noise[k];
    }
    firsts.push_back(c);
  }
  for (std::size_t r = firsts.size(); r < rows.size(); ++r)
    for (const Extended& left : rows[r])
      // What was passed over for rounding, times what other columns have of it. A column more leaves far more.
      if (abs(left) > 4096 * noise[r]) return std::nullopt;
  return firsts;
}

/// The columns that are independent of those before them, and the others as their sums.
struct ReducedColumns {
  std::vector<std::size_t> firsts;
  Rows rows;                    ///< one for each of these, of columns over their sizes
  std::vector<Extended> sizes;  ///< of all columns
};

/// At given values of the runtime parameters, or for all values alike; nothing if those are special, so that what
/// is independent at most values is not at these.
std::optional<ReducedColumns> reduced_columns(const Kinematics& kinematics, const RegressorColumns& columns,
                                              const std::vector<Expr>& runtime, bool for_all_values) {
  const Mechanism& mechanism = kinematics.mechanism;
  ExprGraph& graph = kinematics.graph;
  const Independent independent =
      independent_columns(mechanism, columns, graph, for_all_values ? std::vector<Expr>() : runtime);
  // Columns of about the same size; rounding is none.
  ReducedColumns out{{},
                     sampled_rows(mechanism, columns, graph, for_all_values ? runtime : std::vector<Expr>(),
                                  independent.points),
                     std::vector<Extended>(columns.parameters.size(), Extended(0))};
  for (const auto& row : out.rows)
    for (std::size_t c = 0; c < row.size(); ++c) out.sizes[c] = std::max<Extended>(out.sizes[c], abs(row[c]));
  for (auto& row : out.rows)
    for (std::size_t c = 0; c < row.size(); ++c)
      row[c] = out.sizes[c] == 0 || independent.zero[c] ? Extended(0) : Extended(row[c] / out.sizes[c]);
  std::optional<std::vector<std::size_t>> firsts = reduce(out.rows, independent.columns);
  if (!firsts) return std::nullopt;
  const auto all = static_cast<std::size_t>(std::ranges::count(independent.columns, 1));
  if (!for_all_values && !runtime.empty() && firsts->size() < all) return std::nullopt;
  out.firsts = *std::move(firsts);
  return out;
}

}  // namespace

BaseParameters base_parameters(const Kinematics& kinematics) {
  const Mechanism& mechanism = kinematics.mechanism;
  ExprGraph& graph = kinematics.graph;
  const RegressorColumns columns =
      columns_of(force_regressor(mechanism, kinematics.tree, graph), static_cast<std::size_t>(mechanism.nv));
  std::vector<Expr> runtime;
  for (const Parameter& parameter : mechanism.parameters)
    if (parameter.runtime) runtime.push_back(graph.symbol(parameter.name));
  std::optional<ReducedColumns> found = reduced_columns(kinematics, columns, runtime, false);
  if (!found && !runtime.empty()) found = reduced_columns(kinematics, columns, runtime, true);
  if (!found) throw InternalError("base parameters: the rank of the regressor is larger");
  const auto& [firsts, rows, sizes] = *found;

  BaseParameters out;
  std::vector<char> has_effect(kStandardParameters * mechanism.bodies.size(), 0);
  for (std::size_t k = 0; k < firsts.size(); ++k) {
    BaseParameter& base = out.base.emplace_back(BaseParameter{columns.parameters[firsts[k]], {}});
    has_effect[base.parameter] = 1;
    for (std::size_t c = firsts[k] + 1; c < columns.parameters.size(); ++c) {
      if (abs(rows[k][c]) < kRounding || std::ranges::count(firsts, c) > 0) continue;
      const std::size_t other = columns.parameters[c];
      base.joined.emplace_back(other, static_cast<double>(rows[k][c] * sizes[c] / sizes[firsts[k]]));
      has_effect[other] = 1;
    }
  }
  for (std::size_t p = 0; p < has_effect.size(); ++p)
    if (has_effect[p] == 0 &&
        p % kStandardParameters < parameters_of(mechanism.bodies[p / kStandardParameters]))
      out.without_effect.push_back(p);
  return out;
}

}  // namespace alembert
