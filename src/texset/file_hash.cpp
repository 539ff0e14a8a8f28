#include "texset/file_hash.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <fstream>
#include <memory>
#include <vector>

#include "math/error.h"

namespace scree {

std::string sha256_of_file(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(),
                                                                          EVP_MD_CTX_free);
    bool good = context && file && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
    std::vector<char> buffer(1 << 20);
    while (good && !file.eof()) {
        file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        good = !file.bad() && EVP_DigestUpdate(context.get(), buffer.data(),
                                               static_cast<size_t>(file.gcount())) == 1;
    }
    unsigned char digest[EVP_MAX_MD_SIZE];
    unsigned int size = 0;
    if (!good || EVP_DigestFinal_ex(context.get(), digest, &size) != 1)
        throw Error(fmt::format("{}: cannot be read", path.string()));
    std::string hex;
    for (unsigned int i = 0; i < size; ++i)
        hex += fmt::format("{:02x}", digest[i]);
    return hex;
}

} // namespace scree
