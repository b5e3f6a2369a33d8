// Stage `emit`: programs and the names of a mechanism in, the text of all files out. Nothing is written here.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "functions/axis_table.hpp"
#include "functions/function_table.hpp"
#include "mechanism/model.hpp"
#include "program/program.hpp"

namespace alembert {

struct EmittedFile {
  std::string path;  ///< relative, with `/`
  std::string text;
};

enum class Language { cpp, c, python, javascript, cuda };
/// What users call them.
inline constexpr std::pair<std::string_view, Language> kLanguages[] = {{"c++", Language::cpp},
                                                                       {"c", Language::c},
                                                                       {"python", Language::python},
                                                                       {"javascript", Language::javascript},
                                                                       {"cuda", Language::cuda}};

/// A function that is not of the table.
struct ExtraFunction {
  OutputFunction signature;
  Program program;
};

struct EmitOptions {
  Language language = Language::cpp;
  std::string outer_namespace = "alembert::mechanisms";    ///< the mechanism's own namespace lies in it
  std::vector<std::string> scalars = {"double", "float"};  ///< types compiled; of these two
  int parts = 0;                   ///< number of files over which definitions are spread; 0: by size
  std::vector<std::string> batch;  ///< functions to be written over many states too
  std::vector<std::string> batch_instructions = {"avx2", "avx512"};  ///< sets they are compiled for
  /// Functions of fewer dot products are straight over many states: there, these need not read what is just
  /// known from memory, and long code, in blocks, is fetched once for several packs.
  std::size_t batch_dot_products = 0;
  std::vector<ExtraFunction> extra;  ///< in JavaScript, behind those of the table
  std::optional<AxisPrograms> axes;  ///< in C++, for linearize of the runtime
  std::string expected_name;  ///< if given, the mechanism must have this name (builds know file names by it)
};

inline constexpr int kMaxParts = 64;

/// Version of this generator, as in the banner of every file.
std::string_view generator_version();

/// Writes out a mechanism `name` as
///
///     include/name/name.hpp         interface with Eigen, type Mechanism<S> for the runtime library
///     include/name/name_raw.hpp     sizes, names, Inputs, functions over plain arrays
///     include/name/name_impl.hpp    definitions for other scalar types: includes the parts
///     include/name/name_partK.hpp   definitions, K = 1 ... parts
///     include/name/name.h           C interface
///     src/name_partK.cpp            definitions compiled for the scalars
///     src/name_c.cpp                C interface
///
/// in this order, and with options.batch
///
///     include/name/name_batch.hpp   functions over many states
///     include/name/name_batch_impl.hpp  their blocks
///     src/name_batch.cpp            choice of instructions at run time
///     src/name_batch_SET.cpp        compiled for one set of instructions: baseline, avx2, avx512
///
/// and with Language::c, for the first of the scalars and in C99 alone,
///
///     include/name/name.h           the same C interface
///     src/name.c                    its definitions
///
/// to which Language::python adds
///
///     src/name_states.c             functions of C over many states
///     python/name.py                the module over a library of both
///     python/name.pyi               its types
///
/// and with Language::javascript, for double,
///
///     javascript/name.mjs           an ES module
///
/// and with Language::cuda, for any scalar type,
///
///     cuda/name.cuh                 functions of host and device, and kernels
///
/// The same input gives the same bytes. Long functions (BlockSizes in statement_layout.hpp) are cut into
/// blocks; loops are blocks of their own. If all coordinates are real and no program gives coordinate_rates,
/// it is added.
///
/// Throws InputError for options that cannot be (unknown scalar, no namespace, name not as expected, name
/// that cannot be compiled), InternalError for a program that does not fit its function.
std::vector<EmittedFile> emit_mechanism(const Mechanism& mechanism, std::span<const Program> programs,
                                        const EmitOptions& options);

/// Paths that emit_mechanism gives for a mechanism of this name and number of parts, in its order.
std::vector<std::string> emitted_paths(const std::string& name, int parts);

}  // namespace alembert
