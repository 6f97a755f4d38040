# SPDX-License-Identifier: Apache-2.0
# Included by the toolchain files. The runtime's third-party code is headers alone, so the host's serve every target. The
# cross compiler must not see the rest of the host's folder, so a folder of links names these alone.
if(NOT CMAKE_PROJECT_NAME STREQUAL CMAKE_TRY_COMPILE)
  set(host_headers ${CMAKE_BINARY_DIR}/host_headers)
  file(MAKE_DIRECTORY ${host_headers})
  foreach(header IN ITEMS flatbuffers hwy vulkan vk_video xxhash.h)
    if(EXISTS /usr/include/${header})
      file(CREATE_LINK /usr/include/${header} ${host_headers}/${header} SYMBOLIC)
    endif()
  endforeach()
  list(PREPEND CMAKE_INCLUDE_PATH ${host_headers})
endif()
