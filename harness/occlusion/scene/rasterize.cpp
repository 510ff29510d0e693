// SPDX-License-Identifier: MIT
#include "scene/rasterize.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "backend/vulkan/commands.hpp"
#include "scene/internal/peel.hpp"

namespace gloam::scene {
namespace {

using Indices = std::vector<std::uint32_t>;

// The same number for equal positions.
Indices welded(const Mesh& mesh) {
    const auto key = [&](std::uint32_t i) {
        const glm::vec3& p = mesh.positions[i];
        return std::tuple(p.x, p.y, p.z);
    };
    Indices order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    Indices numbers(order.size(), 0);
    for (std::size_t i = 1; i < order.size(); ++i)
        numbers[order[i]] = key(order[i]) == key(order[i - 1]) ? numbers[order[i - 1]] : order[i];
    if (!order.empty()) numbers[order[0]] = order[0];
    return numbers;
}

// What is known about a part.
struct Part {
    std::size_t edges = 0;
    std::size_t one_way = 0;  // edges that are not passed as often in one direction as in the other
    bool has_border = false;  // an edge of a single triangle
    double volume = 0.0;
    Bounds bounds{glm::dvec3(1e300), glm::dvec3(-1e300)};

    [[nodiscard]] bool closed() const { return !has_border && 100 * one_way <= edges && volume > 0.0; }
};

// The parts of a mesh.
class Parts {
  public:
    explicit Parts(const Mesh& mesh) : mesh_(mesh), numbers_(welded(mesh)), root_(numbers_.size()) {
        std::iota(root_.begin(), root_.end(), 0U);
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
            for (std::size_t k = 1; k < 3; ++k) root_[find(corner(t, k))] = find(corner(t, 0));
        parts_.resize(numbers_.size());
        measure();
        count_edges();
    }

    [[nodiscard]] const Part& of(std::size_t triangle) const { return parts_[root_of(triangle)]; }

  private:
    [[nodiscard]] std::uint32_t corner(std::size_t triangle, std::size_t k) const {
        return numbers_[mesh_.indices[3 * triangle + k]];
    }
    std::uint32_t find(std::uint32_t i) {
        while (root_[i] != i) i = root_[i] = root_[root_[i]];
        return i;
    }
    [[nodiscard]] std::uint32_t root_of(std::size_t triangle) const {
        std::uint32_t i = corner(triangle, 0);
        while (root_[i] != i) i = root_[i];
        return i;
    }

    void measure() {
        for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
            Part& part = parts_[root_of(t)];
            std::array<glm::dvec3, 3> p;
            for (std::size_t k = 0; k < 3; ++k) {
                p[k] = mesh_.positions[corner(t, k)];
                part.bounds.low = glm::min(part.bounds.low, p[k]);
                part.bounds.high = glm::max(part.bounds.high, p[k]);
            }
            part.volume += glm::dot(p[0], glm::cross(p[1], p[2])) / 6.0;
        }
    }

    void count_edges() {
        struct Edge {
            std::uint32_t low;
            std::uint32_t high;
            std::uint32_t triangle;
            bool forward;
        };
        std::vector<Edge> edges;
        for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = corner(t, k);
                const std::uint32_t b = corner(t, (k + 1) % 3);
                if (a != b) edges.push_back({std::min(a, b), std::max(a, b), t, a < b});
            }
        }
        std::ranges::sort(edges, {}, [](const Edge& e) { return std::pair(e.low, e.high); });
        for (auto first = edges.begin(); first != edges.end();) {
            const auto last = std::find_if(first, edges.end(), [&](const Edge& e) {
                return std::pair(e.low, e.high) != std::pair(first->low, first->high);
            });
            Part& part = parts_[root_of(first->triangle)];
            const auto forward = std::count_if(first, last, [](const Edge& e) { return e.forward; });
            ++part.edges;
            part.has_border = part.has_border || last - first < 2;
            part.one_way += 2 * forward != last - first ? 1 : 0;
            first = last;
        }
    }

    const Mesh& mesh_;
    Indices numbers_;
    Indices root_;
    std::vector<Part> parts_;  // by the number of their first position
};

}  // namespace

std::vector<bool> hidden_far_sides(const Mesh& view_space, bool orthographic) {
    const Parts parts(view_space);
    std::vector<bool> hidden;
    for (std::size_t t = 0; t < view_space.triangle_count(); ++t) {
        const Part& part = parts.of(t);
        const auto p = [&](std::size_t k) {
            return glm::dvec3(view_space.positions[view_space.indices[3 * t + k]]);
        };
        const glm::dvec3 front = glm::cross(p(1) - p(0), p(2) - p(0));
        const glm::dvec3 away = orthographic ? glm::dvec3(0, 0, -1) : p(0);
        const bool inside = glm::all(glm::lessThanEqual(part.bounds.low, glm::dvec3(0))) &&
                            glm::all(glm::greaterThanEqual(part.bounds.high, glm::dvec3(0)));
        hidden.push_back(part.closed() && !inside && glm::dot(front, away) >= 0.0);
    }
    return hidden;
}

