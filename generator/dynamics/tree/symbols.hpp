// Symbols of what acts on a mechanism, and what all symbols stand for in programs.
#pragma once

#include <vector>

#include "mechanism/model.hpp"
#include "program/lower.hpp"

namespace alembert {

/// World force at the centre of mass and world torque of a body with external_wrench; symbols
/// `wrench(body).fx` ... `.tz`.
struct WrenchSymbols {
  int body;
  Vec3 force, torque;
};
std::vector<WrenchSymbols> wrench_symbols(const Mechanism& mechanism, ExprGraph& graph);

/// The generalized force of a speed, `tau(coordinate)`; of a quaternion's speeds with .x .y .z.
Expr tau_symbol(const Mechanism& mechanism, int speed, ExprGraph& graph);

/// What the symbols stand for: q, qd, qdd, t, runtime parameters, wrenches, tau.
std::vector<SymbolBinding> symbol_bindings(const Mechanism& mechanism, ExprGraph& graph);

}  // namespace alembert
