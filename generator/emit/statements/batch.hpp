// Functions over many states. In: a mechanism, which functions and which sets of instructions. Out: the files
// that compile the mechanism's templates for packs of states and choose among them at run time.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "emit/argument_lists.hpp"
#include "emit/emit.hpp"
#include "emit/text_template.hpp"

namespace alembert {

/// Sets of instructions beside the baseline that there may be, widest first, as the runtime names them.
std::span<const std::string_view> batch_instruction_sets();

/// Functions that a batch has unless told otherwise.
std::vector<std::string> default_batch_functions();

/// The functions of these names as they stand in the table. forward_dynamics needs no program: without one it
/// is solved from mass_matrix_and_bias. Throws InputError at the mechanism for what is unknown or not among
/// the programs.
std::vector<const OutputFunction*> batch_signatures(const Mechanism& mechanism,
                                                    std::span<const Program> programs,
                                                    const EmitOptions& options);

/// The files, in the order of batch_paths.
std::vector<EmittedFile> batch_files(const Mechanism& mechanism, std::span<const Program> programs,
                                     const EmitOptions& options, const Slots& common);

/// Their declarations in C.
std::string batch_c_declarations(const Mechanism& mechanism, std::span<const Program> programs,
                                 const EmitOptions& options, const Slots& common);

/// include/name/name_batch.hpp, include/name/name_batch_impl.hpp, src/name_batch.cpp, src/name_batch_SET.cpp.
std::vector<std::string> batch_paths(const std::string& name, const EmitOptions& options);

}  // namespace alembert
