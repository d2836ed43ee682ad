# Holds the sources to the rules of the architecture: which layer may include which, where each third-party header may
# appear, where threads, processes, randomness and clocks may come from, and which words may not stay.
# Run as: cmake -DROOT=<project> -P include_rule.cmake. Fails with one line "file:line: reason" for each breach.
cmake_minimum_required(VERSION 3.22)

# Who may include whom: <folder of the file>=<folders it may include>; everybody may include assets.
set(layers
  "core/base=core/base"
  "core/mesh=core/(base|mesh)"
  "core/unfold=core/(base|mesh|unfold)"
  "core/solve=core/(base|mesh|unfold|solve)"
  "core/sheet=core/(base|mesh|unfold|sheet)"
  "core/project=core/(base|mesh|unfold|solve|sheet|project)"
  "render=(core/[a-z]+|render)"
  "ui=(core/[a-z]+|render|ui)"
  "app=(core/[a-z]+|render|ui|app)"
  "assets=assets")

# Where a foreign header may appear: <header>=<files>. What is in angle brackets and not in this table is an error.
set(foreign
  "[a-z_]+=.*"
  "glm/.*=.*"
  "(sys/[a-z]+|[a-z]+)[.]h=(core/base/[a-z_]+[.](h|cpp)|core/mesh/read_assimp[.]cpp|app/.*)"
  "[a-z]mmintrin[.]h=core/solve/boxes16[.]cpp"
  "tiny_obj_loader[.]h=core/mesh/read_obj[.]cpp"
  "tiny_gltf[.]h=core/mesh/read_gltf[.]cpp"
  "assimp/.*=core/mesh/read_assimp[.]cpp"
  "Eigen/.*=core/mesh/planarize[.]cpp"
  "(cairo.*|ft2build[.]h|FT_[A-Z_]+|freetype/.*)=core/sheet/write_cairo[.]cpp"
  "qpdf/.*=core/sheet/print_preferences[.]cpp"
  "zip[.]h=core/project/project_file[.]cpp"
  "nlohmann/.*=core/base/json[.](h|cpp)"
  "stb_.*=core/base/image[.]cpp"
  "CLI/.*=app/cli_options[.]cpp"
  "(imgui.*|backends/imgui.*)=(ui/.*|app/(window|application)[a-z_]*[.]cpp)"
  "glad/.*=(render/.*|app/window[a-z_]*[.]cpp)"
  "GLFW/.*=app/.*"
  "EGL/.*=app/window[a-z_]*[.]cpp")

# What code may be written only in some files: <expression>=<where it is watched>=<files that may>=<reason>.
set(words
  "std::j?thread[^:a-z_]=.*=core/base/worker[.](h|cpp)=threads are created in core/base/worker alone"
  "std::async=.*=core/base/worker[.]cpp=threads are created in core/base/worker alone"
  "pthread_create=.*=core/base/worker[.]cpp=threads are created in core/base/worker alone"
  "[^a-z_]v?fork *[(]=.*=core/base/subprocess[.]cpp=child processes are started in core/base/subprocess alone"
  "[^a-z_]exec[lv][a-z]* *[(]=.*=core/base/subprocess[.]cpp=child processes are started in core/base/subprocess alone"
  "posix_spawn=.*=core/base/subprocess[.]cpp=child processes are started in core/base/subprocess alone"
  "[^a-z_](popen|system) *[(]=.*=core/base/subprocess[.]cpp=child processes are started in core/base/subprocess alone"
  "[^a-z_]s?rand *[(]=.*=none=random numbers come from core/base/random.h, seeded"
  "std::random_device=core/.*=none=random numbers come from core/base/random.h, seeded"
  "std::chrono::[a-z_]*_clock=core/solve/.*=none=the search never asks the clock, so that a seed gives one net")

# breach(FILE TEXT OFFSET REASON): notes a breach at this offset of the file's text.
function(breach file text offset reason)
  string(SUBSTRING "${text}" 0 ${offset} before)
  string(REGEX REPLACE "[^\n]" "" before "${before}")
  string(LENGTH "${before}" line)
  math(EXPR line "${line} + 1")
  set_property(GLOBAL APPEND_STRING PROPERTY breaches "${file}:${line}: ${reason}\n")
endfunction()

