# compile_together(TARGET FILES...): has the compiler read the files in groups, so that what they include is read and
# instantiated once a group. Files stay as free in their names as they are alone: two that declare the same name outside
# of a class (most are in unnamed namespaces) go to different groups. Only a name of a header of the same namespace is
# taken even where the header is not included; the compiler tells. Files with COMPILE_OPTIONS are compiled alone.
set(most_together 10)

# The names that lines of `file` begin to declare: the last word before what cannot stand in a name or a type. Not
# namespaces, what is declared elsewhere (a::b), or macros.
function(names_declared file result)
  file(READ "${file}" text)
  string(REGEX MATCHALL "\n[A-Za-z_]([A-Za-z0-9_<>,&* ]|::)*" heads "${text}")
  set(names "")
  foreach(head IN LISTS heads)
    string(REGEX REPLACE "( final)? +$" "" head "${head} ")
    if(head MATCHES "^.(namespace|using namespace|template|extern)( |$)" OR
        head MATCHES "::[A-Za-z0-9_]+$" OR head MATCHES "^.[A-Z0-9_]+$")
      continue()
    endif()
    string(REGEX MATCH "[A-Za-z0-9_]+$" name "${head}")
    list(APPEND names ${name})
  endforeach()
  set(${result} "${names}" PARENT_SCOPE)
endfunction()

function(compile_together target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # A member's type in an unnamed namespace is worth a warning in a header only: GCC takes each file of a group for one.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  # A name that is declared anew may be in the way of the groups.
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ARGN})
  set(groups 0)
  foreach(file IN LISTS ARGN)
    get_source_file_property(is_alone "${file}" SKIP_UNITY_BUILD_INCLUSION)
    if(is_alone)
      continue()
    endif()
    names_declared("${file}" names)
    set(group 0)
    while(group LESS groups)
      if(size_${group} LESS most_together)
        set(common ${names_${group}})
        set(others ${common})
        list(REMOVE_ITEM others ${names} "")
        if("${others}" STREQUAL "${common}")
          break()
        endif()
      endif()
      math(EXPR group "${group} + 1")
    endwhile()
    if(group EQUAL groups)
      math(EXPR groups "${groups} + 1")
      set(size_${group} 0)
      set(names_${group} "")
    endif()
    math(EXPR size_${group} "${size_${group}} + 1")
    list(APPEND names_${group} ${names})
    set_source_files_properties("${file}" PROPERTIES UNITY_GROUP "${group}")
  endforeach()
endfunction()
