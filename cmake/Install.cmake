# What `cmake --install` puts where, and the Debian package. The program finds its study files and goldens from its own
# place (cli/shipped.cpp): PREFIX/bin beside PREFIX/share/mpmvv. Its man page and completions are made when it is
# installed and not when it is built, as not every machine that builds it can run it.
include(GNUInstallDirs)

set(mpmvv_data ${CMAKE_INSTALL_DATAROOTDIR}/mpmvv)

install(TARGETS mpmvv)
if(NOT CMAKE_CROSSCOMPILING OR CMAKE_CROSSCOMPILING_EMULATOR)
  install(CODE "
    set(program ${CMAKE_CROSSCOMPILING_EMULATOR} \"$<TARGET_FILE:mpmvv>\")
    set(man \"${CMAKE_INSTALL_MANDIR}\")
    set(share \"${CMAKE_INSTALL_DATAROOTDIR}\")")
  install(SCRIPT cmake/Manual.cmake)
endif()

file(GLOB mpmvv_studies CONFIGURE_DEPENDS studies/*.toml)
file(GLOB mpmvv_goldens CONFIGURE_DEPENDS goldens/*.toml)
install(FILES ${mpmvv_studies} studies/quick.txt studies/cost.txt DESTINATION ${mpmvv_data}/studies)
install(FILES ${mpmvv_goldens} DESTINATION ${mpmvv_data}/goldens)
install(FILES tests/mutation/summary.json tests/mutation/alarms.toml DESTINATION ${mpmvv_data}/tests/mutation)
install(DIRECTORY adapters DESTINATION ${mpmvv_data} USE_SOURCE_PERMISSIONS)
install(PROGRAMS tests/codes/small_mpm.py DESTINATION ${mpmvv_data}/tests/codes)  # where its adapter looks for it
install(FILES README.md CHANGELOG.md CONTRIBUTING.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR})

if(mpmvv_flags_in_space AND CMAKE_BUILD_TYPE STREQUAL "Release")
  set(mpmvv_processors "It needs a processor with AVX-512.")
elseif(mpmvv_arch_flag STREQUAL "-march=x86-64-v3")
  set(mpmvv_processors "It needs a processor with AVX2 and FMA (x86-64-v3).")
elseif(mpmvv_arch_flag AND NOT mpmvv_arch_flag STREQUAL "-march=x86-64")
  set(mpmvv_processors "It is built with ${mpmvv_arch_flag}.")
else()
  set(mpmvv_processors "It runs on every processor of its architecture.")
endif()
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/Package.cmake)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "gnuplot-nox | gnuplot")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "latexmk, texlive-latex-recommended")  # for what `mpmvv paper` writes
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "\
Runs a solver of the Material Point Method against manufactured solutions,
fits the orders and stability limits that it shows, judges what papers claim
of its methods, and holds the results of every version against reviewed ones.
${mpmvv_processors}")
include(CPack)
