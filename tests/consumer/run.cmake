# Installs alembert, then builds the project beside this file against it as a user would:
#   cmake -DBUILD=BUILD_FOLDER -DWORK=FOLDER -DGENERATOR=Ninja -DC_COMPILER=... -DCXX_COMPILER=... -P run.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/run_command.cmake)
set(prefix "${WORK}/prefix")
set(source "${WORK}/my project")  # with a blank, as users have it
set(build "${WORK}/my build")

function(expect_count text pattern count)
  string(REGEX MATCHALL "${pattern}" found "${text}")
  list(LENGTH found number)
  if(NOT number EQUAL count)
    message(FATAL_ERROR "expected ${count} times '${pattern}', found ${number} in:\n${text}")
  endif()
endfunction()

# A build that generates `generated` times, compiles or not, and (if asked) has nothing at all to do.
function(build_and_expect generated compiled)
  run(output ${CMAKE_COMMAND} --build "${build}" -j2)
  expect_count("${output}" "Generating the equations of motion" ${generated})
  if(compiled)
    if(NOT output MATCHES "Building CXX")
      message(FATAL_ERROR "expected that something is compiled:\n${output}")
    endif()
  else()
    expect_count("${output}" "Building CXX" 0)
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect_nothing_to_do)
  build_and_expect(0 FALSE)
  expect_count("${output}" "Linking" 0)
  if(GENERATOR STREQUAL "Ninja")
    expect_count("${output}" "no work to do" 1)
  endif()
endfunction()

# File systems and make compare times; a second is more than any of them rounds to.
function(wait)
  execute_process(COMMAND ${CMAKE_COMMAND} -E sleep 1.1)
endfunction()

file(REMOVE_RECURSE "${WORK}")
file(COPY "${CMAKE_CURRENT_LIST_DIR}/project/" DESTINATION "${source}")
foreach(component runtime generator)
  run(output ${CMAKE_COMMAND} --install "${BUILD}" --prefix "${prefix}" --component ${component})
endforeach()

file(GLOB headers RELATIVE "${CMAKE_CURRENT_LIST_DIR}/../../src" "${CMAKE_CURRENT_LIST_DIR}/../../src/alembert/*.hpp")
if(NOT headers)
  message(FATAL_ERROR "no header of the runtime found")
endif()
foreach(header ${headers})
  if(NOT EXISTS "${prefix}/include/${header}")
    message(FATAL_ERROR "not installed: ${header}")
  endif()
endforeach()

file(GLOB_RECURSE built "${BUILD}/generated/*alembert_catalogue.a")
file(GLOB_RECURSE catalogue "${prefix}/*alembert_catalogue.a" "${prefix}/alembert-catalogue-targets.cmake")
list(LENGTH catalogue catalogue_files)
if(built AND NOT catalogue_files EQUAL 2)
  message(FATAL_ERROR "the catalogue was built and is not installed: ${catalogue}")
endif()

run(output ${CMAKE_COMMAND} -S "${source}" -B "${build}" -G "${GENERATOR}" -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_BUILD_TYPE=Debug
    -DCMAKE_C_COMPILER=${C_COMPILER} -DCMAKE_CXX_COMPILER=${CXX_COMPILER} --warn-uninitialized -Werror=dev)
build_and_expect(3 TRUE)
run(motion "${build}/motion")
run(torque "${build}/torque")
run(torque_from_objects "${build}/torque_from_objects")
expect_count("${motion}" "torque [-0-9.]+ [-0-9.]+" 1)
if(NOT motion STREQUAL torque OR NOT torque_from_objects STREQUAL torque)
  message(FATAL_ERROR "three ways to the same torque differ: ${motion} ${torque} ${torque_from_objects}")
endif()
expect_nothing_to_do()

# Touched but the same: generated once for each target, nothing compiled, and then nothing to do.
wait()
file(TOUCH "${source}/arm.yaml")
build_and_expect(3 FALSE)
expect_nothing_to_do()

