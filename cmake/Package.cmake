# From which commit a package is and who made it, found out when cpack makes it, which sets no policies.
cmake_policy(VERSION 3.25)

function(ask result)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${CMAKE_CURRENT_LIST_DIR}
    OUTPUT_VARIABLE text ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

# A package made before a release counts as older than the release's, and one of a later commit as newer than one of an
# earlier.
ask(tags git tag --points-at HEAD)
ask(top git rev-parse --show-prefix)
ask(commit env TZ=UTC git show --no-patch --format=%cd.%h --date=format-local:%Y%m%d%H%M)
string(REPLACE "\n" ";" tags "${tags}")
if(commit AND top STREQUAL "cmake/" AND NOT "v${CPACK_PACKAGE_VERSION}" IN_LIST tags)
  set(CPACK_DEBIAN_PACKAGE_VERSION "${CPACK_PACKAGE_VERSION}~git${commit}")
endif()

# The maintainer: these two variables, which Debian's own tools read, else git's user, else who works here.
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
