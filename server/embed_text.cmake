# cmake -DINPUT=file -DOUTPUT=source.cpp -DNAME=kConstant -P embed_text.cmake
# Writes a source file that defines ossuary::server::NAME as the text of INPUT.
file(READ ${INPUT} text)
string(FIND "${text}" ")embedded\"" clash)
if(NOT clash EQUAL -1)
    message(FATAL_ERROR "${INPUT} contains the raw string's delimiter")
endif()
file(WRITE ${OUTPUT}
     "#include \"server/embedded.h\"\n\nnamespace ossuary::server {\n\nconst std::string_view ${NAME} =\n    R\"embedded(")
file(APPEND ${OUTPUT} "${text}")
file(APPEND ${OUTPUT} ")embedded\";\n\n}  // namespace ossuary::server\n")
