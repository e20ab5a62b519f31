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
