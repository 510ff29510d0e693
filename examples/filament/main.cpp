// SPDX-License-Identifier: MIT
// Ambient occlusion in Filament: a scene drawn to colour and depth, gloam's method as a material over the
// whole image, and the picture darkened by it.
//
//     filament_occlusion MATERIALS RADIUS FOLDER
//
// MATERIALS: folder with the compiled materials. Writes into FOLDER the picture without occlusion and with it
// (without.png, with.png), the occlusion (occlusion.pfm), and the frame as gloam render --gbuffer reads it
// (f0000.json, f0000_depth.pfm).
#include <filament/Camera.h>
#include <filament/Engine.h>
#include <filament/IndexBuffer.h>
#include <filament/Material.h>
#include <filament/MaterialInstance.h>
#include <filament/RenderTarget.h>
#include <filament/RenderableManager.h>
#include <filament/Renderer.h>
#include <filament/Scene.h>
#include <filament/SwapChain.h>
#include <filament/Texture.h>
#include <filament/TextureSampler.h>
#include <filament/TransformManager.h>
#include <filament/VertexBuffer.h>
#include <filament/View.h>
#include <filament/Viewport.h>
#include <utils/EntityManager.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace filament;
using math::float2;
using math::float3;
using math::mat4f;

constexpr std::uint32_t width = 640;
constexpr std::uint32_t height = 360;
constexpr double near_plane = 0.1;

Material* material_of(Engine& engine, const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error("cannot read " + file + ": expected a material of matc");
    const std::vector<char> bytes((std::istreambuf_iterator<char>(in)), {});
    return Material::Builder().package(bytes.data(), bytes.size()).build(engine);
}

// Buffers that Filament reads later than it is given them.
template <class T>
backend::BufferDescriptor lasting(const std::vector<T>& values) {
    auto* copy = new std::vector<T>(values);
    return {copy->data(), copy->size() * sizeof(T),
            [](void*, std::size_t, void* user) { delete static_cast<std::vector<T>*>(user); }, copy};
}

VertexBuffer* vertices_of(Engine& engine, const std::vector<float3>& positions) {
    VertexBuffer* buffer = VertexBuffer::Builder()
                               .vertexCount(static_cast<std::uint32_t>(positions.size()))
                               .bufferCount(1)
                               .attribute(VertexAttribute::POSITION, 0, VertexBuffer::AttributeType::FLOAT3)
                               .build(engine);
    buffer->setBufferAt(engine, 0, lasting(positions));
    return buffer;
}

IndexBuffer* indices_of(Engine& engine, const std::vector<std::uint16_t>& indices) {
    IndexBuffer* buffer = IndexBuffer::Builder()
                              .indexCount(static_cast<std::uint32_t>(indices.size()))
                              .bufferType(IndexBuffer::IndexType::USHORT)
                              .build(engine);
    buffer->setBuffer(engine, lasting(indices));
    return buffer;
}

utils::Entity drawable(Engine& engine, VertexBuffer* vertices, IndexBuffer* indices,
                       const MaterialInstance* material) {
    const utils::Entity entity = utils::EntityManager::get().create();
    RenderableManager::Builder(1)
        .boundingBox({{0, 0, 0}, {1, 1, 1}})
        .material(0, material)
        .geometry(0, RenderableManager::PrimitiveType::TRIANGLES, vertices, indices)
        .culling(false)
        .castShadows(false)
        .receiveShadows(false)
        .build(engine, entity);
    return entity;
}

struct Box {
    float3 middle, half, color;
};

// A floor, a wall behind it, and boxes and stairs on the floor.
std::vector<Box> boxes() {
    std::vector<Box> all{{{0, -0.1F, 0}, {6, 0.1F, 6}, {0.80F, 0.77F, 0.72F}},
                         {{0, 1.5F, -2.1F}, {6, 1.5F, 0.1F}, {0.78F, 0.80F, 0.77F}},
                         {{-1.7F, 0.8F, -1.3F}, {0.5F, 0.8F, 0.5F}, {0.72F, 0.40F, 0.27F}},
                         {{-0.6F, 0.25F, -1.2F}, {0.6F, 0.25F, 0.4F}, {0.45F, 0.58F, 0.70F}},
                         {{0.6F, 0.35F, -0.2F}, {0.35F, 0.35F, 0.35F}, {0.82F, 0.70F, 0.38F}}};
    for (int i = 0; i < 5; ++i) {
        const auto step = static_cast<float>(i);
        all.push_back(
            {{2.4F, 0.1F + 0.2F * step, -0.4F - 0.3F * step}, {0.8F, 0.1F, 0.15F}, {0.68F, 0.65F, 0.60F}});
    }
    return all;
}

