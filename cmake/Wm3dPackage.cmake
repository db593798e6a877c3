# Debian packages by `cpack` in a build folder: wm3d (the commands), libwm3d-dev (to build on) and, where it is built,
# python3-wm3d. What the executables need is found by dpkg-shlibdeps; the static libraries need what their users link.

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME wm3d)
set(CPACK_PACKAGE_VENDOR "the wm3d project")
set(CPACK_PACKAGE_CONTACT "wm3d maintainers <maintainers@wm3d.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE) # whatever the umask
set(CPACK_COMPONENTS_ALL commands development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_COMMANDS_PACKAGE_NAME wm3d)
set(CPACK_DEBIAN_COMMANDS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_COMMANDS_PACKAGE_SUGGESTS gnuplot-nox) # draws plots of analyze and bench
set(CPACK_COMPONENT_COMMANDS_DESCRIPTION
"Hides an owner's mark in the geometry of a 3D mesh and later tells, from
a copy and the owner's key alone, whether the mark is there, with an exact
false-positive probability.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libwm3d-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(debian_needs)
foreach(third IN LISTS all_thirds) # of Wm3dInstall.cmake
    get_target_property(packages wm3d_third_${third} WM3D_DEBIAN)
    list(APPEND debian_needs ${packages})
endforeach()
list(SORT debian_needs)
list(JOIN debian_needs ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
"Headers and static libraries to mark and verify 3D meshes from C++20
programs, found by CMake and pkg-config.")

if(WM3D_PYTHON)
    list(APPEND CPACK_COMPONENTS_ALL python)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-wm3d)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
    list(GET WM3D_PYTHON_ABI 0 major)
    list(GET WM3D_PYTHON_ABI 1 minor)
    math(EXPR next "${minor} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
        "python3-numpy, python3 (>= ${major}.${minor}), python3 (<< ${major}.${next})")
    set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Marks and verifies 3D meshes given as numpy arrays.")
endif()

# What Debian wants of every package: its copyright and changelog, compressed as the manual pages are.
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/debian/documents.cmake)
set(CPACK_WM3D_COPYRIGHT ${CMAKE_CURRENT_LIST_DIR}/debian/copyright)
set(CPACK_WM3D_NEWS ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
include(CPack)
