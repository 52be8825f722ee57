# The components: what each stands on and which packages it needs. This one table serves the option
# PARAPET_COMPONENTS, the build, and the CMake package that is installed. A new component is one
# entry here and a folder.

set(parapet_components "")  # every component, each after those it stands on
set(parapet_packages "")

# parapet_package(NAME ARGUMENT...): a package and what find_package() is told beside its name;
# PKG_CONFIG for one that pkg-config finds.
function(parapet_package name)
  set(parapet_packages ${parapet_packages} ${name} PARENT_SCOPE)
  set(parapet_find_${name} ${ARGN} PARENT_SCOPE)
endfunction()

# parapet_component(NAME [FOLDER folder] [NEEDS component...] [PACKAGES package...] [PROGRAMS]): the
# library parapet::NAME, built by the folder of that name or by FOLDER, with what it links. PROGRAMS:
# programs or what only they use; not part of the CMake package.
function(parapet_component name)
  cmake_parse_arguments(ARG "PROGRAMS" "FOLDER" "NEEDS;PACKAGES" ${ARGN})
  foreach(need IN LISTS ARG_NEEDS)
    if(NOT need IN_LIST parapet_components)
      message(FATAL_ERROR "the component ${name} needs ${need}, which must stand before it")
    endif()
  endforeach()
  foreach(package IN LISTS ARG_PACKAGES)
    if(NOT package IN_LIST parapet_packages)
      message(FATAL_ERROR "the component ${name} needs ${package}, which is not a parapet_package")
    endif()
  endforeach()
  if(NOT ARG_FOLDER)
    set(ARG_FOLDER ${name})
  endif()
  set(parapet_components ${parapet_components} ${name} PARENT_SCOPE)
  set(parapet_folder_${name} ${ARG_FOLDER} PARENT_SCOPE)
  set(parapet_needs_${name} ${ARG_NEEDS} PARENT_SCOPE)
  set(parapet_packages_${name} ${ARG_PACKAGES} PARENT_SCOPE)
  set(parapet_programs_${name} ${ARG_PROGRAMS} PARENT_SCOPE)
endfunction()

parapet_package(OpenMP COMPONENTS CXX)
parapet_package(Threads)
parapet_package(Eigen3 3.4 NO_MODULE)
parapet_package(NLopt)
parapet_package(nlohmann_json 3.11)
parapet_package(muparser 2.3)
parapet_package(ZLIB)
parapet_package(fmt)
parapet_package(spdlog)
parapet_package(CLI11)
parapet_package(cairo PKG_CONFIG)

parapet_component(math PACKAGES Eigen3)
parapet_component(flow FOLDER solver/flow PACKAGES OpenMP)
parapet_component(solver NEEDS flow PACKAGES OpenMP)
parapet_component(designs NEEDS solver math PACKAGES nlohmann_json muparser)
parapet_component(records NEEDS designs PACKAGES nlohmann_json fmt ZLIB)
parapet_component(optimizer PACKAGES NLopt)
parapet_component(surrogate FOLDER optimizer/surrogate NEEDS optimizer math PACKAGES Eigen3)
parapet_component(acquisition FOLDER optimizer/acquisition NEEDS math PACKAGES Eigen3)
parapet_component(bayesian FOLDER optimizer/bayesian NEEDS optimizer surrogate acquisition)
parapet_component(study NEEDS math designs records optimizer bayesian PACKAGES fmt Threads)
parapet_component(reports NEEDS math designs records study PACKAGES nlohmann_json fmt Eigen3 cairo)
parapet_component(validation PROGRAMS NEEDS flow solver designs reports
                  PACKAGES nlohmann_json fmt Eigen3)
parapet_component(cli PROGRAMS NEEDS solver designs optimizer study reports validation
                  PACKAGES CLI11 spdlog fmt)

# What is wanted, and what that stands on: parapet_chosen_components, in the order of the table.
set(PARAPET_COMPONENTS all CACHE STRING "what is configured, built and installed: all, or a list")
string(REPLACE "," ";" parapet_wanted "${PARAPET_COMPONENTS}")
if("all" IN_LIST parapet_wanted)
  set(parapet_wanted ${parapet_components})
endif()
foreach(component IN LISTS parapet_wanted)
  if(NOT component IN_LIST parapet_components)
    list(JOIN parapet_components ", " valid)
    message(FATAL_ERROR
      "PARAPET_COMPONENTS: there is no component \"${component}\"; there are: all, ${valid}")
  endif()
endforeach()
if(NOT parapet_wanted)
  message(FATAL_ERROR "PARAPET_COMPONENTS is empty; \"all\" stands for every component")
endif()
set(backwards ${parapet_components})
list(REVERSE backwards)
foreach(component IN LISTS backwards)
  if(component IN_LIST parapet_wanted)
    list(APPEND parapet_wanted ${parapet_needs_${component}})
  endif()
endforeach()
set(parapet_chosen_components "")
set(parapet_chosen_packages "")
foreach(component IN LISTS parapet_components)
  if(component IN_LIST parapet_wanted)
    list(APPEND parapet_chosen_components ${component})
    list(APPEND parapet_chosen_packages ${parapet_packages_${component}})
  endif()
endforeach()
list(REMOVE_DUPLICATES parapet_chosen_packages)
