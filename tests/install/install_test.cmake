# Installs Plinian into a folder of its own, builds a program of somebody else against it, and runs both from
# there: cmake -DBUILD=... -DSOURCE=... -DWORK=... -P install_test.cmake
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGV}\nended with ${code}:\n${output}")
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

# A plug-in, built as anyone's.
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/install/plugin -B ${WORK}/plugin -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/plugin)

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
execute_process(COMMAND sh -ex ${WORK}/readme.sh WORKING_DIRECTORY ${WORK}/author RESULT_VARIABLE code
                OUTPUT_VARIABLE output ERROR_VARIABLE errors)
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

# The tutorial's as it is and with the other strings of the C++ library; a program of the tests loads both.
run(${CMAKE_COMMAND} -S ${examples}/marker -B ${WORK}/marker_old -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/prefix
    -DCMAKE_CXX_FLAGS=-D_GLIBCXX_USE_CXX11_ABI=0)
run(${CMAKE_COMMAND} --build ${WORK}/marker_old)
file(COPY_FILE ${WORK}/marker_old/marker.so ${WORK}/author/marker/marker_old.so)
run(${CMAKE_COMMAND} -E env PLINIAN_TUTORIAL=${WORK}/author/marker ${BUILD}/tests/host/draw/draw_test --gtest_filter=*Tutorial*)

# The one that shows every type of attribute.
run(${CMAKE_COMMAND} -S ${examples}/attributes -B ${WORK}/attributes -G Ninja -DCMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/attributes)

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
