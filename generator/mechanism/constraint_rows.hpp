// Rows of the constraints of a mechanism. In: its constraints. Out: one name and type for each row, in file
// order.
#pragma once

#include <string>
#include <vector>

#include "mechanism/model.hpp"

namespace alembert {

/// One scalar equation. The name is that of its constraint, with its index in brackets where there are
/// several.
struct ConstraintRow {
  std::string name;
  ConstraintType type;
  std::size_t constraint;  ///< index into Mechanism::constraints
};

inline std::vector<ConstraintRow> constraint_rows(const Mechanism& mechanism) {
  std::vector<ConstraintRow> rows;
  for (std::size_t c = 0; c < mechanism.constraints.size(); ++c) {
    const Constraint& constraint = mechanism.constraints[c];
    for (std::size_t i = 0; i < constraint.rows(); ++i) {
      const std::string index = constraint.rows() == 1 ? "" : "[" + std::to_string(i) + "]";
      rows.push_back({constraint.name + index, constraint.type, c});
    }
  }
  return rows;
}

}  // namespace alembert
