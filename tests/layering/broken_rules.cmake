# The check of layering fails where a rule is broken: a small tree that keeps all rules, then one broken rule at a time.
# Arguments: CHECK (the script), FOLDER (empty or to be emptied).
cmake_minimum_required(VERSION 3.25)

# write_tree(PATH TEXT ...): the tree that keeps the rules, with these files changed or added.
function(write_tree)
  file(REMOVE_RECURSE ${FOLDER})
  set(generator ${FOLDER}/generator)
  file(WRITE ${generator}/CMakeLists.txt "target_link_libraries(alembert PRIVATE alembert_upper)\n")
  file(WRITE ${generator}/lower/CMakeLists.txt "alembert_room(lower SOURCES ground.cpp loft/roof.cpp LINK fmt::fmt FLOORS . loft)\n")
  file(WRITE ${generator}/upper/CMakeLists.txt
       "alembert_room(upper SOURCES door.cpp part.cpp LINK alembert_lower ONLY lower:door PARTS part:door)\n")
  file(WRITE ${generator}/main.cpp "#include \"upper/door.hpp\"\n")
  file(WRITE ${generator}/lower/ground.hpp "struct Ground {\n};\n")
  file(WRITE ${generator}/lower/ground.cpp "#include \"lower/ground.hpp\"\n")
  file(WRITE ${generator}/lower/loft/roof.hpp "#include \"lower/ground.hpp\"\n")
  file(WRITE ${generator}/lower/loft/roof.cpp "#include \"lower/loft/roof.hpp\"\n")
  file(WRITE ${generator}/upper/door.hpp "#include \"lower/ground.hpp\"\n")
  file(WRITE ${generator}/upper/door.cpp "#include \"upper/door.hpp\"\n")
  file(WRITE ${generator}/upper/part.cpp "#include \"upper/door.hpp\"\n")
  file(WRITE ${generator}/README.md
       "| `generator/main.cpp` | it | upper |\n| `generator/upper/` | it | lower |\n| `generator/lower/` | it | |\n")
  file(WRITE ${FOLDER}/src/run.hpp "#include <vector>\n")
  while(ARGN)
    list(POP_FRONT ARGN path text)
    file(WRITE ${FOLDER}/${path} "${text}")
  endwhile()
endfunction()

function(check result_variable text_variable)
  execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${FOLDER} -DLEAST=1 -P ${CHECK} RESULT_VARIABLE result OUTPUT_VARIABLE out
                  ERROR_VARIABLE error)
  string(REGEX REPLACE "[ \n]+" " " error "${error}")
  set(${result_variable} ${result} PARENT_SCOPE)
  set(${text_variable} "${out}${error}" PARENT_SCOPE)
endfunction()

# refused(TEXT PATH TEXT ...): the tree with these files is refused, and told why.
function(refused expected)
  write_tree(${ARGN})
  check(result text)
  string(FIND "${text}" "${expected}" place)
  if(result EQUAL 0 OR place LESS 0)
    message(SEND_ERROR "expected to be refused with '${expected}', found ${result}: ${text}")
  endif()
endfunction()

write_tree()
check(result text)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the tree that keeps the rules is refused: ${text}")
endif()
refused("lower may not include upper" generator/lower/ground.hpp "#include \"upper/door.hpp\"\n")
refused("upper may not include lower" generator/upper/part.cpp "#include \"upper/door.hpp\"\n#include \"lower/ground.hpp\"\n")
refused("lower/. may not include lower/loft" generator/lower/ground.cpp
        "#include \"lower/ground.hpp\"\n#include \"lower/loft/roof.hpp\"\n")
refused("cellar is no floor of lower" generator/lower/cellar/pit.hpp "")
refused("no CMakeLists.txt has a room attic" generator/attic/box.hpp "")
refused("there is no generator/lower/alone.hpp" generator/lower/alone.cpp "")
refused("does not include its header" generator/lower/ground.cpp "")
refused("another file is called ground.hpp too" generator/upper/ground.hpp "")
refused("another header defines a type Ground too" generator/upper/door.hpp "#include \"lower/ground.hpp\"\nstruct Ground {\n};\n")
refused("links lower, but includes nothing of it" generator/upper/door.hpp "")
refused("the table says lower" generator/upper/CMakeLists.txt "alembert_room(upper SOURCES door.cpp part.cpp LINK fmt::fmt PARTS part:door)\n"
        generator/upper/door.hpp "")
refused("the table of rooms has no lower" generator/README.md "| `generator/main.cpp` | it | upper |\n| `generator/upper/` | it | lower |\n")
refused("the runtime may include" src/run.hpp "#include \"upper/door.hpp\"\n")
file(REMOVE_RECURSE ${FOLDER})
