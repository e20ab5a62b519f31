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

# The tutorial's, as it is and with the other strings of the C++ library; a program of the tests loads both.
foreach(name marker marker_old)
  set(definitions "")
  if(name STREQUAL marker_old)
    set(definitions -DCMAKE_CXX_FLAGS=-D_GLIBCXX_USE_CXX11_ABI=0)
  endif()
  run(${CMAKE_COMMAND} -S ${SOURCE}/tests/install/tutorial -B ${WORK}/${name} -G Ninja -DCMAKE_BUILD_TYPE=Release
      -DCMAKE_PREFIX_PATH=${WORK}/prefix ${definitions})
  run(${CMAKE_COMMAND} --build ${WORK}/${name})
  file(COPY_FILE ${WORK}/${name}/marker.so ${WORK}/tutorial_${name}.so)
endforeach()
file(MAKE_DIRECTORY ${WORK}/tutorial)
file(RENAME ${WORK}/tutorial_marker.so ${WORK}/tutorial/marker.so)
file(RENAME ${WORK}/tutorial_marker_old.so ${WORK}/tutorial/marker_old.so)
run(${CMAKE_COMMAND} -E env PLINIAN_TUTORIAL=${WORK}/tutorial ${BUILD}/tests/host/draw/draw_test --gtest_filter=*Tutorial*)

# A shape of its own: it overlaps an atfmVolume, and each shadows the other.
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/install/puff -B ${WORK}/puff -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/puff)
run(${CMAKE_COMMAND} -E env PLINIAN_SECOND_SHAPE=${WORK}/puff ${BUILD}/tests/host/scene/host_scene_test
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
