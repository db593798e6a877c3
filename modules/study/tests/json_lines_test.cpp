// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/json_lines.hpp>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include <wm3d/core/error.hpp>

using namespace wm3d;
using namespace wm3d::study;
using nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

/// A path in a folder of its own, which is removed at the end.
struct TemporaryPath {
    fs::path folder;
    std::string file;
    TemporaryPath() {
        std::string name = (fs::temp_directory_path() / "wm3d-lines-XXXXXX").string();
        folder = ::mkdtemp(name.data());
        file = folder / "log";
    }
    ~TemporaryPath() { fs::remove_all(folder); }
    TemporaryPath(const TemporaryPath&) = delete;
    TemporaryPath& operator=(const TemporaryPath&) = delete;

    std::string text() const {
        std::stringstream content;
        content << std::ifstream(file, std::ios::binary).rdbuf();
        return content.str();
    }
    void write(const std::string& text) const { std::ofstream(file, std::ios::binary) << text; }
};

/// Opens the file as a log of things; the first line is the header, the others are counted.
struct Log {
    std::size_t things = 0;
    JsonLines lines;
    explicit Log(const std::string& path)
        : lines(path, "thing", "wm3d.things/1", [this](const ordered_json& line, std::size_t number) {
              if (number == 1 && line.at("schema") != "wm3d.things/1")
                  throw InputError("these are other things");
              things += number > 1 ? 1 : 0;
          }) {
        if (lines.was_empty())
            lines.append({{"schema", "wm3d.things/1"}});
    }
};

const std::string header = "{\"schema\":\"wm3d.things/1\"}\n";

} // namespace

TEST_CASE("lines are kept, and a last line that was cut off is dropped") {
    const TemporaryPath path;
    {
        Log log(path.file);
        log.lines.append({{"thing", 1}});
    }
    CHECK(path.text() == header + "{\"thing\":1}\n");
    path.write(path.text() + "{\"thing\":2");
    Log log(path.file);
    CHECK(log.things == 1);
    log.lines.append({{"thing", 3}});
    CHECK(path.text() == header + "{\"thing\":1}\n{\"thing\":3}\n");
}

TEST_CASE("another's file is never changed, whether it has line ends or not") {
    const TemporaryPath path;
    for (const std::string text :
         {"{\"asset\":{\"version\":\"2.0\"}}", "{", "{\"schema\":\"wm3d.verify/1\"", "x", "[1]\n[2]\n",
          "{\"schema\":\"wm3d.other/1\"}\n{\"a\"", "solid cube\nendsolid", "\n\n"}) {
        path.write(text);
        CHECK_THROWS_AS(Log(path.file), InputError);
        CHECK(path.text() == text);
    }
    const std::string bytes("glTF\0\0\0", 7);
    path.write(bytes);
    CHECK_THROWS_WITH_AS(Log(path.file), doctest::Contains("left alone"), InputError);
    CHECK(path.text() == bytes);
}

TEST_CASE("a first line that was cut off is begun anew") {
    const TemporaryPath path;
    for (std::size_t length : {header.size() - 1, header.size() - 2, std::size_t{0}}) {
        path.write(header.substr(0, length));
        CHECK(Log(path.file).lines.was_empty());
        CHECK(path.text() == header);
    }
}

TEST_CASE("brackets without end are refused") {
    const TemporaryPath path;
    const std::string text = header + std::string(400000, '[') + "\n";
    path.write(text);
    CHECK_THROWS_WITH_AS(Log(path.file), doctest::Contains("line 2: brackets nest"), InputError);
    CHECK(path.text() == text);
}

TEST_CASE("only one process writes to a file") {
    const TemporaryPath path;
    std::optional<Log> first(std::in_place, path.file);
    CHECK_THROWS_WITH_AS(Log(path.file), doctest::Contains("another process"), OutputError);
    first.reset();
    CHECK_NOTHROW(Log(path.file));
}

TEST_CASE("a line that finds no room is taken back") {
    const TemporaryPath path;
    Log log(path.file);
    struct rlimit before {};
    REQUIRE(::getrlimit(RLIMIT_FSIZE, &before) == 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    struct rlimit small = before;
    small.rlim_cur = header.size() + 20;
    REQUIRE(::setrlimit(RLIMIT_FSIZE, &small) == 0);
    CHECK_THROWS_AS(log.lines.append({{"thing", std::string(100, 'x')}}), OutputError);
    REQUIRE(::setrlimit(RLIMIT_FSIZE, &before) == 0);
    std::signal(SIGXFSZ, handler);
    CHECK(path.text() == header);
    log.lines.append({{"thing", 1}});
    CHECK(path.text() == header + "{\"thing\":1}\n");
}
