# Mechanisms without constraints, through the command: states and poses are what it prints.
find_package(Python3 COMPONENTS Interpreter)
if(Python3_FOUND)
  set(chains chains_test.cpp)
else()
  message(STATUS "No python3: descriptions that scripts write are not compared with the scripts")
endif()
alembert_test(paper SOURCES minute_test.cpp closure_test.cpp rolling_wheels_test.cpp frenet_test.cpp ${chains}
              LINK alembert_oracles nlohmann_json::nlohmann_json Eigen3::Eigen SLOW "*" COST 10)
target_compile_definitions(test_paper PRIVATE ALEMBERT_EXECUTABLE="$<TARGET_FILE:alembert>" ALEMBERT_PYTHON="${Python3_EXECUTABLE}")
add_dependencies(test_paper alembert)
