# Run by embed_files at build time.
# A file is one literal after its lines are joined. The standard demands 65536 characters of a compiler; g++ and clang
# take longer ones, and clang warns of them.
set(text "#include <span>\n#include <string_view>\n\n#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n\nnamespace ${NAMESPACE} {\nnamespace {\n")
set(table "")
set(names "")
set(index 0)
foreach(file IN LISTS FILES)
  file(READ ${file} hex HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${hex}")
  # short literals: g++ takes long ones, editors do not
  string(REGEX REPLACE "(................................................................)" "\\1\"\n  \"" bytes "${bytes}")
  file(RELATIVE_PATH name ${ROOT} ${file})
  file(SIZE ${file} size)
  string(APPEND text "constexpr char file_${index}[] =\n  \"${bytes}\";\n")
  string(APPEND table "  if (name == \"${name}\") return {file_${index}, ${size}};\n")
  string(APPEND names "\"${name}\", ")
  math(EXPR index "${index} + 1")
endforeach()
string(APPEND text "}  // namespace\n\nstd::string_view embedded_file(std::string_view name) {\n${table}  return {};\n}\n\nstd::span<const std::string_view> embedded_names() {\n  static constexpr std::string_view names[] = {${names}};\n  return names;\n}\n\n}  // namespace ${NAMESPACE}\n")
file(WRITE ${OUT} "${text}")
