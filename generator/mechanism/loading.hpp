// What the readers of the sections share while one description is being loaded.
#pragma once

#include <map>
#include <optional>
#include <span>
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

/// Makes the coordinates of a list known: names, types, indices, symbols (coordinates.cpp).
void declare_coordinates(Loading& loading, const YamlNode& list);
/// Reads their initial values and limits, once parameters have values. `start` replaces initial values, unless
/// empty.
void read_coordinate_values(Loading& loading, const YamlNode& list, std::span<const double> start);
/// Index of the coordinate that a scalar names; `type` is the type it must have.
int expect_coordinate(Loading& loading, const YamlNode& node, CoordinateType type, std::string_view what);

/// Reads a list of factors (transforms.cpp). `what` names it: `the transform of body 'arm'`.
Transform read_transform(Loading& loading, const YamlNode& list, const std::string& what);

/// Throws at the first matrix that is no rotation at the initial state or at random states near it
/// (transform_checks.cpp).
void check_matrices(const Loading& loading);

/// Reads bodies and frames into the mechanism, parents first (bodies.cpp).
void read_bodies(Loading& loading, const YamlNode& list);
void read_frames(Loading& loading, const YamlNode& list);
/// Index of the body that a scalar names, -1 for the world.
int expect_body(const Loading& loading, const YamlNode& node, const std::string& what);

/// Warns of inertias that no body can have (inertia_checks.cpp).
void check_inertias(Loading& loading);

/// Reads the shapes of a body (geometry.cpp).
std::vector<Shape> read_geometry(Loading& loading, const YamlNode& list, const std::string& body);

/// Reads constraints, once bodies and frames are known (constraints.cpp).
void read_constraints(Loading& loading, const YamlNode& list);

}  // namespace alembert
