#include "texset/spool.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <numeric>
#include <vector>

#include "support/files.h"

namespace scree::test {
namespace {

TEST(Spool, GivesBackWhatItWasGivenAsOftenAsAsked)
{
    TempFolder temp;
    Spool spool(temp.path());
    std::vector<float> numbers(100000), back(numbers.size());
    std::iota(numbers.begin(), numbers.end(), 0.5F);
    ASSERT_TRUE(spool.append(numbers.data(), 1));
    spool.clear();
    for (size_t i = 0; i < numbers.size(); i += 1000)
        ASSERT_TRUE(spool.append(&numbers[i], 1000));
    EXPECT_FALSE(spool.whole());
    spool.finish();
    ASSERT_TRUE(spool.whole());
    for (const bool last_time : {false, false, true}) {
        spool.rewind(last_time);
        std::fill(back.begin(), back.end(), 0.0F);
        for (size_t i = 0; i < back.size(); i += 20000)
            spool.read(&back[i], 20000);
        EXPECT_EQ(numbers, back);
    }
    EXPECT_TRUE(std::filesystem::is_empty(temp.path())) << "the file has no name";
}

TEST(Spool, WithoutAPlaceToWriteItIsNeverWhole)
{
    Spool spool("no/such/folder");
    const float number = 1;
    EXPECT_FALSE(spool.append(&number, 1));
    spool.finish();
    EXPECT_FALSE(spool.whole());
}

} // namespace
} // namespace scree::test
