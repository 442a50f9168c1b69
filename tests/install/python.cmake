# The installed binding for Python finds the installed library by itself.
include(${CMAKE_CURRENT_LIST_DIR}/common.cmake)

unset(ENV{SULFUR_LIBRARY})
set(ENV{PYTHONPATH} ${prefix}/${libdir}/sulfur/python)
run(${python} -B ${prefix}/share/doc/sulfur/examples/stack.py)
expect_output("${output}" "^asleep: 10 of 10\n")
run(${python} -B -c "print(__import__('sulfur').library.library._name)")
expect_output("${output}" "^${prefix}/${libdir}/libsulfur_c\\.so\\.0\n$")
