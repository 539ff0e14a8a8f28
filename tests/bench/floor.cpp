// scree_floor INPUT UNCOMPRESSED_SET_DIR OUT_DIR --compression none|zip --threads N [--no-decode]
//
// The least time a bake can take: decodes INPUT and writes the texels of a set baked before with
// compression none, through OpenEXR, in the order of a streaming baker, and computes nothing.
//
//   INPUT                 scanline image, read in strips of 64 rows through OpenImageIO
//   UNCOMPRESSED_SET_DIR  *.exr, tiled, MIP-mapped, uncompressed, level 0 as large as INPUT; each
//   is
//                         rewritten under its own name in OUT_DIR with the header it has, except
//                         compression and line order (RANDOM_Y)
//   order                 after each row of level-0 tiles, every coarser row of tiles whose texels
//                         are then known
//   --threads N           workers in OpenEXR's pool; decoding, and writing of each file, have a
//                         thread of their own beside it, which mostly wait. N = 1: one thread in
//                         all
//   --no-decode           leave the input alone: the price of writing only
//
// The texels come from the page cache (tile by tile, so that no mapped page counts as memory): that
// copy stands where a baker computes. Times printed are sums over threads and may exceed the wall.

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfThreading.h>
#include <ImfTiledInputFile.h>
#include <ImfTiledOutputFile.h>
#include <OpenImageIO/imageio.h>
#include <openexr.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace fs = std::filesystem;

