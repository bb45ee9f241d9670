# cmake -DINPUT=x.codes -DNAME=x -DOUTPUT=x.cpp -P embed_codes.cmake
# Writes the text of a .codes file as a string literal. No other tool is needed, so it works for every
# target that CMake can build for.
file(READ "${INPUT}" text)
file(WRITE "${OUTPUT}" "// From ${NAME}.codes
#include <string_view>
#if defined(__clang__)
#pragma clang diagnostic ignored \"-Woverlength-strings\"
#endif
namespace runmark::codes {
extern const std::string_view ${NAME};
const std::string_view ${NAME} = R\"codes(${text})codes\";
}  // namespace runmark::codes
")
