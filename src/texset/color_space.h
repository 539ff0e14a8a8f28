#pragma once

#include <memory>
#include <string>

namespace scree {

/// Color of an input file to scene-linear, by OpenColorIO.
class ColorConversion {
public:
    /// config_file     an OCIO config; empty: $OCIO, or else the small config Scree carries
    /// input_space     a color space, role or alias of the config; empty: what `file_metadata`
    ///                 names if the config knows it, or else what the config's file rules say
    /// file_metadata   the color space the file's header names, may be empty
    /// file            the file's path, for the rules and for messages
    /// Throws Error naming the file, the space and the config's spaces when one is unknown, or when
    /// the config cannot be read or has no scene_linear role.
    ColorConversion(const std::string& config_file, const std::string& input_space,
                    const std::string& file_metadata, const std::string& file);
    ~ColorConversion();
    ColorConversion(ColorConversion&&) noexcept;
    ColorConversion& operator=(ColorConversion&&) noexcept;

    [[nodiscard]] const std::string& input_space() const { return input_space_; }
    [[nodiscard]] const std::string& working_space() const { return working_space_; }

    /// Converts `pixels` interleaved RGB triples in place. Thread safe.
    void apply(float* rgb, long pixels) const;

private:
    struct Processor;
    std::unique_ptr<Processor> processor_;
    std::string input_space_, working_space_;
};

} // namespace scree