namespace {

constexpr int kStripRows = 64;
constexpr int kDecodeAhead = 4; // strips: as far as a baker with a small buffer would run ahead

struct Options {
    std::string input, set_dir, out_dir;
    Imf::Compression compression = Imf::NO_COMPRESSION;
    int threads = 0;
    bool decode = true;
};

struct Seconds {
    double decode = 0, copy = 0, write = 0;
};

double seconds_of(const std::function<void()>& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// texels from first to last, both included, as OpenEXR's boxes have them
std::size_t extent(int first, int last)
{
    const int texels = last - first + 1;
    return static_cast<std::size_t>(texels);
}

// Tiles of an uncompressed file, found through its chunk offset table.
class RawTiles {
public:
    explicit RawTiles(const std::string& path) : path_(path)
    {
        exr_context_initializer_t init = EXR_DEFAULT_CONTEXT_INITIALIZER;
        check(exr_start_read(&context_, path.c_str(), &init));
    }
    ~RawTiles() { exr_finish(&context_); }
    RawTiles(const RawTiles&) = delete;
    RawTiles& operator=(const RawTiles&) = delete;

    // For each row of texels: each channel in the header's order. Valid until the next call.
    const std::vector<char>& read(int tile_x, int tile_y, int level)
    {
        exr_chunk_info_t chunk;
        check(exr_read_tile_chunk_info(context_, 0, tile_x, tile_y, level, level, &chunk));
        texels_.resize(chunk.packed_size);
        check(exr_read_chunk(context_, 0, &chunk, texels_.data()));
        return texels_;
    }

private:
    void check(exr_result_t result) const
    {
        if (result != EXR_ERR_SUCCESS)
            throw std::runtime_error(path_ + ": " + exr_get_default_error_message(result));
    }

    std::string path_;
    exr_context_t context_ = nullptr;
    std::vector<char> texels_;
};

Imf::Header output_header(const Imf::TiledInputFile& in, Imf::Compression compression)
{
    const Imf::Header& source = in.header();
    const std::string name = in.fileName();
    if (source.compression() != Imf::NO_COMPRESSION)
        throw std::runtime_error(name + ": compressed, expected a set baked with compression none");
    if (source.tileDescription().mode != Imf::MIPMAP_LEVELS ||
        source.tileDescription().roundingMode != Imf::ROUND_DOWN)
        throw std::runtime_error(name + ": expected MIP levels, sizes rounded down");
    Imf::Header header = source;
    header.compression() = compression;
    header.lineOrder() = Imf::RANDOM_Y;
    return header;
}

// One texture of the set on its way from the uncompressed file to the new one.
class Rewriter {
public:
    Rewriter(const fs::path& source, const fs::path& target, const Options& options, int pool)
        : tiles_(source.string())
    {
        const Imf::TiledInputFile in(source.c_str(), 0);
        const Imf::Header header = output_header(in, options.compression);
        // A file's thread count is no more than its share of tile buffers, two a thread: with fewer
        // than this the pool runs dry whenever the writing thread is not scheduled at once.
        out_ = std::make_unique<Imf::TiledOutputFile>(target.c_str(), header, 4 * pool);
        next_row_.assign(static_cast<std::size_t>(out_->numLevels()), 0);

        std::size_t bytes_per_texel = 0;
        for (auto c = header.channels().begin(); c != header.channels().end(); ++c) {
            channels_.push_back(
                {c.name(), c.channel().type, c.channel().type == Imf::HALF ? 2U : 4U});
            bytes_per_texel += channels_.back().bytes;
        }
        strip_.resize(static_cast<std::size_t>(out_->levelWidth(0)) * out_->tileYSize() *
                      bytes_per_texel);
    }

    int width() const { return out_->levelWidth(0); }
    int height() const { return out_->levelHeight(0); }

    // Writes all rows of tiles that are complete once `rows` rows of level 0 are known.
    void advance(int rows, Seconds& seconds)
    {
        for (int level = 0; level < out_->numLevels(); ++level) {
            int& tile_y = next_row_[static_cast<std::size_t>(level)];
            const int height_texels = out_->levelHeight(level);
            const int known = rows == height() ? height_texels : rows >> level;
            while (tile_y < out_->numYTiles(level) &&
                   known >= std::min(height_texels,
                                     (tile_y + 1) * static_cast<int>(out_->tileYSize()))) {
                seconds.copy += seconds_of([&] { fill_strip(tile_y, level); });
                seconds.write += seconds_of([&] {
                    out_->writeTiles(0, out_->numXTiles(level) - 1, tile_y, tile_y, level);
                });
                ++tile_y;
            }
        }
    }

private:
    struct Channel {
        std::string name;
        Imf::PixelType type;
        std::size_t bytes;
    };

    // A plane a channel, the texels of one row of tiles, row after row.
    void fill_strip(int tile_y, int level)
    {
        const int last = out_->numXTiles(level) - 1;
        const Imath::Box2i window(out_->dataWindowForTile(0, tile_y, level).min,
                                  out_->dataWindowForTile(last, tile_y, level).max);
        const auto width = extent(window.min.x, window.max.x);
        const auto rows = extent(window.min.y, window.max.y);

        for (int tile_x = 0; tile_x <= last; ++tile_x) {
            const Imath::Box2i tile = out_->dataWindowForTile(tile_x, tile_y, level);
            const auto first = static_cast<std::size_t>(tile.min.x - window.min.x);
            const auto count = extent(tile.min.x, tile.max.x);
            const std::vector<char>& texels = tiles_.read(tile_x, tile_y, level);
            const char* from = texels.data();
            for (std::size_t row = 0; row < rows; ++row) {
                char* plane = strip_.data();
                for (const Channel& c : channels_) {
                    std::memcpy(plane + (row * width + first) * c.bytes, from, count * c.bytes);
                    from += count * c.bytes;
                    plane += rows * width * c.bytes;
                }
            }
            if (from != texels.data() + texels.size())
                throw std::runtime_error(std::string(out_->fileName()) +
                                         ": tile of unexpected size");
        }

        Imf::FrameBuffer frame;
        char* plane = strip_.data();
        for (const Channel& c : channels_) {
            frame.insert(c.name, Imf::Slice::Make(c.type, plane, window, c.bytes));
            plane += rows * width * c.bytes;
        }
        out_->setFrameBuffer(frame);
    }

    RawTiles tiles_;
    std::unique_ptr<Imf::TiledOutputFile> out_;
    std::vector<Channel> channels_;
    std::vector<char> strip_;
    std::vector<int> next_row_;
};

class Decoder {
public:
    explicit Decoder(const std::string& path) : path_(path), in_(OIIO::ImageInput::open(path))
    {
        if (!in_)
            throw std::runtime_error(path + ": " + OIIO::geterror());
        if (in_->spec().tile_width != 0)
            throw std::runtime_error(path + ": tiled, expected scanlines");
        strip_.resize(in_->spec().scanline_bytes(true) * kStripRows);
    }

    int width() const { return in_->spec().width; }
    int height() const { return in_->spec().height; }

    void read(int begin, int end)
    {
        const OIIO::ImageSpec& spec = in_->spec();
        if (!in_->read_scanlines(0, 0, spec.y + begin, spec.y + end, 0, 0, spec.nchannels,
                                 OIIO::TypeUnknown, strip_.data()))
            throw std::runtime_error(path_ + ": " + in_->geterror());
    }

private:
    std::string path_;
    std::unique_ptr<OIIO::ImageInput> in_;
    std::vector<char> strip_;
};

// Keeps the decoder at most kDecodeAhead strips before the slowest writer, and no writer before it.
class Progress {
public:
    explicit Progress(std::size_t writers) : written_(writers, 0) {}
    void strip_decoded()
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ++decoded_;
        changed_.notify_all();
    }
    void strip_written(std::size_t writer)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ++written_[writer];
        changed_.notify_all();
    }
    void stop()
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        stopped_ = true;
        changed_.notify_all();
    }
    // Both return false if another thread failed.
    bool wait_to_decode()
    {
        std::unique_lock<std::mutex> lock(mutex_);
        changed_.wait(lock, [&] {
            return stopped_ ||
                   decoded_ < *std::min_element(written_.begin(), written_.end()) + kDecodeAhead;
        });
        return !stopped_;
    }
    bool wait_to_write(int strip)
    {
        std::unique_lock<std::mutex> lock(mutex_);
        changed_.wait(lock, [&] { return stopped_ || decoded_ > strip; });
        return !stopped_;
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    int decoded_ = 0;
    std::vector<int> written_;
    bool stopped_ = false;
};

