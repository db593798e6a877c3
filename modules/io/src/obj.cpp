// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront OBJ. A scan of the `v` lines finds where the coordinates stand and reads them exactly (tinyobjloader's own
// decimals may be off by a few ulp, which would open seams between equal positions that are spelt differently).
// tinyobjloader reads the other statements, but where there are only faces of plain numbers: these the scan reads itself,
// in a tenth of the time.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <istream>
#include <limits>
#include <streambuf>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <wm3d/core/parallel.hpp>

#include "document.hpp"
#include "obj_lines.hpp"
#include "polygons.hpp"
#include "text.hpp"

namespace wm3d::io {

namespace {

/// Pieces are cut by size alone, so that nothing depends on the number of threads.
constexpr std::size_t piece_size = std::size_t{1} << 17;

/// Some bytes as a stream that knows how far it was read.
class BytesBuffer : public std::streambuf {
public:
    explicit BytesBuffer(std::string_view bytes) {
        char* begin = const_cast<char*>(bytes.data()); // a get area is never written to
        setg(begin, begin, begin + bytes.size());
    }
    std::size_t offset() const { return static_cast<std::size_t>(gptr() - eback()); }
};

/// A run of whole lines of the file, and what they hold.
struct Piece {
    std::size_t begin = 0, end = 0;
    std::vector<Vec3> positions;
    std::vector<TextOffsets> offsets; ///< of the positions' words
    bool plain = true; ///< no line but `v`, faces of plain numbers, and those that say nothing of the shape
    Polygons faces;
    std::vector<Triangle> triangles;
    Index largest = 0; ///< vertex number of a face
    std::size_t largest_at = 0;
    std::exception_ptr error;

    /// Adds a corner, which stands in the line that holds `place`.
    void add_corner(Index v, std::size_t place) {
        if (v > largest) {
            largest = v;
            largest_at = place;
        }
        faces.corners.push_back(v);
    }
};

/// Faces of a piece as tinyobjloader reports them, line by line.
class FaceReader {
public:
    /// `vertices` come before the piece.
    FaceReader(const Source& source, Piece& piece, std::size_t vertices)
        : source_(source), piece_(piece), buffer_(source.bytes.substr(piece.begin, piece.end - piece.begin)),
          vertices_(vertices) {}

    /// \return  number of vertices up to the end of the piece
    std::size_t run() {
        tinyobj::callback_t callback;
        callback.vertex_cb = [](void* self, double, double, double, double) {
            ++static_cast<FaceReader*>(self)->vertices_;
        };
        callback.index_cb = [](void* self, tinyobj::index_t* indices, int count) {
            static_cast<FaceReader*>(self)->add_face(indices, count);
        };
        std::istream stream(&buffer_);
        std::string warnings, errors;
        if (!tinyobj::LoadObjWithCallback(stream, callback, this, nullptr, &warnings, &errors))
            fail(errors.empty() ? "the file can't be understood as OBJ" : errors);
        return vertices_;
    }

private:
    /// A byte of the line that was read last; the reader stands behind its end.
    std::size_t place() const { return piece_.begin + buffer_.offset() - (buffer_.offset() > 0 ? 1 : 0); }
    [[noreturn]] void fail(std::string_view what) const { source_.fail_in_line(place(), what); }

    Index resolve(int index) const {
        if (index > 0)
            return static_cast<Index>(index) - 1;
        if (index == 0)
            fail("a face names vertex 0 or something that is no number; OBJ counts vertices from 1");
        const auto back =
            static_cast<std::size_t>(-static_cast<std::int64_t>(index)); // -1 is the latest vertex
        if (back > vertices_)
            fail(
                fmt::format("a face names vertex {}, but only {} vertices come before it", index, vertices_));
        return static_cast<Index>(vertices_ - back);
    }

    void add_face(const tinyobj::index_t* indices, int count) {
        if (count < 3)
            fail(fmt::format("a face has {} corners, but needs 3 or more", count));
        for (int i = 0; i < count; ++i)
            piece_.add_corner(resolve(indices[i].vertex_index), place());
        piece_.faces.close_face();
    }

