# Writes the manual page: docs/man/runmark.1.in with what `runmark COMMAND --help` says of each command.
#   cmake -DRUNMARK=<program> -DPROJECT_VERSION=<version> -DINPUT=<.in> -DOUTPUT=<page> -P man_page.cmake
function(help_of out)
  execute_process(COMMAND ${RUNMARK} ${ARGN} --help OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

help_of(overview)
string(REGEX REPLACE "^.*\nSubcommands:\n" "" overview "${overview}")
string(REGEX MATCHALL "(^|\n)  [a-z]+ " names "${overview}")
set(COMMANDS "")
foreach(name IN LISTS names)
  string(STRIP "${name}" name)
  help_of(text ${name})
  string(REGEX REPLACE "\\\\" "\\\\\\\\" text "${text}")
  string(REPLACE "-" "\\-" text "${text}")
  # A line that begins with a dot or a quote would be a request.
  string(REGEX REPLACE "\n([.'])" "\n\\\\&\\1" text "${text}")
  string(APPEND COMMANDS ".SS ${name}\n.nf\n${text}.fi\n")
endforeach()
configure_file(${INPUT} ${OUTPUT} @ONLY)