# Changed: compiled and different.
wait()
file(READ "${source}/arm.yaml" text)
string(REPLACE "mass: 2" "mass: 3" heavier "${text}")
file(WRITE "${source}/arm.yaml" "${heavier}")
build_and_expect(3 TRUE)
run(heavier_torque "${build}/torque")
if(heavier_torque STREQUAL torque)
  message(FATAL_ERROR "a heavier arm has the same torque: ${torque}")
endif()
expect_nothing_to_do()

# A file that was deleted comes back (make knows outputs only, and the stamp is the output).
if(GENERATOR STREQUAL "Ninja")
  file(REMOVE "${build}/alembert/arm/include/arm/arm.hpp")
  build_and_expect(1 TRUE)
  expect_nothing_to_do()
endif()

# Called otherwise now: the build says what to do.
wait()
string(REPLACE "name: arm" "name: leg" renamed "${text}")
file(WRITE "${source}/arm.yaml" "${renamed}")
execute_process(COMMAND ${CMAKE_COMMAND} --build "${build}" OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
if(result EQUAL 0 OR NOT output MATCHES "arm.yaml:[0-9]+:[0-9]+: error: .*'leg' where the build expects 'arm'")
  message(FATAL_ERROR "renaming the mechanism must fail and say why (${result}):\n${output}")
endif()
wait()
file(WRITE "${source}/arm.yaml" "${text}")
build_and_expect(3 TRUE)

# The library installs with its headers, for others to find.
run(output ${CMAKE_COMMAND} --install "${build}" --prefix "${WORK}/installed")
foreach(file include/arm/arm.hpp include/arm/arm.h lib/libalembert_arm.a lib/cmake/consumer/consumer.cmake)
  if(NOT EXISTS "${WORK}/installed/${file}")
    message(FATAL_ERROR "not installed: ${file}")
  endif()
endforeach()

# What follows does not depend on the build tool.
if(NOT GENERATOR STREQUAL "Ninja")
  file(REMOVE_RECURSE "${WORK}")
  return()
endif()

# The same in C, without a compiler for C++, without its library and without Eigen.
run(output ${CMAKE_COMMAND} -S "${CMAKE_CURRENT_LIST_DIR}/c_project" -B "${WORK}/c build" -G "${GENERATOR}" -DCMAKE_PREFIX_PATH=${prefix}
    -DCMAKE_C_COMPILER=${C_COMPILER} "-DPROJECT=${source}" "-DROBOT=${CMAKE_CURRENT_LIST_DIR}/../../mechanisms/examples/controller/arm.urdf" -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON -DCMAKE_CXX_COMPILER=no-such-compiler --warn-uninitialized
    -Werror=dev)
run(output ${CMAKE_COMMAND} --build "${WORK}/c build" -j2)
foreach(library arm m)
  run(torque_in_c "${WORK}/c build/torque_${library}")
  if(NOT torque_in_c STREQUAL torque)
    message(FATAL_ERROR "C99 gives another torque: ${torque_in_c} and ${torque}")
  endif()
endforeach()
run(torque_in_float "${WORK}/c build/torque_float")
expect_count("${torque_in_float}" "torque [-0-9.]+ [-0-9.]+" 1)
run(weight "${WORK}/c build/flying")
expect_count("${weight}" "weight 51.993" 1)
run(output "${WORK}/c build/swings")
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES "${WORK}/c build/torque_m" RESOLVED_DEPENDENCIES_VAR libraries)
if("${libraries}" MATCHES "stdc|c\\+\\+")
  message(FATAL_ERROR "C needs a library of C++: ${libraries}")
endif()

# Without the command, the package says which variables would name it.
run(output ${CMAKE_COMMAND} -E copy_directory "${prefix}" "${WORK}/runtime only")
file(GLOB targets "${WORK}/runtime only/lib*/cmake/alembert/alembert-generator-targets*" "${WORK}/runtime only/lib*/*/cmake/alembert/alembert-generator-targets*")
if(NOT targets)
  message(FATAL_ERROR "the generator's targets are not where this test looks for them")
