# deal.II, PETSc and MPI behind one interface target, their headers as SYSTEM.
# Only clevis_engine.so may link it: a process that loads deal.II pays 0.3-0.6 s.
find_package(deal.II 9.4 REQUIRED HINTS /usr/share/cmake/deal.II)
add_library(clevis_dealii_headers INTERFACE)
target_include_directories(clevis_dealii_headers SYSTEM INTERFACE
                           ${DEAL_II_INCLUDE_DIRS})
target_compile_definitions(clevis_dealii_headers INTERFACE
                           ${DEAL_II_USER_DEFINITIONS_RELEASE})
add_library(clevis_dealii INTERFACE)
target_link_libraries(clevis_dealii INTERFACE clevis_dealii_headers
                      ${DEAL_II_LIBRARIES_RELEASE})

# deal.II brings some 300 shared libraries; gold reads them ten times faster
# than the default linker (1 s against 13 s for each binary).
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold HAVE_GOLD)
if(HAVE_GOLD)
  target_link_options(clevis_dealii INTERFACE -fuse-ld=gold)
endif()
