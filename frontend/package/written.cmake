# Runs while files are installed: what the program writes about itself goes where the system looks for it.
# Given: RUNGPROOF, DATA_DIR and MAN_DIR; CMAKE_INSTALL_PREFIX and DESTDIR as for every install.
set(data $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/${DATA_DIR})
set(man $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/${MAN_DIR}/man1)
# The folder that zsh of Debian searches for packages; zsh of others, and /usr/local, the usual one.
set(zsh site-functions)
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(zsh vendor-completions)
endif()

function(written)
  execute_process(COMMAND ${RUNGPROOF} ${ARGN} RESULT_VARIABLE result ERROR_VARIABLE error)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "rungproof ${ARGN}: ${error}")
  endif()
endfunction()

function(completion shell file)
  get_filename_component(folder ${file} DIRECTORY)
  file(MAKE_DIRECTORY ${folder})
  execute_process(COMMAND ${RUNGPROOF} completion ${shell} OUTPUT_FILE ${file} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "rungproof completion ${shell} failed")
  endif()
  message(STATUS "Installing: ${file}")
endfunction()

completion(bash ${data}/bash-completion/completions/rungproof)
completion(zsh ${data}/zsh/${zsh}/_rungproof)
completion(fish ${data}/fish/vendor_completions.d/rungproof.fish)

message(STATUS "Installing: ${man}")
written(guide --man -o ${man} --isolated)
find_program(GZIP gzip)
file(GLOB pages ${man}/rungproof*.1)
if(GZIP)
  execute_process(COMMAND ${GZIP} -9nf ${pages})
endif()

message(STATUS "Installing: ${data}/doc/rungproof/guide")
written(guide -o ${data}/doc/rungproof/guide --isolated)
