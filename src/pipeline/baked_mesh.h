#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "pipeline/options.h"
#include "texset/manifest.h"

namespace scree {

class LimitSurface;
class TexelMetrics;

/// The mesh of a bake, read once for all its tiles.
class BakedMesh {
public:
    /// Throws Error as read_mesh() and LimitSurface do.
    explicit BakedMesh(const BakeOptions& options);
    ~BakedMesh();

    [[nodiscard]] std::string name() const { return file_.string(); } ///< for messages
    [[nodiscard]] const TexelMetrics& metrics() const { return *metrics_; }
    /// Of the whole cage; without what is said of texels.
    [[nodiscard]] const MeshRecord& record() const { return record_; }

    /// Numbers of the tiles that its faces reach into, rising; and how many tiles have no number.
    [[nodiscard]] std::vector<int> tiles() const;
    [[nodiscard]] int tiles_without_number() const;

    [[nodiscard]] InputRecord input() const;
    /// What is odd about it, a sentence each.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

private:
    std::filesystem::path file_;
    std::unique_ptr<LimitSurface> surface_;
    std::unique_ptr<TexelMetrics> metrics_;
    MeshRecord record_;
    std::vector<std::string> warnings_;
};

} // namespace scree
