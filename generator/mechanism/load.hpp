// Stage `load`: text of a description in, checked Mechanism out.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mechanism/document.hpp"
#include "mechanism/model.hpp"
#include "support/error.hpp"
#include "symbolic/expr.hpp"

namespace alembert {

/// What stands in the place of an input, wherever it is used: an expression as of an output, and of outputs.
struct InputExpression {
  std::string name;
  std::shared_ptr<const SourceText> source;  ///< `NAME=EXPRESSION`
};

/// Parses and checks a description (mechanisms/README.md: all checks that need no equations of motion).
/// Expressions are made in `graph`. Throws InputError with the place of what is wrong.
Mechanism load_mechanism(std::shared_ptr<const SourceText> source, ExprGraph& graph,
                         const std::vector<InputExpression>& inputs = {});

/// The same from a document, which another reader may have made. `start` are coordinates, n_q of them, that take
/// the place of the description's initial ones, and need not be inside the limits; none if empty.
Mechanism load_mechanism(const Document& document, ExprGraph& graph, std::span<const double> start = {},
                         const std::vector<InputExpression>& inputs = {});

}  // namespace alembert
