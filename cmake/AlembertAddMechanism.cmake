# alembert_add_mechanism(): a mechanism's description becomes a library.
#
#   alembert_add_mechanism(TARGET target MECHANISM file.yaml
#                          [IMPORT option ...]     of a robot in another format: options of `alembert import`, such as --root floating
#                          [NAME name]             the mechanism's name, if it cannot be read off the file: its line `name: ...`, or a robot's name;
#                                                  or what a robot in another format is to be called
#                          [LANGUAGE CXX|C|PYTHON|JAVASCRIPT|CUDA] C: the C interface with C99 behind it and nothing of C++; then one of SCALARS
#                                                  (default double), and no NAMESPACE, PARTS, TRIG, BATCH. PYTHON: the same as a
#                                                  shared library, and the module over it beside it, in the folder that the target's
#                                                  property ALEMBERT_PYTHON_FOLDER names. JAVASCRIPT: no library, but the ES
#                                                  module that the target's property ALEMBERT_JAVASCRIPT_MODULE names; no SCALARS.
#                                                  CUDA: <cuda/NAME.cuh>, a header for any scalar type, and no library
#                          [NAMESPACE a::b]        outer namespace; default alembert::mechanisms
#                          [FUNCTIONS f g ...]     functions to write; default: those that `alembert generate --functions help` marks
#                          [SCALARS double float]  types to compile for; default both
#                          [FORMULATION auto|factored|reduced] [LOOP_OPERATIONS n] [LOOP_RESULTS n]
#                          [PARTS n]               source files to spread large functions over; default 4
#                          [FP_CONTRACT off|on|fast]   -ffp-contract of the generated code; default: the compiler's
#                          [TRIG vector|library]   sines and cosines of double: vectorised by alembert/sines_and_cosines.hpp
#                                                  (the default), or one by one by the C library
#                          [BATCH default|f g ...] functions over many states too; default: inverse_dynamics,
#                                                  mass_matrix_and_bias, forward_dynamics
#                          [BATCH_INSTRUCTIONS avx2 avx512]   sets they are compiled for beside the baseline; default both;
#                                                  at run time the widest that the machine has is taken
#                          [STATIC | SHARED | OBJECT])
#
# The target carries its include folder, the runtime library and its own optimisation flags, and its headers are a file set,
# so that install(TARGETS target FILE_SET HEADERS) works. It is also known as alembert::mechanisms::target. Sources include
# <name/name.hpp>, in C <name/name.h>; a target of LANGUAGE C needs <math.h> only. When the description or the generator changes, the code is written anew, and only files whose text
# changes are compiled again.
include_guard(GLOBAL)
cmake_policy(PUSH)
cmake_policy(VERSION 3.23...3.25)

# What to run and what to depend on, into the two variables named.
function(_alembert_generator command_variable depends_variable)
  set(executable "${ALEMBERT_GENERATOR_EXECUTABLE}")
  if(NOT executable AND DEFINED ENV{ALEMBERT_GENERATOR_EXECUTABLE})
    set(executable "$ENV{ALEMBERT_GENERATOR_EXECUTABLE}")
  endif()
  if(executable)
    set(${command_variable} "${executable}" PARENT_SCOPE)
    set(${depends_variable} "${executable}" PARENT_SCOPE)
  elseif(TARGET alembert::alembert)
    set(${command_variable} alembert::alembert PARENT_SCOPE)
    set(${depends_variable} "$<TARGET_FILE:alembert::alembert>" PARENT_SCOPE)
  elseif(TARGET alembert)
    set(${command_variable} alembert PARENT_SCOPE)
    set(${depends_variable} alembert "$<TARGET_FILE:alembert>" PARENT_SCOPE)
  else()
    message(FATAL_ERROR "alembert_add_mechanism: the command alembert is missing. Ask for it with find_package(alembert "
                        "COMPONENTS generator), or set ALEMBERT_GENERATOR_EXECUTABLE to it, or ALEMBERT_HOST_PREFIX to where "
                        "it is installed for this machine.")
  endif()
