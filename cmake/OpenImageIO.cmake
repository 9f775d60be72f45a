# OpenImageIO, found so that its imported target can be used with Debian's packages: that names OpenCV's headers, which its own
# do not need and its package does not bring.
find_package(OpenImageIO REQUIRED QUIET)
get_target_property(includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
foreach (folder IN LISTS includes)
  if (NOT EXISTS "${folder}")
    list(REMOVE_ITEM includes "${folder}")
  endif ()
endforeach ()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${includes}")
