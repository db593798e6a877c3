// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/io/model.hpp>

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/io/file.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/weld.hpp>

#include "document.hpp"
#include "file_bytes.hpp"
#include "normals.hpp"

namespace wm3d::io {

struct Model::Impl {
    Format format = Format::obj;
    std::string name;
    FileBytes bytes;
    Resolver resolver;
    Limits limits;
    Welded welded;
    std::unique_ptr<CoordinateStore> store;

    explicit Impl(std::string of_file) : bytes(std::move(of_file)) {}

    Welding welding() const { return {welded.mesh, welded.vertex_of}; }

    /// The store, whose views of the file's bytes can be looked at.
    const CoordinateStore& awake() {
        bytes.here();
        return *store;
    }
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
TriangleMesh Model::take_mesh() && {
    const std::unique_ptr<Impl> going = std::move(impl_);
    return std::move(going->welded.mesh);
}
std::span<const Index> Model::vertex_of_slot() const {
    return impl_->welded.vertex_of;
}
std::string_view Model::bytes() const {
    return impl_->bytes.here();
}
void Model::let_bytes_go(std::size_t fewest) const {
    impl_->bytes.let_go(fewest);
}
double Model::coordinate_step() const {
    return impl_->awake().step(impl_->welding());
}

std::vector<Vec3> Model::stored_positions(std::span<const Vec3> wanted) const {
    return impl_->awake().settle(impl_->welding(), wanted);
}

std::string Model::patched(std::span<const Vec3> wanted, Normals normals) const {
    return patched_files(wanted, {}, normals).bytes;
}

PatchedFiles Model::patched_files(std::span<const Vec3> wanted, std::string_view output_name,
                                  Normals normals) const {
    PatchedFiles files = impl_->awake().patch(impl_->welding(), wanted, output_name);
    if (normals == Normals::keep)
        return files;
    return with_turned_normals(std::move(files), impl_->format, {impl_->name, impl_->bytes.here()},
                               impl_->welding(), impl_->resolver, output_name);
}

/// Reads the files beside a patched one, as they are written or as they were.
Resolver Model::written_or_beside(const PatchedFiles& files) const {
    return [this, &files](std::string_view uri) {
        for (const SideFile& side : files.side_files)
            if (side.name == uri)
                return side.bytes;
        if (!impl_->resolver)
            throw InputError(
                fmt::format("{}: nothing is known of its buffer {}", impl_->name, printable(uri)));
        return impl_->resolver(uri);
    };
}

Model Model::read_back(const PatchedFiles& files) const {
    return parse(files.bytes, impl_->format, impl_->name, written_or_beside(files), impl_->limits);
}

TriangleMesh Model::reread(PatchedFiles& files) const {
    Model written =
        parse(std::move(files.bytes), impl_->format, impl_->name, written_or_beside(files), impl_->limits);
    files.bytes = std::move(written.impl_->bytes).take();
    return std::move(written).take_mesh();
}

Vec3 largest_coordinates(const TriangleMesh& mesh) {
    const Box box = surface_box(mesh);
    return box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs());
}

namespace {

Document read_document(const Source& source, Format format, const Resolver& resolver, const Limits& limits) {
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
        return read_gltf(source, resolver, limits);
    case Format::glb:
        return read_glb(source, resolver, limits);
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

/// Whether the file lies in the folder or below it, once every symbolic link is followed.
bool lies_below(const std::filesystem::path& file, const std::filesystem::path& folder) {
    std::error_code failure;
    const auto real_folder = std::filesystem::canonical(folder.empty() ? "." : folder, failure);
    const auto real_file = std::filesystem::weakly_canonical(file, failure);
    return !failure &&
           std::mismatch(real_folder.begin(), real_folder.end(), real_file.begin(), real_file.end()).first ==
               real_folder.end();
}

} // namespace

Resolver resolver_beside(const std::filesystem::path& path) {
    return [path](std::string_view uri) {
        const std::filesystem::path relative(uri), file = path.parent_path() / relative;
        const auto refuse = [&](std::string_view why) {
            throw InputError(
                fmt::format("{}: its buffer {} {}", path.string(), printable(uri.substr(0, 60)), why));
        };
        const bool leaves = relative.is_absolute() || uri.find("://") != std::string_view::npos ||
                            std::ranges::find(relative, "..") != relative.end();
        if (leaves || !lies_below(file, path.parent_path()))
            refuse("lies outside the file's folder and is not read; put the buffer beside the file");
        std::error_code failure;
        const auto status = std::filesystem::status(file, failure);
        if (!std::filesystem::exists(status))
            refuse("is not there; put it beside the file, or save the model as GLB");
        if (!std::filesystem::is_regular_file(status)) // a pipe would be waited for
            refuse("is no regular file and is not read");
        return read_file(file);
    };
}

Limits Limits::none() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {.per_byte = infinity, .unpacked_per_byte = infinity};
}

Model parse(std::string bytes, Format format, std::string name, const Resolver& resolver,
            const Limits& limits) {
    auto impl = std::make_unique<Model::Impl>(std::move(bytes));
    impl->format = format;
    impl->name = std::move(name);
    impl->resolver = resolver;
    impl->limits = limits;
    const Source source{impl->name, impl->bytes.here()};
    if (source.bytes.empty())
        source.fail("the file is empty");
    refuse_other_format(source, format);
    Document document = read_document(source, format, resolver, limits);
    if (document.triangles.empty())
        source.fail("the file holds no faces, so there is no surface to work on");
    impl->welded = weld(std::move(document.positions), std::move(document.triangles));
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
    Model model = parse(std::move(bytes), *format, path.string(), resolver_beside(path), options.limits);
    model.impl_->bytes.came_from(path);
    return model;
}

} // namespace wm3d::io
