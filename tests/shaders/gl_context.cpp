#include "shaders/gl_context.h"

#define EGL_NO_X11 // no display, no need for its headers
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace scree::test {

namespace {

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

/// The compiler's log, and the source lines it names: "0:12(5): error" is Mesa's way.
std::string explained(const std::string& log, const std::string& source)
{
    const auto lines = lines_of(source);
    std::set<size_t> named;
    static const std::regex place("0:([0-9]+)");
    for (std::sregex_iterator at(log.begin(), log.end(), place), end; at != end; ++at)
        named.insert(std::stoul((*at)[1]));
    std::string text = log;
    for (const size_t line : named)
        if (line >= 1 && line <= lines.size())
            text += fmt::format("{:5} | {}\n", line, lines[line - 1]);
    return text;
}

void use_filter(const GlFunctions& gl, GLenum target, GlFilter filter)
{
    const bool nearest = filter == GlFilter::nearest;
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER,
                     nearest ? GL_NEAREST_MIPMAP_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
}

} // namespace

std::string glsl_version(GlApi api) { return api == GlApi::desktop_330 ? "330 core" : "300 es"; }

std::unique_ptr<GlContext> GlContext::make(GlApi api, std::string& reason)
{
    // A graphics card would do too, but its rounding is its own.
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
    const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (extensions == nullptr ||
        std::strstr(extensions, "EGL_MESA_platform_surfaceless") == nullptr) {
        reason = "EGL has no surfaceless platform; is libgl1-mesa-dri installed?";
        return nullptr;
    }
    EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    const auto fail = [&](const std::string& what) {
        reason = fmt::format("{}: EGL error {:#x}", what, eglGetError());
        if (display != EGL_NO_DISPLAY)
            eglTerminate(display);
        return nullptr;
    };
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
        return fail("no surfaceless display");

    const bool desktop = api == GlApi::desktop_330;
    if (eglBindAPI(desktop ? EGL_OPENGL_API : EGL_OPENGL_ES_API) == EGL_FALSE)
        return fail("no OpenGL " + glsl_version(api));
    const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE,
                             desktop ? EGL_OPENGL_BIT : EGL_OPENGL_ES3_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint configs = 0;
    if (eglChooseConfig(display, wanted, &config, 1, &configs) == EGL_FALSE || configs == 0)
        return fail("no configuration for OpenGL " + glsl_version(api));
    const EGLint desktop_version[] = {EGL_CONTEXT_MAJOR_VERSION,
                                      3,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      3,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_NONE};
    const EGLint es_version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0,
                                 EGL_NONE};
    EGLContext context =
        eglCreateContext(display, config, EGL_NO_CONTEXT, desktop ? desktop_version : es_version);
    if (context == EGL_NO_CONTEXT)
        return fail("no context for OpenGL " + glsl_version(api));
    if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE)
        return fail("cannot use OpenGL " + glsl_version(api));
    return std::unique_ptr<GlContext>(new GlContext(api, display, context));
}