using Rewriters = std::vector<std::unique_ptr<Rewriter>>;

void run_in_one_thread(Decoder* decoder, const Rewriters& rewriters, int height, Seconds& seconds)
{
    for (int y = 0; y < height; y += kStripRows) {
        const int end = std::min(height, y + kStripRows);
        if (decoder)
            seconds.decode += seconds_of([&] { decoder->read(y, end); });
        for (const auto& rewriter : rewriters)
            rewriter->advance(end, seconds);
    }
}

// A thread decodes, and one a file copies and writes: while one file waits for write(), another
// fills the pool.
void run_in_threads(Decoder* decoder, const Rewriters& rewriters, int height, Seconds& seconds)
{
    const int strips = (height + kStripRows - 1) / kStripRows;
    Progress progress(rewriters.size());
    std::vector<Seconds> by_thread(rewriters.size() + 1);
    std::vector<std::exception_ptr> failures(rewriters.size() + 1);

    const auto guarded = [&](std::size_t thread, const std::function<void()>& work) {
        try {
            work();
        } catch (...) {
            failures[thread] = std::current_exception();
            progress.stop();
        }
    };
    const auto decode = [&] {
        for (int strip = 0; strip < strips && progress.wait_to_decode(); ++strip) {
            const int y = strip * kStripRows;
            if (decoder)
                by_thread.back().decode +=
                    seconds_of([&] { decoder->read(y, std::min(height, y + kStripRows)); });
            progress.strip_decoded();
        }
    };
    const auto write = [&](std::size_t file) {
        for (int strip = 0; strip < strips && progress.wait_to_write(strip); ++strip) {
            rewriters[file]->advance(std::min(height, (strip + 1) * kStripRows), by_thread[file]);
            progress.strip_written(file);
        }
    };

    std::vector<std::thread> threads;
    for (std::size_t file = 0; file < rewriters.size(); ++file)
        threads.emplace_back([&, file] { guarded(file, [&] { write(file); }); });
    guarded(rewriters.size(), decode);
    for (std::thread& thread : threads)
        thread.join();
    for (const std::exception_ptr& failure : failures)
        if (failure)
            std::rethrow_exception(failure);
    for (const Seconds& s : by_thread) {
        seconds.decode += s.decode;
        seconds.copy += s.copy;
        seconds.write += s.write;
    }
}

