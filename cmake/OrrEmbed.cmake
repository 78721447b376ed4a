# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DINPUT=file -DOUTPUT=file.c -DNAME=symbol -P OrrEmbed.cmake: a text file as a C array (string literals are too short
# for it in strict C).
file(READ "${INPUT}" hex HEX)
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
string(REGEX REPLACE "(0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,0x..,)" "\\1\n" bytes "${bytes}")
file(WRITE "${OUTPUT}" "// Made from ${INPUT}.\n#include <stddef.h>\nextern const char ${NAME}[];\nextern const size_t ${NAME}_n;\nconst char ${NAME}[] = {${bytes}0};\nconst size_t ${NAME}_n = sizeof ${NAME} - 1;\n")
