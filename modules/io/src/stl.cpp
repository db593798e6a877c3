// SPDX-License-Identifier: GPL-3.0-or-later
// STL, text and binary. The header's first word proves nothing: binary files may begin with "solid" too.
#include <algorithm>
#include <cctype>
#include <cstdint>

#include <fmt/format.h>

#include "binary.hpp"
#include "document.hpp"
#include "normals.hpp"
#include "text.hpp"

namespace wm3d::io {

namespace {

constexpr std::size_t header_size = 84; // 80 bytes of anything and the count
constexpr std::size_t facet_size = 50;  // normal, three corners, two bytes of attributes

void number_corners(Document& document) {
    document.triangles.resize(document.positions.size() / 3);
    for (std::size_t f = 0; f < document.triangles.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
            document.triangles[f][k] = static_cast<Index>(3 * f + k);
}

Document read_binary(const Source& source, std::size_t facets) {
    BinaryStore::Layout layout;
    layout.swap = swaps(std::endian::little);
    auto store = std::make_unique<BinaryStore>(source.bytes, layout);
    Document document;
    document.positions.reserve(3 * facets);
    store->reserve(3 * facets);
    for (std::size_t f = 0; f < facets; ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t offset = header_size + f * facet_size + 12 * (k + 1);
            document.positions.push_back(store->add(offset));
            if (!document.positions.back().allFinite())
                source.fail_at_byte(offset,
                                    fmt::format("corner {} of facet {} is not finite; wm3d needs finite "
                                                "coordinates",
                                                k + 1, f + 1));
        }
    number_corners(document);
    document.store = std::move(store);
    return document;
}

bool equal_words(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// Reads the statements of a text file one word at a time.
class TextReader {
public:
    explicit TextReader(const Source& source)
        : scan_(source, 0), store_(std::make_unique<TextStore>(source.bytes)) {}

    /// Reads the normals too; without this they may be anything.
    void collect(std::vector<Vec3>& normals, TextStore& store) {
        normals_ = &normals;
        normal_store_ = &store;
    }

    Document run() {
        for (std::string_view word = scan_.word(); !word.empty(); word = scan_.word()) {
            if (!in_solid_)
                expect(word, "solid");
            if (!in_solid_ || equal_words(word, "endsolid")) {
                in_solid_ = !in_solid_;
                scan_.skip_line(); // the name, which may be anything
            } else {
                expect(word, "facet");
                read_facet();
            }
        }
        if (in_solid_)
            scan_.source().fail("the file ends without \"endsolid\"; it is cut short");
        number_corners(document_);
        document_.store = std::move(store_);
        return std::move(document_);
    }

private:
    void expect(std::string_view word, std::string_view wanted) {
        if (equal_words(word, wanted))
            return;
        if (word.empty())
            scan_.source().fail(fmt::format("the file ends where \"{}\" should be; it is cut short", wanted));
        scan_.source().fail_in_line(
            scan_.offset(), fmt::format("\"{}\" stands where \"{}\" should be", word.substr(0, 30), wanted));
    }
    void expect_next(std::string_view wanted) { expect(scan_.word(), wanted); }

    void read_normal() {
        if (normals_ == nullptr) {
            for (int k = 0; k < 3; ++k)
                scan_.word(); // kept as it stands; some programs write nan here
            return;
        }
        std::array<std::size_t, 3> offsets{};
        normals_->push_back(scan_.any_vector("a normal", offsets));
        normal_store_->add(offsets);
    }

    void read_facet() {
        expect_next("normal");
        read_normal();
        expect_next("outer");
        expect_next("loop");
        for (int corner = 0; corner < 3; ++corner) {
            expect_next("vertex");
            std::array<std::size_t, 3> offsets{};
            Vec3 position;
            for (std::size_t k = 0; k < 3; ++k)
                position[static_cast<int>(k)] = scan_.number("a vertex coordinate", offsets[k]);
            document_.positions.push_back(position);
            store_->add(offsets);
        }
        expect_next("endloop");
        expect_next("endfacet");
    }

    TextScanner scan_;
    std::unique_ptr<TextStore> store_;
    Document document_;
    std::vector<Vec3>* normals_ = nullptr;
    TextStore* normal_store_ = nullptr;
    bool in_solid_ = false;
};

bool looks_like_text(std::string_view bytes) {
    const std::size_t first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && equal_words(bytes.substr(first, 5), "solid") &&
           bytes.substr(0, 512).find('\0') == std::string_view::npos;
}

/// Facets that the header of a binary file counts.
std::size_t counted_facets(const Source& source) {
    return source.bytes.size() < header_size
               ? 0
               : static_cast<std::size_t>(
                     load(source.bytes.data() + 80, Scalar::u32, swaps(std::endian::little)));
}

bool is_binary(const Source& source) {
    return source.bytes.size() >= header_size &&
           source.bytes.size() == header_size + counted_facets(source) * facet_size;
}

} // namespace

NormalTable stl_normals(const Source& patched) {
    NormalTable table;
    if (!is_binary(patched)) {
        auto store = std::make_unique<TextStore>(patched.bytes);
        TextReader reader(patched);
        reader.collect(table.values, *store);
        reader.run();
        table.store = std::move(store);
        return table;
    }
    BinaryStore::Layout layout;
    layout.swap = swaps(std::endian::little);
    auto store = std::make_unique<BinaryStore>(patched.bytes, layout);
    for (std::size_t f = 0; f < counted_facets(patched); ++f)
        table.values.push_back(store->add(header_size + f * facet_size));
    table.store = std::move(store);
    return table;
}

Document read_stl(const Source& source) {
    const std::size_t size = source.bytes.size();
    const std::size_t facets = counted_facets(source);
    if (is_binary(source))
        return read_binary(source, facets);
    if (looks_like_text(source.bytes))
        return TextReader(source).run();
    if (size < header_size)
        source.fail(
            fmt::format("the file has {} bytes, but a binary STL has at least {}; it is cut short or no STL",
                        size, header_size));
    source.fail(
        fmt::format("its header counts {} facets, which take {} bytes, but the file has {}; it is cut short, "
                    "damaged, or no STL",
                    facets, header_size + facets * facet_size, size));
}

} // namespace wm3d::io
