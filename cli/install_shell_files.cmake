# Installs man pages and completions, which the command writes of itself: so that they say what
# `--help` does. A build for another machine has none.
if(NOT CMAKE_CROSSCOMPILING)
  install(CODE "
    set(plastica \"$<TARGET_FILE:plastica_cli>\")
    set(share \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATAROOTDIR}\")
    set(mans \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1\")
    foreach(folder \${mans} \${share}/bash-completion/completions
        \${share}/zsh/vendor-completions \${share}/fish/vendor_completions.d)
      file(MAKE_DIRECTORY \${folder})
    endforeach()
    execute_process(COMMAND \${plastica} man --all-to \${mans} COMMAND_ERROR_IS_FATAL ANY)
    foreach(pair bash=bash-completion/completions/plastica zsh=zsh/vendor-completions/_plastica
        fish=fish/vendor_completions.d/plastica.fish)
      string(REGEX MATCH \"^[a-z]+\" shell \${pair})
      string(REGEX REPLACE \"^[a-z]+=\" \"\" file \${pair})
      execute_process(COMMAND \${plastica} completion \${shell}
        OUTPUT_FILE \${share}/\${file} COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
    # As Debian wants them, with the same bytes from every build.
    find_program(gzip gzip)
    if(gzip)
      file(GLOB pages \${mans}/plastica*.1)
      execute_process(COMMAND \${gzip} -9nf \${pages} COMMAND_ERROR_IS_FATAL ANY)
    endif()
  ")
endif()
