# cmake -DFILE=... -DSYMBOL=... -DHEADER=... -DOUT=... -P embed_file.cmake
# writes C++ that defines vernier::SYMBOL, the bytes of FILE, as HEADER declares it.
file(READ ${FILE} hex HEX)
string(LENGTH "${hex}" digits)
math(EXPR size "${digits} / 2")
string(REGEX REPLACE "(................................................................)" "\\1\n" hex "${hex}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
file(WRITE ${OUT} "#include \"${HEADER}\"

namespace vernier {
namespace {
const unsigned char kBytes[${size}] = {
${bytes}};
}  // namespace

const std::span<const std::byte> ${SYMBOL} = std::as_bytes(std::span(kBytes));

}  // namespace vernier
")
