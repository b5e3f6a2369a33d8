// Inputs of a mechanism over time, from a table. In: text of comma-separated values, a header `t,NAME,...` and rows of
// ascending time. Out: values at any time, along straight lines between the rows, those of the first and last row
// beyond.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "mechanism/model.hpp"
#include "simulation/dynamics_evaluator.hpp"
#include "support/error.hpp"

namespace alembert {

class InputTable {
 public:
  InputTable() = default;
  /// Throws InputError at the place of what is no number, no input, or out of order.
  InputTable(std::shared_ptr<const SourceText> source, const Mechanism& mechanism);

  /// Sets the inputs to what they are at the state's time.
  void apply(EvaluationState& state) const;

 private:
  std::vector<std::size_t> places_;  ///< in EvaluationState::parameters, by column
  std::vector<double> times_;
  std::vector<double> values_;  ///< row by row
};

}  // namespace alembert
