// Python: a module over the C interface by ctypes and numpy, its type stubs, and the functions of C over many
// states that it calls. In: rows of the function table and the files of C99. Out: text.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "emit/c99.hpp"
#include "emit/emit.hpp"
#include "emit/text_template.hpp"
#include "mechanism/model.hpp"

namespace alembert {

/// src/NAME_states.c, python/NAME.py and python/NAME.pyi. The module refuses a library that was not compiled
/// from `c_files`. Throws InputError if Python cannot import a module of the mechanism's name.
std::vector<EmittedFile> python_files(const Mechanism& mechanism, std::span<const WrittenFunction> functions,
                                      std::span<const EmittedFile> c_files, const std::string& number,
                                      const Slots& common);

}  // namespace alembert
