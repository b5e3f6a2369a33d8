# alembert_install_if_built(TARGET COMPONENT): the install rules of this folder that follow hold only if the target is there when
# `cmake --install` runs. Each folder has an install script of its own, which ends early.
set(ALEMBERT_PACKAGE_FOLDER ${CMAKE_INSTALL_LIBDIR}/cmake/alembert)
function(alembert_install_if_built target component)
  install(CODE "if(NOT EXISTS \"$<TARGET_FILE:${target}>\")
    message(STATUS \"Not built, not installed: ${target}\")
    return()
  endif()" COMPONENT ${component})
endfunction()
