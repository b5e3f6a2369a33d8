# Everything comes from the system's packages; the README names them.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
if(ALEMBERT_BUILD_GENERATOR)
  find_package(fmt REQUIRED)
  find_package(CLI11 REQUIRED)
  find_package(yaml-cpp REQUIRED)
  find_package(pegtl REQUIRED)
  find_package(pugixml REQUIRED)
  find_package(nlohmann_json REQUIRED)
  find_package(Boost REQUIRED)  # Multiprecision, headers only, over MPFR
endif()
if(ALEMBERT_BUILD_TESTS)
  find_package(GTest REQUIRED)
endif()
