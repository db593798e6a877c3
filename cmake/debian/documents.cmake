# Run by CPack before it packs: adds Debian's documents to the tree of each component.

# The day of the newest release that the news tell of.
file(STRINGS ${CPACK_WM3D_NEWS} releases REGEX "^## .*[0-9]+-[0-9]+-[0-9]+")
string(REGEX MATCH "[0-9]+-[0-9]+-[0-9]+" day "${releases}")
if(NOT day)
    string(TIMESTAMP day %Y-%m-%d UTC)
endif()
execute_process(COMMAND date -u -R -d ${day} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE
    COMMAND_ERROR_IS_FATAL ANY)

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} upper)
    set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
    set(tree ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}/usr)
    set(folder ${tree}/share/doc/${package})
    configure_file(${CPACK_WM3D_COPYRIGHT} ${folder}/copyright COPYONLY)
    configure_file(${CPACK_WM3D_NEWS} ${folder}/NEWS COPYONLY)
    file(WRITE ${folder}/changelog "${package} (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium\n\n"
        "  * See NEWS.gz.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
    file(GLOB pages ${tree}/share/man/man1/*.1)
    execute_process(COMMAND gzip -9 -n -f ${folder}/changelog ${folder}/NEWS ${pages} COMMAND_ERROR_IS_FATAL ANY)
    file(REMOVE ${folder}/LICENSE) # copyright names it
endforeach()
