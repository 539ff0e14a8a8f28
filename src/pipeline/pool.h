#pragma once

#include <mutex>
#include <utility>
#include <vector>

namespace scree {

/// Things used again instead of being made anew; their memory stays allocated. Thread safe.
template <class T>
class Pool {
public:
    /// One that was given back, or a new one.
    T take()
    {
        const std::lock_guard lock(mutex_);
        if (free_.empty())
            return T();
        T item = std::move(free_.back());
        free_.pop_back();
        return item;
    }

    void give(T item)
    {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(item));
    }

private:
    std::mutex mutex_;
    std::vector<T> free_;
};

} // namespace scree
