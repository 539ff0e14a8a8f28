#include "texset/texture_lookup.h"

#include <OpenImageIO/texture.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "math/error.h"

namespace scree {

namespace {

struct DestroyTextures {
    void operator()(OIIO::TextureSystem* textures) const
    {
        OIIO::TextureSystem::destroy(textures, true);
    }
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
        auto* handle = textures.get_texture_handle(OIIO::ustring(file.string()));
        if (handle == nullptr || !textures.good(handle))
            system_->fail(file);
        system_->maps[static_cast<size_t>(record.map)] = {handle, file,
                                                          static_cast<int>(record.channels.size())};
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
    if (!system_->textures->texture(texture.handle, system_->textures->get_perthread_info(),
                                    options, place.s, place.t, place.ds_dx, place.dt_dx,
                                    place.ds_dy, place.dt_dy, count, result))
        system_->fail(texture.file);
}

} // namespace scree
