# The versions of SUNDIALS whose integrator hawser knows how to reshape in mid-run (docs/theory.md, "The integrator goes on").
# 6.4.1 and 7.1.1 are what it was tested with. Whether the history is where it should be is looked at again whenever
# an integrator starts.
set(HAWSER_SUNDIALS_FROM 6.4)
set(HAWSER_SUNDIALS_BELOW 8)
if(SUNDIALS_VERSION VERSION_LESS HAWSER_SUNDIALS_FROM OR NOT SUNDIALS_VERSION VERSION_LESS HAWSER_SUNDIALS_BELOW)
    message(FATAL_ERROR "SUNDIALS ${SUNDIALS_VERSION} was found; hawser supports ${HAWSER_SUNDIALS_FROM} and later, below "
                        "${HAWSER_SUNDIALS_BELOW}: point CMAKE_PREFIX_PATH or SUNDIALS_DIR at one of those")
endif()