endfunction()

# Flags of generated code. Unoptimised, straight-line code of this length is many times slower: they do not wait for the build
# type. The time of long functions is that of fetching their code, which the options for GCC make shorter.
function(_alembert_optimise target)
  foreach(language C CXX)
    target_compile_options(
      ${target} PRIVATE "$<$<COMPILE_LANG_AND_ID:${language},GNU,Clang,AppleClang>:-O2;-fno-math-errno>"
      "$<$<COMPILE_LANG_AND_ID:${language},GNU>:-fno-tree-slp-vectorize;-frename-registers;-fno-omit-frame-pointer>")
  endforeach()
endfunction()

# Whether a file is a robot in another format: those are XML.
function(_alembert_is_robot file variable)
  file(READ "${file}" beginning LIMIT 1024)
  if(beginning MATCHES "^[ \t\r\n]*<")
    set(${variable} TRUE PARENT_SCOPE)
  else()
    set(${variable} FALSE PARENT_SCOPE)
  endif()
endfunction()

# The name of the mechanism in a description, read without knowing YAML: the file names follow from it.
# The line `name: ...` of a description, or the name of a robot in another format.
function(_alembert_mechanism_name file variable)
  _alembert_is_robot("${file}" is_robot)
  if(is_robot)
    file(READ "${file}" text LIMIT 1048576)
    string(REGEX REPLACE "<!--([^-]|-[^-])*-->" "" text "${text}")
    if(NOT text MATCHES "<(robot|world|model|Model|mujoco)[ \t\r\n][^>]*(name|model)[ \t\r\n]*=[ \t\r\n]*[\"']([^\"']+)")
      message(FATAL_ERROR "alembert_add_mechanism: ${file} does not name its robot. Give it with NAME.")
    endif()
    string(MAKE_C_IDENTIFIER "${CMAKE_MATCH_3}" name)
    set(${variable} "${name}" PARENT_SCOPE)
    return()
  endif()
  file(STRINGS "${file}" lines REGEX "^name[ \t]*:" LIMIT_COUNT 1)
  if(NOT lines MATCHES "^name[ \t]*:[ \t]*[\"']?([A-Za-z_][A-Za-z0-9_]*)[\"']?[ \t]*(#.*)?$")
    message(FATAL_ERROR "alembert_add_mechanism: ${file} has no line `name: ...` with the mechanism's name. Give it with NAME.")
  endif()
  set(${variable} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction()

# Lets the files name_batch_SET.cpp among those given use their instructions, where compiler and processor have them.
# Without these flags they are empty.
function(_alembert_batch_flags fp_contract)
  set(baseline)
  set(avx2 -mavx2 -mfma)
  set(avx512 -mavx512f -mavx512dq -mavx512vl -mavx2 -mfma)
  list(LENGTH CMAKE_OSX_ARCHITECTURES architectures)
  foreach(source ${ARGN})
    if(NOT CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang" OR MSVC OR NOT source MATCHES "_batch_([a-z0-9]+)\\.cpp$")
      continue()
    endif()
    set(instructions ${CMAKE_MATCH_1})
    # What is fused is written in pack.hpp, so that all lanes are computed alike.
    set(flags -ffp-contract=off)
    if(fp_contract STREQUAL off)
      list(APPEND flags -DALEMBERT_PACK_NO_FMA)
    endif()
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64|i[3-6]86)$" AND architectures LESS 2)
      list(APPEND flags ${${instructions}})
    endif()
    set_source_files_properties("${source}" PROPERTIES COMPILE_OPTIONS "${flags}")
  endforeach()
endfunction()

function(alembert_add_mechanism)
  cmake_parse_arguments(PARSE_ARGV 0 arg "STATIC;SHARED;OBJECT"
                        "TARGET;MECHANISM;NAME;LANGUAGE;NAMESPACE;FORMULATION;LOOP_OPERATIONS;LOOP_RESULTS;PARTS;FP_CONTRACT;TRIG" "FUNCTIONS;SCALARS;BATCH;BATCH_INSTRUCTIONS;IMPORT")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "alembert_add_mechanism: unknown arguments ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(arg_KEYWORDS_MISSING_VALUES)
    message(FATAL_ERROR "alembert_add_mechanism: no value for ${arg_KEYWORDS_MISSING_VALUES}")
  endif()
  if(NOT arg_TARGET OR NOT arg_MECHANISM)
    message(FATAL_ERROR "alembert_add_mechanism: TARGET and MECHANISM must be given")
  endif()
  get_filename_component(description "${arg_MECHANISM}" ABSOLUTE)
  if(NOT EXISTS "${description}" OR IS_DIRECTORY "${description}")
    message(FATAL_ERROR "alembert_add_mechanism: there is no file ${description}")
  endif()
  set(type STATIC)
  set(types ${arg_STATIC} ${arg_SHARED} ${arg_OBJECT})
  list(REMOVE_ITEM types FALSE)
  list(LENGTH types type_count)
  if(type_count GREATER 1)
    message(FATAL_ERROR "alembert_add_mechanism: only one of STATIC, SHARED and OBJECT can be given")
  endif()
  foreach(candidate STATIC SHARED OBJECT)
    if(arg_${candidate})
      set(type ${candidate})
    endif()
  endforeach()
  if(NOT arg_LANGUAGE)
    set(arg_LANGUAGE CXX)
  endif()
  if(NOT arg_LANGUAGE MATCHES "^(C|CXX|PYTHON|JAVASCRIPT|CUDA)$")
    message(FATAL_ERROR "alembert_add_mechanism: LANGUAGE must be CXX, C, PYTHON, JAVASCRIPT or CUDA, not ${arg_LANGUAGE}")
  endif()
  set(refused)
  if(NOT arg_LANGUAGE STREQUAL "CXX")
    list(APPEND refused NAMESPACE PARTS TRIG BATCH BATCH_INSTRUCTIONS)
  endif()
  if(arg_LANGUAGE MATCHES "^(JAVASCRIPT|CUDA)$")
    list(APPEND refused SCALARS FP_CONTRACT STATIC SHARED OBJECT)
  endif()
  foreach(argument ${refused})
    if(arg_${argument})
      message(FATAL_ERROR "alembert_add_mechanism: ${argument} does not go with LANGUAGE ${arg_LANGUAGE}")
    endif()
  endforeach()
  # A module of Python is one over a shared library of C.
  set(python FALSE)
  if(arg_LANGUAGE STREQUAL "PYTHON")
    if(arg_STATIC OR arg_OBJECT)
      message(FATAL_ERROR "alembert_add_mechanism: a library for LANGUAGE PYTHON is SHARED")
    endif()
    set(python TRUE)
    set(type SHARED)
    set(arg_LANGUAGE C)
  endif()
  if(NOT arg_PARTS)
    set(arg_PARTS 4)
  endif()
  if(NOT arg_PARTS MATCHES "^[1-9][0-9]?$" OR arg_PARTS GREATER 64)
    message(FATAL_ERROR "alembert_add_mechanism: PARTS must be 1 to 64, not ${arg_PARTS}")
  endif()
  if(NOT arg_TRIG)
    set(arg_TRIG vector)
  endif()
  if(NOT arg_TRIG MATCHES "^(vector|library)$")
    message(FATAL_ERROR "alembert_add_mechanism: TRIG must be vector or library, not ${arg_TRIG}")
  endif()
  if(arg_LANGUAGE STREQUAL "CXX" AND NOT TARGET alembert::runtime)
    message(FATAL_ERROR "alembert_add_mechanism: ${arg_TARGET} is in C++ and needs the runtime library of alembert, which needs Eigen 3.4 or "
                        "newer: find_package(alembert COMPONENTS runtime generator) says what is missing. LANGUAGE C needs neither.")
  endif()
  set(name "${arg_NAME}")
  if(NOT name)
    _alembert_mechanism_name("${description}" name)
  endif()
  _alembert_generator(generator generator_depends)

  # One folder a target: two targets may be made from one description.
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/alembert/${arg_TARGET}")
  set(include "${folder}/include/${name}")
  set(headers "${include}/${name}.hpp" "${include}/${name}_raw.hpp" "${include}/${name}_impl.hpp" "${include}/${name}.h")
  set(sources "${folder}/src/${name}_c.cpp")
  if(arg_LANGUAGE STREQUAL "C")
    set(headers "${include}/${name}.h")
    set(sources "${folder}/src/${name}.c")
    if(python)
      list(APPEND sources "${folder}/src/${name}_states.c")
    endif()
  endif()
  if(arg_LANGUAGE STREQUAL "JAVASCRIPT")
    set(headers "")
    set(sources "${folder}/javascript/${name}.mjs")
  endif()
  if(arg_LANGUAGE STREQUAL "CUDA")
    set(headers "${folder}/cuda/${name}.cuh")
    set(sources "")
  endif()
  foreach(part RANGE 1 ${arg_PARTS})
    if(NOT arg_LANGUAGE STREQUAL "CXX")
      break()
    endif()
    list(APPEND headers "${include}/${name}_part${part}.hpp")
    list(APPEND sources "${folder}/src/${name}_part${part}.cpp")
  endforeach()

  if(arg_BATCH)
    if(NOT arg_BATCH_INSTRUCTIONS)
      set(arg_BATCH_INSTRUCTIONS avx2 avx512)
    endif()
    list(APPEND headers "${include}/${name}_batch.hpp" "${include}/${name}_batch_impl.hpp")
    list(APPEND sources "${folder}/src/${name}_batch.cpp")
    foreach(set ${arg_BATCH_INSTRUCTIONS} baseline)
      list(APPEND sources "${folder}/src/${name}_batch_${set}.cpp")
    endforeach()
    _alembert_batch_flags("${arg_FP_CONTRACT}" ${sources})
  elseif(arg_BATCH_INSTRUCTIONS)
    message(FATAL_ERROR "alembert_add_mechanism: BATCH_INSTRUCTIONS without BATCH")
  endif()

  set(options --expected-name ${name} ${arg_IMPORT})
  _alembert_is_robot("${description}" is_robot)
  if(is_robot)  # its own name may be another one
    list(APPEND options --name ${name})
  endif()
  if(arg_LANGUAGE STREQUAL "C")
    if(python)
      list(APPEND options --language python)
    else()
      list(APPEND options --language c)
    endif()
  elseif(arg_LANGUAGE STREQUAL "JAVASCRIPT")
    list(APPEND options --language javascript)
  elseif(arg_LANGUAGE STREQUAL "CUDA")
    list(APPEND options --language cuda)
  else()
    list(APPEND options --parts ${arg_PARTS})
  endif()
  if(arg_FUNCTIONS)
    list(JOIN arg_FUNCTIONS "," functions)
    list(APPEND options --functions ${functions})
  endif()
  if(arg_SCALARS)
    list(JOIN arg_SCALARS "," scalars)
    list(APPEND options --scalars ${scalars})
  endif()
  if(arg_BATCH)
    list(JOIN arg_BATCH "," batch)
    list(JOIN arg_BATCH_INSTRUCTIONS "," batch_instructions)
    list(APPEND options --batch ${batch} --batch-instructions ${batch_instructions})
  endif()
  if(arg_NAMESPACE)
    list(APPEND options --namespace ${arg_NAMESPACE})
  endif()
  if(arg_FORMULATION)
    list(APPEND options --formulation ${arg_FORMULATION})
  endif()
  if(DEFINED arg_LOOP_OPERATIONS)
    list(APPEND options --loop-operations ${arg_LOOP_OPERATIONS})
  endif()
  if(DEFINED arg_LOOP_RESULTS)
    list(APPEND options --loop-results ${arg_LOOP_RESULTS})
  endif()

  # The stamp is the only OUTPUT: it is touched by every run, while the files themselves are written only if they change.
  # Were they outputs, Makefiles would see them older than the description, and generate for ever.
  set(stamp "${folder}/${name}.stamp")
  file(MAKE_DIRECTORY "${folder}")
  add_custom_command(
    OUTPUT "${stamp}"
    BYPRODUCTS ${sources} ${headers}
    COMMAND ${generator} generate "${description}" --out-dir "${folder}" --depfile "${stamp}.d" --stamp "${stamp}" ${options}
    DEPENDS "${description}" ${generator_depends}
    DEPFILE "${stamp}.d"
    COMMENT "Generating the equations of motion of ${name}"
    VERBATIM)

  if(arg_LANGUAGE STREQUAL "JAVASCRIPT")
    add_custom_target(${arg_TARGET} ALL DEPENDS "${stamp}")
    set_target_properties(${arg_TARGET} PROPERTIES ALEMBERT_JAVASCRIPT_MODULE "${sources}")
    return()
  endif()
  if(arg_LANGUAGE STREQUAL "CUDA")
    add_custom_target(${arg_TARGET}_header DEPENDS "${stamp}")
    add_library(${arg_TARGET} INTERFACE)
    add_dependencies(${arg_TARGET} ${arg_TARGET}_header)
    target_include_directories(${arg_TARGET} INTERFACE "${folder}")
    return()
  endif()
  add_library(${arg_TARGET} ${type} ${sources} "${stamp}")
  add_library(alembert::mechanisms::${arg_TARGET} ALIAS ${arg_TARGET})
  target_sources(${arg_TARGET} PUBLIC FILE_SET HEADERS BASE_DIRS "${folder}/include" FILES ${headers})
  if(arg_LANGUAGE STREQUAL "CXX")
    target_link_libraries(${arg_TARGET} PUBLIC alembert::runtime)
    target_compile_features(${arg_TARGET} PUBLIC cxx_std_17)
  else()
    # Not `m`, which may be a target.
    if(NOT WIN32)
      target_link_libraries(${arg_TARGET} PUBLIC -lm)
    endif()
    set_target_properties(${arg_TARGET} PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON LINKER_LANGUAGE C)
  endif()
  if(arg_BATCH)
    find_package(Threads QUIET)
    target_link_libraries(${arg_TARGET} PRIVATE ${CMAKE_THREAD_LIBS_INIT})
  endif()
  # A target called m must not become libm.a; symbols of a shared library are for its users. PARTS are to be compiled
  # each by itself.
  set_target_properties(${arg_TARGET} PROPERTIES OUTPUT_NAME alembert_${arg_TARGET} POSITION_INDEPENDENT_CODE ON
                        CXX_VISIBILITY_PRESET default VISIBILITY_INLINES_HIDDEN OFF WINDOWS_EXPORT_ALL_SYMBOLS ON UNITY_BUILD OFF
                        CXX_CLANG_TIDY "" CXX_CPPCHECK "" CXX_INCLUDE_WHAT_YOU_USE "")
  if(python)
    set_target_properties(${arg_TARGET} PROPERTIES OUTPUT_NAME alembert_${name} ALEMBERT_PYTHON_FOLDER "${folder}/python"
                          LIBRARY_OUTPUT_DIRECTORY "$<1:${folder}/python>" RUNTIME_OUTPUT_DIRECTORY "$<1:${folder}/python>")
  endif()
  _alembert_optimise(${arg_TARGET})
  if(arg_TRIG STREQUAL vector AND arg_LANGUAGE STREQUAL "CXX")
    target_compile_definitions(${arg_TARGET} PRIVATE ALEMBERT_VECTOR_TRIG)
  endif()
  if(arg_FP_CONTRACT)
    target_compile_options(${arg_TARGET} PRIVATE "$<$<COMPILE_LANG_AND_ID:${arg_LANGUAGE},GNU,Clang,AppleClang>:-ffp-contract=${arg_FP_CONTRACT}>")
  endif()
endfunction()

cmake_policy(POP)
