// SPDX-License-Identifier: GPL-3.0-or-later
#include "target.hpp"

#include <cstdlib>

#include <fmt/format.h>

#include <wm3d/commitment.hpp>
#include <wm3d/io.hpp>
#include <wm3d/key.hpp>
#include <wm3d/resync/receipt.hpp>
#include <wm3d/shapes.hpp>

#include "fixed_key.hpp"

#ifdef WM3D_WITH_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

namespace wm3d::fuzz {

namespace {

using Seeds = std::vector<std::string>;

// Models: a byte for format and normals, one for the size of the buffer beside the file, the file.

std::string model(int format, bool turn, int beside, const std::string& bytes) {
    return std::string{static_cast<char>(turn ? 132 + format : format), static_cast<char>(beside)} + bytes;
}

/// A glTF file with its only buffer beside it.
std::string model_with_buffer(const std::string& json, const std::string& buffer) {
    const std::size_t all = json.size() + buffer.size();
    return model(4, true, static_cast<int>((256 * buffer.size() + all - 1) / all), json + buffer);
}

const char* const instances =
    R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{"mesh":0,"scale":[-1,1,1],)"
    R"("children":[2]},{"mesh":0,"translation":[1,0,0]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,)"
    R"("NORMAL":0},"mode":5}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3",)"
    R"("min":[0,0,0],"max":[1,1,1]}],"bufferViews":[{"buffer":0,"byteLength":72}],"buffers":[{"byteLength":72,)"
    R"("uri":"b.bin"}]})";

const char* const sparse =
    R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":6}]}],)"
    R"("accessors":[{"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":3,"indices":{"bufferView":0,)"
    R"("componentType":5123},"values":{"bufferView":1}}}],"bufferViews":[{"buffer":0,"byteLength":6},)"
    R"({"buffer":0,"byteOffset":8,"byteLength":36}],"buffers":[{"byteLength":44,"uri":"b.bin"}]})";

std::string sparse_buffer() {
    const float corners[] = {0, 1, 0, 1, 0, 0, 0, 0, 1};
    std::string bytes{1, 0, 2, 0, 3, 0, 0, 0};
    bytes.append(reinterpret_cast<const char*>(corners), sizeof corners);
    return bytes;
}

#ifdef WM3D_WITH_MESHOPTIMIZER
/// A square of two triangles, packed.
std::string packed() {
    const float corners[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const unsigned indices[] = {0, 1, 2, 0, 2, 3};
    std::string positions(meshopt_encodeVertexBufferBound(4, 12), '\0'),
        triangles(meshopt_encodeIndexBufferBound(6, 4), '\0');
    positions.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(positions.data()),
                                                positions.size(), corners, 4, 12));
    triangles.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(triangles.data()),
                                               triangles.size(), indices, 6));
    const auto view = [](std::size_t offset, std::size_t length, int bytes, int stride, int count,
                         const char* mode) {
        return fmt::format(
            R"({{"buffer":1,"byteLength":{},"extensions":{{"EXT_meshopt_compression":{{"buffer":0,"byteOffset":{},)"
            R"("byteLength":{},"byteStride":{},"count":{},"mode":"{}","filter":"NONE"}}}}}})",
            bytes, offset, length, stride, count, mode);
    };
    const std::string json =
        R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
        R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},{"bufferView":1,)"
        R"("componentType":5123,"count":6,"type":"SCALAR"}],"bufferViews":[)" +
        view(0, positions.size(), 48, 12, 4, "ATTRIBUTES") + "," +
        view(positions.size(), triangles.size(), 12, 2, 6, "TRIANGLES") +
        fmt::format(R"(],"buffers":[{{"byteLength":{},"uri":"b.bin"}},{{"byteLength":60,"extensions":)"
                    R"({{"EXT_meshopt_compression":{{"fallback":true}}}}}}]}})",
                    positions.size() + triangles.size());
    return model_with_buffer(json, positions + triangles);
}
#endif

Seeds models() {
    Seeds all;
    for (const TriangleMesh& mesh : {shapes::box({1, 2, 3}, 1), shapes::sphere(1, 3), shapes::square(1, 2)})
        for (int format = 0; format < 6; ++format)
            for (const bool ascii : {false, true})
                for (const bool turn : {false, true})
                    all.push_back(model(format, turn, 0,
                                        io::encode(mesh, static_cast<io::Format>(format), {.ascii = ascii})));
    all.push_back(
        model(0, true, 0, "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 0.6 0.8\nf 1//1 2/7/2 -1//-1\n"));
    all.push_back(model(3, true, 0, "NOFF 3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0.6 0.8\n3 0 1 2\n"));
    all.push_back(model(1, true, 0,
                        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                        "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                        "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                        "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0.6 0.8\n3 0 1 2\n"));
    all.push_back(model(1, false, 0,
                        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                        "property double z\nproperty uchar red\nelement tristrips 1\n"
                        "property list int int vertex_indices\nend_header\n"
                        "0 0 0 9\n1 0 0 9\n0 1 0 9\n1 1 0 9\n5 0 1 2 -1 3\n"));
    all.push_back(model_with_buffer(instances, std::string(72, '\x3f')));
    all.push_back(model_with_buffer(sparse, sparse_buffer()));
#ifdef WM3D_WITH_MESHOPTIMIZER
    all.push_back(packed());
#endif
    return all;
}

// Documents: a byte for the kind, the text.

