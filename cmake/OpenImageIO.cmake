# OpenImageIO, found so that its imported target can be used with Debian's packages: that names OpenCV's headers, which its own
# do not need and its package does not bring. On the way there Imath's files say that a library for Python may have been deleted, which is in
# another package: a message of no use to who builds this.
set(level "${CMAKE_MESSAGE_LOG_LEVEL}")
set(CMAKE_MESSAGE_LOG_LEVEL NOTICE)
find_package(OpenImageIO REQUIRED QUIET)
set(CMAKE_MESSAGE_LOG_LEVEL "${level}")
get_target_property(includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
foreach (folder IN LISTS includes)
  if (NOT EXISTS "${folder}")
    list(REMOVE_ITEM includes "${folder}")
  endif ()
endforeach ()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${includes}")
