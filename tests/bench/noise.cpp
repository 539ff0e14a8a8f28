// scree_noise OUT.exr SIZE [--type float|half] [--compression zip|none]
//
// Writes the height map the benchmark bakes: SIZE x SIZE texels of periodic 1/f noise, one channel
// "Y", scanlines, the same bytes on every machine. Memory grows with the width, not the area.
//
//   h(s, t) = kAmplitude sum_k v_k(s, t),  k = 1 .. log2(SIZE)
//
// v_k is value noise on a periodic lattice of 2^k x 2^k nodes, uniform in [-1, 1], interpolated
// bilinearly. Equal amplitude in every octave is a spectrum of 1/f in amplitude. The last octave
// has a node a texel, so low mantissa bits are as hard to compress as those of a scanned surface.

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>
#include <half.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr float kAmplitude =
    0.25F; // rms slope near 0.3 at one unit a texel: a rough but real surface
constexpr int kStripRows = 64;
constexpr int kMaxSize = 1 << 16;

struct Options {
    std::string output;
    int size = 0;
    Imf::PixelType type = Imf::FLOAT;
    Imf::Compression compression = Imf::ZIP_COMPRESSION;
};

// splitmix64 finalizer
std::uint64_t mix(std::uint64_t x)
{
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
    return x ^ (x >> 31);
}

float lattice_value(int octave, std::size_t i, std::size_t j)
{
    const std::uint64_t key =
        (static_cast<std::uint64_t>(octave) << 48) ^ (static_cast<std::uint64_t>(j) << 24) ^ i;
    const auto bits = static_cast<std::uint32_t>(mix(key + 0x9e3779b97f4a7c15ULL) >> 40); // 24 bits
    return static_cast<float>(bits) * 0x1p-23F - 1.0F;
}

// One octave: the two lattice rows around the current row of texels.
struct Octave {
    int index;
    std::size_t nodes;
    std::size_t texels_per_node;
    std::vector<float> above, below;

    void fill(std::vector<float>& row, std::size_t j) const
    {
        for (std::size_t i = 0; i < nodes; ++i)
            row[i] = kAmplitude * lattice_value(index, i, j % nodes);
    }
};

class NoiseRows {
public:
    explicit NoiseRows(int size)
        : sum_(static_cast<std::size_t>(size)), coarser_(static_cast<std::size_t>(size))
    {
        const auto width = static_cast<std::size_t>(size);
        for (std::size_t nodes = 2; nodes <= width; nodes *= 2) {
            const int index = static_cast<int>(octaves_.size()) + 1;
            octaves_.push_back({index, nodes, width / nodes, std::vector<float>(nodes),
                                std::vector<float>(nodes)});
        }
    }

    // Rows come in order, 0 first.
    const std::vector<float>& next()
    {
        sum_[0] = 0.0F;
        for (Octave& octave : octaves_) {
            const std::size_t j = row_ / octave.texels_per_node;
            const std::size_t remainder = row_ % octave.texels_per_node;
            if (row_ == 0)
                octave.fill(octave.below, 0);
            if (remainder == 0) {
                octave.above.swap(octave.below);
                octave.fill(octave.below, j + 1);
            }
            add(octave, static_cast<float>(remainder) / static_cast<float>(octave.texels_per_node));
        }
        ++row_;
        return sum_;
    }

private:
    // The coarser octaves are linear between the nodes of this one's half-sized lattice, so
    // doubling their sum by midpoints is exact and a row costs two operations a texel, not one an
    // octave.
    void add(const Octave& octave, float fraction)
    {
        sum_.swap(coarser_);
        const std::size_t half_nodes = octave.nodes / 2;
        for (std::size_t i = 0; i < half_nodes; ++i) {
            const float here = coarser_[i];
            const float right = coarser_[i + 1 == half_nodes ? 0 : i + 1];
            sum_[2 * i] = here;
            sum_[2 * i + 1] = 0.5F * (here + right);
        }
        for (std::size_t i = 0; i < octave.nodes; ++i)
            sum_[i] += octave.above[i] + fraction * (octave.below[i] - octave.above[i]);
    }

    std::vector<Octave> octaves_;
    std::vector<float> sum_, coarser_;
    std::size_t row_ = 0;
};

template <class T>
void write_rows(Imf::OutputFile& file, const Options& options)
{
    const auto width = static_cast<std::size_t>(options.size);
    NoiseRows rows(options.size);
    std::vector<T> strip(width * kStripRows);
    for (int y = 0; y < options.size; y += kStripRows) {
        const int count = options.size - y < kStripRows ? options.size - y : kStripRows;
        for (int r = 0; r < count; ++r) {
            const std::vector<float>& row = rows.next();
            for (std::size_t x = 0; x < width; ++x)
                strip[static_cast<std::size_t>(r) * width + x] = static_cast<T>(row[x]);
        }
        const Imath::Box2i window({0, y}, {options.size - 1, y + count - 1});
        Imf::FrameBuffer frame;
        frame.insert("Y", Imf::Slice::Make(options.type, strip.data(), window, sizeof(T)));
        file.setFrameBuffer(frame);
        file.writePixels(count);
    }
}

void write_noise(const Options& options)
{
    Imf::setGlobalThreadCount(static_cast<int>(std::thread::hardware_concurrency()));
    Imf::Header header(options.size, options.size);
    header.compression() = options.compression;
    header.channels().insert("Y", Imf::Channel(options.type));
    Imf::OutputFile file(options.output.c_str(), header);
    if (options.type == Imf::HALF)
        write_rows<half>(file, options);
    else
        write_rows<float>(file, options);
}

int size_from(const std::string& text)
{
    std::size_t used = 0;
    const int size = std::stoi(text, &used);
    if (used != text.size() || size < 2 || size > kMaxSize || (size & (size - 1)) != 0)
        throw std::invalid_argument(text);
    return size;
}

Options parse(const std::vector<std::string>& args)
{
    Options options;
    int positional = 0;
    for (std::size_t i = 0; i < args.size(); ++i) {
        const std::string& arg = args[i];
        if (arg == "--type") {
            const std::string& value = args.at(++i);
            if (value != "float" && value != "half")
                throw std::invalid_argument(value);
            options.type = value == "half" ? Imf::HALF : Imf::FLOAT;
        } else if (arg == "--compression") {
            const std::string& value = args.at(++i);
            if (value != "zip" && value != "none")
                throw std::invalid_argument(value);
            options.compression = value == "zip" ? Imf::ZIP_COMPRESSION : Imf::NO_COMPRESSION;
        } else if (arg.rfind("--", 0) == 0 || positional == 2) {
            throw std::invalid_argument(arg);
        } else if (positional++ == 0) {
            options.output = arg;
        } else {
            options.size = size_from(arg);
        }
    }
    if (positional != 2)
        throw std::invalid_argument("OUT.exr and SIZE are required");
    return options;
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    try {
        options = parse({argv + 1, argv + argc});
    } catch (const std::exception& e) {
        std::fprintf(
            stderr,
            "scree_noise: error: bad argument (%s)\n"
            "usage: scree_noise OUT.exr SIZE [--type float|half] [--compression zip|none]\n"
            "       SIZE is a power of two, 2 to %d\n",
            e.what(), kMaxSize);
        return 2;
    }
    try {
        write_noise(options);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "scree_noise: error: %s: %s\n", options.output.c_str(), e.what());
        return 1;
    }
    return 0;
}