GlContext::GlContext(GlApi api, void* display, void* context)
    : api_(api), display_(display), context_(context)
{
#define SCREE_GL(name)                                                                             \
    gl_.name = reinterpret_cast<decltype(gl_.name)>(eglGetProcAddress("gl" #name));                \
    if (gl_.name == nullptr)                                                                       \
        throw std::runtime_error("OpenGL has no function gl" #name);
#include "shaders/gl_functions.inc"
#undef SCREE_GL
    GLuint none = 0; // core profiles draw nothing without a vertex array, be it empty
    gl_.GenVertexArrays(1, &none);
    gl_.BindVertexArray(none);
}

GlContext::~GlContext()
{
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

void GlContext::expect_no_error(const char* doing)
{
    if (const GLenum error = gl_.GetError(); error != GL_NO_ERROR)
        throw std::runtime_error(fmt::format("OpenGL error {:#x}, {}", error, doing));
}

GLuint GlContext::stage(GLenum kind, const std::vector<std::string>& files)
{
    std::string source = "#version " + glsl_version(api_) + "\n", names;
    for (const std::string& file : files) {
        const std::string text = read_bytes(std::filesystem::path(SCREE_SOURCE) / file);
        if (text.empty())
            throw std::runtime_error(file + ": missing or empty");
        source += text;
        names += (names.empty() ? "" : " + ") + file;
    }
    const GLuint shader = gl_.CreateShader(kind);
    const char* start = source.c_str();
    gl_.ShaderSource(shader, 1, &start, nullptr);
    gl_.CompileShader(shader);
    GLint done = GL_FALSE;
    gl_.GetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (done == GL_FALSE) {
        std::string log(65536, '\0');
        GLsizei length = 0;
        gl_.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<size_t>(length));
        throw std::runtime_error("GLSL " + glsl_version(api_) + ", " + names + ":\n" +
                                 explained(log, source));
    }
    return shader;
}

GLuint GlContext::program(const std::vector<std::string>& vertex_files,
                          const std::vector<std::string>& fragment_files)
{
    const GLuint program = gl_.CreateProgram();
    for (const GLuint shader :
         {stage(GL_VERTEX_SHADER, vertex_files), stage(GL_FRAGMENT_SHADER, fragment_files)}) {
        gl_.AttachShader(program, shader);
        gl_.DeleteShader(shader); // lives on in the program
    }
    gl_.LinkProgram(program);
    GLint done = GL_FALSE;
    gl_.GetProgramiv(program, GL_LINK_STATUS, &done);
    if (done == GL_FALSE) {
        std::string log(65536, '\0');
        GLsizei length = 0;
        gl_.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
        log.resize(static_cast<size_t>(length));
        throw std::runtime_error("GLSL " + glsl_version(api_) + " does not link: " + log);
    }
    return program;
}

GLuint GlContext::texture(const std::vector<Image>& levels, GlFilter filter, GLint wrap)
{
    GLuint texture = 0;
    gl_.GenTextures(1, &texture);
    gl_.BindTexture(GL_TEXTURE_2D, texture);
    use_filter(gl_, GL_TEXTURE_2D, filter);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(levels.size()) - 1);
    for (size_t level = 0; level < levels.size(); ++level)
        gl_.TexImage2D(GL_TEXTURE_2D, static_cast<GLint>(level), GL_RGBA32F, levels[level].width,
                       levels[level].height, 0, GL_RGBA, GL_FLOAT, levels[level].pixels.data());
    expect_no_error("making a texture");
    return texture;
}

GLuint GlContext::texture_array(const std::vector<std::vector<Image>>& levels, GlFilter filter)
{
    GLuint texture = 0;
    gl_.GenTextures(1, &texture);
    arrays_.insert(texture);
    gl_.BindTexture(GL_TEXTURE_2D_ARRAY, texture);
    use_filter(gl_, GL_TEXTURE_2D_ARRAY, filter);
    gl_.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL,
                      static_cast<GLint>(levels.size()) - 1);
    for (size_t level = 0; level < levels.size(); ++level) {
        const Image& first = levels[level].at(0);
        std::vector<float> pixels;
        for (const Image& layer : levels[level])
            pixels.insert(pixels.end(), layer.pixels.begin(), layer.pixels.end());
        gl_.TexImage3D(GL_TEXTURE_2D_ARRAY, static_cast<GLint>(level), GL_RGBA32F, first.width,
                       first.height, static_cast<GLsizei>(levels[level].size()), 0, GL_RGBA,
                       GL_FLOAT, pixels.data());
    }
    expect_no_error("making an array of textures");
    return texture;
}

GLenum GlContext::target(GLuint texture) const
{
    return arrays_.count(texture) > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
}

void GlContext::show_level(GLuint texture, int level)
{
    gl_.BindTexture(target(texture), texture);
    gl_.TexParameteri(target(texture), GL_TEXTURE_BASE_LEVEL, level);
    gl_.TexParameteri(target(texture), GL_TEXTURE_MAX_LEVEL, level);
}

void GlContext::bind(GLuint program, const std::vector<std::pair<std::string, GLuint>>& textures)
{
    for (size_t unit = 0; unit < textures.size(); ++unit) {
        gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        gl_.BindTexture(target(textures[unit].second), textures[unit].second);
        set(program, textures[unit].first, static_cast<int>(unit));
    }
}

GLint GlContext::location(GLuint program, const std::string& name)
{
    gl_.UseProgram(program);
    const GLint location = gl_.GetUniformLocation(program, name.c_str());
    if (location < 0)
        throw std::runtime_error("the program uses no uniform " + name);
    return location;
}

void GlContext::set(GLuint program, const std::string& name, int value)
{
    gl_.Uniform1i(location(program, name), value);
}

void GlContext::set(GLuint program, const std::string& name, const std::vector<float>& values)
{
    const GLint at = location(program, name);
    const auto& v = values;
    switch (v.size()) {
    case 1:
        gl_.Uniform1f(at, v[0]);
        break;
    case 2:
        gl_.Uniform2f(at, v[0], v[1]);
        break;
    case 3:
        gl_.Uniform3f(at, v[0], v[1], v[2]);
        break;
    case 4:
        gl_.Uniform4f(at, v[0], v[1], v[2], v[3]);
        break;
    case 16:
        gl_.UniformMatrix4fv(at, 1, GL_FALSE, v.data());
        break;
    default:
        throw std::runtime_error("no uniform type has that many components: " + name);
    }
    expect_no_error(("setting " + name).c_str());
}

Image GlContext::draw(GLuint program, int width, int height)
{
    GLuint target = 0, frame = 0;
    gl_.ActiveTexture(GL_TEXTURE15); // leaves the program's own textures bound
    gl_.GenTextures(1, &target);
    gl_.BindTexture(GL_TEXTURE_2D, target);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    use_filter(gl_, GL_TEXTURE_2D, GlFilter::nearest);
    gl_.GenFramebuffers(1, &frame);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, frame);
    gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error("OpenGL cannot draw into float textures");

    gl_.UseProgram(program);
    gl_.Viewport(0, 0, width, height);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    Image image{width, height, {"R", "G", "B", "A"}, {}};
    image.pixels.resize(4 * static_cast<size_t>(width) * static_cast<size_t>(height));
    gl_.ReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, image.pixels.data());
    expect_no_error("drawing");
    gl_.DeleteFramebuffers(1, &frame);
    gl_.DeleteTextures(1, &target);
    return image;
}

} // namespace scree::test
