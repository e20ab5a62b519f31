# Installs Plinian into a folder of its own, builds a program of somebody else against it, and runs both from
# there: cmake -DBUILD=... -DSOURCE=... -DWORK=... -P install_test.cmake
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGV}\nended with ${code}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# Builds an example without a warning, neither of the compiler nor of the assembler.
function(build folder)
  run(${CMAKE_COMMAND} --build ${folder})
  if(output MATCHES "[Ww]arning")
    message(FATAL_ERROR "${folder} is built with warnings:\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first)
# A tree that is moved after its installation still works: nothing in it may point to where it was.
file(RENAME ${WORK}/first ${WORK}/prefix)

run(${CMAKE_COMMAND} -S ${SOURCE}/tests/install/consumer -B ${WORK}/consumer -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${WORK}/prefix ${CONSUMER_OPTIONS})
run(${CMAKE_COMMAND} --build ${WORK}/consumer)
run(${WORK}/consumer/consumer)

# A plug-in, built as anyone's who wants to hear of everything, also of fields that are left out.
set(strict "-Wall -Wextra -Wpedantic -Werror")
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/install/plugin -B ${WORK}/plugin -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${WORK}/prefix "-DCMAKE_CXX_FLAGS=${strict}")
build(${WORK}/plugin)
find_program(clang clang++)
if(clang)
  run(${CMAKE_COMMAND} -S ${SOURCE}/tests/install/plugin -B ${WORK}/plugin_clang -G Ninja -DCMAKE_BUILD_TYPE=Release
      -DCMAKE_PREFIX_PATH=${WORK}/prefix -DCMAKE_CXX_COMPILER=${clang} "-DCMAKE_CXX_FLAGS=${strict}")
  build(${WORK}/plugin_clang)
  file(WRITE ${WORK}/clang.pln "pluginInfo ${WORK}/plugin_clang/outside.so\n")
  run(${WORK}/prefix/bin/plinian run ${WORK}/clang.pln)
endif()

# The examples, from the installation and by the lines of its README; they answer what stands there.
set(examples ${WORK}/prefix/share/plinian/examples)
file(READ ${WORK}/prefix/share/doc/plinian/README.md readme)
if(NOT readme MATCHES "```sh\nprefix=[^\n]*\n([^`]*)```\n+```text\n([^`]*)```")
  message(FATAL_ERROR "the README does not say how its examples are built")
endif()
set(lines "${CMAKE_MATCH_1}")
set(answers "${CMAKE_MATCH_2}")
file(WRITE ${WORK}/readme.sh "prefix=${WORK}/prefix\n${lines}")
file(MAKE_DIRECTORY ${WORK}/author)
execute_process(COMMAND ${CMAKE_COMMAND} -E env "CXXFLAGS=${strict}" sh -ex ${WORK}/readme.sh
                WORKING_DIRECTORY ${WORK}/author
                RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE errors)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "the README's lines ended with ${code}:\n${output}\n${errors}")
endif()
string(FIND "${output}" "${answers}" at)
if(at EQUAL -1)
  message(FATAL_ERROR "the README's lines do not answer\n${answers}\nbut\n${output}")
endif()
if(NOT EXISTS ${WORK}/author/puff.png)
  message(FATAL_ERROR "the README's lines made no picture:\n${output}\n${errors}")
endif()
if("${output}${errors}" MATCHES "[Ww]arning: setting")
  message(FATAL_ERROR "the examples are built with warnings:\n${output}\n${errors}")
endif()
string(REGEX MATCHALL "\\([^() ]+[.]png\\)" pictures "${readme}")
list(LENGTH pictures count)
if(count LESS 5)
  message(FATAL_ERROR "the README shows ${count} pictures")
endif()
foreach(picture ${pictures})
  string(REGEX REPLACE "[()]" "" picture "${picture}")
  if(NOT EXISTS ${WORK}/prefix/share/doc/plinian/${picture})
    message(FATAL_ERROR "the README shows ${picture}, which is not installed")
  endif()
endforeach()
# A scene of an older version of a type, migrated.
file(WRITE ${WORK}/old.plinian "plinian scene 1.0
requires places 1.0
node spread s
  .diameter 7
type spread 1 from places 1.0
  .diameter 2
end
")
file(WRITE ${WORK}/old.pln "getAttr s.radius\n")
run(${CMAKE_COMMAND} -E env PLINIAN_PLUGIN_PATH=${WORK}/author/places ${WORK}/prefix/bin/plinian run ${WORK}/old.pln
    ${WORK}/old.plinian)
if(NOT output MATCHES "3.5\n")
  message(FATAL_ERROR "the example's older scene is not migrated:\n${output}")
endif()

# The tutorial's as it is and with the other strings of the C++ library; a program of the tests loads both.
run(${CMAKE_COMMAND} -S ${examples}/marker -B ${WORK}/marker_old -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/prefix
    -DCMAKE_CXX_FLAGS=-D_GLIBCXX_USE_CXX11_ABI=0)
run(${CMAKE_COMMAND} --build ${WORK}/marker_old)
file(COPY_FILE ${WORK}/marker_old/marker.so ${WORK}/author/marker/marker_old.so)
run(${CMAKE_COMMAND} -E env PLINIAN_TUTORIAL=${WORK}/author/marker ${BUILD}/tests/host/draw/draw_test --gtest_filter=*Tutorial*)

# The one that shows every type of attribute.
run(${CMAKE_COMMAND} -S ${examples}/attributes -B ${WORK}/attributes -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/prefix
    "-DCMAKE_CXX_FLAGS=${strict}")
build(${WORK}/attributes)
run(${CMAKE_COMMAND} -E env PLINIAN_PLUGIN_PATH=${WORK}/attributes ${WORK}/prefix/bin/plinian run
    ${examples}/attributes/try.pln)
if(NOT output MATCHES " 11 .* 0.035 .* 2\"?\n")
  message(FATAL_ERROR "attributes/try.pln does not answer with what it set:\n${output}")
endif()

# A shape of its own: it overlaps an atfmVolume, and each shadows the other.
run(${CMAKE_COMMAND} -E env PLINIAN_SECOND_SHAPE=${WORK}/author/puff ${BUILD}/tests/host/scene/host_scene_test
    --gtest_filter=SecondShape.*)

set(program ${WORK}/prefix/bin/plinian)
run(${program} --version)
run(${program} make ash --resolution 16 -o ${WORK}/ash.vdb)
run(${program} render ${WORK}/ash.vdb -o ${WORK}/ash.png --preset high --renderer cpu --size 16x16 --samples 1)
run(${program} render ${WORK}/ash.vdb -o ${WORK}/ash.exr --renderer cpu --size 16x16 --samples 1)
run(${program} info ${WORK}/ash.exr)
foreach(file ${WORK}/prefix/libexec/plinian/plinian-image-files.so ${WORK}/ash.exr ${WORK}/plugin/outside.so ${WORK}/ash.png ${WORK}/prefix/share/plinian/presets/fast.json)
  if(NOT EXISTS ${file})
    message(FATAL_ERROR "${file} is missing")
  endif()
endforeach()
file(REMOVE_RECURSE ${WORK})
