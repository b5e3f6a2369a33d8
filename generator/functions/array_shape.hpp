// Sizes of the arrays that output functions take and fill. In: a row of the function table and a mechanism.
// Out: numbers.
#pragma once

#include <cstddef>
#include <vector>

#include "functions/function_table.hpp"
#include "mechanism/model.hpp"

namespace alembert {

/// Blocks of rows and columns, one after another, each row by row.
struct ArrayShape {
  std::size_t blocks, rows, columns;
  std::size_t size() const { return blocks * rows * columns; }
};
ArrayShape array_shape(const ResultArray& result, const Mechanism& mechanism);

/// Its sizes as an array of several dimensions: a number of blocks where there may be several, and no columns
/// or rows where there is one by definition.
std::vector<std::size_t> natural_shape(const ResultArray& result, const Mechanism& mechanism);

/// Whether the columns of a result stand for speeds: those of M, P and Jacobians.
constexpr bool has_speed_columns(const ResultArray& result) {
  return result.columns == kPerSpeed;
}

/// The same array as one table: blocks below one another where columns are speeds, else a row for each block;
/// a column where there is one block of one column.
struct TableShape {
  std::size_t rows, columns;
};
TableShape table_shape(const ResultArray& result, const Mechanism& mechanism);

/// Numbers that an argument of this kind has.
std::size_t argument_size(ArgumentKind kind, const Mechanism& mechanism);

/// Whether the function says anything of this mechanism: poses of frames do not where there are no frames.
bool has_results(const OutputFunction& function, const Mechanism& mechanism);

}  // namespace alembert
