# A chain that breaks in two and is caught again: three mechanisms generated beforehand.
set(topology_libraries)
foreach(name chain_whole chain_upper chain_lower)
  alembert_add_mechanism(TARGET topology_${name} MECHANISM ${PROJECT_SOURCE_DIR}/mechanisms/paper/${name}.yaml SCALARS double PARTS 1
                         FUNCTIONS mass_matrix_and_bias coordinate_rates energy body_poses body_jacobians body_inertias)
  list(APPEND topology_libraries topology_${name})
endforeach()
alembert_test(paper_topology SOURCES breaking_chain_test.cpp LINK ${topology_libraries} alembert::runtime)
