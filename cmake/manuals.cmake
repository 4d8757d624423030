# Manual pages and completions, written by the programs themselves from the tables that --help prints.
set(folder ${CMAKE_BINARY_DIR}/manuals)
set(made)
foreach(program tilemend tilemend-coordinator tilemend-worker)
  set(page ${folder}/man/${program}.1)
  set(bash ${folder}/bash/${program})
  set(zsh ${folder}/zsh/_${program})
  add_custom_command(OUTPUT ${page}.gz ${bash} ${zsh}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}/man ${folder}/bash ${folder}/zsh
    COMMAND $<TARGET_FILE:${program}> --describe man > ${page}
    COMMAND gzip -9nf ${page}
    COMMAND $<TARGET_FILE:${program}> --describe bash > ${bash}
    COMMAND $<TARGET_FILE:${program}> --describe zsh > ${zsh}
    DEPENDS ${program}
    COMMENT "manual of ${program}"
    VERBATIM)
  list(APPEND made ${page}.gz)
  install(FILES ${page}.gz DESTINATION share/man/man1)
  install(FILES ${bash} DESTINATION share/bash-completion/completions)
  install(FILES ${zsh} DESTINATION share/zsh/vendor-completions)
endforeach()
add_custom_target(tilemend_manuals ALL DEPENDS ${made})