const char* const protected_key =
    "wm3d key, version 2\n"
    "name: seed\n"
    "protected-secret: argon2id 3 256 744d9c82ba346c691bd88c849806e28e "
    "96e3a05addddc4db47fb604129f428ec9ae73dfc377b6433 "
    "d2af42ac1109a8704fd266bbe7380c574568f361d790fa7d067f0a7897f58487c6d5ace8383b3ad1693b9a6bb629d8e6\n"
    "levels: 3 4 5 6\n"
    "rmax: 0.1\n"
    "reference-strength: 0.05\n"
    "created-by: wm3d 0.2.0\n"
    "checksum: 00000000000000000000000000000000\n"; // made to fit by the target

Seeds documents() {
    const key::Key key = fixed_key();
    resync::Receipt receipt;
    receipt.tool = "wm3d";
    receipt.key_name = key.fingerprint();
    receipt.key_commitment = key.commitment();
    receipt.original = receipt.marked = resync::digest_of("model");
    receipt.base_vertices = 100;
    receipt.level = 3;
    receipt.gamma = receipt.rmax = 0.1;
    receipt.rms_percent = 0.05;
    receipt.frame.axes = Mat3::Identity();
    receipt.frame.scale = 1;
    receipt.pose_template = resync::make_template(shapes::sphere(1, 8), 40);
    const std::string text = resync::to_text(receipt);
    return {'\0' + key.to_text(),
            std::string("\0", 1) + protected_key,
            '\1' + text,
            '\2' + commitment::to_text(commitment::commit_to(key, {}, text)),
            '\2' + commitment::to_text(commitment::commit_to(key, {}, std::nullopt)),
            "\3wm3d.org/42",
            "\3"
            "0x0123456789abcdef"};
}

// Grammars: a byte for the kind, the text. Arguments are separated by line ends.

Seeds grammars() {
    Seeds all;
    for (const char* chain : {"noise:0.3", "smoothing:10+noise:0.1", "simplification:90",
                              "cropping:30,cap=yes", "rotation:5+scaling:2", "subdivision:loop", "+"})
        all.push_back(std::string("\0", 1) + chain);
    for (const char* list : {"noise:0.3,smoothing:10", "crop:30,cap=yes,noise:0.1+quantization:8", ","})
        all.push_back(std::string("\1") + list);
    for (const char* line :
         {"bench\n--models\nscans\n--out\nresults\n--mrms\n0.02,0.08\n--pf\n1e-6,1e-9\n--keys\n2\n--"
          "attacks\nnoise:0.3",
          "mark\nin.ply\n-o\nout.ply\n--key\nk\n--visibility\n0.1\n--payload\n0x12\n--json",
          "verify\nin.ply\n--key\nk\n--pf=1e-6\n--detector\npaper\n--null-keys\n7\n--threads\n2",
          "analyze\nin.ply\n--strength\n0.1,0.2\n--pf\n1e-12:0.5:50\n--trials\n3",
          "attack\nnoise:0.3\nin.obj\n-o\n-\n--format\nply", "keygen\nk\n--name\nn\n--levels\n4,5",
          "identify\nin.ply\n--key\nk\n--ledger\nl", "info\n--\n-x.ply"})
        all.push_back(std::string("\2") + line);
    const std::string bench = R"({"schema":"wm3d.bench-items/1","settings":{"seed":1}})"
                              "\n";
    all.push_back(
        '\3' + bench +
        R"({"kind":"command","command":"wm3d bench"})"
        "\n"
        R"({"kind":"model","model":"a.obj","mesh":"0123456789abcdef","vertices":9,"triangles":14})"
        "\n"
        R"({"kind":"mark","model":"a.obj","strength_asked":0.02,"key":0,"strength":0.02,"gamma":0.1,)"
        R"("rms_percent":0.02,"mrms_percent":0.03,"msdm2":null,"msdm2_both":0.2})"
        "\n"
        R"({"kind":"item","model":"a.obj","strength_asked":0.02,"key":0,"attack":"noise:0.3","log10_p":-9.5,)"
        R"("sigmas":6,"hypotheses":8,"level":4,"pose":0,"filter":{"t":0.1,"power":1},"vertices":9,)"
        R"("wrong_log10_p":[-0.1],"wrong_one_log10_p":[null],"searched":{"found":true,"centres":3},)"
        R"("assisted":{"log10_p":-3,"aligned":true,"coverage":1},"payload":{"bits":32,"raw_errors":0,)"
        R"("read":true,"wrong":false,"log10_p":-2},"seconds":1.5})"
        "\n"
        R"({"kind":"item","model":"a.obj","mrms_limit":0.02,"key":1,"attack":"file","error":"no"})"
        "\n");
    all.push_back('\4' + std::string(R"({"schema":"wm3d.trials/1","mesh":"0123456789abcdef"})"
                                     "\n"));
    return all;
}

// Marks: a byte for the profile, an OFF file or corners of a lattice.

Seeds marks() {
    Seeds all;
    for (const char profile : {'\0', '\1', '\2'}) {
        for (const TriangleMesh& mesh :
             {shapes::box({1, 2, 3}, 2), shapes::sphere(1, 5), shapes::square(1, 5),
              shapes::torus(2, 0.5, 10, 6), shapes::blob(70, 1)})
            all.push_back(profile + io::encode(mesh, io::Format::off));
        std::string lattice(1, profile);
        for (int i = 0; i < 300; ++i)
            lattice += static_cast<char>(i * 37 + i / 7);
        all.push_back(lattice);
    }
    return all;
}

} // namespace

Seeds seeds(std::string_view target) {
    if (target == "models")
        return models();
    if (target == "documents")
        return documents();
    return target == "grammars" ? grammars() : marks();
}

void require(bool holds) {
    if (!holds)
        std::abort();
}

} // namespace wm3d::fuzz