    const Source& source_;
    Piece& piece_;
    BytesBuffer buffer_;
    std::size_t vertices_; // so far: negative numbers count back from here
};

/// The statement's name with a blank behind it, or nothing.
std::string_view keyword(std::string_view bytes, std::size_t at) {
    constexpr std::size_t longest = 2;
    std::size_t end = at;
    while (end < std::min(at + longest, bytes.size()) && !is_blank(bytes[end]) && !is_line_end(bytes[end]))
        ++end;
    return end < bytes.size() && is_blank(bytes[end]) ? bytes.substr(at, end - at) : std::string_view{};
}

/// The position of a `v` line, whose coordinates the scanner stands before.
void scan_vertex(TextScanner& scan, std::size_t line, Piece& piece) {
    TextOffsets offsets{};
    Vec3 position;
    for (std::size_t k = 0; k < 3; ++k) {
        scan.skip_blanks();
        if (scan.at_line_end())
            scan.source().fail_in_line(line, "a vertex has fewer than 3 coordinates");
        position[static_cast<int>(k)] = scan.number("a vertex coordinate", offsets[k]);
    }
    piece.positions.push_back(position);
    piece.offsets.push_back(offsets);
}

/// Reads digits.
/// \return  their number, or 0 where there are none or too many
unsigned scan_digits(const char*& at, const char* end) {
    constexpr std::ptrdiff_t most = 10;
    constexpr std::uint64_t largest = std::numeric_limits<unsigned>::max();
    const char* const first = at;
    std::uint64_t value = 0;
    for (; at < end && is_digit(*at); ++at)
        value = 10 * value + static_cast<std::uint64_t>(*at - '0');
    return at - first <= most && value <= largest ? static_cast<unsigned>(value) : 0;
}

/// Adds the face of an `f` line, which the scanner stands in, if its corners are numbers counted from 1, which others may
/// follow after slashes.
/// \return  whether they are; if not, nothing that was added is of use
bool scan_plain_face(TextScanner& scan, Piece& piece) {
    const std::string_view bytes = scan.source().bytes;
    const std::size_t line = scan.offset();
    const char *at = bytes.data() + line, *const end = bytes.data() + bytes.size();
    int count = 0;
    for (;; ++count) {
        while (at < end && is_blank(*at))
            ++at;
        if (at == end || is_line_end(*at))
            break;
        const unsigned number = scan_digits(at, end);
        if (number == 0)
            return false;
        piece.add_corner(static_cast<Index>(number) - 1, line);
        for (int slash = 0; slash < 2 && at < end && *at == '/'; ++slash)
            scan_digits(++at, end);
        if (at < end && !is_blank(*at) && !is_line_end(*at))
            return false;
    }
    if (count < 3)
        return false;
    piece.faces.close_face();
    scan.jump(static_cast<std::size_t>(at - bytes.data()));
    return true;
}

/// What the piece's lines hold as far as they are plain; positions and places of coordinates of all of them.
void scan_piece(const Source& source, Piece& piece) {
    TextScanner scan(source, piece.begin);
    while (scan.offset() < piece.end) {
        scan.skip_blanks();
        const std::size_t line = scan.offset();
        const std::string_view statement = keyword(source.bytes, line);
        scan.jump(line + statement.size());
        if (statement == "v")
            scan_vertex(scan, line, piece);
        else if (statement == "f")
            piece.plain = piece.plain && scan_plain_face(scan, piece);
        else if (statement != "vn" && statement != "vt")
            piece.plain &= scan.at_line_end() || source.bytes[line] == '#';
        scan.skip_line();
    }
}

/// What tinyobjloader makes of a piece's faces.
void read_piece(const Source& source, Piece& piece, std::size_t vertices_before) {
    piece.faces = {};
    piece.largest = 0;
    piece.largest_at = 0;
    if (FaceReader(source, piece, vertices_before).run() != vertices_before + piece.positions.size())
        source.fail("its lines can't be told apart; the file may mix line ends or hold control characters");
}

/// Cuts the file after line ends.
std::vector<Piece> cut(const Source& source) {
    std::vector<Piece> pieces;
    for (std::size_t begin = 0; begin < source.bytes.size();) {
        const std::size_t line_end = source.bytes.find('\n', begin + piece_size);
        const std::size_t end = line_end == std::string_view::npos ? source.bytes.size() : line_end + 1;
        pieces.push_back({begin, end, {}, {}, true, {}, {}, 0, 0, nullptr});
        begin = end;
    }
    return pieces;
}

/// Runs `read` on every piece; of several errors, that of the first piece is thrown.
template<typename F>
void for_each_piece(std::vector<Piece>& pieces, F&& read) {
    parallel_blocks(pieces.size(), 1, [&](std::size_t begin, std::size_t) {
        try {
            read(begin);
        } catch (...) {
            pieces[begin].error = std::current_exception();
        }
    });
    for (const Piece& piece : pieces)
        if (piece.error)
            std::rethrow_exception(piece.error);
}

Document read_statements(const Source& source, std::string_view original) {
    std::vector<Piece> pieces = cut(source);
    for_each_piece(pieces, [&](std::size_t p) { scan_piece(source, pieces[p]); });
    std::vector<std::size_t> before(pieces.size() + 1, 0);
    for (std::size_t p = 0; p < pieces.size(); ++p)
        before[p + 1] = before[p] + pieces[p].positions.size();
    for_each_piece(pieces, [&](std::size_t p) {
        if (!pieces[p].plain)
            read_piece(source, pieces[p], before[p]);
    });

    Document document;
    document.positions.reserve(before.back());
    auto store = std::make_unique<TextStore>(original);
    store->reserve(before.back());
    for (Piece& piece : pieces) {
        if (!piece.faces.corners.empty() && piece.largest >= before.back())
            source.fail_in_line(piece.largest_at,
                                fmt::format("a face names vertex {}, but the file has {} vertices",
                                            std::size_t{piece.largest} + 1, before.back()));
        document.positions.insert(document.positions.end(), piece.positions.begin(), piece.positions.end());
        store->add(piece.offsets);
    }
    for_each_piece(pieces, [&](std::size_t p) {
        pieces[p].triangles = triangulate(document.positions, pieces[p].faces);
    });
    for (const Piece& piece : pieces)
        document.triangles.insert(document.triangles.end(), piece.triangles.begin(), piece.triangles.end());
    document.store = std::move(store);
    return document;
}

} // namespace

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

Document read_obj(const Source& source) {
    if (const std::size_t zero = source.bytes.find('\0'); zero != std::string_view::npos)
        source.fail_at_byte(zero, "a zero byte, which no OBJ file holds; the file is binary or damaged");
    if (source.bytes.find('\\') == std::string_view::npos)
        return read_statements(source, source.bytes);
    const std::string joined = join_continued_lines(source.bytes);
    return read_statements({source.name, joined}, source.bytes);
}

} // namespace wm3d::io