endif()
file(REMOVE ${targets})
set(configure ${CMAKE_COMMAND} -S "${source}" "-DCMAKE_PREFIX_PATH=${WORK}/runtime only" -G "${GENERATOR}"
    -DCMAKE_C_COMPILER=${C_COMPILER} -DCMAKE_CXX_COMPILER=${CXX_COMPILER})
execute_process(COMMAND ${configure} -B "${WORK}/failing" OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
if(result EQUAL 0 OR NOT output MATCHES "ALEMBERT_GENERATOR_EXECUTABLE" OR NOT output MATCHES "ALEMBERT_HOST_PREFIX")
  message(FATAL_ERROR "a missing generator must be named (${result}):\n${output}")
endif()
run(output ${configure} -B "${WORK}/given" -DALEMBERT_GENERATOR_EXECUTABLE=${prefix}/bin/alembert)
run(output ${CMAKE_COMMAND} --build "${WORK}/given" --target torque)

# When cross-compiling, the installed command is for the target machine: the one for this machine must be named.
set(configure ${CMAKE_COMMAND} -S "${source}" "-DCMAKE_PREFIX_PATH=${prefix}" -G "${GENERATOR}" -DCMAKE_C_COMPILER=${C_COMPILER}
    -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=other)
execute_process(COMMAND ${configure} -B "${WORK}/cross" OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
if(result EQUAL 0 OR NOT output MATCHES "ALEMBERT_HOST_PREFIX")
  message(FATAL_ERROR "cross-compiling without a command for this machine must fail and say why (${result}):\n${output}")
endif()
run(output ${configure} -B "${WORK}/cross with prefix" "-DALEMBERT_HOST_PREFIX=${prefix}")
run(output ${CMAKE_COMMAND} --build "${WORK}/cross with prefix" --target torque)

# Flags from pkg-config suffice for the runtime library.
find_program(pkg_config pkg-config)
if(pkg_config)
  file(GLOB_RECURSE pc "${prefix}/alembert.pc")
  execute_process(COMMAND ${CMAKE_COMMAND} -E env "PKG_CONFIG_PATH=${prefix}/lib/pkgconfig:${prefix}/lib/x86_64-linux-gnu/pkgconfig"
                  ${pkg_config} --cflags alembert OUTPUT_VARIABLE output RESULT_VARIABLE result)
  if(NOT result EQUAL 0 OR NOT output MATCHES "-I[^ ]*/include")
    message(FATAL_ERROR "pkg-config gives '${output}' for ${pc}")
  endif()
endif()
# The example for GPUs, by CUDA's compiler where there is one.
find_program(nvcc nvcc PATHS /usr/local/cuda/bin)
if(nvcc)
  run(output ${CMAKE_COMMAND} -S "${CMAKE_CURRENT_LIST_DIR}/../../mechanisms/examples/gpu" -B "${WORK}/gpu build" -G "${GENERATOR}" -DGPU_ENABLED=ON
      -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CUDA_COMPILER=${nvcc} -DCMAKE_CXX_COMPILER=${CXX_COMPILER} --warn-uninitialized -Werror=dev)
  run(output ${CMAKE_COMMAND} --build "${WORK}/gpu build" -j2)
  # On a GPU where one is, otherwise on the processor.
  run(output "${WORK}/gpu build/gpu")
  find_program(nvidia_smi nvidia-smi)
  if(nvidia_smi)
    execute_process(COMMAND ${nvidia_smi} -L OUTPUT_VARIABLE devices ERROR_QUIET)
    if(devices MATCHES "GPU 0" AND NOT output MATCHES "GPU: a payload")
      message(FATAL_ERROR "there is a GPU, and the example ran without it: ${output}")
    endif()
  endif()
endif()
file(REMOVE_RECURSE "${WORK}")
