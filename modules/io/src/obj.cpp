// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ. tinyobjloader reads the statements; a scan of the `v` lines finds where the coordinates stand
// and reads them exactly (tinyobjloader's own decimals may be off by a few ulp, which would open seams between
// equal positions that are spelt differently).
#include <cstring>
#include <exception>
#include <istream>
#include <streambuf>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <wm3d/mesh/parallel.hpp>

#include "document.hpp"
#include "polygons.hpp"
#include "text.hpp"

namespace wm3d::io {

namespace {

/// The statements of a file in memory, as a stream that knows how far it was read.
class BytesBuffer : public std::streambuf {
public:
    explicit BytesBuffer(std::string_view bytes) {
        char* begin = const_cast<char*>(bytes.data()); // a get area is never written to
        setg(begin, begin, begin + bytes.size());
    }
    std::size_t offset() const { return static_cast<std::size_t>(gptr() - eback()); }
};

/// Faces as tinyobjloader reports them, line by line.
struct FaceReader {
    const Source& source;
    BytesBuffer buffer;
    Polygons faces;
    std::size_t vertices = 0; // so far: negative indices count back from here
    Index largest = 0;
    std::size_t largest_at = 0;

    explicit FaceReader(const Source& s) : source(s), buffer(s.bytes) {}

    [[noreturn]] void fail(std::string_view what) const {
        // The reader stands behind the line's end.
        source.fail_in_line(buffer.offset() - (buffer.offset() > 0 ? 1 : 0), what);
    }

    Index resolve(int index) const {
        if (index > 0)
            return static_cast<Index>(index) - 1;
        if (index == 0)
            fail("a face names vertex 0 or something that is no number; OBJ counts vertices from 1");
        if (static_cast<std::size_t>(-static_cast<long long>(index)) > vertices)
            fail(fmt::format("a face names vertex {}, but only {} vertices come before it", index, vertices));
        return static_cast<Index>(vertices - static_cast<std::size_t>(-static_cast<long long>(index)));
    }

    void add_face(const tinyobj::index_t* indices, int count) {
        if (count < 3)
            fail(fmt::format("a face has {} corners, but needs 3 or more", count));
        for (int i = 0; i < count; ++i) {
            const Index v = resolve(indices[i].vertex_index);
            if (v > largest || faces.corners.empty()) {
                largest = v;
                largest_at = buffer.offset() - 1;
            }
            faces.corners.push_back(v);
        }
        faces.close_face();
    }

    void run() {
        tinyobj::callback_t callback;
        callback.vertex_cb = [](void* self, double, double, double, double) {
            ++static_cast<FaceReader*>(self)->vertices;
        };
        callback.index_cb = [](void* self, tinyobj::index_t* indices, int count) {
            static_cast<FaceReader*>(self)->add_face(indices, count);
        };
        std::istream stream(&buffer);
        std::string warnings, errors;
        if (!tinyobj::LoadObjWithCallback(stream, callback, this, nullptr, &warnings, &errors))
            fail(errors.empty() ? "the file can't be understood as OBJ" : errors);
    }
};

/// Positions and places of the coordinates of all `v` lines.
void scan_vertices(const Source& source, std::vector<Vec3>& positions, TextStore& store) {
    TextScanner scan(source, 0);
    const std::string_view bytes = source.bytes;
    while (!scan.at_end()) {
        scan.skip_blanks();
        const std::size_t at = scan.offset();
        if (at + 1 < bytes.size() && bytes[at] == 'v' && (bytes[at + 1] == ' ' || bytes[at + 1] == '\t')) {
            scan.jump(at + 2);
            std::array<std::size_t, 3> offsets{};
            Vec3 position;
            for (std::size_t k = 0; k < 3; ++k) {
                scan.skip_blanks();
                if (scan.at_line_end())
                    source.fail_in_line(at, "a vertex has fewer than 3 coordinates");
                position[static_cast<int>(k)] = scan.number("a vertex coordinate", offsets[k]);
            }
            positions.push_back(position);
            store.add(offsets);
        }
        scan.skip_line();
    }
}

/// The bytes with every backslash that continues a line, and that line's end, blanked: same offsets.
std::string join_continued_lines(std::string_view bytes) {
    std::string joined(bytes);
    for (std::size_t at = joined.find('\\'); at != std::string::npos; at = joined.find('\\', at + 1)) {
        std::size_t end = at + 1;
        if (end < joined.size() && joined[end] == '\r')
            ++end;
        if (end < joined.size() && joined[end] == '\n')
            ++end;
        if (end > at + 1)
            std::memset(joined.data() + at, ' ', end - at);
    }
    return joined;
}

template <typename F>
std::exception_ptr caught(F&& f) {
    try {
        f();
    } catch (...) {
        return std::current_exception();
    }
    return nullptr;
}

Document read_statements(const Source& source, std::string_view original) {
    auto store = std::make_unique<TextStore>(original);
    Document document;
    FaceReader reader(source);
    std::exception_ptr of_vertices, of_faces; // caught here so that the same one is told on every run
    parallel_invoke([&] { of_faces = caught([&] { reader.run(); }); },
                    [&] { of_vertices = caught([&] { scan_vertices(source, document.positions, *store); }); });
    for (const std::exception_ptr& error : {of_vertices, of_faces})
        if (error)
            std::rethrow_exception(error);
    if (reader.vertices != document.positions.size())
        source.fail("its lines can't be told apart; the file may mix line ends or hold control characters");
    if (!reader.faces.corners.empty() && reader.largest >= document.positions.size())
        source.fail_in_line(reader.largest_at, fmt::format("a face names vertex {}, but the file has {} vertices",
                                                           reader.largest + 1, document.positions.size()));
    document.triangles = triangulate(document.positions, reader.faces);
    document.store = std::move(store);
    return document;
}

} // namespace

Document read_obj(const Source& source) {
    if (const std::size_t zero = source.bytes.find('\0'); zero != std::string_view::npos)
        source.fail_at_byte(zero, "a zero byte, which no OBJ file holds; the file is binary or damaged");
    if (source.bytes.find('\\') == std::string_view::npos)
        return read_statements(source, source.bytes);
    const std::string joined = join_continued_lines(source.bytes);
    return read_statements({source.name, joined}, source.bytes);
}

} // namespace wm3d::io
