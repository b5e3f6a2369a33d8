// For the tests of the loader: descriptions in memory in, loaded mechanisms or diagnostics out.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "mechanism/load.hpp"
#include "symbolic/to_string.hpp"

namespace alembert::test {

inline std::shared_ptr<const SourceText> source_of(std::string text) {
  auto source = std::make_shared<SourceText>();
  source->name = "m.yaml";
  source->text = std::move(text);
  return source;
}

/// A mechanism with the graph that its expressions live in.
struct Loaded {
  ExprGraph graph;
  Mechanism mechanism;
  explicit Loaded(std::string text) : mechanism(load_mechanism(source_of(std::move(text)), graph)) {}
  Expr number(std::int64_t n, std::int64_t d = 1) { return graph.rational(Rational(n, d)); }
  Expr symbol(std::string_view name) { return graph.symbol(name); }
};

/// The diagnostic of a description that is wrong, or nothing if it loads.
inline std::string error_of(std::string text) {
  ExprGraph graph;
  try {
    load_mechanism(source_of(std::move(text)), graph);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// A description with one body whose transform is `transform`, over the coordinates `coordinates`.
inline std::string with_transform(const std::string& transform, const std::string& coordinates = "[q]") {
  return "alembert: 1\nname: one\ncoordinates: " + coordinates +
         "\nbodies:\n  - {name: arm, mass: 1, transform: " + transform + "}\n";
}

/// A description with one body that is shifted by `offset`, with parameters r = 1/4 and k (runtime).
inline std::string with_parameters(const std::string& offset, const std::string& coordinates) {
  return "alembert: 1\nname: one\nparameters: {r: 0.25, k: {value: 3, runtime: true}}\ncoordinates: " +
         coordinates +
         "\ngravity: [r, k, 0]\nbodies:\n  - {name: arm, mass: 1, transform: [{translate: " + offset +
         "}]}\n";
}

inline const std::vector<Factor>& factors(const Loaded& loaded) {
  return loaded.mechanism.bodies.at(0).transform.factors;
}

/// How far along x that transform begins by shifting.
inline Expr shift(const Loaded& loaded) {
  return std::get<Translation>(factors(loaded).at(0).value).offset[0];
}

}  // namespace alembert::test

namespace alembert {
/// Shown by GoogleTest when two expressions differ.
inline void PrintTo(const Expr& x, std::ostream* out) {
  *out << (x.valid() ? to_string(x) : "no expression");
}
}  // namespace alembert
