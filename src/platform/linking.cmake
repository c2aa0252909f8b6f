# What the linker is told, which differs from system to system. Tried on Linux alone.

# A library exports exactly these functions; "prefix_*" is allowed. On Windows they are those that UPS_EXPORT marks.
function(ups_export_only target)
  set(symbols ${ARGN})
  set(script ${CMAKE_CURRENT_BINARY_DIR}/${target}.exports)
  if(WIN32)
    target_link_options(${target} PRIVATE -Wl,--exclude-libs,ALL)
    return()
  elseif(APPLE)
    list(JOIN symbols "\n_" symbols)
    file(CONFIGURE OUTPUT ${script} @ONLY CONTENT "_@symbols@\n")
    target_link_options(${target} PRIVATE -Wl,-exported_symbols_list,${script})
  else()
    list(JOIN symbols ";\n    " symbols)
    file(CONFIGURE OUTPUT ${script} @ONLY
         CONTENT "UPS_${UPS_SOVERSION} {\n  global:\n    @symbols@;\n  local: *;\n};\n")
    target_link_options(${target} PRIVATE -Wl,--exclude-libs,ALL -Wl,--version-script=${script})
  endif()
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${script})
endfunction()

# A host may unload a library while contexts and jobs are there (Mono does, at its exit), and would pull the code from
# under their threads. Nor may it miss a function that it needs. Elsewhere the second is the linker's own rule, and the
# host must see to the first.
function(ups_stay_loaded target)
  if(NOT WIN32 AND NOT APPLE)
    target_link_options(${target} PRIVATE -Wl,--no-undefined -Wl,-z,nodelete)
  endif()
endfunction()

# Where a library or a program that was moved looks for the others: the folder that it is in. Windows does that anyway.
if(APPLE)
  set(UPS_OWN_FOLDER "@loader_path")
else()
  set(UPS_OWN_FOLDER "$ORIGIN")
endif()
