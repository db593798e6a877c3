// SPDX-License-Identifier: GPL-3.0-or-later
// OFF with its variants that add normals, colours or texture coordinates after x, y and z: one line per
// element.
#include <algorithm>

#include <fmt/format.h>

#include "document.hpp"
#include "normals.hpp"
#include "polygons.hpp"
#include "text.hpp"

namespace wm3d::io {

namespace {

/// Skips line ends, blank lines and comments.
void skip_to_content(TextScanner& scan) {
    for (;;) {
        scan.skip_space();
        if (scan.at_end() || scan.source().bytes[scan.offset()] != '#')
            return;
        scan.skip_line();
    }
}

/// Reads the keyword, which may be missing; the counts may follow it on the same line, even without a space.
std::string_view read_keyword(TextScanner& scan) {
    skip_to_content(scan);
    const std::string_view rest = scan.source().bytes.substr(scan.offset());
    const std::size_t length = std::min(rest.find_first_of(" \t\r\n#0123456789"), rest.size());
    const std::string_view keyword = rest.substr(0, length);
    if (!keyword.empty() && !keyword.ends_with("OFF"))
        scan.source().fail_in_line(scan.offset(),
                                   fmt::format("\"{}\" is no keyword of OFF", keyword.substr(0, 30)));
    if (rest.starts_with("4OFF") || rest.starts_with("nOFF") || keyword.find('4') != std::string_view::npos ||
        keyword.find('n') != std::string_view::npos)
        scan.source().fail_in_line(scan.offset(),
                                   "an OFF file of another dimension than 3 holds no surface in space");
    scan.jump(scan.offset() + length);
    scan.skip_blanks();
    if (scan.source().bytes.substr(scan.offset()).starts_with("BINARY"))
        scan.source().fail_in_line(scan.offset(),
                                   "binary OFF is not read; save the file as text OFF or as PLY");
    return keyword;
}

struct Counts {
    std::size_t vertices = 0, faces = 0;
};

Counts read_counts(TextScanner& scan) {
    const Source& source = scan.source();
    skip_to_content(scan);
    const auto vertices = static_cast<std::size_t>(scan.integer("the number of vertices", 0));
    const auto faces = static_cast<std::size_t>(scan.integer("the number of faces", 0));
    scan.skip_line(); // the number of edges, which nobody trusts
    // A vertex takes 6 bytes or more and a face 2; checked by division, so that no count overflows.
    if (vertices > source.bytes.size() / 5 || faces > source.bytes.size() / 2)
        source.fail(fmt::format(
            "it announces {} vertices and {} faces, but the file is too short for them; it is cut "
            "short or damaged",
            vertices, faces));
    return {vertices, faces};
}

void read_vertices(TextScanner& scan, std::size_t count, std::vector<Vec3>& positions, TextStore& store) {
    positions.reserve(count);
    store.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        skip_to_content(scan);
        std::array<std::size_t, 3> offsets{};
        Vec3 position;
        for (std::size_t k = 0; k < 3; ++k)
            position[static_cast<int>(k)] = scan.number("a vertex coordinate", offsets[k]);
        positions.push_back(position);
        store.add(offsets);
        scan.skip_line();
    }
}

Polygons read_faces(TextScanner& scan, std::size_t count, std::size_t vertices) {
    Polygons faces;
    faces.ends.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        skip_to_content(scan);
        const std::size_t line = scan.offset();
        const auto corners = static_cast<std::size_t>(scan.integer("the number of corners of a face", 0));
        for (std::size_t k = 0; k < corners; ++k) {
            const std::int64_t v = scan.integer("a vertex number", 0);
            if (v >= static_cast<std::int64_t>(vertices))
                scan.source().fail_in_line(line,
                                           fmt::format("a face names vertex {}, but the file has {} (counted "
                                                       "from 0)",
                                                       v, vertices));
            faces.corners.push_back(static_cast<Index>(v));
        }
        faces.close_face();
        scan.skip_line();
    }
    return faces;
}

} // namespace

Document read_off(const Source& source) {
    TextScanner scan(source, 0);
    read_keyword(scan);
    const auto [vertices, faces] = read_counts(scan);
    Document document;
    auto store = std::make_unique<TextStore>(source.bytes);
    read_vertices(scan, vertices, document.positions, *store);
    document.triangles = triangulate(document.positions, read_faces(scan, faces, vertices));
    document.store = std::move(store);
    return document;
}

std::optional<NormalTable> off_normals(const Source& patched) {
    TextScanner scan(patched, 0);
    const std::string_view keyword = read_keyword(scan);
    if (keyword.find('N') == std::string_view::npos)
        return std::nullopt;
    if (keyword.find('C') != std::string_view::npos)
        patched.fail("programs disagree on whether an OFF file's normals stand before its colours, so its "
                     "normals can't "
                     "be recomputed; keep them, or save the file as PLY");
    const std::size_t vertices = read_counts(scan).vertices;
    NormalTable table;
    auto store = std::make_unique<TextStore>(patched.bytes);
    for (std::size_t i = 0; i < vertices; ++i) {
        skip_to_content(scan);
        for (int k = 0; k < 3; ++k)
            scan.word(); // the position
        std::array<std::size_t, 3> offsets{};
        table.values.push_back(scan.any_vector("a normal", offsets));
        store->add(offsets);
        scan.skip_line();
    }
    table.store = std::move(store);
    return table;
}

} // namespace wm3d::io
