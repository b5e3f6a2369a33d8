# Builds generator, runtime and tests with clang, address and undefined behaviour sanitizers, and runs the tests, among them the freshness of
# generated/: so that both compilers' generators are known to write the same bytes. Left out is what only repeats on more or longer mechanisms what other
# tests reach. Arguments: ROOT, BUILD.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}")
  endif()
endfunction()

run(${CMAKE_COMMAND} -S ${ROOT} -B ${BUILD} -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release
    "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -g1" -DALEMBERT_SANITIZE=address,undefined,fuzzer-no-link -DALEMBERT_BUILD_TESTS=ON -DALEMBERT_BUILD_FUZZERS=ON
    -DALEMBERT_BUILD_VIEWER=OFF)
run(${CMAKE_COMMAND} --build ${BUILD} --target alembert fuzz_load test_support test_symbolic test_differentiation test_mechanism test_program test_dynamics
    test_emit test_emitted test_batch test_cli test_runtime test_generated)
set(ENV{UBSAN_OPTIONS} print_stacktrace=1)
set(ENV{ASAN_OPTIONS} strict_string_checks=1:detect_stack_use_after_return=1)
# Rooms whose programs were not built have no tests here, but a test called so.
run(${CMAKE_CTEST_COMMAND} --test-dir ${BUILD} -j2 --output-on-failure --no-tests=error
    -E "_NOT_BUILT$|^dynamics\\.(Random|Seeds)|^consumer|^golden|^paper\\.|^oracles|[Mm]illion|formatting|layering|upper_body|train|scapula|ellipsoids")
