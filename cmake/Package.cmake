# What a package says of itself, asked when cpack makes it: from which commit, and by whom.
function(ask result)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR}
    OUTPUT_VARIABLE text ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

# Before a release a package is older than the release's, and later commits make newer packages.
ask(tags git tag --points-at HEAD)
ask(commit git show --no-patch --format=%cd.%h --date=format:%Y%m%d%H%M)
if(commit AND NOT tags MATCHES "v${CPACK_PACKAGE_VERSION}")
  set(CPACK_DEBIAN_PACKAGE_VERSION "${CPACK_PACKAGE_VERSION}~git${commit}")
endif()

# As Debian's own tools have it: these two variables, else who works here.
set(name "$ENV{DEBFULLNAME}")
set(address "$ENV{DEBEMAIL}")
if(NOT name)
  ask(name git config user.name)
endif()
if(NOT address)
  ask(address git config user.email)
endif()
if(NOT name)
  ask(name id --user --name)
endif()
if(NOT address)
  ask(user id --user --name)
  cmake_host_system_information(RESULT host QUERY HOSTNAME)
  set(address "${user}@${host}")
endif()
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${name} <${address}>")
