// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A glTF asset as a container: its JSON and its buffers, wherever they are kept.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
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
        /// Bytes, unless they are a part of the file; buffers that name the same file share them.
        std::shared_ptr<const std::string> own;
        std::string_view bytes; ///< byteLength bytes
        std::string uri_prefix; ///< of an inline URI, up to the comma and with it
    };

    /// Takes a GLB container apart, or the text of a .gltf.
    /// \throw InputError
    static GltfFile open(const Source& source, bool binary, const Resolver& resolver,
                         const Limits& limits = Limits::none());

    const Source& source() const { return source_; }
    const Json& json() const { return json_; }
    std::string_view text() const { return text_; }

    /// Bytes of a buffer, fetched on first use.
    /// \throw InputError
    std::string_view buffer(std::size_t number);
    /// The buffers that the file lists, then one for each buffer view that may be unpacked.
    const std::vector<Buffer>& buffers() const { return buffers_; }

    /// Number of the buffer that holds what `unpack` gives for a buffer view; calls it on first use.
    /// `size` is how many bytes that will be.
    /// \throw InputError  if that is beyond the asset's limits
    std::size_t unpacked_view(std::size_t view, std::size_t size, const std::function<std::string()>& unpack);

    /// Bytes of the file and of all that it referred to so far.
    std::size_t asset_bytes() const { return asset_bytes_; }
    /// Refuses `count` of what the asset shows if that is beyond its limits.
    /// \throw InputError
    void check_shown(double count, std::string_view what) const;

    /// Offset in the file of the GLB's binary chunk's data.
    std::size_t chunk_offset() const { return chunk_offset_; }
    bool is_binary() const { return binary_; }

private:
    GltfFile(const Source& source, const Limits& limits)
        : source_(source), limits_(limits), asset_bytes_(source.bytes.size()) {}
    void split_chunks();
    void parse_json();
    void load(std::size_t number);
    std::shared_ptr<const std::string> beside(std::size_t number, const std::string& uri);

    Source source_;
    Limits limits_;
    Resolver resolver_;
    std::size_t asset_bytes_;
    std::size_t unpacked_bytes_ = 0;
    std::map<std::string, std::shared_ptr<const std::string>> beside_; ///< by path
    bool binary_ = false;
    std::string_view text_;
    std::string_view chunk_;
    std::size_t chunk_offset_ = 0;
    Json json_;
    std::size_t listed_buffers_ = 0;
    std::vector<Buffer> buffers_;
};

/// Array member of an object; an empty array if it is missing.
/// \throw InputError if it is something else
const Json& gltf_array(const Source& source, const Json& object, const char* key);
/// Unsigned member of an object.
/// \throw InputError if it is something else
std::size_t gltf_size(const Source& source, const Json& object, const char* key, std::size_t missing);
/// Entry of a top-level array such as "accessors".
/// \throw InputError if there is none
const Json& gltf_entry(const Source& source, const Json& root, const char* key, std::size_t number);

} // namespace wm3d::io
