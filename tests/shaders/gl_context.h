#pragma once

// Shaders in tests: OpenGL off screen, in software, without a display.

#include <GLES3/gl3.h> // types and constants; the desktop has the same ones

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "support/files.h"

namespace scree::test {

/// The two dialects of GLSL that the kernel is written in.
enum class GlApi { desktop_330, es_300 };

/// "330 core" or "300 es".
std::string glsl_version(GlApi api);

/// What the tests call of OpenGL, the same functions in both dialects.
struct GlFunctions {
#define SCREE_GL(name) decltype(&gl##name) name = nullptr;
#include "shaders/gl_functions.inc"
#undef SCREE_GL
};

enum class GlFilter { nearest, trilinear };

/// A context and the few things the tests do with one. What it makes (textures, programs) lives as
/// long as it does; one context at a time.
class GlContext {
public:
    /// reason  receives why there is no context, when null is returned
    static std::unique_ptr<GlContext> make(GlApi api, std::string& reason);
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// A program from files below the project's folder, each stage the concatenation of its files
    /// behind the #version of the context. Throws with the log and the lines it names.
    GLuint program(const std::vector<std::string>& vertex_files,
                   const std::vector<std::string>& fragment_files);

    /// A float texture of four channels; levels[0] is the finest.
    GLuint texture(const std::vector<Image>& levels, GlFilter filter, GLint wrap = GL_REPEAT);

    /// An array of such textures, levels[level][layer].
    GLuint texture_array(const std::vector<std::vector<Image>>& levels, GlFilter filter);

    /// Only this level of the texture from now on.
    void show_level(GLuint texture, int level);

    /// Textures to the samplers named, units counted from 0.
    void bind(GLuint program, const std::vector<std::pair<std::string, GLuint>>& textures);

    /// Sets a uniform of float type with as many components as there are values (16: a matrix,
    /// column by column). Throws where the program has none of that name.
    void set(GLuint program, const std::string& name, const std::vector<float>& values);
    void set(GLuint program, const std::string& name, int value);

    /// Four vertices as a strip into a cleared float target. Row 0 is the lower edge of the
    /// picture, as OpenGL counts; four channels.
    Image draw(GLuint program, int width, int height);

private:
    GlContext(GlApi api, void* display, void* context);
    GLuint stage(GLenum kind, const std::vector<std::string>& files);
    GLint location(GLuint program, const std::string& name);
    GLenum target(GLuint texture) const;
    void expect_no_error(const char* doing);

    GlApi api_;
    void* display_;
    void* context_;
    GlFunctions gl_;
    std::set<GLuint> arrays_; ///< of the textures, those that are arrays
};

} // namespace scree::test
