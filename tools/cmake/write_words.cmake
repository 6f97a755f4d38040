# SPDX-License-Identifier: Apache-2.0
# Writes the words of the SPIR-V file FROM to TO, as a C array NAME. Words are little endian, as glslang writes them here.
file(READ ${FROM} digits HEX)
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1,\n" words "${digits}")
file(WRITE ${TO} "const uint32_t ${NAME}[] = {\n${words}};\n")
