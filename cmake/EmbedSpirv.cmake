# cmake -D INPUT=x.spv -D OUTPUT=x.spv.h -D NAME=kSpirv_x -P EmbedSpirv.cmake: SPIR-V, little-endian, as an array of words.
file(READ ${INPUT} bytes HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${bytes}")
string(REGEX REPLACE "(...........,...........,...........,...........,...........,...........,...........,...........,)" "\\1\n"
       words "${words}")
file(WRITE ${OUTPUT} "#pragma once\n#include <cstdint>\nconst std::uint32_t ${NAME}[] = {\n${words}};\n")
