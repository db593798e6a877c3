// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the first inputs of every fuzzing target: make_seeds FOLDER. They are made by code, so none is kept.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>

#include <wm3d/commitment.hpp>
#include <wm3d/io.hpp>
#include <wm3d/key.hpp>
#include <wm3d/resync/receipt.hpp>
#include <wm3d/shapes.hpp>

namespace {

using namespace wm3d;
namespace fs = std::filesystem;

class Folder {
public:
    explicit Folder(fs::path path) : path_(std::move(path)) { fs::create_directories(path_); }
    void add(const std::string& bytes) {
        std::ofstream(path_ / fmt::format("seed-{}", number_++), std::ios::binary) << bytes;
    }

private:
    fs::path path_;
    int number_ = 0;
};

std::string with_head(int format, bool turn, int beside, const std::string& bytes) {
    return std::string{static_cast<char>(turn ? 132 + format : format),
                       static_cast<char>(beside)} +
           bytes;
}

void add_models(Folder folder) {
    const TriangleMesh meshes[] = {shapes::box({1, 2, 3}, 1), shapes::sphere(1, 3), shapes::square(1, 2)};
    for (const TriangleMesh& mesh : meshes)
        for (int format = 0; format < 6; ++format)
            for (bool ascii : {false, true})
                for (bool turn : {false, true})
                    folder.add(
                        with_head(format, turn, 0,
                                  io::encode(mesh, static_cast<io::Format>(format), {.ascii = ascii})));
    folder.add(
        with_head(0, true, 0, "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvn 0 0.6 0.8\nf 1//1 2/7/2 -1//-1\n"));
    folder.add(with_head(3, true, 0, "NOFF 3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0.6 0.8\n3 0 1 2\n"));
    folder.add(with_head(1, true, 0,
                         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                         "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                         "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                         "0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0.6 0.8\n3 0 1 2\n"));
    // Instances, a strip, and a buffer beside the file: the last 72 of all bytes.
    const std::string json =
        R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{"mesh":0,"scale":[-1,1,1],)"
        R"("children":[2]},{"mesh":0,"translation":[1,0,0]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,)"
        R"("NORMAL":0},"mode":5}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":6,"type":"VEC3",)"
        R"("min":[0,0,0],"max":[1,1,1]}],"bufferViews":[{"buffer":0,"byteLength":72}],"buffers":[{"byteLength":72,)"
        R"("uri":"b.bin"}]})";
    folder.add(with_head(4, true, 256 * 72 / static_cast<int>(json.size() + 72) + 1,
                         json + std::string(72, '\x3f')));
}

void add_documents(Folder folder) {
    const key::Key key = key::Key::generate("seed");
    const key::Passphrase passphrase(std::string("seed"));
    folder.add('\0' + key.to_text());
    folder.add('\0' + key.to_text(&passphrase, {1, 8}));
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
    folder.add('\1' + resync::to_text(receipt));
    folder.add('\2' + commitment::to_text(commitment::commit_to(key, {}, resync::to_text(receipt))));
}

void add_grammars(Folder folder) {
    for (const char* text :
         {"noise:0.3", "smoothing:10,noise:0.1", "simplification:90", "cropping:30", "quantization:8",
          "rotation:5,scaling:2", "noise:0.3:seed=7", "subdivision:loop", ","})
        folder.add(text);
}

void add_marks(Folder folder) {
    for (const TriangleMesh& mesh : {shapes::box({1, 2, 3}, 3), shapes::sphere(1, 7), shapes::square(1, 6),
                                     shapes::torus(2, 0.5, 12, 8), shapes::blob(120, 1)})
        folder.add(io::encode(mesh, io::Format::off));
    std::string lattice;
    for (int i = 0; i < 600; ++i)
        lattice += static_cast<char>(i * 37 + i / 7);
    folder.add(lattice);
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: make_seeds FOLDER\n", stderr);
        return 2;
    }
    const fs::path folder = argv[1];
    add_models(Folder(folder / "models"));
    add_documents(Folder(folder / "documents"));
    add_grammars(Folder(folder / "grammars"));
    add_marks(Folder(folder / "marks"));
    return 0;
}