void run(const Options& options, Seconds& seconds)
{
    // OpenEXR compresses in the calling thread when its pool is empty.
    const int pool = options.threads == 1 ? 0 : options.threads;
    OIIO::attribute("threads", options.threads);
    OIIO::attribute("exr_threads", options.threads == 1 ? -1 : options.threads); // -1: none
    Imf::setGlobalThreadCount(pool);

    std::vector<fs::path> sources;
    for (const fs::directory_entry& entry : fs::directory_iterator(options.set_dir))
        if (entry.path().extension() == ".exr")
            sources.push_back(entry.path());
    std::sort(sources.begin(), sources.end());
    if (sources.empty())
        throw std::runtime_error(options.set_dir + ": no .exr file, expected a baked set");

    std::unique_ptr<Decoder> decoder;
    if (options.decode)
        decoder = std::make_unique<Decoder>(options.input);
    fs::create_directories(options.out_dir);
    Rewriters rewriters;
    for (const fs::path& source : sources) {
        const fs::path target = options.out_dir / source.filename();
        if (fs::exists(target) && fs::equivalent(source, target))
            throw std::runtime_error(target.string() + ": would overwrite the set it reads");
        rewriters.push_back(std::make_unique<Rewriter>(source, target, options, pool));
        const Rewriter& r = *rewriters.back();
        if (decoder && (r.width() != decoder->width() || r.height() != decoder->height()))
            throw std::runtime_error(source.string() + ": not as large as " + options.input);
        if (r.height() != rewriters.front()->height())
            throw std::runtime_error(source.string() + ": not as large as " +
                                     sources.front().string());
    }
    Imf::setGlobalThreadCount(pool); // opening the input may have made OpenImageIO set its own

    const int height = rewriters.front()->height();
    if (options.threads == 1)
        run_in_one_thread(decoder.get(), rewriters, height, seconds);
    else
        run_in_threads(decoder.get(), rewriters, height, seconds);
    seconds.write += seconds_of([&] { rewriters.clear(); }); // offset tables are written on closing
}

Options parse(const std::vector<std::string>& args)
{
    Options options;
    bool compression_given = false;
    std::vector<std::string> positional;
    for (std::size_t i = 0; i < args.size(); ++i) {
        const std::string& arg = args[i];
        if (arg == "--compression") {
            const std::string& value = args.at(++i);
            if (value != "zip" && value != "none")
                throw std::invalid_argument(value);
            options.compression = value == "zip" ? Imf::ZIP_COMPRESSION : Imf::NO_COMPRESSION;
            compression_given = true;
        } else if (arg == "--threads") {
            options.threads = std::stoi(args.at(++i));
        } else if (arg == "--no-decode") {
            options.decode = false;
        } else if (arg.rfind("--", 0) == 0) {
            throw std::invalid_argument(arg);
        } else {
            positional.push_back(arg);
        }
    }
    if (positional.size() != 3 || !compression_given || options.threads < 1)
        throw std::invalid_argument("three paths, --compression and --threads >= 1 are required");
    options.input = positional[0];
    options.set_dir = positional[1];
    options.out_dir = positional[2];
    return options;
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    try {
        options = parse({argv + 1, argv + argc});
    } catch (const std::exception& e) {
        std::fprintf(stderr,
                     "scree_floor: error: bad argument (%s)\n"
                     "usage: scree_floor INPUT UNCOMPRESSED_SET_DIR OUT_DIR\n"
                     "                   --compression none|zip --threads N [--no-decode]\n",
                     e.what());
        return 2;
    }
    try {
        Seconds seconds;
        const double wall = seconds_of([&] { run(options, seconds); });
        std::printf("wall %.3f s  decode %.3f s  copy %.3f s  write %.3f s\n", wall, seconds.decode,
                    seconds.copy, seconds.write);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "scree_floor: error: %s\n", e.what());
        return 1;
    }
    return 0;
}
