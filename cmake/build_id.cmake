# Writes the definition of BuildId (common/util/build_id.h).
#
#   cmake -DFOLDER=SOURCES -DFILES=LIST -DTOOLS=TEXT -DOUTPUT=FILE -P build_id.cmake
#
# LIST has a file a line, relative to SOURCES.
file(STRINGS ${FILES} files)
set(all "${TOOLS}\n")
foreach(path IN LISTS files)
  file(SHA256 ${FOLDER}/${path} digest)
  string(APPEND all "${digest} ${path}\n")
endforeach()
string(SHA256 id "${all}")
string(SUBSTRING ${id} 0 16 id)
file(WRITE ${OUTPUT} "#include \"common/util/build_id.h\"

namespace tilemend {

std::string BuildId() { return \"${id}\"; }

}  // namespace tilemend
")