function(check_own_include file text line header)
  string(FIND "${text}" "${line}" at)
  if(NOT header MATCHES "^(core/[a-z]+|render|ui|app|assets)/")
    breach("${file}" "${text}" ${at} "includes are written from the root, unlike \"${header}\"")
    return()
  endif()
  foreach(rule IN LISTS layers)
    string(REPLACE "=" ";" rule "${rule}")
    list(GET rule 0 folder)
    list(GET rule 1 allowed)
    if(file MATCHES "^${folder}/")
      if(NOT header MATCHES "^(${allowed}|assets)/")
        breach("${file}" "${text}" ${at} "this folder may not include \"${header}\"")
      endif()
      return()
    endif()
  endforeach()
  breach("${file}" "${text}" ${at} "this folder has no layer in tests/include_rule.cmake")
endfunction()

function(check_foreign_include file text line header)
  set(reason "<${header}> is on no list of tests/include_rule.cmake")
  foreach(rule IN LISTS foreign)
    string(REPLACE "=" ";" rule "${rule}")
    list(GET rule 0 headers)
    list(GET rule 1 files)
    if(header MATCHES "^${headers}$")
      if(file MATCHES "^${files}$")
        return()
      endif()
      set(reason "<${header}> may not appear in this file")
    endif()
  endforeach()
  string(FIND "${text}" "${line}" at)
  breach("${file}" "${text}" ${at} "${reason}")
endfunction()

function(check_includes file text)
  string(REGEX MATCHALL "#include[^\n]*" lines "${text}")
  foreach(line IN LISTS lines)
    if(line MATCHES "^#include \"([^\"]+)\"")
      check_own_include("${file}" "${text}" "${line}" "${CMAKE_MATCH_1}")
    elseif(line MATCHES "^#include <([^>]+)>")
      check_foreign_include("${file}" "${text}" "${line}" "${CMAKE_MATCH_1}")
    elseif(line MATCHES "^#include +([A-Z_]+)")
      check_foreign_include("${file}" "${text}" "${line}" "${CMAKE_MATCH_1}")
    endif()
  endforeach()
endfunction()

function(check_words file text)
  foreach(rule IN LISTS words)
    string(REPLACE "=" ";" rule "${rule}")
    list(GET rule 0 expression)
    list(GET rule 1 watched)
    list(GET rule 2 allowed)
    list(GET rule 3 reason)
    if(NOT file MATCHES "^${watched}$" OR file MATCHES "^${allowed}$")
      continue()
    endif()
    if(text MATCHES "${expression}")
      # The match may begin with the end of the line before, so the sign after its first one tells the line.
      string(FIND "${text}" "${CMAKE_MATCH_0}" at)
      math(EXPR at "${at} + 1")
      breach("${file}" "${text}" ${at} "${reason}")
    endif()
  endforeach()
endfunction()

function(check_unfinished file text)
  if("\n${text}\n" MATCHES "[^A-Za-z0-9_]((TODO|FIXME|XXX|HACK)[^A-Za-z0-9_])")
    set(word "${CMAKE_MATCH_2}")
    string(FIND "${text}" "${CMAKE_MATCH_1}" at)
    breach("${file}" "${text}" ${at} "${word} is an issue to file, not a comment to keep")
  endif()
endfunction()

file(GLOB_RECURSE files RELATIVE "${ROOT}"
  "${ROOT}/app/*" "${ROOT}/assets/*.h" "${ROOT}/assets/*.in" "${ROOT}/core/*" "${ROOT}/render/*" "${ROOT}/ui/*"
  "${ROOT}/shaders/*" "${ROOT}/tests/*.h" "${ROOT}/tests/*.cpp")
list(LENGTH files count)
if(count EQUAL 0)
  message(FATAL_ERROR "no sources below ${ROOT}")
endif()
foreach(file IN LISTS files)
  file(READ "${ROOT}/${file}" text)
  # These signs mean something to CMake's lists, and nothing to any rule.
  string(REPLACE ";" "," text "${text}")
  string(REPLACE "[" "(" text "${text}")
  string(REPLACE "]" ")" text "${text}")
  string(REPLACE "\\" "/" text "${text}")
  check_unfinished("${file}" "${text}")
  if(file MATCHES "[.](h|cpp|in)$" AND NOT file MATCHES "^tests/")
    check_includes("${file}" "${text}")
    string(REGEX REPLACE "//[^\n]*" "" code "${text}")
    check_words("${file}" "${code}")
  endif()
endforeach()

get_property(breaches GLOBAL PROPERTY breaches)
if(breaches)
  message(FATAL_ERROR "${breaches}")
endif()
message(STATUS "${count} files keep the rules")
