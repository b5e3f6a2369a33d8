// Where to look when constants overflow. In: the text of a description. Out: the place of its number of the
// largest or smallest magnitude.
#pragma once

#include <memory>

#include "support/error.hpp"

namespace alembert {

/// The number farthest from 1 by its logarithm, powers of numbers included; the beginning of the text if
/// there is none but 0 and 1. The text must be a description.
SourceLocation most_extreme_number(const std::shared_ptr<const SourceText>& source);

}  // namespace alembert
