# Run by cpack between installing and packing: gives each Debian package what policy asks for beside
# its files (copyright, compressed changelogs and manual pages, its own folder of documentation).
find_program(GZIP gzip REQUIRED)

function(compress file)
  execute_process(COMMAND ${GZIP} -9nf ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(copyright "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Parapet

Files: *
Copyright: 2026 ${CPACK_PACKAGE_VENDOR}
License: Apache-2.0
 On Debian systems the full text of the Apache License, version 2.0, is in
 /usr/share/common-licenses/Apache-2.0.
")

# SOURCE_DATE_EPOCH, where it is set, makes the packages the same each time.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(share ${CPACK_TEMPORARY_DIRECTORY}/${component}${CPACK_PACKAGING_INSTALL_PREFIX}/share)
  set(doc ${share}/doc/${package})
  if(NOT package STREQUAL "parapet" AND EXISTS ${share}/doc/parapet)
    file(RENAME ${share}/doc/parapet ${doc})
  endif()
  file(MAKE_DIRECTORY ${doc})

  file(REMOVE ${doc}/LICENSE)
  file(WRITE ${doc}/copyright "${copyright}")
  if(EXISTS ${doc}/CHANGELOG.md)
    file(RENAME ${doc}/CHANGELOG.md ${doc}/changelog)
    compress(${doc}/changelog)
  endif()
  set(version ${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
  file(WRITE ${doc}/changelog.Debian "parapet (${version}) unstable; urgency=medium

  * Parapet ${CPACK_PACKAGE_VERSION}; see changelog.gz in the package parapet.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  compress(${doc}/changelog.Debian)
  if(EXISTS ${share}/man/man1/parapet.1)  # one page for both programs
    file(WRITE ${share}/man/man1/parapet-validate.1 ".so man1/parapet.1\n")
  endif()
  file(GLOB manual_pages ${share}/man/man1/*.1)
  foreach(page IN LISTS manual_pages)
    compress(${page})
  endforeach()
endforeach()
