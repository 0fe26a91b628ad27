# cmake -DINPUT=page.html -DOUTPUT=x.cpp -DHEADER=room/x.hpp -DFUNCTION=name -P EmbedText.cmake
#
# Writes a source in which the text is string literals, of a length that every compiler takes. The text is ASCII, as
# apps/viewer/build.mjs makes it.
file(READ "${INPUT}" text)
string(LENGTH "${text}" length)
set(source "#include \"${HEADER}\"\n\nnamespace toccata::io {\n\n")
string(APPEND source "std::span<const std::string_view> ${FUNCTION}() {\n  using namespace std::string_view_literals;\n  static constexpr std::string_view pieces[] = {\n")
set(at 0)
while(at LESS length)
  string(SUBSTRING "${text}" ${at} 15000 piece)
  string(APPEND source "R\"toccata(${piece})toccata\"sv,\n")
  math(EXPR at "${at} + 15000")
endwhile()
string(APPEND source "  };\n  return pieces;\n}\n\n}  // namespace toccata::io\n")
file(WRITE "${OUTPUT}" "${source}")
