// Checks of transforms that need values or dependences: that a matrix is a rotation, that no transform has
// more than six speeds, and that every coordinate moves something.
#include "mechanism/transform_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>

#include "mechanism/model.hpp"
#include "mechanism/section.hpp"
#include "mechanism/symbols_below.hpp"
#include "mechanism/transforms.hpp"
#include "symbolic/evaluate.hpp"
#include "symbolic/postorder.hpp"

namespace alembert {
namespace {

constexpr double kRotationTolerance = 1e-9;
constexpr int kRandomStates = 6;
constexpr int kAttempts = 30;  // to find them inside the domains of the functions used
// Seven coordinates have more speeds than a transform may have, whichever they are.
static_assert(SymbolsBelow::kMost > kMostSpeedsOfATransform);

/// What is wrong with a numerical rotation, or nothing.
std::string objection_to_rotation(std::span<const double, 9> r) {
  const auto at = [&](int i, int k) { return r[static_cast<std::size_t>(3 * i + k)]; };
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k <= i; ++k) {
      double product = 0;
      for (int j = 0; j < 3; ++j) product += at(j, i) * at(j, k);
      if (std::abs(product - (i == k ? 1.0 : 0.0)) <= kRotationTolerance) continue;
      if (i == k) return fmt::format("column {} has length {:.9g}", i + 1, std::sqrt(product));
      return fmt::format("columns {} and {} are not orthogonal (their product is {:.3g})", k + 1, i + 1,
                         product);
    }
  const double determinant = at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) -
                             at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0)) +
                             at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
  return determinant > 0 ? "" : "it is a reflection (its determinant is -1)";
}

std::vector<double> symbol_values(const Loading& loading) {
  std::vector<double> values(loading.graph.symbol_count(), 0.0);
  for (const auto& [symbol, value] : loading.initial_state)
    values[loading.graph.symbol_index(symbol.ref().node())] = value;
  return values;
}

/// Appends the expressions of one factor; frames move with their `along` coordinates by way of their points.
struct Collector {
  const Mechanism& mechanism;
  std::vector<Expr>& out;
  void vector(const Vec3& v) const { out.insert(out.end(), v.entries.begin(), v.entries.end()); }
  void operator()(const Translation& f) const { vector(f.offset); }
  void operator()(const AxisRotation& f) const { out.push_back(f.angle); }
  void operator()(const VectorRotation& f) const {
    vector(f.axis);
    out.push_back(f.angle);
  }
  void operator()(const QuaternionRotation& f) const {
    out.push_back(mechanism.coordinates[static_cast<std::size_t>(f.coordinate)].symbols[0]);
  }
  void operator()(const RigidMatrix& f) const {
    out.insert(out.end(), f.rotation.entries.begin(), f.rotation.entries.end());
    vector(f.translation);
  }
  void operator()(const CurveFrame& f) const { vector(f.point); }
  void operator()(const SurfaceFrame& f) const { vector(f.point); }
};

}  // namespace

void check_matrices(const Loading& loading) {
  const std::vector<MatrixToCheck>& matrices = loading.matrices;
  if (matrices.empty()) return;
  std::vector<Expr> entries;
  for (const MatrixToCheck& matrix : matrices)
    entries.insert(entries.end(), matrix.rotation.entries.begin(), matrix.rotation.entries.end());
  const std::vector<double> initial = symbol_values(loading);
  std::mt19937_64 random(1);
  const auto uniform = [&] { return 2.0 * static_cast<double>(random() >> 11) / 9007199254740992.0 - 1.0; };

  std::vector<int> checked(matrices.size(), 0);  // states at which each matrix had values
  std::size_t wrong = matrices.size();           // first in the file
  std::string objection;
  double reach = 0.5;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::vector<double> values = initial;
    if (attempt > 0) {
      // Coordinates and time move; runtime parameters stay, since a matrix may need them to fit together.
      for (const Coordinate& coordinate : loading.mechanism.coordinates)
        for (const Expr& symbol : coordinate.symbols)
          values[loading.graph.symbol_index(symbol.ref().node())] += reach * uniform();
      values[loading.graph.symbol_index(loading.mechanism.time.ref().node())] += reach * uniform();
    }
    const std::vector<double> all = evaluate(entries, values);
    bool undefined = false, enough = true;
    for (std::size_t i = 0; i < wrong; ++i) {
      const std::span<const double, 9> r(all.data() + 9 * i, 9);
      if (!std::all_of(r.begin(), r.end(), [](double x) { return std::isfinite(x); })) {
        undefined = true;
      } else if (const std::string found = objection_to_rotation(r); !found.empty()) {
        wrong = i;
        objection = fmt::format(
            "{}: {}", attempt == 0 ? "at the initial state" : "at a state near the initial one", found);
      } else {
        ++checked[i];
      }
      enough = enough && checked[i] > kRandomStates;
    }
    if (enough) break;
    if (undefined) reach *= 0.7;  // outside the domain of some function
  }
  if (wrong < matrices.size())
    throw InputError(matrices[wrong].where,
                     fmt::format("the left 3x3 part of the matrix is not a rotation {}", objection));
}

std::vector<Expr> expressions_of(std::span<const Factor> factors, const Mechanism& mechanism) {
  std::vector<Expr> out;
  for (const Factor& factor : factors) std::visit(Collector{mechanism, out}, factor.value);
  return out;
}
std::vector<Expr> expressions_of(const Factor& factor, const Mechanism& mechanism) {
  return expressions_of(std::span(&factor, 1), mechanism);
}

bool depends_on(std::span<const Expr> expressions, const Expr& symbol) {
  const std::vector<std::uint32_t> nodes = postorder(expressions);
  return std::find(nodes.begin(), nodes.end(), symbol.ref().node()) != nodes.end();
}

void check_coordinates(const Loading& loading, const std::vector<const Body*>& bodies_in_file_order) {
  const Mechanism& mechanism = loading.mechanism;
  const SymbolsBelow below(loading.graph, mechanism);
  std::vector<bool> moves_a_body(mechanism.coordinates.size(), false);
  for (const Body* body : bodies_in_file_order) {
    std::vector<int> used;
    for (const Expr& x : expressions_of(body->transform.factors, mechanism))
      SymbolsBelow::merge(used, below.coordinates(x));
    int speeds = 0;
    std::vector<std::string> names;
    for (const int c : used) {
      moves_a_body[static_cast<std::size_t>(c)] = true;
      speeds += mechanism.coordinates[static_cast<std::size_t>(c)].nv();
      names.push_back(mechanism.coordinates[static_cast<std::size_t>(c)].name);
    }
    if (speeds > kMostSpeedsOfATransform)
      throw InputError(body->where,
                       fmt::format("the transform of body '{}' depends on more than {} speeds", body->name,
                                   kMostSpeedsOfATransform),
                       fmt::format("coordinates {}; a rigid body in its parent has no more than {} freedoms",
                                   fmt::join(names, ", "), kMostSpeedsOfATransform));
    for (const Shape& shape : body->geometry)
      for (const Factor& factor : shape.transform.factors)
        for (const Expr& x : expressions_of(factor, mechanism))
          if (moves(below.kinds(x)))
            throw InputError(
                factor.where,
                fmt::format("the transform of a shape of body '{}' must be constant", body->name),
                "shapes move with their body");
  }
  for (std::size_t i = 0; i < mechanism.coordinates.size(); ++i)
    if (!moves_a_body[i])
      throw InputError(
          mechanism.coordinates[i].where,
          fmt::format("coordinate '{}' is not used: it moves no body", mechanism.coordinates[i].name));
}

}  // namespace alembert
