#include "failures/cases.h"

#include <algorithm>

namespace scree::test {

std::vector<FailureCase> all_cases()
{
    std::vector<FailureCase> all;
    for (const auto& group :
         {direction_cases(), covariance_cases(), slope_law_cases(), color_cases(), relief_cases(),
          number_cases(), border_cases(), texel_cases(), filter_cases()})
        all.insert(all.end(), group.begin(), group.end());
    std::sort(all.begin(), all.end(),
              [](const FailureCase& a, const FailureCase& b) { return a.number < b.number; });
    return all;
}

} // namespace scree::test
