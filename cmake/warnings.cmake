# alembert_warnings(TARGET): the warnings every target of this project is built with.
function(alembert_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                         # gcc 12 sees overlapping copies in "text" + string at -O3 that are none (GCC bug 105651)
                         $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
                         -Werror=switch-enum -Werror=return-type $<$<BOOL:${ALEMBERT_WERROR}>:-Werror>)
  if(ALEMBERT_SANITIZE)
    # gcc 12 to 14 then see uninitialised values in <regex> that are none (GCC bug 105616)
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  endif()
endfunction()
