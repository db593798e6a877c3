// SPDX-License-Identifier: GPL-3.0-or-later
// PLY: text and binary bodies are walked by the same code over two kinds of cursor.
#include <algorithm>
#include <atomic>
#include <utility>

#include <fmt/format.h>

#include <wm3d/core/parallel.hpp>

#include "document.hpp"
#include "normals.hpp"
#include "ply_header.hpp"
#include "polygons.hpp"
#include "text.hpp"

namespace wm3d::io {

namespace {

/// The three properties that hold a vertex's coordinates, or those of its normal.
struct CoordinateProperties {
    std::array<std::size_t, 3> number{};
    std::size_t first = 0, last = 0;
    bool finite = true; ///< whether they have to be
};

/// Walks a text body.
class TextBody {
public:
    TextBody(const Source& source, const PlyHeader& header, const PlyElement&, const CoordinateProperties&)
        : scan_(source, header.body), store_(std::make_unique<TextStore>(source.bytes)) {}

    void reserve(std::size_t slots) { store_->reserve(slots); }
    std::int64_t integer(Scalar, std::string_view what, std::int64_t least) {
        return scan_.integer(what, least);
    }
    void skip(Scalar, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
            if (scan_.word().empty())
                scan_.source().fail("the file ends before all its elements are read; it is cut short");
    }
    /// Checks that a list of `count` values can still follow.
    void expect(std::size_t count, Scalar) {
        if (count > scan_.source().bytes.size() - scan_.offset())
            scan_.source().fail_in_line(scan_.offset(),
                                        fmt::format("a list of {} values is longer than the file", count));
    }
    Vec3 coordinates(const PlyElement& element, const CoordinateProperties& xyz) {
        std::array<std::size_t, 3> offsets{};
        Vec3 position;
        for (std::size_t p = xyz.first; p <= xyz.last; ++p) {
            const auto k = static_cast<std::size_t>(std::find(xyz.number.begin(), xyz.number.end(), p) -
                                                    xyz.number.begin());
            if (k < 3)
                position[static_cast<int>(k)] = xyz.finite ? scan_.number("a vertex coordinate", offsets[k])
                                                           : scan_.any_number("a normal", offsets[k]);
            else
                skip(element.properties[p].type, 1);
        }
        store_->add(offsets);
        return position;
    }
    /// Text is read number by number.
    std::vector<Triangle> plain_triangles(const PlyElement&, std::size_t) { return {}; }
    [[noreturn]] void fail(std::string_view what) const { scan_.source().fail_in_line(scan_.offset(), what); }
    std::unique_ptr<CoordinateStore> take_store() { return std::move(store_); }

    /// Fewest bytes that an element of this kind takes.
    static std::size_t least_size(const PlyElement& element) { return 2 * element.properties.size(); }

private:
    TextScanner scan_;
    std::unique_ptr<TextStore> store_;
};

/// Walks a binary body of either byte order.
class BinaryBody {
public:
    BinaryBody(const Source& source, const PlyHeader& header, const PlyElement& vertex,
               const CoordinateProperties& xyz)
        : source_(source), at_(header.body),
          swap_(swaps(header.encoding == PlyEncoding::binary_big_endian ? std::endian::big
                                                                        : std::endian::little)) {
        BinaryStore::Layout layout;
        layout.swap = swap_;
        std::size_t within = 0;
        for (std::size_t p = xyz.first; p <= xyz.last; ++p) {
            for (std::size_t k = 0; k < 3; ++k)
                if (xyz.number[k] == p) {
                    layout.types[k] = vertex.properties[p].type;
                    layout.within[k] = within;
                }
            within += size_of(vertex.properties[p].type);
        }
        coordinates_size_ = within;
        store_ = std::make_unique<BinaryStore>(source.bytes, layout);
    }

    void reserve(std::size_t slots) { store_->reserve(slots); }
    std::int64_t integer(Scalar type, std::string_view what, std::int64_t least) {
        expect(1, type);
        const auto value = static_cast<std::int64_t>(load(source_.bytes.data() + at_, type, swap_));
        if (value < least)
            fail(fmt::format("{} is {}, but can't be below {}", what, value, least));
        at_ += size_of(type);
        return value;
    }
    void skip(Scalar type, std::size_t count) {
        expect(count, type);
        at_ += count * size_of(type);
    }
    void expect(std::size_t count, Scalar type) {
        if (count > (source_.bytes.size() - at_) / size_of(type))
            fail(fmt::format("{} should follow, but the file ends; it is cut short or damaged",
                             count == 1 ? "a value" : fmt::format("{} values", count)));
    }
    Vec3 coordinates(const PlyElement&, const CoordinateProperties& xyz) {
        expect(coordinates_size_, Scalar::u8);
        const Vec3 position = store_->add(at_);
        if (xyz.finite && !position.allFinite())
            fail("a vertex coordinate is not finite; wm3d needs finite coordinates");
        at_ += coordinates_size_;
        return position;
    }
    std::vector<Triangle> plain_triangles(const PlyElement& faces, std::size_t vertices);
    [[noreturn]] void fail(std::string_view what) const { source_.fail_at_byte(at_, what); }
    std::unique_ptr<CoordinateStore> take_store() { return std::move(store_); }

