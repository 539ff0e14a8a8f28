#include "pipeline/write_pass.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <memory>

#include "math/error.h"
#include "pipeline/pool.h"

namespace scree {

namespace {

struct FinishedRow {
    TextureOutput* output;
    TileRow row;
};

using StripPtr = std::shared_ptr<Strip>;
using Finished = std::shared_ptr<std::vector<FinishedRow>>;

/// The first two stages of a pass: strips read, and run through the pyramid.
class StripStages {
public:
    StripStages(StripReader& reader, MomentPyramid& pyramid, const TexelMoments& texels)
        : reader_(reader), pyramid_(pyramid), texels_(texels)
    {}

    /// The next strip, or the end of the pipeline.
    StripPtr read(tbb::flow_control& control)
    {
        StripPtr strip = used_.take();
        if (!strip)
            strip = std::make_shared<Strip>();
        if (!reader_.next(*strip))
            control.stop();
        return strip;
    }

    /// Returns the number of rows done.
    int make_texels(const StripPtr& strip)
    {
        pyramid_.push(strip->count, [&](int y, int x0, int count, MomentRow row) {
            texels_.fill(*strip, y, x0, count, row);
        });
        const int done = strip->first_row + strip->count;
        used_.give(strip);
        return done;
    }

private:
    StripReader& reader_;
    MomentPyramid& pyramid_;
    const TexelMoments& texels_;
    Pool<StripPtr> used_;
};

/// Compresses all tiles of a strip's finished rows.
void encode_all(std::vector<FinishedRow>& finished)
{
    struct Tile {
        FinishedRow* of;
        int tile_x;
    };
    std::vector<Tile> tiles;
    for (FinishedRow& f : finished)
        for (size_t t = 0; t < f.row.sizes.size(); ++t)
            tiles.push_back({&f, static_cast<int>(t)});
    tbb::parallel_for(size_t{0}, tiles.size(), [&](size_t i) {
        tiles[i].of->output->file->encode(tiles[i].of->row, tiles[i].tile_x);
    });
}

void expect_no_overflow(const std::vector<TextureOutput>& outputs)
{
    for (const TextureOutput& output : outputs)
        if (output.rows->overflowed())
            throw Error(fmt::format("{}: numbers beyond 65504 do not fit half floats; use "
                                    "--pixel-type float or auto, or check --texel-size and "
                                    "--height-scale",
                                    map_info(output.map).name));
}

} // namespace

void write_pass(StripReader& strips, MomentPyramid& pyramid, const TexelMoments& texels,
                std::vector<TextureOutput>& outputs, int height, const BakeMonitor& monitor)
{
    StripStages stages(strips, pyramid, texels);
    auto make_texels = [&](const StripPtr& strip) -> Finished {
        const int done = stages.make_texels(strip);
        auto finished = std::make_shared<std::vector<FinishedRow>>();
        for (TextureOutput& output : outputs)
            for (TileRow& row : output.rows->take_finished())
                finished->push_back({&output, std::move(row)});
        monitor.report("bake", static_cast<double>(done) / height);
        return finished;
    };
    auto encode = [](const Finished& finished) -> Finished {
        encode_all(*finished);
        return finished;
    };
    auto write = [&](const Finished& finished) {
        for (FinishedRow& f : *finished) {
            f.output->file->write(f.row);
            f.output->rows->recycle(std::move(f.row));
        }
    };

    // Two strips are computed or compressed while one is read and one written.
    const auto in_flight = static_cast<size_t>(tbb::this_task_arena::max_concurrency()) + 1;
    tbb::parallel_pipeline(
        in_flight,
        tbb::make_filter<void, StripPtr>(tbb::filter_mode::serial_in_order,
                                         [&](tbb::flow_control& c) { return stages.read(c); }) &
            tbb::make_filter<StripPtr, Finished>(tbb::filter_mode::serial_in_order, make_texels) &
            tbb::make_filter<Finished, Finished>(tbb::filter_mode::parallel, encode) &
            tbb::make_filter<Finished, void>(tbb::filter_mode::serial_in_order, write));
    expect_no_overflow(outputs);
    for (TextureOutput& output : outputs)
        output.file->close();
}

void measure_pass(StripReader& strips, MomentPyramid& pyramid, const TexelMoments& texels,
                  int height, const BakeMonitor& monitor)
{
    StripStages stages(strips, pyramid, texels);
    tbb::parallel_pipeline(
        2, tbb::make_filter<void, StripPtr>(tbb::filter_mode::serial_in_order,
                                            [&](tbb::flow_control& c) { return stages.read(c); }) &
               tbb::make_filter<StripPtr, void>(
                   tbb::filter_mode::serial_in_order, [&](const StripPtr& strip) {
                       const int done = stages.make_texels(strip);
                       monitor.report("measure", static_cast<double>(done) / height);
                   }));
}

} // namespace scree
