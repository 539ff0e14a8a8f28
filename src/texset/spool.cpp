#include "texset/spool.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "math/error.h"

namespace scree {

namespace {

int open_unnamed(const std::filesystem::path& folder)
{
    const int file = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (file >= 0)
        return file;
    // Some network file systems have no unnamed files.
    std::string name = (folder / "spool-XXXXXX").string();
    const int named = mkostemp(name.data(), O_CLOEXEC);
    if (named >= 0)
        unlink(name.c_str());
    return named;
}

} // namespace

Spool::Spool(const std::filesystem::path& folder) : file_(open_unnamed(folder)), good_(file_ >= 0)
{}

Spool::~Spool()
{
    if (mapped_ != nullptr)
        munmap(mapped_, mapped_bytes_);
    if (file_ >= 0)
        close(file_);
}

void Spool::clear()
{
    position_ = 0;
    whole_ = false;
}

bool Spool::append(const float* numbers, size_t count)
{
    const char* bytes = reinterpret_cast<const char*>(numbers);
    size_t left = count * sizeof(float);
    while (good_ && left > 0) {
        const ssize_t written = pwrite(file_, bytes, left, position_);
        if (written < 0 && errno == EINTR)
            continue;
        good_ = written > 0;
        if (!good_) {
            (void)!ftruncate(file_, 0); // gives the room back to those who need it
            break;
        }
        bytes += written;
        left -= static_cast<size_t>(written);
        position_ += written;
    }
    return good_;
}

void Spool::finish()
{
    whole_ = good_;
    written_bytes_ = static_cast<size_t>(position_);
    position_ = 0;
}

const float* Spool::all()
{
    if (mapped_ == nullptr && whole_ && written_bytes_ > 0) {
        void* mapped = mmap(nullptr, written_bytes_, PROT_READ, MAP_SHARED, file_, 0);
        if (mapped != MAP_FAILED) {
            mapped_ = mapped;
            mapped_bytes_ = written_bytes_;
        }
    }
    if (mapped_ == nullptr)
        throw Error("a temporary file beside the output cannot be read back; is there room for the "
                    "heights as floats?");
    return static_cast<const float*>(mapped_);
}

void Spool::rewind(bool last_time)
{
    position_ = 0;
    last_time_ = last_time;
}

void Spool::read(float* numbers, size_t count)
{
    const long long begin = position_;
    char* bytes = reinterpret_cast<char*>(numbers);
    size_t left = count * sizeof(float);
    while (left > 0) {
        const ssize_t got = pread(file_, bytes, left, position_);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            throw Error("a temporary file beside the output cannot be read back; is the disk in "
                        "order?");
        bytes += got;
        left -= static_cast<size_t>(got);
        position_ += got;
    }
    if (last_time_) // where a file system cannot, the room comes back at the end
        (void)!fallocate(file_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, begin,
                         position_ - begin);
}

} // namespace scree
