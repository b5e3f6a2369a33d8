# Fails if clang-format would change a file that people write. Run as `cmake -DROOT=... -DCLANG_FORMAT=... -P check_formatting.cmake`.
file(GLOB_RECURSE files ${ROOT}/generator/*.cpp ${ROOT}/generator/*.hpp ${ROOT}/src/*.hpp ${ROOT}/tests/*.cpp ${ROOT}/tests/*.hpp
     ${ROOT}/mechanisms/examples/*.cpp)
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${files} RESULT_VARIABLE result ERROR_VARIABLE errors)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "these places are not formatted (clang-format -i mends them):\n${errors}")
endif()