    static std::size_t least_size(const PlyElement& element) { return element.least_size(); }

private:
    const Source& source_;
    std::size_t at_;
    bool swap_;
    std::size_t coordinates_size_ = 0;
    std::unique_ptr<BinaryStore> store_;
};

/// All faces at once where each is a byte that says 3 and three numbers of vertices, as nearly always; nothing, and
/// nothing is read, where they are not: then they are read one by one, and what is wrong with one is told.
std::vector<Triangle> BinaryBody::plain_triangles(const PlyElement& faces, std::size_t vertices) {
    constexpr std::size_t corners = 3, block = 16384;
    if (faces.properties.size() != 1)
        return {};
    const PlyProperty& list = faces.properties.front();
    const std::size_t number = size_of(list.type), record = 1 + corners * number;
    if (size_of(*list.count_type) != 1 || faces.count > (source_.bytes.size() - at_) / record)
        return {};
    std::vector<Triangle> triangles(faces.count);
    std::atomic<bool> plain = true;
    parallel_blocks(faces.count, block, [&](std::size_t begin, std::size_t end) {
        const auto most = static_cast<double>(vertices);
        for (std::size_t f = begin; f < end && plain; ++f) {
            const char* at = source_.bytes.data() + at_ + f * record;
            bool fits = *at == corners;
            for (std::size_t k = 0; k < corners; ++k) {
                const double corner = load(at + 1 + k * number, list.type, swap_);
                fits = fits && corner >= 0 && corner < most;
                triangles[f][k] = fits ? static_cast<Index>(corner) : 0;
            }
            if (!fits)
                plain = false;
        }
    });
    if (!plain)
        return {};
    at_ += faces.count * record;
    return triangles;
}

template<typename Body>
void skip_property(Body& body, const PlyProperty& property) {
    std::size_t count = 1;
    if (property.is_list())
        count = static_cast<std::size_t>(body.integer(*property.count_type, "the length of a list", 0));
    body.skip(property.type, count);
}

template<typename Body>
void read_vertices(Body& body, const PlyElement& element, const CoordinateProperties& xyz,
                   Document& document) {
    document.positions.reserve(element.count);
    body.reserve(element.count);
    for (std::size_t i = 0; i < element.count; ++i)
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            if (p == xyz.first) {
                document.positions.push_back(body.coordinates(element, xyz));
                p = xyz.last;
            } else {
                skip_property(body, element.properties[p]);
            }
        }
}

/// Reads one list of vertex numbers; -1 is kept as no_index where strips end with it.
template<typename Body>
void read_indices(Body& body, const PlyProperty& property, std::size_t vertices, bool strips,
                  std::vector<Index>& indices) {
    const auto count =
        static_cast<std::size_t>(body.integer(*property.count_type, "the length of a list", 0));
    body.expect(count, property.type);
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t index = body.integer(property.type, "a vertex number", strips ? -1 : 0);
        if (index >= static_cast<std::int64_t>(vertices))
            body.fail(
                fmt::format("a face names vertex {}, but the file has {} (counted from 0)", index, vertices));
        indices.push_back(index < 0 ? no_index : static_cast<Index>(index));
    }
}

/// \param plain  triangles that come before `faces`
template<typename Body>
void read_faces(Body& body, const PlyElement& element, std::size_t list, std::size_t vertices,
                std::vector<Triangle>& plain, Polygons& faces) {
    if (plain.empty() && faces.size() == 0) {
        plain = body.plain_triangles(element, vertices);
        if (!plain.empty())
            return;
    }
    for (std::size_t i = 0; i < element.count; ++i)
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            if (p == list) {
                read_indices(body, element.properties[p], vertices, false, faces.corners);
                faces.close_face();
            } else {
                skip_property(body, element.properties[p]);
            }
        }
}

template<typename Body>
void read_strips(Body& body, const PlyElement& element, std::size_t list, std::size_t vertices,
                 std::vector<Triangle>& triangles) {
    std::vector<Index> strip;
    for (std::size_t i = 0; i < element.count; ++i)
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            if (p != list) {
                skip_property(body, element.properties[p]);
                continue;
            }
            strip.clear();
            read_indices(body, element.properties[p], vertices, true, strip);
            for (auto begin = strip.begin(); begin != strip.end();) {
                const auto end = std::find(begin, strip.end(), no_index);
                append_strip({begin, end}, triangles);
                begin = end == strip.end() ? end : end + 1;
            }
        }
}

std::optional<std::size_t> index_list(const PlyElement& element) {
    for (std::string_view name : {"vertex_indices", "vertex_index"})
        if (const auto p = element.find(name); p && element.properties[*p].is_list())
            return p;
    return std::nullopt;
}

