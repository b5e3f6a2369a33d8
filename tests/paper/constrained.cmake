# Mechanisms with constraints, generated and compiled here; each for what the tests need of it.
set(constrained_libraries)
foreach(name rolling_ellipsoids rolling_disc rolling_ball chaplygin_sleigh rattleback five_bar stewart)
  list(APPEND constrained_files ${PROJECT_SOURCE_DIR}/mechanisms/paper/${name}.yaml)
endforeach()
foreach(name weight five_bar_in_space contradiction out_of_reach)
  list(APPEND constrained_files ${CMAKE_CURRENT_SOURCE_DIR}/constrained/${name}.yaml)
endforeach()
foreach(file ${constrained_files})
  get_filename_component(name ${file} NAME_WE)
  alembert_add_mechanism(TARGET constrained_${name} MECHANISM ${file} SCALARS double PARTS 1
                         FUNCTIONS mass_matrix_and_bias coordinate_rates constraints energy body_poses)
  list(APPEND constrained_libraries constrained_${name})
endforeach()
alembert_test(paper_constrained
  SOURCES constrained_closed_form_test.cpp constrained_drift_test.cpp constrained_loops_test.cpp
  LINK ${constrained_libraries} alembert::runtime SLOW "Loops.*:Drift.*")