void add_boxes(Engine& engine, const Material* surface, Scene& scene) {
    std::vector<float3> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back({i % 2 == 0 ? -1 : 1, i / 2 % 2 == 0 ? -1 : 1, i / 4 == 0 ? -1 : 1});
    VertexBuffer* vertices = vertices_of(engine, corners);
    IndexBuffer* indices = indices_of(engine, {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                               2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6});
    for (const Box& box : boxes()) {
        MaterialInstance* material = surface->createInstance();
        material->setParameter("color", box.color);
        const utils::Entity entity = drawable(engine, vertices, indices, material);
        TransformManager& transforms = engine.getTransformManager();
        transforms.create(entity, {}, mat4f::translation(box.middle) * mat4f::scaling(box.half));
        scene.addEntity(entity);
    }
}

Texture* texture_of(Engine& engine, Texture::InternalFormat format, Texture::Usage attachment) {
    return Texture::Builder()
        .width(width)
        .height(height)
        .levels(1)
        .format(format)
        .usage(attachment | Texture::Usage::SAMPLEABLE)
        .build(engine);
}

// A view of a scene into these images; depth may be null.
View* view_of(Engine& engine, Scene* scene, Camera* camera, Texture* color, Texture* depth) {
    RenderTarget::Builder target;
    target.texture(RenderTarget::AttachmentPoint::COLOR, color);
    if (depth != nullptr) target.texture(RenderTarget::AttachmentPoint::DEPTH, depth);
    View* view = engine.createView();
    view->setViewport({0, 0, width, height});
    view->setScene(scene);
    view->setCamera(camera);
    view->setPostProcessingEnabled(false);
    view->setShadowingEnabled(false);
    view->setRenderTarget(target.build(engine));
    return view;
}

// A scene of one triangle that covers the image.
Scene* whole_image(Engine& engine, const MaterialInstance* material) {
    VertexBuffer* vertices = vertices_of(engine, {{-1, -1, 0.5F}, {3, -1, 0.5F}, {-1, 3, 0.5F}});
    Scene* scene = engine.createScene();
    scene->addEntity(drawable(engine, vertices, indices_of(engine, {0, 1, 2}), material));
    return scene;
}

// Four floats of each pixel, the top row first; known after Engine::flushAndWait().
void read(Renderer& renderer, const View& view, std::vector<float>& texels) {
    texels.resize(std::size_t{4} * width * height);
    renderer.readPixels(view.getRenderTarget(), 0, 0, width, height,
                        {texels.data(), texels.size() * sizeof(float), backend::PixelDataFormat::RGBA,
                         backend::PixelDataType::FLOAT});
}

std::ofstream file_of(const std::string& name) {
    std::ofstream out(name, std::ios::binary);
    if (!out) throw std::runtime_error("cannot write " + name);
    return out;
}

// PFM has the bottom row first.
void write_pfm(const std::string& name, const std::vector<float>& texels, std::size_t channel) {
    std::ofstream out = file_of(name);
    out << "Pf\n" << width << ' ' << height << "\n-1.0\n";
    for (std::size_t y = height; y-- > 0;)
        for (std::size_t x = 0; x < width; ++x) {
            const float texel = texels[4 * (y * width + x) + channel];
            const float value = texel < 1e18F ? texel : std::numeric_limits<float>::infinity();
            out.write(reinterpret_cast<const char*>(&value), sizeof value);
        }
}

void write_png(const std::string& name, const std::vector<float>& texels) {
    std::vector<unsigned char> bytes;
    for (std::size_t i = 0; i < texels.size(); ++i)
        if (i % 4 < 3)
            bytes.push_back(
                static_cast<unsigned char>(std::lround(255.0F * std::clamp(texels[i], 0.0F, 1.0F))));
    if (stbi_write_png(name.c_str(), width, height, 3, bytes.data(), 3 * width) == 0)
        throw std::runtime_error("cannot write " + name);
}

