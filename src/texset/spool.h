#pragma once

#include <cstddef>
#include <filesystem>

namespace scree {

/// Numbers kept in a file without a name, to be read again.
///
/// It lets a baker that goes over its input several times decode it once. The file vanishes with
/// the object, or with the process. A spool that cannot be written (no room, no permission) says so
/// and is of no further use; that is no error.
class Spool {
public:
    /// folder  where the file takes its room
    explicit Spool(const std::filesystem::path& folder);
    ~Spool();
    Spool(const Spool&) = delete;
    Spool& operator=(const Spool&) = delete;

    /// Forgets what it holds; append() begins anew.
    void clear();

    /// False when it could not be kept; then whole() stays false.
    bool append(const float* numbers, size_t count);

    /// All there will be has been appended.
    void finish();
    [[nodiscard]] bool whole() const { return whole_; }

    /// read() begins at the first number again; for the last time, it gives back the room of what
    /// it read, so that the system need not write it to the disk.
    void rewind(bool last_time);

    /// The next `count` numbers. Throws Error when the disk fails.
    void read(float* numbers, size_t count);

    /// All numbers of a whole spool, to be read in any order, by any thread, as long as the object
    /// lives; what is not in memory comes from the file. Throws Error where that cannot be.
    [[nodiscard]] const float* all();

private:
    int file_ = -1;
    void* mapped_ = nullptr;
    size_t mapped_bytes_ = 0, written_bytes_ = 0;
    bool good_ = false, whole_ = false, last_time_ = false;
    long long position_ = 0; ///< bytes
};

} // namespace scree
