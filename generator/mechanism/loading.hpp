// What the readers of the sections share while one description is being loaded.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mechanism/expression_reader.hpp"
#include "mechanism/model.hpp"
#include "mechanism/scope.hpp"

namespace alembert {

/// The rotation of a factor `matrix`, checked with all others once everything is read.
struct MatrixToCheck {
  Mat3 rotation;
  SourceLocation where;
};

struct Loading {
  Loading(const Document& d, ExprGraph& g) : document(d), graph(g), reader(d, g, scope, mechanism) {}

  const Document& document;
  ExprGraph& graph;
  Mechanism mechanism;
  Scope scope;
  ExpressionReader reader;
  /// Values at the initial state, by symbol.
  std::vector<std::pair<Expr, double>> initial_state;
  /// By coordinate: where a quaternion was used, if it was.
  std::vector<std::optional<SourceLocation>> quaternion_use;
  std::vector<MatrixToCheck> matrices;
  /// By name: in the order of the file while bodies are read, then in Mechanism::bodies.
  std::map<std::string, int, std::less<>> body_indices;
  std::map<std::string, SourceLocation> inertia_places;  ///< by body, of those that have an inertia
};

}  // namespace alembert
