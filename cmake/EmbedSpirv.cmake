# cmake -D INPUT=x.spv -D OUTPUT=x.spv.h -D NAME=kSpirv_x -P EmbedSpirv.cmake: a header with SPIR-V as an array of words. The
# assembler takes them from the file itself: as text they were 30 MB for the compiler to read. The name is local to each
# file that includes the header; the sum tells caches of compilers that the words are others.
file(SIZE ${INPUT} bytes)
math(EXPR words "${bytes} / 4")
file(SHA256 ${INPUT} sum)
file(WRITE ${OUTPUT} "#pragma once
#include <cstdint>
// ${sum}
asm(\".pushsection .rodata\\n.balign 4\\n${NAME}:\\n.incbin \\\"${INPUT}\\\"\\n.popsection\");
extern \"C\" const std::uint32_t ${NAME}[${words}];
")
