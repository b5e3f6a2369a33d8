// Symbols of what acts on a mechanism, and what all symbols stand for in programs.
#pragma once

#include <vector>

#include "dynamics/tree/spatial_vectors.hpp"
#include "mechanism/model.hpp"
#include "program/lower.hpp"

namespace alembert {

/// The wrench about the centre of mass of a body with external_wrench, in world axes; symbols
/// `wrench(body).fx` ... `.tz`.
struct WrenchSymbols {
  int body;
  Wrench wrench;
};
std::vector<WrenchSymbols> wrench_symbols(const Mechanism& mechanism, ExprGraph& graph);

/// The generalized force of a speed, `tau(coordinate)`; of a quaternion's speeds with .x .y .z.
Expr tau_symbol(const Mechanism& mechanism, int speed, ExprGraph& graph);
/// The weight of the generalized force of one speed.
Expr mu_symbol(const Mechanism& mechanism, int speed, ExprGraph& graph);

/// What the symbols stand for: q, qd, qdd, t, runtime parameters, wrenches, tau.
std::vector<SymbolBinding> symbol_bindings(const Mechanism& mechanism, ExprGraph& graph);

}  // namespace alembert
