# alembert_warnings(TARGET): the warnings that every target of this project is built with, by compiler.
function(alembert_warnings target)
  set(gnu_like $<CXX_COMPILER_ID:GNU,Clang,AppleClang>)
  target_compile_options(${target} PRIVATE
    "$<${gnu_like}:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion;-Wno-sign-conversion>"
    # gcc 12 sees overlapping copies in "text" + string at -O3 that are none (GCC bug 105651)
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    "$<${gnu_like}:-Werror=switch-enum;-Werror=return-type>"
    "$<$<CXX_COMPILER_ID:MSVC>:/W4;/permissive-;/utf-8;/bigobj;/we4062>")
  if(ALEMBERT_WERROR)
    target_compile_options(${target} PRIVATE $<${gnu_like}:-Werror> $<$<CXX_COMPILER_ID:MSVC>:/WX>)
  endif()
  if(ALEMBERT_SANITIZE)
    # gcc 12 to 14 then see uninitialised values in <regex> that are none (GCC bug 105616)
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  endif()
endfunction()
