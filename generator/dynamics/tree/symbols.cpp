// Symbols of forces and wrenches, and bindings of all symbols (see the header).
#include "dynamics/tree/symbols.hpp"

#include <array>
#include <cmath>

#include "support/error.hpp"

namespace alembert {

namespace {

/// `tau(coordinate)`
Expr symbol_of_speed(const char* what, const Mechanism& mechanism, int speed, ExprGraph& graph) {
  for (const Coordinate& coordinate : mechanism.coordinates) {
    const int k = speed - coordinate.first_speed;
    if (k < 0 || k >= coordinate.nv()) continue;
    std::string name = std::string(what) + "(" + coordinate.name + ")";
    if (coordinate.type == CoordinateType::quaternion)
      name += std::array{".x", ".y", ".z"}[static_cast<std::size_t>(k)];
    return graph.symbol(name);
  }
  throw InternalError("there is no speed of that index");
}

}  // namespace

Expr tau_symbol(const Mechanism& mechanism, int speed, ExprGraph& graph) {
  return symbol_of_speed("tau", mechanism, speed, graph);
}

Expr mu_symbol(const Mechanism& mechanism, int speed, ExprGraph& graph) {
  return symbol_of_speed("mu", mechanism, speed, graph);
}

std::vector<WrenchSymbols> wrench_symbols(const Mechanism& mechanism, ExprGraph& graph) {
  std::vector<WrenchSymbols> result;
  for (std::size_t b = 0; b < mechanism.bodies.size(); ++b) {
    if (!mechanism.bodies[b].external_wrench) continue;
    const std::string prefix = "wrench(" + mechanism.bodies[b].name + ").";
    WrenchSymbols symbols{static_cast<int>(b), {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const char axis = "xyz"[i];
      symbols.wrench.force[i] = graph.symbol(prefix + "f" + axis);
      symbols.wrench.moment[i] = graph.symbol(prefix + "t" + axis);
    }
    result.push_back(symbols);
  }
  return result;
}

std::vector<SymbolBinding> symbol_bindings(const Mechanism& mechanism, ExprGraph& graph) {
  std::vector<SymbolBinding> bindings;
  const auto bind = [&](Expr symbol, ArgumentKind kind, std::size_t index, double unit = 1) {
    bindings.push_back({symbol,
                        {kind, static_cast<std::uint32_t>(index),
                         graph.symbol_name(graph.symbol_index(symbol.ref().node()))},
                        unit});
  };
  std::size_t q = 0, speed = 0;
  for (const Coordinate& coordinate : mechanism.coordinates) {
    for (const Expr symbol : coordinate.symbols) bind(symbol, ArgumentKind::q, q++);
    for (std::size_t k = 0; k < coordinate.speed_symbols.size(); ++k, ++speed) {
      bind(coordinate.speed_symbols[k], ArgumentKind::qd, speed);
      bind(coordinate.rate_symbols[k], ArgumentKind::qdd, speed);
      bind(tau_symbol(mechanism, static_cast<int>(speed), graph), ArgumentKind::tau, speed);
    }
  }
  bind(mechanism.time, ArgumentKind::time, 0);
  std::size_t parameter = 0;
  for (const Parameter& p : mechanism.parameters) {
    if (p.runtime)
      bind(graph.symbol(p.name), ArgumentKind::parameter, parameter++, p.value == 0 ? 1 : std::abs(p.value));
  }
  std::size_t wrench = 0;
  for (const WrenchSymbols& symbols : wrench_symbols(mechanism, graph)) {
    const auto& [moment, force] = symbols.wrench;
    for (const Expr symbol : force.entries) bind(symbol, ArgumentKind::wrench, wrench++);
    for (const Expr symbol : moment.entries) bind(symbol, ArgumentKind::wrench, wrench++);
  }
  for (std::size_t k = 0; k < speed; ++k)
    bind(mu_symbol(mechanism, static_cast<int>(k), graph), ArgumentKind::mu, k);
  return bindings;
}

}  // namespace alembert