namespace {

// A vertex with GLOAM_MOTION; each corner of each triangle has its own.
struct MovingVertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec3 previous_position;
    glm::vec2 object_triangle;
};

// The object of each triangle, in the order of view_space_mesh().
std::vector<std::uint32_t> objects_of_triangles(const Scene& scene) {
    std::vector<std::uint32_t> objects(scene.mesh.triangle_count(), 0);
    for (std::uint32_t k = 0; k < scene.objects.size(); ++k)
        objects.insert(objects.end(), scene.objects[k].mesh.triangle_count(), k + 1);
    return objects;
}

gpu::Buffer moving_vertex_buffer(const gpu::Device& device, const Scene& scene, const Mesh& now,
                                 const Mesh& before) {
    gpu::Buffer buffer(device, now.indices.size() * sizeof(MovingVertex));
    const std::span<MovingVertex> vertices = buffer.as<MovingVertex>();
    const std::vector<std::uint32_t> objects = objects_of_triangles(scene);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const std::uint32_t index = now.indices[i];
        vertices[i] = {now.positions[index], now.normals[index], before.positions[index],
                       glm::vec2(objects[i / 3], i / 3)};
    }
    return buffer;
}

// The corners of the triangles that can be seen. Without the others, rounding cannot draw the far side of a
// closed shape at its silhouette, with a normal that points into the shape.
std::vector<std::uint32_t> seen_corners(const Mesh& mesh, bool orthographic, bool own_vertices) {
    const std::vector<bool> hidden = hidden_far_sides(mesh, orthographic);
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)
        if (!hidden[i / 3]) corners.push_back(own_vertices ? static_cast<std::uint32_t>(i) : mesh.indices[i]);
    return corners;
}

gpu::RasterPipeline make_pipeline(const gpu::Device& device, const PassLibrary& passes, bool reversed_z,
                                  bool moving) {
    using Formats = std::vector<gpu::Format>;
    using gpu::Format;
    const std::vector<std::string> defines(moving ? 1 : 0, "GLOAM_MOTION");
    const shader::Spirv vertex = passes.compile("gbuffer.vert", defines);
    const shader::Spirv fragment = passes.compile("gbuffer.frag", defines);
    return {device,
            {.vertex_spirv = vertex,
             .fragment_spirv = fragment,
             .attribute_sizes = moving ? std::vector{3, 3, 3, 2} : std::vector{3, 3},
             .color_formats = moving ? Formats{Format::r32f, Format::rgba32f, Format::rgba32f, Format::r32f}
                                     : Formats{Format::r32f, Format::rgba32f},
             .push_constant_bytes = sizeof(RasterConstants),
             .reversed_z = reversed_z}};
}

// Motion from previous_position: dx, dy in pixels, and whether the point was in the previous image.
std::vector<glm::vec3> motion_of(const GBuffer& view, const CameraFrame& before) {
    std::vector<glm::vec3> motion(view.depth.size(), glm::vec3(0));
    const glm::dmat4 projection(before.proj_vk);
    const glm::dvec2 size(view.extent.width, view.extent.height);
    for (std::size_t i = 0; i < motion.size(); ++i) {
        if (std::isinf(view.depth[i])) continue;
        const glm::dvec4 clip = projection * glm::dvec4(glm::dvec3(view.previous_position[i]), 1.0);
        if (!(clip.w > 0.0)) continue;
        const glm::dvec2 then = (0.5 * glm::dvec2(clip) / clip.w + 0.5) * size;
        const glm::dvec2 now(static_cast<double>(i % view.extent.width) + 0.5,
                             static_cast<double>(i / view.extent.width) + 0.5);
        const bool inside = then.x >= 0.0 && then.y >= 0.0 && then.x < size.x && then.y < size.y;
        motion[i] = {glm::vec2(now - then), inside ? 1.0F : 0.0F};
    }
    return motion;
}

// One frame of one scene.
class Shot {
  public:
    Shot(const gpu::Device& device, const Scene& scene, gpu::Extent frame, const RasterizeOptions& options)
        : options_(options),
          moving_(options.motion || options.ids || options.color),
          border_(guard_border(frame, options.guard)),
          now_(with_border(camera_at(scene, options.frame), frame, border_)),
          before_(with_border(camera_at(scene, std::max(0, options.frame - 1)), frame, border_)),
          depth_(device, with_border(frame, border_), gpu::Format::depth32f) {
        const gpu::Extent extent = depth_.extent();
        aspect_ = static_cast<double>(extent.width) / extent.height;
        colors_.emplace_back(device, extent, gpu::Format::r32f);
        colors_.emplace_back(device, extent, gpu::Format::rgba32f);
        if (!moving_) return;
        colors_.emplace_back(device, extent, gpu::Format::rgba32f);
        colors_.emplace_back(device, extent, gpu::Format::r32f);
    }

