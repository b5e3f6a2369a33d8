# The page of `simulate --html`: three.js from npm, pinned by a lock file, and templates/viewer/ are bundled by esbuild into one
# text that is compiled in. Sets ALEMBERT_VIEWER_PAGE_SOURCE, the C++ source that holds it, and ALEMBERT_HAS_VIEWER_PAGE.
#
# ALEMBERT_BUILD_VIEWER: AUTO bundles if npm and its registry can be reached; ON makes their absence an error; OFF leaves
# the page out, and --html then says so. The packages are fetched when the build is configured, once for each lock file.
set(web ${PROJECT_SOURCE_DIR}/templates/viewer)
set(folder ${PROJECT_BINARY_DIR}/viewer)
set(ALEMBERT_HAS_VIEWER_PAGE OFF CACHE INTERNAL "")

# alembert_npm_packages(FOLDER FROM dir RESULT variable): the packages of FROM's lock file in FOLDER/node_modules; RESULT is
# empty, or what is wrong.
function(alembert_npm_packages folder)
  cmake_parse_arguments(NPM "" "FROM;RESULT" "" ${ARGN})
  set(${NPM_RESULT} "" PARENT_SCOPE)
  find_program(ALEMBERT_NPM npm)
  mark_as_advanced(ALEMBERT_NPM)
  if(NOT ALEMBERT_NPM)
    set(${NPM_RESULT} "npm is not installed (Debian: apt-get install npm)" PARENT_SCOPE)
    return()
  endif()
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${NPM_FROM}/package-lock.json)
  file(SHA256 ${NPM_FROM}/package-lock.json wanted)
  set(stamp ${folder}/packages.sha256)
  if(EXISTS ${stamp})
    file(READ ${stamp} present)
    if(present STREQUAL wanted)
      return()
    endif()
  endif()
  file(COPY ${NPM_FROM}/package.json ${NPM_FROM}/package-lock.json DESTINATION ${folder})
  message(STATUS "Fetching the packages of ${NPM_FROM}/package-lock.json")
  execute_process(COMMAND ${ALEMBERT_NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline WORKING_DIRECTORY ${folder}
                  RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE errors TIMEOUT 300)
  if(NOT result EQUAL 0)
    set(${NPM_RESULT} "npm ci failed: ${errors}" PARENT_SCOPE)
    return()
  endif()
  file(WRITE ${stamp} ${wanted})
endfunction()

if(ALEMBERT_BUILD_VIEWER)
  alembert_npm_packages(${folder} FROM ${web} RESULT problem)
  if(problem AND ALEMBERT_BUILD_VIEWER STREQUAL AUTO)
    message(STATUS "Without the page of `simulate --html`: ${problem}")
  elseif(problem)
    message(FATAL_ERROR "ALEMBERT_BUILD_VIEWER is ON, but ${problem}")
  else()
    set(ALEMBERT_HAS_VIEWER_PAGE ON CACHE INTERNAL "")
  endif()
endif()

set(ALEMBERT_VIEWER_PAGE_SOURCE ${CMAKE_CURRENT_BINARY_DIR}/page_template.cpp)
set(embed ${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake)
if(ALEMBERT_HAS_VIEWER_PAGE)
  file(GLOB sources CONFIGURE_DEPENDS ${web}/source/*.js ${web}/source/*.css)
  set(bundle ${folder}/bundle)
  # Sources are found in place, three.js beside the copied lock file.
  add_custom_command(OUTPUT ${bundle}/main.js ${bundle}/main.css
    COMMAND ${CMAKE_COMMAND} -E env NODE_PATH=${folder}/node_modules ${folder}/node_modules/.bin/esbuild ${web}/source/main.js --bundle
            --minify --format=iife --target=es2020 --charset=ascii --legal-comments=inline --log-level=warning --outdir=${bundle}
    DEPENDS ${sources} ${folder}/packages.sha256 VERBATIM)
  add_custom_command(OUTPUT ${ALEMBERT_VIEWER_PAGE_SOURCE}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${ALEMBERT_VIEWER_PAGE_SOURCE} -DPAGE=${web}/page.html -DSCRIPT=${bundle}/main.js
            -DSTYLE=${bundle}/main.css -P ${embed}
    DEPENDS ${web}/page.html ${bundle}/main.js ${bundle}/main.css ${embed} VERBATIM)
else()
  add_custom_command(OUTPUT ${ALEMBERT_VIEWER_PAGE_SOURCE}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${ALEMBERT_VIEWER_PAGE_SOURCE} -P ${embed} DEPENDS ${embed} VERBATIM)
endif()
