#pragma once

#include <memory>
#include <string>
#include <vector>

namespace scree {

/// Which conversion a file's colors need.
struct ColorRequest {
    std::string config_file;   ///< an OCIO config; empty: $OCIO, or else the one Scree carries
    std::string working_space; ///< scene-linear space, role or alias; empty: role scene_linear
    std::string input_space;   ///< space, role or alias of the file's colors; empty: see below
    std::string file_metadata; ///< space the header names (stated_color()), or a role; may be empty
    std::string file;          ///< its path, for the config's file rules and for messages
    std::string file_fallback = {}; ///< to go by where the config does not know file_metadata
};

/// Color of an input file to scene-linear, by OpenColorIO.
///
/// Without an input_space the colors are in the first of these that the config knows:
///   1. file_metadata, under any of the names that configs have for it;
///   2. file_fallback;
///   3. what the config's file rules say of the path.
/// A header that says just "Linear", as OpenImageIO does of every OpenEXR file, names no primaries:
/// a rule made for such files goes before it, the Default rule does not. Without either it is
/// Rec.709, the OpenEXR standard's assumption, or else the config's scene_linear.
class ColorConversion {
public:
    /// Throws Error naming the file, the space and the config's spaces when one is unknown; when
    /// the config cannot be read, or has no scene_linear role and no working space is given; when
    /// the working space is data, meant for a display, or encoded.
    explicit ColorConversion(const ColorRequest& request);
    ~ColorConversion();
    ColorConversion(ColorConversion&&) noexcept;
    ColorConversion& operator=(ColorConversion&&) noexcept;

    [[nodiscard]] const std::string& input_space() const { return input_space_; }
    [[nodiscard]] const std::string& working_space() const { return working_space_; }
    /// What a user should know: a header that names a space which the config does not have.
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

    /// Converts `pixels` interleaved RGB triples in place. Thread safe.
    void apply(float* rgb, long pixels) const;

private:
    struct Processor;
    std::unique_ptr<Processor> processor_;
    std::string input_space_, working_space_;
    std::vector<std::string> notes_;
};

} // namespace scree
