# Run by CPack before it packs: adds Debian's documents to the tree of each component.
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
    string(TOUPPER ${component} upper)
    set(tree ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}/usr)
    set(folder ${tree}/share/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
    configure_file(${CPACK_WM3D_COPYRIGHT} ${folder}/copyright COPYONLY)
    configure_file(${CPACK_WM3D_CHANGELOG} ${folder}/changelog COPYONLY)
    file(GLOB pages ${tree}/share/man/man1/*.1)
    execute_process(COMMAND gzip -9 -n -f ${folder}/changelog ${pages} COMMAND_ERROR_IS_FATAL ANY)
    file(REMOVE ${folder}/LICENSE) # copyright names it
endforeach()
