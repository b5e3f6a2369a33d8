# Turns text files into one C++ source of string literals, so that the generator finds its templates wherever it is.
# So it does the headers of the runtime that generated code needs.
#   cmake -DOUTPUT=FILE -DDIRECTORY=DIR -DHEADERS=FILE,FILE... -P embed_templates.cmake
file(GLOB names RELATIVE ${DIRECTORY} ${DIRECTORY}/*.in)
list(SORT names)
set(text "// Written by cmake/embed_templates.cmake from templates/.
#include \"emit/text_template.hpp\"

#include \"support/error.hpp\"

namespace alembert {

std::string_view template_text(std::string_view name) {\n")
function(embed key file)
  file(READ ${file} content)
  set(text "${text}  if (name == \"${key}\") return R\"~~~~(${content})~~~~\";\n" PARENT_SCOPE)
endfunction()
foreach(name IN LISTS names)
  string(REGEX REPLACE "\\.in$" "" key "${name}")
  embed("${key}" ${DIRECTORY}/${name})
endforeach()
string(REPLACE "," ";" HEADERS "${HEADERS}")
foreach(header IN LISTS HEADERS)
  get_filename_component(name ${header} NAME)
  embed("alembert/${name}" ${header})
endforeach()
string(APPEND text "  throw InternalError(\"there is no template \" + std::string(name));
}

}  // namespace alembert
")
file(WRITE ${OUTPUT} "${text}")
