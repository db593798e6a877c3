# Every third-party library is wrapped here once, as a SYSTEM interface target wm3d::third::<name>:
# modules name what they use and never see how it is found.
#
# wm3d_third_party(NAME LINK target... FIND "find_dependency(...)" PKG_CONFIG module... LIBS -lx... DEBIAN package...)
#
# FIND is how a program finds it again that links the installed modules, for these are static; PKG_CONFIG or LIBS say
# the same to pkg-config, DEBIAN to Debian's packages. Headers that only sources include need none of them.

function(wm3d_third_party name)
    cmake_parse_arguments(ARG "" "" "LINK;FIND;PKG_CONFIG;LIBS;DEBIAN" ${ARGN})
    add_library(wm3d_third_${name} INTERFACE)
    add_library(wm3d::third::${name} ALIAS wm3d_third_${name})
    set_target_properties(wm3d_third_${name} PROPERTIES EXPORT_NAME third::${name} WM3D_FIND "${ARG_FIND}"
        WM3D_PKG_CONFIG "${ARG_PKG_CONFIG}" WM3D_LIBS "${ARG_LIBS}" WM3D_DEBIAN "${ARG_DEBIAN}")
    foreach(library IN LISTS ARG_LINK)
        target_link_libraries(wm3d_third_${name} INTERFACE ${library})
        if(TARGET ${library})
            get_target_property(includes ${library} INTERFACE_INCLUDE_DIRECTORIES)
            if(includes)
                target_include_directories(wm3d_third_${name} SYSTEM INTERFACE "$<BUILD_INTERFACE:${includes}>")
            endif()
        endif()
    endforeach()
endfunction()

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
wm3d_third_party(eigen LINK Eigen3::Eigen DEBIAN libeigen3-dev FIND "find_dependency(Eigen3 3.4 NO_MODULE)" PKG_CONFIG eigen3)
# Eigen's own threads would make the order of sums depend on their number.
target_compile_definitions(wm3d_third_eigen INTERFACE EIGEN_DONT_PARALLELIZE)

find_package(TBB REQUIRED)
wm3d_third_party(tbb LINK TBB::tbb DEBIAN libtbb-dev FIND "find_dependency(TBB)" PKG_CONFIG tbb)

find_package(fmt REQUIRED)
wm3d_third_party(fmt LINK fmt::fmt DEBIAN libfmt-dev FIND "find_dependency(fmt)" PKG_CONFIG fmt)

find_package(nlohmann_json REQUIRED)
wm3d_third_party(json LINK nlohmann_json::nlohmann_json)

find_package(PkgConfig REQUIRED)
pkg_check_modules(SODIUM REQUIRED IMPORTED_TARGET libsodium)
wm3d_third_party(sodium LINK PkgConfig::SODIUM DEBIAN libsodium-dev PKG_CONFIG libsodium
    FIND "find_dependency(PkgConfig)" "pkg_check_modules(SODIUM REQUIRED IMPORTED_TARGET libsodium)")

if("ledger" IN_LIST WM3D_MODULES)
    pkg_check_modules(SQLITE REQUIRED IMPORTED_TARGET sqlite3)
    wm3d_third_party(sqlite LINK PkgConfig::SQLITE DEBIAN libsqlite3-dev PKG_CONFIG sqlite3
        FIND "find_dependency(PkgConfig)" "pkg_check_modules(SQLITE REQUIRED IMPORTED_TARGET sqlite3)")
endif()

pkg_check_modules(TINYOBJ REQUIRED IMPORTED_TARGET tinyobjloader_double)
wm3d_third_party(tinyobjloader LINK PkgConfig::TINYOBJ DEBIAN libtinyobjloader-dev PKG_CONFIG tinyobjloader_double
    FIND "find_dependency(PkgConfig)" "pkg_check_modules(TINYOBJ REQUIRED IMPORTED_TARGET tinyobjloader_double)")
target_compile_definitions(wm3d_third_tinyobjloader INTERFACE TINYOBJLOADER_USE_DOUBLE)

