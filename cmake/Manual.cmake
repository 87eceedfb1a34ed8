# Installs the man page and the completions, as the program prints them from the definition of its command line.
# `program` is what is called; they go into the folders `man` and `share`.
execute_process(COMMAND mktemp -d OUTPUT_VARIABLE made OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)

macro(mpmvv_install file folder)  # no function, in which file(INSTALL) would not reach the list of what is installed
  execute_process(${ARGN} OUTPUT_FILE ${made}/${file} COMMAND_ERROR_IS_FATAL ANY)
  set(place ${folder})
  cmake_path(ABSOLUTE_PATH place BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX})
  file(INSTALL ${made}/${file} DESTINATION ${place})
endmacro()

set(zsh site-functions)
if(CMAKE_INSTALL_PREFIX MATCHES "/usr$")  # where Debian's zsh looks for what packages bring
  set(zsh vendor-completions)
endif()
mpmvv_install(mpmvv.1.gz ${man}/man1 COMMAND ${program} man COMMAND gzip -9n)
mpmvv_install(mpmvv ${share}/bash-completion/completions COMMAND ${program} completion bash)
mpmvv_install(_mpmvv ${share}/zsh/${zsh} COMMAND ${program} completion zsh)
mpmvv_install(mpmvv.fish ${share}/fish/vendor_completions.d COMMAND ${program} completion fish)
file(REMOVE_RECURSE ${made})
