# The example's arm.yaml is what importing its arm.urdf gives:  cmake -DALEMBERT=COMMAND -DEXAMPLE=FOLDER -DWORK=SCRATCH -P check_import.cmake
execute_process(COMMAND ${ALEMBERT} import ${EXAMPLE}/arm.urdf --out ${WORK}/imported.yaml COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${WORK}/imported.yaml ${EXAMPLE}/arm.yaml RESULT_VARIABLE different)
if(different)
  message(FATAL_ERROR "arm.yaml is not what `alembert import arm.urdf` writes: run it again")
endif()
