// What documentation says of an output function, in every language. In: its row of the table, the mechanism's
// sizes, operations. Out: lines of plain text, not yet marked as a comment.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "emit/c99.hpp"
#include "emit/text_template.hpp"
#include "functions/function_table.hpp"
#include "mechanism/model.hpp"

namespace alembert {

/// `M [6 x 6]`, with a number of blocks in front where there are several: `W [7 x 3 x 4]`.
std::string result_with_shape(const ResultArray& result, const Mechanism& mechanism);

/// Summary and formula.
std::string function_summary(const OutputFunction& function);

/// Summary, formula, results with shapes and units, remark, source and operations. With a prefix, constants have
/// the names of C and Python: PREFIXbody_names for kBodyNames.
std::string function_doc(const OutputFunction& function, const Mechanism& mechanism,
                         const std::string& operations,
                         const std::optional<std::string>& prefix = std::nullopt);

/// The arrays of the state that functions take or give, a line each: `q    [6] coordinates: a, b and 4 more`.
/// Names are followed by blanks up to `width`; `brackets` says how a size is written, such as `[{}]`.
std::string state_arguments(std::span<const WrittenFunction> functions, const Slots& common,
                            std::size_t width, std::string_view brackets);

}  // namespace alembert
