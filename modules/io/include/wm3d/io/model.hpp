// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A mesh file in memory: its surface for the analysis, and its bytes with other coordinates.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <wm3d/io/format.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::io {

/// A file that belongs beside another, by its name in the same folder.
struct SideFile {
    std::string name;
    std::string bytes;
};

/// A patched file and the files it refers to that had to change with it (external buffers of glTF).
struct PatchedFiles {
    std::string bytes;
    std::vector<SideFile> side_files;
};

/// What becomes of normals that a file stores when its positions are patched.
enum class Normals {
    keep, ///< every byte of them
    turn, ///< each turns as its faces do, so that creases and smoothing stay as they were; shading follows
          ///< the surface
};

struct Document;
struct Limits;

/// A mesh file that was read. A *slot* is one stored vertex (a `v` line, a facet corner, a vertex of one
/// instance of a glTF mesh); slots that coincide are one *vertex* of the analysis mesh and move together.
class Model {
public:
    Model(Model&&) noexcept;
    Model& operator=(Model&&) noexcept;
    ~Model();

    Format format() const;

    /// The analysis mesh, in world coordinates of the file: coinciding positions welded, polygons
    /// triangulated, triangles that repeat a vertex dropped, isolated vertices kept.
    const TriangleMesh& mesh() const;

    /// The mesh alone, for who needs no more of the file: what it takes to patch it is let go.
    TriangleMesh take_mesh() &&;

    /// Vertex of every slot, #slots, in file order.
    std::span<const Index> vertex_of_slot() const;

    /// The file as it was read.
    std::string_view bytes() const;

    /// Lets the file's bytes go until something needs them, if they were `read` from a file: they are then read again.
    /// Whatever needs them throws InputError if the file was changed meanwhile.
    /// \param fewest  so many bytes or more go; fewer are nothing beside what a mark takes, and reading them again takes time
    /// \pre  nobody looks at `bytes` any more
    void let_bytes_go(std::size_t fewest = std::size_t{4} << 20) const;

    /// The coarsest distance between neighbouring values that a coordinate of the surface can be given in
    /// this file, in units of the mesh. Moves well below it are lost.
    double coordinate_step() const;

    /// Positions that reading the patched file would give, #V: `wanted` rounded to what the file can hold.
    /// Vertices that can't move without tearing a seam (see the README on instances) keep their position.
    /// \pre  wanted.size() == #V, all finite
    std::vector<Vec3> stored_positions(std::span<const Vec3> wanted) const;

    /// The whole file with the vertices at `wanted`, #V. Bytes of coordinates that don't change and all bytes
    /// outside coordinates stay. A changed external buffer of glTF is put inline (a `data:` URI).
    /// \pre  wanted.size() == #V, all finite
    /// \throw InputError  with Normals::turn, if the normals can't be understood
    std::string patched(std::span<const Vec3> wanted, Normals normals = Normals::keep) const;

    /// As `patched`, for writing under `output_name`: a changed external buffer becomes a side file
    /// STEM.bin (STEM-1.bin, ... for further ones), STEM being `output_name` without folder and extension.
    PatchedFiles patched_files(std::span<const Vec3> wanted, std::string_view output_name,
                               Normals normals = Normals::keep) const;

    /// What reading the patched files would give once they are written.
    /// \throw InputError  as `parse`
    Model read_back(const PatchedFiles& files) const;

    /// The surface of `read_back`, without a copy of the file's bytes.
    /// \throw InputError  as `parse`; the files are of no use any more then
    TriangleMesh reread(PatchedFiles& files) const;

private:
    struct Impl;
    explicit Model(std::unique_ptr<Impl> impl);
    std::function<std::string(std::string_view)> written_or_beside(const PatchedFiles& files) const;
    friend Model parse(std::string, Format, std::string, const std::function<std::string(std::string_view)>&,
                       const Limits&);
    friend Model read(const std::filesystem::path&, const struct ReadOptions&);
    std::unique_ptr<Impl> impl_;
};

/// Bytes behind a relative URI that a glTF file names; throws InputError if there are none.
using Resolver = std::function<std::string(std::string_view uri)>;

/// Resolver that reads regular files below the folder of `path` only: a mesh file can't make wm3d read
/// anything else, by no `..` and by no symbolic link.
Resolver resolver_beside(const std::filesystem::path& path);

/// How far a file may grow in memory: instances, shared accessors and packing let a few bytes of glTF stand
/// for any number of vertices.
struct Limits {
    double per_byte = 2;           ///< vertices, triangles and primitives shown, for each byte of the asset
    std::size_t always = 1u << 20; ///< as many of each are taken from the smallest file
    double unpacked_per_byte = 64; ///< bytes out of packed views, for each byte of the asset

    /// No limit but memory, for files whose origin is known.
    static Limits none();
};

/// Reads a mesh out of `bytes`; `name` stands for the file in messages.
/// \throw InputError  if the bytes are no mesh of this format, an empty one, or one beyond `limits`
Model parse(std::string bytes, Format format, std::string name, const Resolver& resolver = {},
            const Limits& limits = {});

struct ReadOptions {
    std::optional<Format> format{}; ///< default: by the file's extension
    Limits limits{};
};

/// Reads a mesh file. External buffers of glTF are looked for below the file's folder only.
/// \throw InputError  if the file can't be read or is no mesh of its format
Model read(const std::filesystem::path& path, const ReadOptions& options = {});

} // namespace wm3d::io
