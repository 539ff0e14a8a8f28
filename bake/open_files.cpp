#include "bake/open_files.h"

#include <sys/resource.h>

namespace scree::tool {

void allow_many_open_files() noexcept
{
    rlimit limit{};
    if (getrlimit(RLIMIT_NOFILE, &limit) != 0)
        return;
    limit.rlim_cur = limit.rlim_max;
    (void)setrlimit(RLIMIT_NOFILE, &limit);
}

} // namespace scree::tool
