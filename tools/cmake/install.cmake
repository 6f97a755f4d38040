# SPDX-License-Identifier: Apache-2.0
# Rules of `cmake --install` for four components. Each is usable alone, but vulkan needs runtime. No installed file
# names the folder of the build or of the installation.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)
set(WELKIN_INSTALL_SHADERDIR ${CMAKE_INSTALL_DATADIR}/welkin/shaders)
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Welkin)
set(pkgconfig_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
set(modules_folder ${CMAKE_INSTALL_LIBDIR}/welkin)
file(RELATIVE_PATH bin_to_modules /prefix/${CMAKE_INSTALL_BINDIR} /prefix/${modules_folder})

set_target_properties(welkin_runtime PROPERTIES EXPORT_NAME runtime)
set_target_properties(welkin_vulkan PROPERTIES EXPORT_NAME vulkan)
set(components runtime vulkan)
if(TARGET welkin_shared_library)
  set_target_properties(welkin_shared_library PROPERTIES EXPORT_NAME library)
  install(TARGETS welkin_shared_library EXPORT WelkinTargets-library
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT library
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  list(APPEND components library)
endif()
if(TARGET welkin)
  set_target_properties(welkin PROPERTIES EXPORT_NAME bake
    INSTALL_RPATH "$ORIGIN/${bin_to_modules}")  # stays right when the installation moves
  install(TARGETS welkin_image welkin_chart welkin_window LIBRARY DESTINATION ${modules_folder} COMPONENT bake)
  install(TARGETS welkin EXPORT WelkinTargets-bake RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT bake)
  install(DIRECTORY examples/island DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/welkin/examples COMPONENT bake  # what `welkin view` shows
    FILES_MATCHING PATTERN "*.toml" PATTERN "*.png" PATTERN "*.gltf" PATTERN "*.bin" PATTERN generate EXCLUDE)
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/WelkinBake.cmake DESTINATION ${config_folder} COMPONENT bake)
  file(RELATIVE_PATH lib_to_modules /prefix/${CMAKE_INSTALL_LIBDIR} /prefix/${modules_folder})
  set_target_properties(welkin_baker PROPERTIES EXPORT_NAME baker INSTALL_RPATH "$ORIGIN/${lib_to_modules}")
  install(TARGETS welkin_image LIBRARY DESTINATION ${modules_folder} COMPONENT baker)
  install(TARGETS welkin_baker EXPORT WelkinTargets-baker LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT baker
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(FILES tools/baker/include/welkin/bake.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/welkin COMPONENT baker)
  list(APPEND components bake baker)
endif()
foreach(component runtime vulkan)
  install(TARGETS welkin_${component} EXPORT WelkinTargets-${component}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${component}
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endforeach()

install(FILES LICENSE CHANGELOG.md README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)
install(FILES shaders/welkin/sky_constants.h shaders/welkin/volume_constants.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/welkin COMPONENT runtime)
install(DIRECTORY runtime/include/welkin DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT runtime
  FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp" PATTERN "welkin_vulkan*" EXCLUDE)
install(DIRECTORY runtime/include/welkin DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT vulkan
  FILES_MATCHING PATTERN "welkin_vulkan*.h*")
# Only the GLSL of shared/ is installed. Its headers only serve to compile the GLSL as C++.
install(DIRECTORY shaders/welkin DESTINATION ${WELKIN_INSTALL_SHADERDIR} COMPONENT runtime
  FILES_MATCHING PATTERN "*.glsl" PATTERN "*.h")
install(DIRECTORY shaders/shared DESTINATION ${WELKIN_INSTALL_SHADERDIR} COMPONENT runtime
  FILES_MATCHING PATTERN "*.glsl")

if(WELKIN_TRANSLATED_SHADERS)
  install(FILES ${WELKIN_TRANSLATED_SHADERS} DESTINATION ${WELKIN_INSTALL_SHADERDIR}/welkin COMPONENT runtime)
endif()

set(WELKIN_NEEDS_HIGHWAY FALSE)
if(WELKIN_HIGHWAY_LIBRARY)
  set(WELKIN_NEEDS_HIGHWAY TRUE)
endif()
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/WelkinConfig.cmake.in ${PROJECT_BINARY_DIR}/WelkinConfig.cmake
  INSTALL_DESTINATION ${config_folder} PATH_VARS WELKIN_INSTALL_SHADERDIR NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/WelkinConfigVersion.cmake COMPATIBILITY SameMinorVersion)
foreach(component IN LISTS components)
  install(EXPORT WelkinTargets-${component} NAMESPACE welkin:: DESTINATION ${config_folder} COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/WelkinConfig.cmake ${PROJECT_BINARY_DIR}/WelkinConfigVersion.cmake
    DESTINATION ${config_folder} COMPONENT ${component})
endforeach()

# A static C++ library in a C program needs the C++ library after it.
set(WELKIN_PC_LIBS "")
foreach(library IN LISTS CMAKE_CXX_IMPLICIT_LINK_LIBRARIES)
  if(library MATCHES "^(stdc\\+\\+|c\\+\\+|c\\+\\+abi|m)$")
    string(APPEND WELKIN_PC_LIBS " -l${library}")
  endif()
endforeach()
string(STRIP "${WELKIN_PC_LIBS}" WELKIN_PC_LIBS)
if(WELKIN_HIGHWAY_LIBRARY)
  set(WELKIN_PC_HIGHWAY "-lhwy ")
endif()
file(RELATIVE_PATH WELKIN_PC_PREFIX /prefix/${pkgconfig_folder} /prefix)
string(REGEX REPLACE "/$" "" WELKIN_PC_PREFIX ${WELKIN_PC_PREFIX})
foreach(component runtime vulkan library)
  if(NOT component IN_LIST components)
    continue()
  endif()
  configure_file(${CMAKE_CURRENT_LIST_DIR}/welkin-${component}.pc.in ${PROJECT_BINARY_DIR}/welkin-${component}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/welkin-${component}.pc DESTINATION ${pkgconfig_folder} COMPONENT ${component})
endforeach()
