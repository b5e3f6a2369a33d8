# alembert_warnings(TARGET): the warnings every target of this project is built with.
function(alembert_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                         -Werror=switch-enum -Werror=return-type $<$<BOOL:${ALEMBERT_WERROR}>:-Werror>)
endfunction()
