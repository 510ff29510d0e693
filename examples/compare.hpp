// SPDX-License-Identifier: MIT
#pragma once
// What an engine's example compares itself by: a mesh on a plane, triangles and camera, the occlusion that
// `gloam render` traces for them, and its own.
#include <array>
#include <chrono>
#include <cmath>

#include "gbuffers.hpp"

struct Comparison {
    int width = 640, height = 480;
    float radius = 0;                          // of influence, world units
    std::vector<std::array<float, 3>> points;  // three for each triangle: the mesh, then two of the plane
    std::vector<float> view;                   // from world space, 16 numbers column by column; looks down -z
    double angle = 0;                          // of the view from bottom to top, degrees
    Picture truth, gloam;                      // occlusion, NaN where none is known

    // Runs the program: a minute where it traces the first time. Files are written into the folder.
    Comparison(std::string program, const std::string& mesh = "/usr/share/glmark2/models/bunny.obj",
               std::string folder = "compared/")
        : program(std::move(program)), folder(std::move(folder)) {
        const std::string& out = this->folder;
        run("'" + mesh +
            "' --orbit 30,25 --size 640x480 --frames 8 --truth --truth-rays 256 --write-gbuffer " + out +
            " --out " + out);
        const std::string json = read_file(out + "f0000.json"), key = "\"ao_radius\":";
        radius = std::strtof(json.c_str() + json.find(key) + key.size(), nullptr);
        view = numbers_of(json, "view");
        angle = 2 * std::atan(1 / numbers_of(json, "proj_gl").at(5)) * 180 / M_PI;
        truth = read_pfm(out + "truth.pfm", 1);
        gloam = read_pfm(out + "f0007_ao.pfm", 1);
        read_triangles(mesh);
    }

    // Root mean square of what differs between an occlusion, first the truth, and a picture of visibility as
    // OpenGL reads it: rows from the bottom up, of red, green and blue.
    double error(const unsigned char* picture) const { return error(picture, truth); }
    double error(const unsigned char* picture, const Picture& occlusion) const {
        return error(occlusion, [=, this](int i) {
            return 1 - picture[3 * ((height - 1 - i / width) * width + i % width)] / 255.0F;
        });
    }
    // The occlusion that `gloam render` makes of a depth buffer: 0 to 1, rows from the bottom up, drawn with
    // OpenGL's projection, column by column.
    Picture rendered(const float* depth, const double* projection) const {
        Picture picture{width, height, 1, {}};
        for (int y = height; y-- > 0;)
            picture.values.insert(picture.values.end(), depth + y * width, depth + (y + 1) * width);
        const std::string of = folder + "of_depth/";
        write_pfm(of + "f0000_depth.pfm", picture);
        std::ofstream json(of + "f0000.json");
        json << "{\"width\": " << width << ", \"height\": " << height
             << ", \"camera\": {\"view\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], \"proj_gl\": [";
        for (int i = 0; i < 16; ++i) json << (i > 0 ? "," : "") << projection[i];
        json << "]}}";
        json.close();
        run("--gbuffer " + of + " --depth buffer --out " + of + " --radius " + std::to_string(radius));
        return read_pfm(of + "f0000_ao.pfm", 1);
    }
    // The table's head, and its first row.
    void print_head() const {
        std::printf("| pass | RMSE (G) | ms |\n| --- | --: | --: |\n| gloam render | %.4f | |\n",
                    error(truth, [this](int i) { return gloam.values[i]; }));
    }
    // The least time that draw() takes for a frame, ms.
    template <class Draw>
    static double least_time(int frames, const Draw& draw) {
        std::chrono::duration<double, std::milli> least(1e9);
        for (int i = 0; i < frames; ++i) {
            const auto begin = std::chrono::steady_clock::now();
            draw();
            least = std::min<decltype(least)>(least, std::chrono::steady_clock::now() - begin);
        }
        return least.count();
    }
    static void print_row(const std::string& pass, double error, double milliseconds) {
        std::printf("| %s | %.4f | %.1f |\n", pass.c_str(), error, milliseconds);
    }

  private:
    std::string program, folder;

    void run(const std::string& arguments) const {
        const std::string command = "'" + program + "' render --quiet " + arguments;
        if (std::system(command.c_str()) != 0) throw std::runtime_error("this failed: " + command);
    }

    template <class Shown>
    double error(const Picture& occlusion, const Shown& shown) const {
        double sum = 0, count = 0;
        for (int i = 0; i < width * height; ++i) {
            if (!std::isfinite(occlusion.values[i])) continue;
            sum += std::pow(double(shown(i)) - occlusion.values[i], 2);
            ++count;
        }
        return std::sqrt(sum / count);
    }

    // Triangles of an OBJ file whose y is up, and the plane under them, both as `gloam render` places them.
    void read_triangles(const std::string& mesh) {
        std::istringstream lines(read_file(mesh));
        std::vector<std::array<float, 3>> vertices;
        std::array<float, 3> low{1e30F, 1e30F, 1e30F}, high{-1e30F, -1e30F, -1e30F};
        for (std::string line, kind; std::getline(lines, line);) {
            std::istringstream words(line);
            words >> kind;
            if (kind == "v") {
                std::array<float, 3>& p = vertices.emplace_back();
                for (int i = 0; i < 3; ++i) {
                    words >> p[i];
                    low[i] = std::min(low[i], p[i]);
                    high[i] = std::max(high[i], p[i]);
                }
            } else if (kind == "f") {
                std::array<int, 3> corners{};
                for (int& corner : corners) {
                    words >> corner;
                    while (words.good() && words.peek() > ' ')
                        words.get();  // a texture's and a normal's number
                    points.push_back(vertices.at(corner - 1));
                }
            }
        }
        for (auto& [x, y, z] : points) x -= (low[0] + high[0]) / 2, y -= low[1], z -= (low[2] + high[2]) / 2;
        const float half = 30 * std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
        for (const auto& [x, z] : {std::array{-half, half},
                                   {half, half},
                                   {half, -half},
                                   {-half, half},
                                   {half, -half},
                                   {-half, -half}})
            points.push_back({x, 0, z});
    }
};
