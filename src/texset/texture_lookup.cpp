#include "texset/texture_lookup.h"

#include <OpenImageIO/texture.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <mutex>
#include <vector>

#include "math/error.h"

namespace scree {

namespace {

struct DestroyTextures {
    void operator()(OIIO::TextureSystem* textures) const
    {
        OIIO::TextureSystem::destroy(textures, true);
    }
};

using ThreadInfo = OIIO::TextureSystem::Perthread;

/// What OpenImageIO keeps for each thread that looks up, lent to a thread for one lookup.
///
/// Its own way is a thread-local pointer found by the address of the cache. That outlives the cache
/// in threads that go on, such as a pool's, and a later cache at the same address takes it for its
/// own (2.4): hence these.
class ThreadInfos {
public:
    explicit ThreadInfos(OIIO::TextureSystem& textures) : textures_(textures) {}
    ~ThreadInfos()
    {
        for (ThreadInfo* info : idle_)
            textures_.destroy_thread_info(info);
    }
    ThreadInfos(const ThreadInfos&) = delete;
    ThreadInfos& operator=(const ThreadInfos&) = delete;

    /// Given back at the end of its life.
    class Loan {
    public:
        explicit Loan(ThreadInfos& from) : from_(from), info_(from.take()) {}
        ~Loan() { from_.give_back(info_); }
        Loan(const Loan&) = delete;
        Loan& operator=(const Loan&) = delete;

        [[nodiscard]] ThreadInfo* get() const { return info_; }

    private:
        ThreadInfos& from_;
        ThreadInfo* info_;
    };

private:
    ThreadInfo* take()
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (idle_.empty())
            return textures_.create_thread_info();
        ThreadInfo* info = idle_.back();
        idle_.pop_back();
        return info;
    }

    void give_back(ThreadInfo* info)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        idle_.push_back(info);
    }

    OIIO::TextureSystem& textures_;
    std::mutex mutex_;
    std::vector<ThreadInfo*> idle_;
};

struct Texture {
    OIIO::TextureSystem::TextureHandle* handle = nullptr; ///< null: the set does not have it
    std::filesystem::path file;
    int channels = 0;
};

constexpr size_t kMaps = static_cast<size_t>(Map::bumpslopes) + 1;

} // namespace

struct TextureLookup::System {
    /// Of its own: another set of the same name in this process shares nothing with it.
    std::unique_ptr<OIIO::TextureSystem, DestroyTextures> textures{
        OIIO::TextureSystem::create(false)};
    ThreadInfos thread_infos{*textures};
    OIIO::TextureOpt options;
    std::array<Texture, kMaps> maps;

    [[nodiscard]] const Texture& of(Map map) const { return maps[static_cast<size_t>(map)]; }
    [[noreturn]] void fail(const std::filesystem::path& file) const
    {
        throw Error(fmt::format("{}: cannot be read: {}; bake the set again", file.string(),
                                textures->geterror()));
    }
};

TextureLookup::TextureLookup(const std::filesystem::path& folder, const Manifest& manifest,
                             const TextureFilter& filter)
    : system_(std::make_unique<System>())
{
    OIIO::TextureSystem& textures = *system_->textures;
    textures.attribute("max_memory_MB", static_cast<float>(filter.cache_megabytes));
    OIIO::TextureOpt& options = system_->options;
    options.interpmode = OIIO::TextureOpt::InterpBilinear;
    options.mipmode = OIIO::TextureOpt::MipModeAniso;
    options.anisotropic = filter.anisotropy;
    if (filter.is_tiled)
        options.swrap = options.twrap = OIIO::TextureOpt::WrapPeriodic;
    for (const TextureRecord& record : manifest.textures) {
        const std::filesystem::path file = folder / record.file;
        const int channels = static_cast<int>(record.channels.size());
        const ThreadInfos::Loan info(system_->thread_infos);
        auto* handle = textures.get_texture_handle(OIIO::ustring(file.string()), info.get());
        int found = 0; // asking for it opens the file
        if (handle == nullptr ||
            !textures.get_texture_info(handle, info.get(), 0, OIIO::ustring("channels"),
                                       OIIO::TypeDesc::INT, &found))
            system_->fail(file);
        if (found != channels)
            throw Error(fmt::format("{}: has {} channels, its manifest says {}; bake the set again",
                                    file.string(), found, channels));
        system_->maps[static_cast<size_t>(record.map)] = {handle, file, channels};
    }
}

TextureLookup::~TextureLookup() = default;
TextureLookup::TextureLookup(TextureLookup&&) noexcept = default;
TextureLookup& TextureLookup::operator=(TextureLookup&&) noexcept = default;

bool TextureLookup::has(Map map) const { return system_->of(map).handle != nullptr; }

int TextureLookup::channels(Map map) const { return system_->of(map).channels; }

void TextureLookup::read(Map map, const TexturePlace& place, int first, int count,
                         float* result) const
{
    const Texture& texture = system_->of(map);
    assert(texture.handle != nullptr && first >= 0 && first + count <= texture.channels);
    OIIO::TextureOpt options = system_->options; // a lookup writes to it
    options.firstchannel = first;
    const ThreadInfos::Loan info(system_->thread_infos);
    if (!system_->textures->texture(texture.handle, info.get(), options, place.s, place.t,
                                    place.ds_dx, place.dt_dx, place.ds_dy, place.dt_dy, count,
                                    result))
        system_->fail(texture.file);
}

} // namespace scree