# Optional: unpacks what `gltfpack -c` writes.
find_package(meshoptimizer QUIET)
if(meshoptimizer_FOUND)
    wm3d_third_party(meshoptimizer LINK meshoptimizer::meshoptimizer DEBIAN libmeshoptimizer-dev FIND "find_dependency(meshoptimizer)"
        LIBS -lmeshoptimizer)
endif()

# Optional: makes time stamp requests.
if("commitment" IN_LIST WM3D_MODULES)
    find_package(OpenSSL 3 QUIET)
    if(TARGET OpenSSL::Crypto)
        wm3d_third_party(openssl LINK OpenSSL::Crypto DEBIAN libssl-dev FIND "find_dependency(OpenSSL 3)" PKG_CONFIG libcrypto)
    endif()
endif()

find_package(Boost 1.74 REQUIRED)
wm3d_third_party(boost LINK Boost::headers)

if("search" IN_LIST WM3D_MODULES)
    pkg_check_modules(FFTW REQUIRED IMPORTED_TARGET fftw3)
    pkg_check_modules(FFTWF REQUIRED IMPORTED_TARGET fftw3f)
    wm3d_third_party(fftw LINK PkgConfig::FFTW PkgConfig::FFTWF DEBIAN libfftw3-dev PKG_CONFIG fftw3 fftw3f
        FIND "find_dependency(PkgConfig)" "pkg_check_modules(FFTW REQUIRED IMPORTED_TARGET fftw3)"
             "pkg_check_modules(FFTWF REQUIRED IMPORTED_TARGET fftw3f)")
endif()

if("attack" IN_LIST WM3D_MODULES)
    find_package(OpenMesh REQUIRED CONFIG) # CGAL brings a find module of that name
    wm3d_third_party(openmesh LINK OpenMeshTools OpenMeshCore DEBIAN libopenmesh-dev FIND "find_dependency(OpenMesh CONFIG)"
        LIBS -lOpenMeshTools -lOpenMeshCore)
    set(CGAL_DO_NOT_WARN_ABOUT_CMAKE_BUILD_TYPE TRUE)
    find_package(CGAL 5.5 REQUIRED)
    wm3d_third_party(cgal LINK CGAL::CGAL DEBIAN libcgal-dev FIND "find_dependency(CGAL 5.5)" LIBS -lmpfr -lgmp)
    # g++ 12 suspects null pointers in inlined code of CGAL and Boost, and SYSTEM doesn't silence the optimizer.
    target_compile_options(wm3d_third_cgal INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-null-dereference>)
    # Optional: OpenVDB's own find module asks for more than its headers need.
    find_path(OPENVDB_INCLUDE_DIR openvdb/openvdb.h)
    find_library(OPENVDB_LIBRARY openvdb)
    if(OPENVDB_INCLUDE_DIR AND OPENVDB_LIBRARY)
        wm3d_third_party(openvdb LINK ${OPENVDB_LIBRARY} TBB::tbb DEBIAN libopenvdb-dev FIND "find_dependency(TBB)" LIBS -lopenvdb -ltbb)
        target_include_directories(wm3d_third_openvdb SYSTEM INTERFACE ${OPENVDB_INCLUDE_DIR})
    endif()
endif()

if(WM3D_RESYNC AND "resync" IN_LIST WM3D_MODULES)
    find_package(Ceres 2.1 REQUIRED)
    wm3d_third_party(ceres LINK Ceres::ceres DEBIAN libceres-dev FIND "find_dependency(Ceres 2.1)" LIBS -lceres -lglog)
    find_path(NANOFLANN_INCLUDE_DIR nanoflann.hpp REQUIRED)
    wm3d_third_party(nanoflann)
    target_include_directories(wm3d_third_nanoflann SYSTEM INTERFACE ${NANOFLANN_INCLUDE_DIR})
endif()

if(WM3D_COMMANDS)
    find_package(CLI11 REQUIRED)
    wm3d_third_party(cli11 LINK CLI11::CLI11)
endif()

if(WM3D_TESTS)
    find_package(doctest REQUIRED)
    wm3d_third_party(doctest LINK doctest::doctest)
    include(doctest)
endif()