    [[nodiscard]] GBuffer take(const gpu::Device& device, const PassLibrary& passes, const Scene& scene) {
        GBuffer view{
            .extent = depth_.extent(),
            .camera = options_.frame > 0 ? make_frame(now_, aspect_, before_) : make_frame(now_, aspect_),
            .ao_radius = scene.ao_radius,
            .border = border_};
        draw(device, passes, scene, {view.camera.proj_vk});
        view.depth = colors_[0].download();
        for (float& d : view.depth) {
            if (!(d > 0.0F)) d = std::numeric_limits<float>::infinity();  // cleared to 0: nothing drawn
        }
        view.normal = vectors_of(colors_[1].download());
        if (moving_) read_extras(view);
        if (options_.color) view.color = colors_of(scene);
        if (options_.layers > 1) {
            view.layers = peel(device, passes, view_space_mesh(scene, options_.frame),
                               {view.extent, view.camera.proj_vk, now_.reversed_z}, options_.layers);
            view.layers.erase(view.layers.begin());
        }
        return view;
    }

  private:
    void draw(const gpu::Device& device, const PassLibrary& passes, const Scene& scene,
              const RasterConstants& push) {
        const Mesh mesh = view_space_mesh(scene, options_.frame);
        const int previous = std::max(0, options_.frame - 1);
        const gpu::RasterPipeline pipeline = make_pipeline(device, passes, now_.reversed_z, moving_);
        const gpu::Buffer vertices =
            moving_ ? moving_vertex_buffer(device, scene, mesh, view_space_mesh(scene, previous))
                    : vertex_buffer(device, mesh);
        const std::vector<std::uint32_t> corners =
            seen_corners(mesh, now_.projection == Projection::orthographic, moving_);
        gpu::Buffer indices(device, corners.size() * sizeof(std::uint32_t));
        std::ranges::copy(corners, indices.as<std::uint32_t>().begin());
        const gpu::Draw all{.vertices = vertices,
                            .indices = indices,
                            .index_count = static_cast<std::uint32_t>(corners.size()),
                            .push_constants = std::as_bytes(std::span(&push, 1))};
        const std::vector<std::reference_wrapper<const gpu::Image>> colors(colors_.begin(), colors_.end());
        gpu::Commands commands(device);
        gpu::render(commands, pipeline, colors, depth_, 0.0F, std::span(&all, 1));
        commands.submit();
    }

    [[nodiscard]] std::vector<glm::vec3> colors_of(const Scene& scene) const {
        const std::vector<glm::vec3> of_triangles = view_space_mesh(scene, options_.frame).colors;
        std::vector<glm::vec3> colors;
        for (const float triangle : colors_[3].download()) {
            const auto number = static_cast<std::size_t>(triangle);  // counted from 1; 0: the background
            const bool own = number > 0 && number <= of_triangles.size();
            colors.push_back(own ? of_triangles[number - 1]
                                 : glm::vec3(number > 0 ? 1.0F : 0.0F) * default_color);
        }
        return colors;
    }

    void read_extras(GBuffer& view) const {
        const std::vector<float> extras = colors_[2].download();
        const std::vector<float> triangles = colors_[3].download();
        if (options_.ids) {
            for (std::size_t i = 0; i < triangles.size(); ++i) {
                view.object.push_back(static_cast<std::uint32_t>(extras[4 * i + 3]));
                view.triangle.push_back(static_cast<std::uint32_t>(triangles[i]) - 1U);
            }
        }
        if (!options_.motion) return;
        view.previous_position = vectors_of(extras);
        view.motion = options_.frame > 0 ? motion_of(view, make_frame(before_, aspect_))
                                         : std::vector<glm::vec3>(view.depth.size(), glm::vec3(0));
    }

    RasterizeOptions options_;
    bool moving_;
    gpu::Extent border_;
    double aspect_ = 1.0;
    Camera now_;
    Camera before_;
    gpu::Image depth_;
    std::vector<gpu::Image> colors_;
};

}  // namespace

GBuffer rasterize(const gpu::Device& device, const PassLibrary& passes, const Scene& scene,
                  gpu::Extent extent, const RasterizeOptions& options) {
    validate(scene);
    if (options.frame < 0)
        throw std::invalid_argument("frame " + std::to_string(options.frame) + " of scene " + scene.name +
                                    ": expected 0 or more");
    if (options.layers < 1 || options.layers > 1 + most_further_layers)
        throw std::invalid_argument("layers " + std::to_string(options.layers) + ": expected 1 to " +
                                    std::to_string(1 + most_further_layers));
    if ((options.ids || options.color) && view_space_mesh(scene, 0).triangle_count() >= 1U << 24)
        throw std::invalid_argument("scene " + scene.name + ": too many triangles to tell apart");
    return Shot(device, scene, extent, options).take(device, passes, scene);
}

}  // namespace gloam::scene
