#pragma once

#include <map>
#include <set>
#include <string>

namespace CLI {
class App;
}

namespace scree::tool {

/// What a manifest records of a command line: every option that was given, those of the groups that
/// its help shows included, by long name; the values of an option with a space between them.
///
/// unrecorded  names of those left out: what says how to run and not what to make
std::map<std::string, std::string> given_options(const CLI::App& command,
                                                 const std::set<std::string>& unrecorded);

} // namespace scree::tool
