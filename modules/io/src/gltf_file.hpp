// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A glTF asset as a container: its JSON and its buffers, wherever they are kept.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <wm3d/io/model.hpp>

#include "source.hpp"

namespace wm3d::io {

using Json = nlohmann::json;

class GltfFile {
public:
    enum class Home { chunk, inline_uri, external, unpacked };
    struct Buffer {
        Home home = Home::external;
        bool loaded = false;
        std::string own;        ///< bytes, unless they are a part of the file
        std::string_view bytes; ///< byteLength bytes
        std::string uri_prefix; ///< of an inline URI, up to the comma and with it
    };

    /// Takes a GLB container apart, or the text of a .gltf. \throw InputError
    static GltfFile open(const Source& source, bool binary, const Resolver& resolver);

    const Source& source() const { return source_; }
    const Json& json() const { return json_; }
    std::string_view text() const { return text_; }

    /// Bytes of a buffer, fetched on first use. \throw InputError
    std::string_view buffer(std::size_t number);
    /// The buffers that the file lists, then one for each buffer view that may be unpacked.
    const std::vector<Buffer>& buffers() const { return buffers_; }

    /// Number of the buffer that holds what `unpack` gives for a buffer view; calls it on first use.
    std::size_t unpacked_view(std::size_t view, const std::function<std::string()>& unpack);

    /// Offset in the file of the GLB's binary chunk's data.
    std::size_t chunk_offset() const { return chunk_offset_; }
    bool is_binary() const { return binary_; }

private:
    explicit GltfFile(const Source& source) : source_(source) {}
    void split_chunks();
    void parse_json();
    void load(std::size_t number);

    Source source_;
    Resolver resolver_;
    bool binary_ = false;
    std::string_view text_;
    std::string_view chunk_;
    std::size_t chunk_offset_ = 0;
    Json json_;
    std::size_t listed_buffers_ = 0;
    std::vector<Buffer> buffers_;
};

/// Array member of an object; an empty array if it is missing. \throw InputError if it is something else
const Json& gltf_array(const Source& source, const Json& object, const char* key);
/// Unsigned member of an object. \throw InputError if it is something else
std::size_t gltf_size(const Source& source, const Json& object, const char* key, std::size_t missing);
/// Entry of a top-level array such as "accessors". \throw InputError if there is none
const Json& gltf_entry(const Source& source, const Json& root, const char* key, std::size_t number);

} // namespace wm3d::io
