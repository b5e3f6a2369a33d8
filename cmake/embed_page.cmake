# Turns the page of templates/viewer/, with script and style put in, into a C++ source of string literals.
#   cmake -DOUTPUT=FILE [-DPAGE=page.html -DSCRIPT=main.js -DSTYLE=main.css] -P embed_page.cmake
# Without a page the source says that there is none.
cmake_minimum_required(VERSION 3.25)
set(page "")
if(PAGE)
  file(READ ${PAGE} page)
  file(READ ${SCRIPT} script)
  file(READ ${STYLE} style)
  if(script MATCHES "</[sS][cC][rR][iI][pP][tT]")
    message(FATAL_ERROR "the script contains the end of its own element")
  endif()
  string(REPLACE "@style@" "${style}" page "${page}")
  string(REPLACE "@script@" "${script}" page "${page}")
endif()
set(text "// Written by cmake/embed_page.cmake from templates/viewer/.
#include \"viewer/page.hpp\"

namespace alembert {

std::string page_template() {
  std::string page;\n")
# Compilers need not take literals over 65536 bytes.
string(LENGTH "${page}" length)
set(at 0)
while(at LESS length)
  string(SUBSTRING "${page}" ${at} 60000 piece)
  string(APPEND text "  page += R\"~~~~(${piece})~~~~\";\n")
  math(EXPR at "${at} + 60000")
endwhile()
string(APPEND text "  return page;\n}\n\n}  // namespace alembert\n")
file(WRITE ${OUTPUT} "${text}")
