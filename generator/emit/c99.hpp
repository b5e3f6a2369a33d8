// C99: the source file behind the C interface, with nothing of C++ in it. In: functions as statements of C
// (c_syntax). Out: text. It needs <math.h> only and no memory but the stack.
#pragma once

#include <span>
#include <string>

#include "emit/argument_lists.hpp"
#include "emit/statements/statements.hpp"
#include "emit/text_template.hpp"
#include "mechanism/model.hpp"

namespace alembert {

/// One function with all its texts.
struct WrittenFunction {
  const OutputFunction* signature;
  std::string counts;
  FunctionBody body;
};

/// NAME.c for numbers of this type, double or float.
std::string c99_source(const Mechanism& mechanism, std::span<const WrittenFunction> functions,
                       const std::string& number, const Slots& common);

}  // namespace alembert
