// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/picture/render.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <wm3d/core/error.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d::picture {

namespace {

using Colour = Eigen::Vector3d; // 0 to 1

constexpr double grey = 0.82; // of a model without colours

/// What is in front at each sample.
struct Canvas {
    std::size_t width, height;
    std::vector<float> depth;
    std::vector<Colour> colour;

    Canvas(std::size_t w, std::size_t h, const Colour& background)
        : width(w), height(h), depth(w * h, -std::numeric_limits<float>::infinity()),
          colour(w * h, background) {}
};

Colour to_colour(const Rgb& c) {
    return Colour(c[0], c[1], c[2]) / 255;
}

class Painter {
public:
    Painter(const TriangleMesh& mesh, const Camera& camera, const RenderOptions& options)
        : mesh_(mesh), options_(options), light_(options.light.normalized()),
          canvas_(options.samples * options.width, options.samples * options.height,
                  to_colour(options.background)) {
        axes_.row(0) = camera.upwards.cross(camera.backwards);
        axes_.row(1) = camera.upwards;
        axes_.row(2) = camera.backwards;
        scale_ = static_cast<double>(canvas_.height) / camera.height;
        const Vec3 middle(0.5 * static_cast<double>(canvas_.width), 0.5 * static_cast<double>(canvas_.height),
                          0);
        for (const Vec3& p : mesh.positions) {
            const Vec3 seen = axes_ * (p - camera.centre) * scale_;
            places_.push_back(middle + Vec3(seen[0], -seen[1], seen[2]));
        }
        for (const Vec3& n : vertex_normals(mesh))
            normals_.push_back(axes_ * n);
    }

    void paint(std::size_t f);
    Image picture() const;

private:
    Colour shade(std::size_t f, const Vec3& weights, const Vec3& flat) const;

    const TriangleMesh& mesh_;
    const RenderOptions& options_;
    Vec3 light_;
    Canvas canvas_;
    Mat3 axes_;
    double scale_ = 1;
    std::vector<Vec3> places_;  ///< #V, in samples from the top left, and towards the viewer
    std::vector<Vec3> normals_; ///< #V, as the viewer sees them
};

Colour Painter::shade(std::size_t f, const Vec3& weights, const Vec3& flat) const {
    const Triangle& t = mesh_.triangles[f];
    Vec3 normal = flat;
    if (options_.smooth) {
        normal = weights[0] * normals_[t[0]] + weights[1] * normals_[t[1]] + weights[2] * normals_[t[2]];
        normal = normal.norm() > 0 ? normal.normalized() : flat;
    }
    if (normal[2] < 0)
        normal = -normal; // what is seen is lit from the side where it is seen
    const double lamp = 1 - options_.ambient - options_.headlight;
    const double light =
        options_.ambient + options_.headlight * normal[2] + lamp * std::max(0.0, normal.dot(light_));
    Colour own = Colour::Constant(grey);
    if (!options_.vertex_colours.empty()) {
        own.setZero();
        for (int k = 0; k < 3; ++k)
            own += weights[k] * to_colour(options_.vertex_colours[t[static_cast<std::size_t>(k)]]);
    }
    return light * own;
}

void Painter::paint(std::size_t f) {
    const Triangle& t = mesh_.triangles[f];
    const Vec3 &a = places_[t[0]], &b = places_[t[1]], &c = places_[t[2]];
    const auto turn = [](const Vec3& p, const Vec3& q, double x, double y) {
        return (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
    };
    const double area = turn(a, b, c[0], c[1]);
    if (!(std::abs(area) > 0))
        return; // seen edge-on
    const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    const auto first = [](double x) { return static_cast<std::size_t>(std::max(0.0, std::ceil(x - 0.5))); };
    const auto end = [](double x, std::size_t size) {
        return static_cast<std::size_t>(std::clamp(std::floor(x - 0.5) + 1, 0.0, static_cast<double>(size)));
    };
    const Vec3 flat = (axes_ * area_vector(mesh_, f)).normalized();
    for (std::size_t y = first(low[1]); y < end(high[1], canvas_.height); ++y)
        for (std::size_t x = first(low[0]); x < end(high[0], canvas_.width); ++x) {
            const double px = static_cast<double>(x) + 0.5, py = static_cast<double>(y) + 0.5;
            const Vec3 weights(turn(b, c, px, py) / area, turn(c, a, px, py) / area,
                               turn(a, b, px, py) / area);
            if (weights.minCoeff() < 0)
                continue;
            const auto depth = static_cast<float>(weights[0] * a[2] + weights[1] * b[2] + weights[2] * c[2]);
            const std::size_t sample = y * canvas_.width + x;
            if (!(depth > canvas_.depth[sample]))
                continue;
            canvas_.depth[sample] = depth;
            canvas_.colour[sample] = shade(f, weights, flat);
        }
}

Image Painter::picture() const {
    const std::size_t n = options_.samples;
    Image image(options_.width, options_.height);
    for (std::size_t y = 0; y < image.height; ++y)
        for (std::size_t x = 0; x < image.width; ++x) {
            Colour sum = Colour::Zero();
            for (std::size_t j = 0; j < n; ++j)
                for (std::size_t i = 0; i < n; ++i)
                    sum += canvas_.colour[(y * n + j) * canvas_.width + x * n + i];
            for (std::size_t c = 0; c < 3; ++c) {
                const double value = sum[static_cast<Eigen::Index>(c)] / static_cast<double>(n * n);
                image.at(x, y)[c] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
            }
        }
    return image;
}

} // namespace

Camera frame(const TriangleMesh& mesh, const Vec3& backwards, const Vec3& up) {
    Camera camera;
    camera.backwards = backwards.normalized();
    const Vec3 right = up.cross(camera.backwards).normalized();
    camera.upwards = camera.backwards.cross(right);
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Triangle& t : mesh.triangles)
        for (Index v : t) {
            const Vec3& p = mesh.positions[v];
            const Vec3 seen(right.dot(p), camera.upwards.dot(p), camera.backwards.dot(p));
            low = low.cwiseMin(seen);
            high = high.cwiseMax(seen);
        }
    const Vec3 middle = (low + high) / 2;
    camera.centre = middle[0] * right + middle[1] * camera.upwards + middle[2] * camera.backwards;
    camera.height = 1.06 * std::max(high[0] - low[0], high[1] - low[1]);
    return camera;
}

Camera close_up(const Camera& camera, double x, double y, double zoom) {
    Camera closer = camera;
    const Vec3 right = camera.upwards.cross(camera.backwards);
    closer.centre += 0.5 * camera.height * (x * right + y * camera.upwards);
    closer.height = camera.height / zoom;
    return closer;
}

Image render(const TriangleMesh& mesh, const Camera& camera, const RenderOptions& options) {
    if (options.width * options.height * options.samples == 0)
        throw ParameterError("a picture needs at least one pixel and one sample in it");
    if (!options.vertex_colours.empty() && options.vertex_colours.size() != mesh.positions.size())
        throw ParameterError("a picture needs one colour for each vertex, or none");
    Painter painter(mesh, camera, options);
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        painter.paint(f);
    return painter.picture();
}

} // namespace wm3d::picture
