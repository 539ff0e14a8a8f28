#include "surface/obj_tags.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "math/error.h"

namespace scree {

namespace {

class Reader {
public:
    Reader(const ObjTag& tag, Mesh& mesh) : tag_(tag), mesh_(mesh) {}

    /// False for a tag that is not known.
    bool apply()
    {
        if (tag_.name == "crease")
            read_creases();
        else if (tag_.name == "corner")
            read_corners();
        else if (tag_.name == "hole")
            read_holes();
        else
            return apply_rule();
        return true;
    }

private:
    [[noreturn]] void fail(const std::string& what) const
    {
        throw Error(fmt::format("{}: tag {}: {}", mesh_.name, tag_.name, what));
    }

    bool apply_rule()
    {
        if (tag_.name == "interpolateboundary")
            mesh_.rules.boundary = choice(std::array{
                BoundaryRule::none, BoundaryRule::edge_and_corner, BoundaryRule::edge_only});
        else if (tag_.name == "facevaryinginterpolateboundary" ||
                 tag_.name == "facevaryinginterpolate")
            mesh_.rules.uv =
                choice(std::array{UvRule::none, UvRule::corners_only, UvRule::corners_plus1,
                                  UvRule::corners_plus2, UvRule::boundaries, UvRule::all});
        else if (tag_.name == "creasemethod")
            mesh_.rules.creases =
                word({"normal", "chaikin"}) == 0 ? CreaseRule::uniform : CreaseRule::chaikin;
        else if (tag_.name == "smoothtriangles")
            mesh_.rules.triangles = word({"catmark", "smooth"}) == 0 ? TriangleRule::catmull_clark
                                                                     : TriangleRule::smooth;
        else
            return false;
        return true;
    }

    void read_creases()
    {
        if (tag_.ints.empty() || tag_.ints.size() % 2 != 0)
            fail(fmt::format("{} vertices, expected pairs", tag_.ints.size()));
        for (size_t i = 0; i + 1 < tag_.ints.size(); i += 2)
            mesh_.creases.push_back({index(tag_.ints[i], mesh_.vertices.size(), "vertex"),
                                     index(tag_.ints[i + 1], mesh_.vertices.size(), "vertex"),
                                     sharpness(i / 2, tag_.ints.size() / 2)});
    }

    void read_corners()
    {
        for (size_t i = 0; i < tag_.ints.size(); ++i)
            mesh_.corners.push_back({index(tag_.ints[i], mesh_.vertices.size(), "vertex"),
                                     sharpness(i, tag_.ints.size())});
    }

    void read_holes()
    {
        for (const int face : tag_.ints)
            mesh_.holes.push_back(index(face, mesh_.face_sizes.size(), "face"));
    }

    int index(int value, size_t count, const char* what) const
    {
        if (value < 0 || static_cast<size_t>(value) >= count)
            fail(fmt::format("{} {}, expected 0 to {}", what, value, count - 1));
        return value;
    }

    double sharpness(size_t i, size_t count) const
    {
        if (tag_.reals.size() != 1 && tag_.reals.size() != count)
            fail(fmt::format("{} sharpnesses, expected 1 or {}", tag_.reals.size(), count));
        const double value = tag_.reals[tag_.reals.size() == 1 ? 0 : i];
        if (!std::isfinite(value))
            fail("a sharpness is not finite");
        return std::max(0.0, value);
    }

    template <class Rule, size_t count>
    Rule choice(const std::array<Rule, count>& rules) const
    {
        if (tag_.ints.size() != 1 || tag_.ints[0] < 0 || static_cast<size_t>(tag_.ints[0]) >= count)
            fail(fmt::format("expected one number, 0 to {}", count - 1));
        return rules[static_cast<size_t>(tag_.ints[0])];
    }

    /// Which of two words the tag says.
    int word(const std::array<std::string, 2>& words) const
    {
        for (int i = 0; i < 2; ++i)
            if (tag_.strings.size() == 1 && tag_.strings[0] == words[static_cast<size_t>(i)])
                return i;
        fail(fmt::format("expected \"{}\" or \"{}\"", words[0], words[1]));
    }

    const ObjTag& tag_;
    Mesh& mesh_;
};

} // namespace

std::vector<std::string> apply_tags(const std::vector<ObjTag>& tags, Mesh& mesh)
{
    std::vector<std::string> unknown;
    for (const ObjTag& tag : tags)
        if (!Reader(tag, mesh).apply() &&
            std::find(unknown.begin(), unknown.end(), tag.name) == unknown.end())
            unknown.push_back(tag.name);
    return unknown;
}

} // namespace scree
