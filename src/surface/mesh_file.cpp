#include "surface/mesh_file.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>

#include "math/error.h"
#include "surface/obj_lines.h"
#include "surface/obj_tags.h"
#include "texset/readable.h"

namespace scree {

namespace {

/// Tiles to either side of the first one that texture coordinates may reach.
constexpr double kMostTiles = 1000;

/// What the library makes of a file.
struct Parsed {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
};

Parsed parse(const std::string& text, const std::string& file)
{
    Parsed parsed;
    std::vector<tinyobj::material_t> materials;
    std::string warnings, errors;
    std::istringstream stream(text);
    if (!tinyobj::LoadObj(&parsed.attributes, &parsed.shapes, &materials, &warnings, &errors,
                          &stream, nullptr, false)) {
        errors.erase(errors.find_last_not_of(" \n") + 1);
        throw Error(fmt::format("{}: not a valid OBJ file: {}", file, errors));
    }
    return parsed;
}

std::string read_text(const std::filesystem::path& path)
{
    expect_readable(path, "a mesh (OBJ)");
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (in.bad() || text.fail())
        throw Error(fmt::format("{}: cannot be read", path.string()));
    return std::move(text).str();
}

void copy_points(const tinyobj::attrib_t& attributes, Mesh& mesh)
{
    const std::vector<double>& v = attributes.vertices;
    const std::vector<double>& vt = attributes.texcoords;
    for (size_t i = 0; i + 2 < v.size(); i += 3)
        mesh.vertices.emplace_back(v[i], v[i + 1], v[i + 2]);
    for (size_t i = 0; i + 1 < vt.size(); i += 2)
        mesh.uvs.emplace_back(vt[i], vt[i + 1]);
    // What is a number in the file may still be beyond the range of the library's own parser.
    for (const Vec3& p : mesh.vertices)
        if (!std::isfinite(p.x + p.y + p.z))
            throw Error(fmt::format("{}: a vertex beyond the range of numbers", mesh.name));
    for (const Vec2& uv : mesh.uvs)
        if (!(std::max(std::abs(uv.x), std::abs(uv.y)) <= kMostTiles))
            throw Error(fmt::format("{}: texture coordinate ({}, {}), expected within {} of 0; "
                                    "unwrap the mesh again",
                                    mesh.name, uv.x, uv.y, kMostTiles));
}

void copy_faces(const std::vector<tinyobj::shape_t>& shapes, Mesh& mesh)
{
    for (const tinyobj::shape_t& shape : shapes) {
        for (const unsigned char size : shape.mesh.num_face_vertices)
            mesh.face_sizes.push_back(size);
        for (const tinyobj::index_t& corner : shape.mesh.indices) {
            mesh.face_vertices.push_back(corner.vertex_index);
            mesh.face_uvs.push_back(corner.texcoord_index);
        }
    }
}

/// Counts from 1, as the file does.
void expect_index(const Mesh& mesh, size_t face, int index, size_t count, const char* what)
{
    if (index < 0 || static_cast<size_t>(index) >= count)
        throw Error(fmt::format("{}: face {} names {} {}, but there are {}; is the file cut short?",
                                mesh.name, face + 1, what, index + 1, count));
}

void expect_indices(const Mesh& mesh)
{
    size_t corner = 0, without_uvs = 0, first_without = 0;
    for (size_t face = 0; face < mesh.face_sizes.size(); ++face) {
        bool has_uvs = true;
        for (int i = 0; i < mesh.face_sizes[face]; ++i, ++corner) {
            expect_index(mesh, face, mesh.face_vertices[corner], mesh.vertices.size(), "vertex");
            // The library says -1 for none.
            if (mesh.face_uvs[corner] == -1)
                has_uvs = false;
            else
                expect_index(mesh, face, mesh.face_uvs[corner], mesh.uvs.size(),
                             "texture coordinate");
        }
        if (!has_uvs && without_uvs++ == 0)
            first_without = face + 1;
    }
    if (without_uvs == mesh.face_sizes.size())
        throw Error(fmt::format("{}: no texture coordinates (UVs), expected one at each corner of "
                                "each face; unwrap the mesh and export it with UVs",
                                mesh.name));
    if (without_uvs > 0)
        throw Error(fmt::format("{}: {} of {} faces have corners without texture coordinates, the "
                                "first is face {}; unwrap them or remove them",
                                mesh.name, without_uvs, mesh.face_sizes.size(), first_without));
}

/// The library hands every shape the tags so far, the last one all of them.
std::vector<ObjTag> tags_of(const std::vector<tinyobj::shape_t>& shapes)
{
    std::vector<ObjTag> tags;
    for (const tinyobj::tag_t& tag : shapes.back().mesh.tags)
        tags.push_back({tag.name, tag.intValues, tag.floatValues, tag.stringValues});
    return tags;
}

} // namespace

MeshFile read_mesh(const std::filesystem::path& path)
{
    const std::string text = read_text(path);
    MeshFile file;
    Mesh& mesh = file.mesh;
    mesh.name = path.string();
    const int tag_lines = check_obj_lines(text, mesh.name);
    const Parsed parsed = parse(text, mesh.name);
    copy_points(parsed.attributes, mesh);
    copy_faces(parsed.shapes, mesh);
    if (mesh.face_sizes.empty())
        throw Error(fmt::format("{}: no faces, expected a mesh of polygons", mesh.name));
    expect_indices(mesh);
    const std::vector<ObjTag> tags = tags_of(parsed.shapes);
    if (tags.size() != static_cast<size_t>(tag_lines))
        throw Error(
            fmt::format("{}: {} of {} subdivision tags (lines \"t ...\") stand after a group "
                        "without faces; move them before its g or o line",
                        mesh.name, static_cast<size_t>(tag_lines) - tags.size(), tag_lines));
    file.unknown_tags = apply_tags(tags, mesh);
    return file;
}

} // namespace scree
