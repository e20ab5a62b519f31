# Writes a C++ file that holds text files by their path: cmake -DROOT= -DFILES= -DOUTPUT= -P embed_files.cmake
set(text "// Made by tools/cmake/embed_files.cmake.\n#include \"viewport/gl/shader.h\"\n\nnamespace plinian::gl {\n")
string(APPEND text "const std::vector<std::pair<std::string_view, std::string_view>>& shader_files() {\n")
string(APPEND text "  static const std::vector<std::pair<std::string_view, std::string_view>> files = {\n")
foreach(file IN LISTS FILES)
  file(READ ${ROOT}/${file} content)
  # The delimiter does not occur in GLSL.
  string(APPEND text "      {\"${file}\", R\"embedded(${content})embedded\"},\n")
endforeach()
string(APPEND text "  };\n  return files;\n}\n}  // namespace plinian::gl\n")
file(WRITE ${OUTPUT} "${text}")