void write_frame(const std::string& name, const Camera& camera) {
    std::ofstream out = file_of(name);
    out.precision(17);
    const auto matrix = [&out](const char* key, const auto& m) {
        out << '"' << key << "\": [";
        for (int i = 0; i < 16; ++i) out << (i > 0 ? ", " : "") << m[i / 4][i % 4];
        out << ']';
    };
    out << "{\"width\": " << width << ", \"height\": " << height << ", \"camera\": {";
    matrix("view", camera.getViewMatrix());
    out << ", ";
    matrix("proj_gl", camera.getCullingProjectionMatrix());
    out << "}}\n";
}

const TextureSampler nearest(TextureSampler::MagFilter::NEAREST);

// The three views of a frame, in their order: the scene, its occlusion, the picture darkened by it.
std::vector<View*> views_of(Engine& engine, Camera* camera, const std::string& materials, float radius) {
    using Format = Texture::InternalFormat;
    using Usage = Texture::Usage;
    Texture* color = texture_of(engine, Format::RGBA8, Usage::COLOR_ATTACHMENT);
    Texture* depth = texture_of(engine, Format::DEPTH32F, Usage::DEPTH_ATTACHMENT);
    Texture* occlusion = texture_of(engine, Format::RGBA32F, Usage::COLOR_ATTACHMENT);
    Texture* picture = texture_of(engine, Format::RGBA32F, Usage::COLOR_ATTACHMENT);

    Scene* scene = engine.createScene();
    add_boxes(engine, material_of(engine, materials + "/surface.filamat"), *scene);
    MaterialInstance* estimate = material_of(engine, materials + "/occlusion.filamat")->createInstance();
    const auto projection = camera->getProjectionMatrix();
    estimate->setParameter("depth", depth, nearest);
    estimate->setParameter("p00_p11", float2{projection[0][0], projection[1][1]});
    estimate->setParameter("near", static_cast<float>(near_plane));
    estimate->setParameter("radius", radius);
    MaterialInstance* shade = material_of(engine, materials + "/shade.filamat")->createInstance();
    shade->setParameter("color", color, nearest);
    shade->setParameter("occlusion", occlusion, nearest);
    return {view_of(engine, scene, camera, color, depth),
            view_of(engine, whole_image(engine, estimate), camera, occlusion, nullptr),
            view_of(engine, whole_image(engine, shade), camera, picture, nullptr)};
}

void run(const std::string& materials, float radius, const std::string& folder) {
    Engine* engine = Engine::create(Engine::Backend::OPENGL);
    if (engine == nullptr) throw std::runtime_error("Filament found no OpenGL 4.1 (is there a display?)");
    SwapChain* swap_chain = engine->createSwapChain(width, height);
    Renderer& renderer = *engine->createRenderer();
    renderer.setClearOptions({.clearColor = {0.79F, 0.83F, 0.88F, 1}, .clear = true});
    Camera* camera = engine->createCamera(utils::EntityManager::get().create());
    camera->setProjection(40.0, static_cast<double>(width) / height, near_plane, 100.0);
    camera->lookAt(float3{0, 2.6F, 6.5F}, float3{0.3F, 0.6F, -0.6F});

    const std::vector<View*> views = views_of(*engine, camera, materials, radius);
    std::vector<float> texels[3];
    while (!renderer.beginFrame(swap_chain)) {
    }
    for (View* view : views) renderer.render(view);
    for (std::size_t i = 0; i < 3; ++i) read(renderer, *views[i], texels[i]);
    renderer.endFrame();
    engine->flushAndWait();

    write_png(folder + "/without.png", texels[0]);
    write_png(folder + "/with.png", texels[2]);
    write_pfm(folder + "/occlusion.pfm", texels[1], 0);
    write_pfm(folder + "/f0000_depth.pfm", texels[1], 1);
    write_frame(folder + "/f0000.json", *camera);
    Engine::destroy(&engine);
}

float radius_from(const char* text) {
    char* end = nullptr;
    const float radius = std::strtof(text, &end);
    if (*end != '\0' || !(radius > 0.0F && radius < 1e6F))
        throw std::runtime_error(std::string("radius ") + text +
                                 ": expected a number of world units above 0");
    return radius;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: filament_occlusion MATERIALS RADIUS FOLDER\n");
        return 2;
    }
    try {
        run(argv[1], radius_from(argv[2]), argv[3]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "filament_occlusion: %s\n", error.what());
        return 2;
    }
    return 0;
}
