# Turns text files into one C++ source of string literals, so that the generator finds its templates wherever it is.
#   cmake -DOUTPUT=FILE -DDIRECTORY=DIR -P embed_templates.cmake
file(GLOB names RELATIVE ${DIRECTORY} ${DIRECTORY}/*.in)
list(SORT names)
set(text "// Written by cmake/embed_templates.cmake from templates/.
#include \"emit/text_template.hpp\"

#include \"support/error.hpp\"

namespace alembert {

std::string_view template_text(std::string_view name) {\n")
foreach(name IN LISTS names)
  file(READ ${DIRECTORY}/${name} content)
  string(REGEX REPLACE "\\.in$" "" key "${name}")
  string(APPEND text "  if (name == \"${key}\") return R\"~~~~(${content})~~~~\";\n")
endforeach()
string(APPEND text "  throw InternalError(\"there is no template \" + std::string(name));
}

}  // namespace alembert
")
file(WRITE ${OUTPUT} "${text}")
