# Run by `cmake -P` with SOURCE_DIR, BINARY_DIR, HEADER, COMPILER, BUILD_TYPE, FLAGS, TUNING (a part of FLAGS) and
# FLAGS_IN_SPACE: writes HEADER.

# Flags that decide the code: no warnings, no folder names, nothing of the compiler's memory.
string(REPLACE "${BINARY_DIR}" "<build>" FLAGS "${FLAGS}")
string(REPLACE "${SOURCE_DIR}" "<source>" FLAGS "${FLAGS}")
string(REGEX REPLACE "(^| )(-W|--param=ggc-)[^ ]*" "" FLAGS "${FLAGS}")
string(REGEX REPLACE " +" " " FLAGS "${FLAGS}")
string(STRIP "${FLAGS}" FLAGS)

# The folders whose sources decide a result: solutions and solver; what a case is, of which problem and by which
# settings; what carries it out and measures it, our solver or another code; and the checks. From the other folders
# these use only what keeps and words things, and the mean of repeated costs (studies/fits/paired_rounds.hpp).
set(sources "")
foreach(folder mms solver studies/cases studies/checks studies/codes studies/problems studies/runs studies/settings)
  file(GLOB_RECURSE more RELATIVE "${SOURCE_DIR}" "${SOURCE_DIR}/${folder}/*.?pp")
  list(APPEND sources ${more})
endforeach()
list(SORT sources)

# The code of a C++ source: a comment, an empty line and indentation decide nothing. A line with a quotation mark before
# its comment stays whole, because there `//` may be part of a text. So does a source with a raw text, a `/* */`
# comment or a line that the next one continues.
function(code_of source result)
  file(READ "${source}" text)
  if(NOT text MATCHES "R\"|/[*]|\\\\\n")
    string(REGEX REPLACE "(\n([^\"/\n]|/[^\"/\n])*)//[^\n]*" "\\1" text "\n${text}")
    string(REGEX REPLACE "[ \t]*\n[ \t\n]*" "\n" text "${text}")
  endif()
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

# Neither the tuning nor the flags in space are part of the digest: they change no bit of a result.
string(REPLACE " ${TUNING} " " " deciding_flags "${FLAGS}")
set(summary "compiler ${COMPILER}\nbuild type ${BUILD_TYPE}\nflags ${deciding_flags}\n")
foreach(source IN LISTS sources)
  code_of("${SOURCE_DIR}/${source}" code)
  string(SHA256 hash "${code}")
  string(APPEND summary "${hash} ${source}\n")
endforeach()
string(SHA256 DIGEST "${summary}")
if(FLAGS_IN_SPACE)
  string(APPEND FLAGS ", in space ${FLAGS_IN_SPACE}")
endif()

# Asks git about SOURCE_DIR; `succeeded` is false outside a checkout, without a commit and without git.
function(git succeeded output)
  execute_process(COMMAND git --no-optional-locks ${ARGN} WORKING_DIRECTORY "${SOURCE_DIR}"
    RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  string(COMPARE EQUAL "${code}" "0" success)
  set(${succeeded} ${success} PARENT_SCOPE)
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

set(COMMIT unknown)
set(DIRTY false)
git(in_checkout prefix rev-parse --show-prefix)
if(in_checkout AND prefix STREQUAL "")  # a copy of the tree inside another project's checkout has no commit of its own
  git(has_commit commit rev-parse --verify --quiet HEAD)
  if(has_commit)
    set(COMMIT ${commit})
  endif()
  git(known changes status --porcelain --untracked-files=normal)
  if(changes)
    set(DIRTY true)
  endif()
endif()

file(CONFIGURE OUTPUT "${HEADER}" @ONLY CONTENT [[
#pragma once

namespace mpmvv::build_info {

inline constexpr char digest[] = "@DIGEST@";
inline constexpr char commit[] = "@COMMIT@";
inline constexpr bool dirty = @DIRTY@;
inline constexpr char compiler[] = "@COMPILER@";
inline constexpr char flags[] = R"flags(@FLAGS@)flags";
inline constexpr char build_type[] = "@BUILD_TYPE@";

}  // namespace mpmvv::build_info
]])
