// Units of values, by those of what they are made of (see the header): all terms of a sum have one unit, so that of any
// that is known. A factor may have a unit too, even if it is a number.
#include "viewer/value_units.hpp"

#include <unordered_map>

#include "symbolic/postorder.hpp"
#include "viewer/coordinate_unit.hpp"

namespace alembert {

ValueUnits::ValueUnits(const InitialValues& values) : mechanism_(values.mechanism()) {
  for (const Coordinate& coordinate : mechanism_.coordinates) {
    const bool quaternion = coordinate.type == CoordinateType::quaternion;
    const std::string unit = quaternion ? "rad" : coordinate_unit(values, coordinate);
    if (!quaternion) set(coordinate.symbols[0], unit);
    for (const Expr& speed : coordinate.speed_symbols) {
      set(speed, unit.empty() ? "" : unit + "/s");
      along_.push_back(unit == "rad" ? "N m" : unit == "m" ? "N" : "");
    }
  }
  set(mechanism_.time, "s");
  for (const FrameSymbols& of_frame : mechanism_.frame_symbols) {
    static constexpr const char* kUnits[] = {"m", "m/s", "", "rad/s"};
    for (const Expr& symbol : of_frame.symbols)
      set(symbol, kUnits[static_cast<std::size_t>(of_frame.quantity)]);
  }
  for (const FrameDistance& distance : mechanism_.distances) set(distance.symbol, "m");
  for (const Force& force : mechanism_.forces)
    if (force.kind == ForceKind::path) set(force.rate, "m/s");
  set_inputs();
}

std::string ValueUnits::along(int speed) const {
  return along_[static_cast<std::size_t>(speed)];
}

/// An input that is itself a force has the unit of one.
void ValueUnits::set_inputs() {
  std::map<std::uint32_t, std::string> found;
  const auto set_input = [&](const Expr& value, const std::string& unit) {
    if (value.valid()) found.emplace(value.ref().node(), unit);
  };
  for (const Force& force : mechanism_.forces) {
    if (force.kind == ForceKind::on_speed) set_input(force.value, along(force.speed));
    if (force.kind == ForceKind::path) set_input(force.value, "N");
    if (force.kind != ForceKind::wrench) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      set_input(force.force[i], "N");
      set_input(force.torque[i], "N m");
    }
  }
  for (const Parameter& parameter : mechanism_.parameters) {
    if (!parameter.is_input()) continue;
    for (const auto& [node, unit] : found) {
      const ExprGraph& graph = mechanism_.time.graph();
      if (graph.node(node).op == Operation::symbol &&
          graph.symbol_name(graph.symbol_index(node)) == parameter.name)
        known_[node] = unit;
    }
  }
}

void ValueUnits::set(const Expr& value, const std::string& unit) {
  if (!unit.empty()) known_[value.ref().node()] = unit;
}

std::string ValueUnits::of(const Expr& value) const {
  const ExprGraph& graph = value.graph();
  std::unordered_map<std::uint32_t, std::string> units;
  for (const std::uint32_t id : postorder(std::span(&value, 1))) {
    const Node& node = graph.node(id);
    const auto unit = [&](Ref operand) -> const std::string& { return units[operand.node()]; };
    std::string& out = units[id];
    if (node.op == Operation::symbol) {
      if (const auto known = known_.find(id); known != known_.end()) out = known->second;
    } else if (node.op == Operation::add) {
      const std::string &first = unit(node.a), &second = unit(node.b);
      if (first.empty() || second.empty() || first == second) out = first.empty() ? second : first;
    } else if (node.op == Operation::abs) {
      out = unit(node.a);
    } else if (node.op == Operation::if_positive || node.op == Operation::unless_positive) {
      out = unit(node.b);
    }
  }
  return units[value.ref().node()];
}

}  // namespace alembert
