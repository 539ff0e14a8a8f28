#include "shaders/osl_tools.h"

#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace scree::test {

namespace {

std::filesystem::path program(const std::string& name)
{
    std::vector<std::filesystem::path> folders;
    if (const char* root = std::getenv("OSL_ROOT"))
        folders.push_back(std::filesystem::path(root) / "bin");
    std::istringstream path(std::getenv("PATH") ? std::getenv("PATH") : "");
    for (std::string folder; std::getline(path, folder, ':');)
        folders.emplace_back(folder);
    for (const auto& folder : folders)
        if (std::filesystem::exists(folder / name))
            return folder / name;
    return {};
}

std::string quoted(const std::string& word)
{
    std::string out = "'";
    for (const char c : word)
        out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

} // namespace

OslTools find_osl() { return {program("oslc"), program("testshade"), program("testrender")}; }

RunResult run(const std::filesystem::path& folder, const std::vector<std::string>& command)
{
    std::string line = "cd " + quoted(folder.string()) + " &&";
    for (const auto& word : command)
        line += ' ' + quoted(word);
    RunResult result;
    std::FILE* pipe = ::popen((line + " 2>&1").c_str(), "r");
    if (!pipe)
        return result;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
        result.said += static_cast<char>(c);
    const int status = ::pclose(pipe);
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return result;
}

} // namespace scree::test