const PlyElement& find_vertex_element(const Source& source, const PlyHeader& header) {
    const PlyElement* found = nullptr;
    for (const PlyElement& element : header.elements)
        if (element.name == "vertex") {
            if (found != nullptr)
                source.fail("the header has two elements named vertex");
            found = &element;
        }
    if (found == nullptr)
        source.fail("the header has no element named vertex");
    return *found;
}

using Names = std::array<std::string_view, 3>;
constexpr Names position_names{"x", "y", "z"}, normal_names{"nx", "ny", "nz"};

/// The first of the names that no number of the vertices has.
std::optional<std::string_view> missing_name(const PlyElement& vertex, const Names& names) {
    for (std::string_view name : names)
        if (const auto p = vertex.find(name); !p || vertex.properties[*p].is_list())
            return name;
    return std::nullopt;
}

/// \pre  no name is missing
CoordinateProperties find_numbers(const Source& source, const PlyElement& vertex, const Names& names) {
    CoordinateProperties xyz;
    for (std::size_t k = 0; k < 3; ++k)
        xyz.number[k] = *vertex.find(names[k]);
    xyz.first = *std::min_element(xyz.number.begin(), xyz.number.end());
    xyz.last = *std::max_element(xyz.number.begin(), xyz.number.end());
    for (std::size_t p = xyz.first; p <= xyz.last; ++p)
        if (vertex.properties[p].is_list())
            source.fail(fmt::format(
                "a list stands between {0}, {1} and {2} of its vertices, which wm3d does not read; "
                "save the file with {0}, {1} and {2} together",
                names[0], names[1], names[2]));
    return xyz;
}

CoordinateProperties find_coordinates(const Source& source, const PlyElement& vertex) {
    if (const auto missing = missing_name(vertex, position_names))
        source.fail(fmt::format("its vertices have no number {}, so there are no positions", *missing));
    return find_numbers(source, vertex, position_names);
}

void append(std::vector<Triangle>& triangles, const std::vector<Triangle>& more) {
    triangles.insert(triangles.end(), more.begin(), more.end());
}

/// Refuses counts that the file is too short for, before anything is allocated.
template<typename Body>
void check_counts(const Source& source, const PlyHeader& header) {
    for (const PlyElement& element : header.elements) {
        const std::size_t least = Body::least_size(element);
        // One more byte: the last word of a text file needs no space after it.
        if (least > 0 && element.count > (source.bytes.size() - header.body + 1) / least)
            source.fail(
                fmt::format("its header announces {} elements named {}, but the file ends before; it is cut "
                            "short or damaged",
                            element.count, element.name));
    }
}

template<typename Body>
Document read_body(const Source& source, const PlyHeader& header, const PlyElement& vertex,
                   const CoordinateProperties& xyz) {
    check_counts<Body>(source, header);
    Body body(source, header, vertex, xyz);
    Document document;
    Polygons faces;
    std::vector<Triangle> plain, from_strips;
    for (const PlyElement& element : header.elements) {
        const auto list = index_list(element);
        if (list && !is_integer(element.properties[*list].type))
            source.fail(
                "its vertex numbers are floating-point numbers; save the file with integer vertex numbers");
        if (&element == &vertex)
            read_vertices(body, element, xyz, document);
        else if (element.name == "face" && list)
            read_faces(body, element, *list, vertex.count, plain, faces);
        else if (element.name == "tristrips" && list)
            read_strips(body, element, *list, vertex.count, from_strips);
        else if (!element.properties.empty())
            for (std::size_t i = 0; i < element.count; ++i)
                for (const PlyProperty& property : element.properties)
                    skip_property(body, property);
    }
    document.triangles = std::move(plain);
    if (document.triangles.empty())
        document.triangles = triangulate(document.positions, faces);
    else if (faces.size() > 0)
        append(document.triangles, triangulate(document.positions, faces));
    append(document.triangles, from_strips);
    document.store = body.take_store();
    return document;
}

Document read_encoded(const Source& source, const PlyHeader& header, const PlyElement& vertex,
                      const CoordinateProperties& xyz) {
    return header.encoding == PlyEncoding::ascii ? read_body<TextBody>(source, header, vertex, xyz)
                                                 : read_body<BinaryBody>(source, header, vertex, xyz);
}

} // namespace

Document read_ply(const Source& source) {
    const PlyHeader header = read_ply_header(source);
    const PlyElement& vertex = find_vertex_element(source, header);
    return read_encoded(source, header, vertex, find_coordinates(source, vertex));
}

std::optional<NormalTable> ply_normals(const Source& patched) {
    const PlyHeader header = read_ply_header(patched);
    const PlyElement& vertex = find_vertex_element(patched, header);
    if (missing_name(vertex, normal_names))
        return std::nullopt;
    CoordinateProperties numbers = find_numbers(patched, vertex, normal_names);
    numbers.finite = false;
    // Read as positions would be: the "positions" of this document are the normals.
    Document document = read_encoded(patched, header, vertex, numbers);
    return NormalTable{std::move(document.positions), std::move(document.store)};
}

} // namespace wm3d::io
