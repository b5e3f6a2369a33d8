// The interface with Eigen. In: a row of the function table. Out: the member of Mechanism<S> that calls the
// function over plain arrays.
#pragma once

#include <string>
#include <string_view>

#include "functions/function_table.hpp"

namespace alembert {

/// A function with one result returns it; one with several takes them as its last arguments.
std::string eigen_member(const OutputFunction& function, std::string_view name_space);

}  // namespace alembert
