if(NOT EXISTS ${BUILT} OR EXISTS ${NOT_BUILT})
    message(FATAL_ERROR "wm3d inside another project: ${BUILT} should be there, ${NOT_BUILT} should not")
endif()
