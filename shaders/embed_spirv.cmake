# cmake -DSPIRV=module.spv -DHEADER=name.h -DSYMBOL=Name -DOUT=name.cpp -P embed_spirv.cmake: the module as C++ source.
file(READ ${SPIRV} bytes HEX)
file(SHA256 ${SPIRV} sha256)
# SPIR-V files are little-endian words; eight to a line.
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${bytes}")
string(REGEX REPLACE "(...........)(...........)(...........)(...........)(...........)(...........)(...........)(...........)" "\\1\\2\\3\\4\\5\\6\\7\\8\n" words "${words}")
file(WRITE ${OUT} "#include \"${HEADER}\"

namespace vernier {
namespace {
constexpr std::uint32_t kWords[] = {
${words}
};
}  // namespace
constinit const std::span<const std::uint32_t> k${SYMBOL}Spirv{kWords};
constinit const std::string_view k${SYMBOL}Sha256{\"${sha256}\"};
}  // namespace vernier
")
