# Cross-build for 64-bit ARM with Debian's compiler (g++-aarch64-linux-gnu); what was built runs under
# qemu-aarch64-static (qemu-user-static). PARAPET_SYSROOT, in the environment, names a folder with the
# arm64 libraries, as `.ci/aarch64_sysroot DIR` makes one. See docs/installing.md.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)

if(NOT EXISTS "$ENV{PARAPET_SYSROOT}/usr/lib/aarch64-linux-gnu")
  message(FATAL_ERROR "PARAPET_SYSROOT ('$ENV{PARAPET_SYSROOT}') is no folder with arm64 libraries; "
                      "make one with .ci/aarch64_sysroot DIR")
endif()
set(CMAKE_SYSROOT $ENV{PARAPET_SYSROOT})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_SYSROOT_DIR} ${CMAKE_SYSROOT})
set(ENV{PKG_CONFIG_LIBDIR}
  ${CMAKE_SYSROOT}/usr/lib/aarch64-linux-gnu/pkgconfig:${CMAKE_SYSROOT}/usr/share/pkgconfig)

# Tests find the dynamic linker and the libraries in the same folder.
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static;-L;${CMAKE_SYSROOT})
