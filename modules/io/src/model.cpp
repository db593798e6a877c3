// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/io/model.hpp>

#include <utility>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/io/file.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/weld.hpp>

#include "document.hpp"
#include "normals.hpp"

namespace wm3d::io {

struct Model::Impl {
    Format format = Format::obj;
    std::string name;
    std::string bytes;
    Resolver resolver;
    Welded welded;
    std::unique_ptr<CoordinateStore> store;

    Welding welding() const { return {welded.mesh, welded.vertex_of}; }
};

Model::Model(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(Model&&) noexcept = default;
Model::~Model() = default;

Format Model::format() const {
    return impl_->format;
}
const TriangleMesh& Model::mesh() const {
    return impl_->welded.mesh;
}
std::span<const Index> Model::vertex_of_slot() const {
    return impl_->welded.vertex_of;
}
std::string_view Model::bytes() const {
    return impl_->bytes;
}
double Model::coordinate_step() const {
    return impl_->store->step(impl_->welding());
}

std::vector<Vec3> Model::stored_positions(std::span<const Vec3> wanted) const {
    return impl_->store->settle(impl_->welding(), wanted);
}

std::string Model::patched(std::span<const Vec3> wanted, Normals normals) const {
    return patched_files(wanted, {}, normals).bytes;
}

PatchedFiles Model::patched_files(std::span<const Vec3> wanted, std::string_view output_name,
                                  Normals normals) const {
    PatchedFiles files = impl_->store->patch(impl_->welding(), wanted, output_name);
    if (normals == Normals::keep)
        return files;
    return with_turned_normals(std::move(files), impl_->format, {impl_->name, impl_->bytes}, impl_->welding(),
                               impl_->resolver, output_name);
}

Model Model::read_back(const PatchedFiles& files) const {
    return parse(files.bytes, impl_->format, impl_->name, [&](std::string_view uri) {
        for (const SideFile& side : files.side_files)
            if (side.name == uri)
                return side.bytes;
        if (!impl_->resolver)
            throw InputError(fmt::format("{}: nothing is known of its buffer {}", impl_->name, uri));
        return impl_->resolver(uri);
    });
}

Vec3 largest_coordinates(const TriangleMesh& mesh) {
    const Box box = surface_box(mesh);
    return box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs());
}

namespace {

Document read_document(const Source& source, Format format, const Resolver& resolver) {
    switch (format) {
    case Format::obj:
        return read_obj(source);
    case Format::ply:
        return read_ply(source);
    case Format::stl:
        return read_stl(source);
    case Format::off:
        return read_off(source);
    case Format::gltf:
        return read_gltf(source, resolver);
    case Format::glb:
        return read_glb(source, resolver);
    }
    throw ParameterError("unknown file format");
}

void refuse_other_format(const Source& source, Format format) {
    const auto seen = format_of_content(source.bytes);
    // A binary STL may begin with anything, other formats' words among them.
    if (seen && *seen != format && format != Format::stl)
        source.fail(fmt::format("this is a file of format {0}, not {1}; name it .{0} or say --format {0}",
                                name_of(*seen), name_of(format)));
}

/// Resolver that reads below the folder of `path` only: a mesh file can't make wm3d read anything else.
Resolver resolver_beside(const std::filesystem::path& path) {
    return [path](std::string_view uri) {
        const std::filesystem::path relative(uri);
        bool leaves = relative.is_absolute() || uri.find("://") != std::string_view::npos;
        for (const auto& part : relative)
            leaves = leaves || part == "..";
        if (leaves)
            throw InputError(fmt::format("{}: its buffer {} lies outside the file's folder and is not read; "
                                         "put the buffer beside the file",
                                         path.string(), uri.substr(0, 60)));
        return read_file(path.parent_path() / relative);
    };
}

} // namespace

Model parse(std::string bytes, Format format, std::string name, const Resolver& resolver) {
    auto impl = std::make_unique<Model::Impl>();
    impl->format = format;
    impl->bytes = std::move(bytes);
    impl->name = std::move(name);
    impl->resolver = resolver;
    const Source source{impl->name, impl->bytes};
    if (source.bytes.empty())
        source.fail("the file is empty");
    refuse_other_format(source, format);
    Document document = read_document(source, format, resolver);
    if (document.triangles.empty())
        source.fail("the file holds no faces, so there is no surface to work on");
    impl->welded = weld(document.positions, document.triangles);
    impl->store = std::move(document.store);
    return Model(std::move(impl));
}

Model read(const std::filesystem::path& path, const ReadOptions& options) {
    std::string bytes = read_file(path);
    const auto format = options.format ? options.format : format_of_name(path.filename().string());
    if (!format) {
        const auto seen = format_of_content(bytes);
        throw InputError(fmt::format(
            "{}: the file's extension names no format that wm3d reads (obj, ply, stl, off, "
            "gltf, glb){}",
            path.string(),
            seen ? fmt::format("; its content looks like {0}, so say --format {0}", name_of(*seen))
                 : "; say which it is with --format"));
    }
    return parse(std::move(bytes), *format, path.string(), resolver_beside(path));
}

} // namespace wm3d::io
